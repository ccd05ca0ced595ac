// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/io/atomic_file.h>
#include <posture/io/correspondence_io.h>

#include "input.h"
#include "text.h"
#include "text_reader.h"
#include "text_writer.h"
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace posture {
namespace {

constexpr std::string_view CSV_HEADER = "source,target,face,b0,b1,b2,confidence";
constexpr int NONE = -1;

using Fields = std::array<std::string_view, 7>;

/// The lines of a file, each without its end.
class Lines {
 public:
  explicit Lines(const Input& input) : input_(input), next_(textBegin(input.bytes())) {}

  bool next() {
    const std::string_view text = input_.bytes();
    if (next_ >= text.size()) return false;
    begin_ = next_;
    const std::size_t end = std::min(text.find('\n', begin_), text.size());
    line_ = trimmed(text.substr(begin_, end - begin_));
    next_ = end + 1;
    return true;
  }
  std::string_view line() const { return line_; }
  [[noreturn]] void fail(const std::string& what) const { input_.failAt(begin_, what); }

 private:
  const Input& input_;
  std::string_view line_;
  std::size_t begin_ = 0, next_;
};

Fields split(const Lines& lines) {
  Fields fields;
  std::string_view rest = lines.line();
  for (std::size_t i = 0; i < fields.size(); ++i) {
    const std::size_t comma = rest.find(',');
    if ((comma == std::string_view::npos) != (i + 1 == fields.size()))
      lines.fail("not 7 fields, as in " + std::string(CSV_HEADER));
    fields[i] = trimmed(rest.substr(0, comma));
    if (comma != std::string_view::npos) rest.remove_prefix(comma + 1);
  }
  return fields;
}

int index(const Lines& lines, std::string_view word, int smallest) {
  std::int64_t value = 0;
  if (!parseInteger(word, value) || value < smallest || value > std::numeric_limits<int>::max())
    lines.fail(inQuotes(word) + " is not a vertex or face number");
  return static_cast<int>(value);
}

double share(const Lines& lines, std::string_view word) {
  double value = 0;
  constexpr double ROUNDING = 1e-6;
  if (!parseNumber(word, value) || !(value >= -ROUNDING && value <= 1 + ROUNDING))
    lines.fail(inQuotes(word) + " is not a number from 0 to 1");
  return value;
}

SurfacePoint toPoint(const Lines& lines, const Fields& fields) {
  SurfacePoint point;
  point.vertex = index(lines, fields[1], NONE);
  point.face = index(lines, fields[2], NONE);
  point.barycentric = {share(lines, fields[3]), share(lines, fields[4]), share(lines, fields[5])};
  constexpr double ROUNDING = 1e-4;
  if (point.vertex >= 0 && point.face >= 0 && std::abs(point.barycentric.sum() - 1) > ROUNDING)
    lines.fail("b0, b1 and b2 do not add up to 1");
  return point;
}

}  // namespace

Correspondence readCorrespondence(const std::filesystem::path& path) {
  const Input input(path);
  Lines lines(input);
  if (!lines.next() || lines.line() != CSV_HEADER)
    lines.fail("the first line is not " + std::string(CSV_HEADER));
  Correspondence result;
  std::vector<double> confidence;
  while (lines.next()) {
    if (lines.line().empty()) continue;
    const Fields fields = split(lines);
    if (index(lines, fields[0], 0) != static_cast<int>(result.on_target.size()))
      lines.fail("source is " + std::string(fields[0]) + ", expected " +
                 std::to_string(result.on_target.size()));
    result.on_target.push_back(toPoint(lines, fields));
    confidence.push_back(share(lines, fields[6]));
  }
  result.confidence =
      Eigen::Map<const Vector>(confidence.data(), static_cast<Eigen::Index>(confidence.size()));
  return result;
}

void writeCorrespondence(const std::filesystem::path& path, const Correspondence& correspondence) {
  const auto& points = correspondence.on_target;
  require(static_cast<std::size_t>(correspondence.confidence.size()) == points.size(),
          std::to_string(correspondence.confidence.size()) + " confidences for " +
              std::to_string(points.size()) + " vertices");
  std::string text(CSV_HEADER);
  text += '\n';
  for (std::size_t i = 0; i < points.size(); ++i) {
    SurfacePoint point = points[i];
    double confidence = correspondence.confidence[static_cast<Eigen::Index>(i)];
    if (point.vertex < 0) {
      point = SurfacePoint();
      confidence = 0;
    }
    const Eigen::Vector3d& b = point.barycentric;
    appendNumbers(text, ',', i, point.vertex, point.face, b[0], b[1], b[2], confidence);
    text += '\n';
  }
  writeFile(path, text);
}

std::vector<VertexPair> readVertexPairs(const std::filesystem::path& path) {
  const Input input(path);
  TextReader text(input, 0, '#');
  const auto vertex = [&](std::string_view word) {
    const std::int64_t value = text.integer(word, "a vertex number");
    if (value < 0 || value > std::numeric_limits<int>::max())
      text.fail("vertex number " + std::to_string(value) + " is out of range");
    return static_cast<int>(value);
  };
  std::vector<VertexPair> pairs;
  for (std::string_view word = text.word(); !word.empty(); word = text.word()) {
    VertexPair pair;
    pair.source = vertex(word);
    pair.target = vertex(text.wordOnLine());
    if (const std::string_view more = text.wordOnLine(); !more.empty())
      text.fail(inQuotes(more) + " behind a pair of vertex numbers");
    pairs.push_back(pair);
  }
  if (pairs.empty()) input.fail("there are no vertex pairs in it");
  return pairs;
}

void writeVertexPairs(const std::filesystem::path& path, const std::vector<VertexPair>& pairs) {
  std::string text;
  for (const VertexPair& pair : pairs) {
    appendNumbers(text, ' ', pair.source, pair.target);
    text += '\n';
  }
  writeFile(path, text);
}

}  // namespace posture
