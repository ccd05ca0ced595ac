// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/report/report_json.h>

#include <string>
#include <vector>

namespace posture {

/// A picture on the page: `png` as part of the page itself, or the file `reference` (relative to
/// the page) where `png` is empty.
struct ReportPicture {
  std::string caption;
  std::string reference;
  std::string png;  ///< the bytes of a PNG file
};

/// report.html: the same as report.json for the eye, one page that needs nothing from elsewhere. As
/// there, the last section alone differs between runs on the same input.
std::string reportHtml(const RegistrationResult& result,
                       const RunDescription& run,
                       const std::vector<ReportPicture>& pictures = {});

}  // namespace posture
