// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace posture::test {

/// What keeps an XML document from being well formed: empty where nothing does. Knows elements,
/// attributes and entities, which is all that our writers use.
inline std::string markupFault(const std::string& text) {
  std::vector<std::string> open;
  std::size_t place = 0;
  bool had_root = false;
  while (place < text.size()) {
    if (text[place] == '&') {
      const std::size_t end = text.find(';', place);
      const std::string name = end == std::string::npos ? "" : text.substr(place, end - place + 1);
      if (name != "&amp;" && name != "&lt;" && name != "&gt;" && name != "&quot;")
        return "bare & at " + std::to_string(place);
    }
    if (text[place] == '>') return "bare > at " + std::to_string(place);
    if (text[place] != '<') {
      ++place;
      continue;
    }
    const std::size_t end = text.find('>', place);
    if (end == std::string::npos) return "element without end";
    const std::string tag = text.substr(place + 1, end - place - 1);
    place = end + 1;
    if (tag.find('<') != std::string::npos) return "bare < in " + tag;
    if (tag.front() == '?' || tag.front() == '!') continue;
    if (tag.front() == '/') {
      if (open.empty() || open.back() != tag.substr(1)) return "unexpected end of " + tag.substr(1);
      open.pop_back();
      continue;
    }
    std::size_t quotes = 0;
    for (const char c : tag) quotes += c == '"';
    if (quotes % 2 != 0) return "quotes in " + tag;
    if (open.empty() && had_root) return "second root " + tag;
    had_root = true;
    if (tag.back() != '/') open.push_back(tag.substr(0, tag.find(' ')));
  }
  return open.empty() ? "" : "no end of " + open.back();
}

inline int countOf(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t i = text.find(part); i != std::string::npos; i = text.find(part, i + 1)) ++count;
  return count;
}

}  // namespace posture::test
