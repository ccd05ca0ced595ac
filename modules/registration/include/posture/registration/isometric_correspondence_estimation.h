// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/registration/register_clouds.h>

#include <pcl/PCLPointCloud2.h>
#include <pcl/point_types.h>
#include <pcl/registration/correspondence_estimation.h>

#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace posture {

/// The matches of registerShapes() as one of PCL's correspondence estimations, for its rejectors
/// and transformation estimations to work on. They are found from how the surfaces bend, not from
/// how near the clouds lie to each other: moving, turning or scaling a cloud does not change them.
///
/// The first call after an input, the indices, a mesh, normals or options were set anew registers
/// the clouds, which takes seconds; further calls use what it found, also where the points of a
/// cloud were moved in place, but not where their number changed. A loop that sets its source anew
/// in each iteration, as pcl::IterativeClosestPoint does, registers in each.
///
/// Where the data do not decide, the matches are those of the best guess; where they cannot be used
/// there are none. getResult() has the status, getMessage() the reason.
///
/// Inputs are as for IsometricRegistration. Copies and clones may be used in different threads.
///
/// Precompiled for the point types below; for others of PCL's include
/// posture/registration/impl/isometric_correspondence_estimation.hpp as well, and for those of
/// one's own see docs/installing.md. With PCL 1.13 both types have to be the same.
///
/// \see IsometricRegistration
template <typename PointSource, typename PointTarget, typename Scalar = float>
class IsometricCorrespondenceEstimation
    : public pcl::registration::CorrespondenceEstimationBase<PointSource, PointTarget, Scalar> {
 public:
  using Base = pcl::registration::CorrespondenceEstimationBase<PointSource, PointTarget, Scalar>;
  using PointCloudSourceConstPtr = typename Base::PointCloudSourceConstPtr;
  using PointCloudTargetConstPtr = typename Base::PointCloudTargetConstPtr;
  using Ptr = pcl::shared_ptr<IsometricCorrespondenceEstimation>;
  using ConstPtr = pcl::shared_ptr<const IsometricCorrespondenceEstimation>;

  IsometricCorrespondenceEstimation();

  /// An empty cloud is an input without matches, and withdraws the last result. Through a reference
  /// to the base, where it is another function, an empty target is refused and the last one kept.
  void setInputSource(const PointCloudSourceConstPtr& cloud);
  void setInputTarget(const PointCloudTargetConstPtr& cloud);

  /// The input and a surface over it, see IsometricRegistration. The polygons are used as long as
  /// this cloud is the input.
  void setSourceMesh(const PointCloudSourceConstPtr& cloud,
                     const std::vector<pcl::Vertices>& polygons);
  void setTargetMesh(const PointCloudTargetConstPtr& cloud,
                     const std::vector<pcl::Vertices>& polygons);

  /// Normals help to tell the outside of points from their inside; none are required. They take the
  /// place of those in the input and are used while there is one for each of its points.
  void setSourceNormals(pcl::PCLPointCloud2::ConstPtr normals) override;
  void setTargetNormals(pcl::PCLPointCloud2::ConstPtr normals) override;

  void setOptions(const RegistrationOptions& options);

  /// As IsometricRegistration::setObserver(), of the call that registers.
  void setObserver(Observer observer) { observer_ = std::move(observer); }

  /// One for each source point used that has a counterpart, in their order. index_query and
  /// index_match are numbers in the input and in the target cloud, `distance` the squared distance
  /// between them as the clouds lie.
  /// \param max_distance  pairs that lie farther apart are left out.
  void determineCorrespondences(pcl::Correspondences& correspondences,
                                double max_distance = std::numeric_limits<double>::max()) override;

  /// Those of determineCorrespondences() whose target point is matched to the same source point on
  /// the way back: one to one. Needs Method::REFINED; as published there is no way back.
  void determineReciprocalCorrespondences(
      pcl::Correspondences& correspondences,
      double max_distance = std::numeric_limits<double>::max()) override;

  typename Base::Ptr clone() const override;

  /// Of the last registration. Rows are the source's points used, vertices the target's points
  /// used, each numbered in the order of the indices where they are set.
  const RegistrationResult& getResult() const { return clouds_.result; }
  const std::string& getMessage() const { return clouds_.result.message; }

 private:
  /// The last result is no longer one for the inputs.
  void withdraw(const std::string& message);
  /// Registers if something has changed. \return whether there are inputs.
  bool update();
  CloudSide sourceSide() const;
  CloudSide targetSide() const;
  /// With the distances between the clouds, those above the largest left out.
  pcl::Correspondences asTheyLie(const pcl::Correspondences& matches, double max_distance) const;

  PointCloudSourceConstPtr source_mesh_;  ///< the cloud the polygons are over
  PointCloudTargetConstPtr target_mesh_;
  std::vector<pcl::Vertices> source_polygons_, target_polygons_;
  Points source_normals_, target_normals_;
  RegistrationOptions options_;
  Observer observer_;
  bool changed_ = true;
  // Those of the last registration: the base has setters that set no flag.
  pcl::Indices used_;
  PointCloudSourceConstPtr used_source_;
  PointCloudTargetConstPtr used_target_;
  std::size_t used_source_size_ = 0, used_target_size_ = 0;
  RegisteredClouds clouds_;

 public:
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

extern template class IsometricCorrespondenceEstimation<pcl::PointXYZ, pcl::PointXYZ>;
extern template class IsometricCorrespondenceEstimation<pcl::PointXYZI, pcl::PointXYZI>;
extern template class IsometricCorrespondenceEstimation<pcl::PointXYZRGB, pcl::PointXYZRGB>;
extern template class IsometricCorrespondenceEstimation<pcl::PointNormal, pcl::PointNormal>;
extern template class IsometricCorrespondenceEstimation<pcl::PointXYZRGBNormal,
                                                        pcl::PointXYZRGBNormal>;

}  // namespace posture
