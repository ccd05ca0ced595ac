// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace posture {

/// One line of a benchmark list.
struct BenchmarkPair {
  std::string id;
  std::string family;
  std::string kind;
  std::filesystem::path source;  ///< as all paths here, from where the program runs
  std::filesystem::path target;
  std::filesystem::path truth;         ///< or the word `identity`; empty: none known
  std::filesystem::path mirror_truth;  ///< likewise
  std::string note;
  /// For a target cloud: a clean mesh of the body, in its frame, to measure errors on, and a file
  /// of `point vertex` rows that says where the points lie on it. Empty: see the benchmark.
  std::filesystem::path target_surface;
  std::filesystem::path target_surface_vertices;
};

/// Reads a CSV file with the header `id,family,kind,source,target,truth,mirror_truth,note` and
/// perhaps `target_surface,target_surface_vertices` (columns in any order; all but id, source and
/// target may be left out). Fields may be quoted; paths are
/// relative to the file's folder.
/// \throws InputError  cannot be read, a column is missing, no pair is listed, a row has too few or
///         too many fields, an id is empty, used twice or no file name (letters, digits, '_', '-',
///         '.' but not first, at most 200).
std::vector<BenchmarkPair> readPairList(const std::filesystem::path& path);

/// The records of a CSV text (RFC 4180: fields quoted where they hold commas, quotes or line
/// breaks). Blank lines are no records. \throws InputError  a quote that is never closed, or text
/// after a closing one.
std::vector<std::vector<std::string>> parseCsv(const std::string& text);

}  // namespace posture
