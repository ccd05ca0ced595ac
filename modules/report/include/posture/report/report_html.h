// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/report/report_json.h>

#include <string>

namespace posture {

/// report.html: most of report.json for the eye, one page that needs nothing from elsewhere. As
/// there, the last section alone differs between runs on the same input.
std::string reportHtml(const RegistrationResult& result, const RunDescription& run);

}  // namespace posture
