// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

namespace posture {

/// The text of a whole file, without a UTF-8 byte-order mark; line ends of a classic Mac become LF.
///
/// \throws InputError  one line "<path>: <what is wrong>": missing, no regular file, empty, or it
///         cannot be read.
std::string readTextFile(const std::filesystem::path& path);

}  // namespace posture
