// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace posture::app {

using Json = nlohmann::ordered_json;

/// A document as it is written to files and printed, with its last line break. Bytes that are no
/// UTF-8, as a file's name has or a message quotes from a file, are replaced.
std::string documentText(const Json& document);

/// The text of a member; empty where there is none. \throws Json::type_error  it is no text.
std::string textAt(const Json& document, const std::string& key);

/// A number in a document, by JSON pointer; NaN where it is missing or null.
double numberAt(const Json& document, const std::string& pointer);

/// The numbers at `pointer` of those documents that have one.
std::vector<double> figures(const std::vector<Json>& documents, const std::string& pointer);

}  // namespace posture::app
