// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <pcl/PCLPointCloud2.h>

namespace posture {

/// The cloud with its fields of double precision in single. PCL's point types have single
/// precision, and pcl::fromPCLPointCloud2 leaves a field of another type at zero.
pcl::PCLPointCloud2 inSinglePrecision(const pcl::PCLPointCloud2& cloud);

}  // namespace posture
