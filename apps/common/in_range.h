// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>

#include <charconv>
#include <sstream>
#include <string>
#include <system_error>
#include <type_traits>

namespace posture::app {

/// A number of an option: from `least` to `most`, a whole one where these are. NaN is in no range,
/// and a whole number begins with no 0, which CLI11 would take for an octal one.
template <class Number>
CLI::Validator inRange(Number least, Number most) {
  const bool whole = std::is_integral_v<Number>;
  std::ostringstream range, description;
  range.precision(15);
  description.precision(15);
  range << (whole ? " is no whole number from " : " is no number from ") << least << " to " << most;
  description << "in [" << least << " - " << most << "]";
  const auto check = [least, most, wrong = range.str()](const std::string& text) {
    Number number{};
    const char* const end = text.data() + text.size();
    const auto [rest, error] = std::from_chars(text.data(), end, number);
    const bool good = error == std::errc() && rest == end && number >= least && number <= most;
    const bool octal = std::is_integral_v<Number> && text.size() > 1 && text.front() == '0';
    return good && !octal ? std::string() : text + wrong;
  };
  return {check, description.str()};
}

}  // namespace posture::app
