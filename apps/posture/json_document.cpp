// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "json_document.h"

#include <cmath>
#include <limits>

namespace posture::app {

std::string documentText(const Json& document) {
  return document.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string textAt(const Json& document, const std::string& key) { return document.value(key, ""); }

double numberAt(const Json& document, const std::string& pointer) {
  const Json::json_pointer place(pointer);
  if (!document.contains(place) || !document.at(place).is_number())
    return std::numeric_limits<double>::quiet_NaN();
  return document.at(place).get<double>();
}

std::vector<double> figures(const std::vector<Json>& documents, const std::string& pointer) {
  std::vector<double> found;
  for (const Json& document : documents) {
    const double figure = numberAt(document, pointer);
    if (std::isfinite(figure)) found.push_back(figure);
  }
  return found;
}

}  // namespace posture::app
