// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/evaluation/pair_list.h>
#include <posture/io/text_file.h>

#include <algorithm>
#include <set>

namespace posture {
namespace {

/// The quoted field that begins at `at`, which moves behind its closing quote.
std::string quotedField(const std::string& text, std::size_t& at) {
  std::string field;
  for (++at; at < text.size(); ++at) {
    if (text[at] != '"') {
      field += text[at];
    } else if (at + 1 < text.size() && text[at + 1] == '"') {
      field += text[at++];
    } else {
      ++at;
      if (at < text.size() && text[at] != ',' && text[at] != '\n' && text[at] != '\r')
        throw InputError("text after a closing quote");
      return field;
    }
  }
  throw InputError("a quote that is never closed");
}

/// File systems take names of 255 bytes; results have up to 50 behind the id.
constexpr std::size_t LONGEST_ID = 200;

bool isFileName(const std::string& id) {
  return !id.empty() && id.front() != '.' && std::all_of(id.begin(), id.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.' ||
           c == '_' || c == '-';
  });
}

/// A record with its fields by the name of their column.
class Row {
 public:
  Row(const std::vector<std::string>& header, const std::vector<std::string>& fields)
      : header_(header), fields_(fields) {}

  std::string operator[](const std::string& column) const {
    const auto found = std::find(header_.begin(), header_.end(), column);
    return found == header_.end() ? std::string() : fields_[found - header_.begin()];
  }

 private:
  const std::vector<std::string>& header_;
  const std::vector<std::string>& fields_;
};

BenchmarkPair toPair(const Row& row, const std::filesystem::path& folder) {
  const auto place = [&](const std::string& path) {
    return path.empty() || path == "identity" ? std::filesystem::path(path) : folder / path;
  };
  BenchmarkPair pair;
  pair.id = row["id"];
  pair.family = row["family"];
  pair.kind = row["kind"];
  pair.source = place(row["source"]);
  pair.target = place(row["target"]);
  pair.truth = place(row["truth"]);
  pair.mirror_truth = place(row["mirror_truth"]);
  pair.note = row["note"];
  pair.target_surface = place(row["target_surface"]);
  pair.target_surface_vertices = place(row["target_surface_vertices"]);
  if (!isFileName(pair.id))
    throw InputError("the id '" + pair.id +
                     "' is not made of letters, digits, '.', '_' and '-', or begins with '.'");
  if (pair.id.size() > LONGEST_ID)
    throw InputError("the id '" + pair.id.substr(0, 24) + "...' is longer than " +
                     std::to_string(LONGEST_ID) + " characters and cannot name a file");
  if (pair.source.empty() || pair.target.empty())
    throw InputError("pair " + pair.id + " lacks its source or target");
  return pair;
}

}  // namespace

std::vector<std::vector<std::string>> parseCsv(const std::string& text) {
  std::vector<std::vector<std::string>> records;
  std::size_t at = 0;
  while (at < text.size()) {
    if (text[at] == '\n' || text[at] == '\r') {
      ++at;
      continue;
    }
    std::vector<std::string> record;
    for (bool more = true; more;) {
      if (at < text.size() && text[at] == '"') {
        record.push_back(quotedField(text, at));
      } else {
        const std::size_t end = std::min(text.find_first_of(",\r\n", at), text.size());
        record.push_back(text.substr(at, end - at));
        at = end;
      }
      more = at < text.size() && text[at] == ',';
      if (more) ++at;
    }
    records.push_back(std::move(record));
  }
  return records;
}

std::vector<BenchmarkPair> readPairList(const std::filesystem::path& path) {
  const std::string text = readTextFile(path);
  std::vector<BenchmarkPair> pairs;
  try {
    const auto records = parseCsv(text);
    if (records.empty()) throw InputError("has no line but blank ones");
    const std::vector<std::string>& header = records.front();
    for (const char* column : {"id", "source", "target"})
      if (std::find(header.begin(), header.end(), column) == header.end())
        throw InputError("has no column '" + std::string(column) + "'");
    std::set<std::string> ids;
    for (std::size_t r = 1; r < records.size(); ++r) {
      if (records[r].size() != header.size())
        throw InputError("record " + std::to_string(r) + " has " +
                         std::to_string(records[r].size()) + " fields, the header " +
                         std::to_string(header.size()));
      pairs.push_back(toPair(Row(header, records[r]), path.parent_path()));
      if (!ids.insert(pairs.back().id).second)
        throw InputError("the id '" + pairs.back().id + "' is used twice");
    }
    if (pairs.empty()) throw InputError("lists no pair");
  } catch (const InputError& error) {
    throw InputError(path.string() + ": " + error.what());
  }
  return pairs;
}

}  // namespace posture
