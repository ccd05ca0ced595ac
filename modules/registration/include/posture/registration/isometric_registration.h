// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/registration/register_clouds.h>

#include <pcl/PolygonMesh.h>
#include <pcl/point_types.h>
#include <pcl/registration/registration.h>

#include <cstddef>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

namespace posture {

/// Registration of two scans of one bending body behind PCL's interface: registerShapes() where a
/// program has pcl::IterativeClosestPoint. No starting alignment is needed, and none is used: the
/// guess that align() takes has no influence, and neither have the base's settings of iterations,
/// thresholds, estimators and rejectors. Scans may be in different units.
///
/// Inputs. Clouds, organised or not, in any frame and unit: points that are not finite were not
/// seen. The whole of an organised cloud counts as one view, wherever it was moved; the sensor
/// origin, where the points may have been seen from there, helps to tell the outside. Those who
/// have surfaces give them by setSourceMesh() and setTargetMesh(): they are used as they are, while
/// through points alone a surface is laid first. With indices only the points they name take part,
/// in their order, and of a mesh the triangles between them. Left and right are told apart by the
/// outside of the surfaces: of a mesh that is inside out and more open than cleanMesh() can tell
/// the mirror image is found.
///
/// After align(output):
///  - output[i] is the i-th source point used, deformed onto the target, in the target's unit; its
///    normal is turned by the local rotation, its other fields are kept. Points that are not finite
///    stay as they are. Points without a counterpart go where the rest of the body takes them.
///  - hasConverged(): the data decide, Status::REGISTERED; if not, getMessage() says why. Where
///    they do not decide, the best guess is in `output` and behind all accessors nevertheless;
///    where they cannot be used at all, `output` is the source as it was and
///    getCorrespondences() is empty. Data never make align() throw; an observer may.
///  - getFinalTransformation(): rotation and translation, always of determinant 1, of least squares
///    over getCorrespondences(), as pcl::registration::TransformationEstimationSVD finds them, of
///    meshes that were denoised between the denoised points. A body that bends does not follow it.
///    It has no scale, so that its rotation can be read off: getResult().scale has that, and
///    TransformationEstimationSVDScale makes the matrix with it.
///  - getFitnessScore(): of the deformed points. Called through a reference to the base, where it
///    is another function, it judges the source moved by getFinalTransformation() alone, which
///    says little about a body that bends.
/// A new input or new indices withdraw the last answer: hasConverged() is false from then on, an
/// empty cloud included, which PCL's classes refuse and keep the last one instead. An empty source
/// also drops the indices that were set.
///
/// Copies share the input clouds, which are const, search methods that were set with
/// force_no_recompute, and what was handed in for settings without influence; nothing else. Objects
/// may be used in different threads. Nothing is printed but what the base prints where an input was
/// never set, and pcl::fromPCLPointCloud2 on fields that the cloud of a pcl::PolygonMesh lacks.
///
/// Indices have to be numbers of points of the source when align() is called, which the base does
/// not check: after a smaller source they are to be set anew.
///
/// Inputs are known by their pointers: a cloud whose points were changed in place has to be set
/// anew.
///
/// Precompiled for the point types below; for others of PCL's include
/// posture/registration/impl/isometric_registration.hpp as well, and for those of one's own see
/// docs/installing.md.
/// \see registerShapes(), IsometricCorrespondenceEstimation
template <typename PointSource, typename PointTarget, typename Scalar = float>
class IsometricRegistration : public pcl::Registration<PointSource, PointTarget, Scalar> {
 public:
  using Base = pcl::Registration<PointSource, PointTarget, Scalar>;
  using Matrix4 = typename Base::Matrix4;
  using PointCloudSource = typename Base::PointCloudSource;
  using PointCloudSourceConstPtr = typename Base::PointCloudSourceConstPtr;
  using PointCloudTarget = typename Base::PointCloudTarget;
  using PointCloudTargetConstPtr = typename Base::PointCloudTargetConstPtr;
  using Ptr = pcl::shared_ptr<IsometricRegistration>;
  using ConstPtr = pcl::shared_ptr<const IsometricRegistration>;
  using VisualizationCallback = std::function<typename Base::UpdateVisualizerCallbackSignature>;
  using Base::getFitnessScore;

  IsometricRegistration();
  IsometricRegistration(const IsometricRegistration& other);
  IsometricRegistration& operator=(const IsometricRegistration& other);
  ~IsometricRegistration() override = default;

  /// Points alone: polygons that were set are dropped.
  void setInputSource(const PointCloudSourceConstPtr& cloud) override;
  void setInputTarget(const PointCloudTargetConstPtr& cloud) override;

  /// The input and a surface over it. Polygons of more than three corners are cut by cutPolygon();
  /// without polygons the points are used. Polygons that name points that do not exist are bad
  /// data: align() does not converge. \param polygons  their corners are numbers in the cloud,
  /// counter-clockwise from outside.
  void setSourceMesh(const PointCloudSourceConstPtr& cloud,
                     const std::vector<pcl::Vertices>& polygons);
  void setTargetMesh(const PointCloudTargetConstPtr& cloud,
                     const std::vector<pcl::Vertices>& polygons);
  /// The same from PCL's mesh: its cloud, as pcl::fromPCLPointCloud2 reads it, becomes the input;
  /// positions in double precision, which that does not read, are rounded to single.
  void setSourceMesh(const pcl::PolygonMesh& mesh);
  void setTargetMesh(const pcl::PolygonMesh& mesh);

  void setIndices(const pcl::IndicesPtr& indices) override;
  void setIndices(const pcl::IndicesConstPtr& indices) override;
  void setIndices(const pcl::PointIndicesConstPtr& indices) override;
  void setIndices(std::size_t row_start,
                  std::size_t col_start,
                  std::size_t nb_rows,
                  std::size_t nb_cols) override;

  /// Sets what align() calls once, with the deformed source, the places of the matched points in it
  /// and the numbers of their matches in the target. As in PCL it is also called at once, with both
  /// inputs and no indices; here only where both are set, while through a reference to the base PCL
  /// hands it inputs that do not exist. \return whether there is a callback to call.
  bool registerVisualizationCallback(VisualizationCallback& callback);

  void setOptions(const RegistrationOptions& options) { options_ = options; }
  const RegistrationOptions& getOptions() const { return options_; }

  /// Told of each stage while align() runs, from the thread that called it; none: an empty one.
  /// What it throws leaves align(), which has no answer then; so does running out of memory.
  void setObserver(Observer observer) { observer_ = std::move(observer); }

  /// What registerShapes() says, in double precision. Row i is output[i]; vertices of the target
  /// are points of the target cloud, faces the triangles its polygons were cut into. segmentShape()
  /// and deformedSurface() take the result of registerShapes(), not this: see getSurface().
  const RegistrationResult& getResult() const { return clouds_.result; }
  /// The surface of the source and where its vertices went, for segmentRigidParts() and
  /// applyDeformation(): of a mesh, or laid through the points, its vertices in an order of their
  /// own. Without vertices where there is no answer.
  const DeformedSurface& getSurface() const { return clouds_.surface; }
  /// One line: how it went, or why there is no answer.
  const std::string& getMessage() const { return clouds_.result.message; }

  /// One for each source point used that has a counterpart. index_query is its number in the input
  /// cloud, index_match the nearest point of the target cloud, `distance` squared and from where
  /// the point is in `output`.
  pcl::CorrespondencesConstPtr getCorrespondences() const { return this->correspondences_; }

  /// Other points in the source's frame - markers, a denser scan - taken along with its surface:
  /// applyDeformation(). Fields are treated as in `output`. Empty where there is no answer.
  PointCloudSource deform(const PointCloudSource& points) const;

  /// The mean squared distance from the points in `output` to the nearest of the target. As in PCL
  /// those farther are left out whose squared distance is above max_range, and where none is left
  /// it is the largest double; so it is where there is no answer.
  double getFitnessScore(double max_range = std::numeric_limits<double>::max());

 protected:
  void computeTransformation(PointCloudSource& output, const Matrix4& guess) override;

 private:
  /// The last answer is no longer one for the inputs.
  void withdraw(const std::string& message);
  /// Takes apart what a copy of the base shares.
  void detach();
  void showOutcome(const PointCloudSource& output) const;

  std::vector<pcl::Vertices> source_polygons_, target_polygons_;
  RegistrationOptions options_;
  Observer observer_;
  RegisteredClouds clouds_;

 public:
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

extern template class IsometricRegistration<pcl::PointXYZ, pcl::PointXYZ>;
extern template class IsometricRegistration<pcl::PointXYZI, pcl::PointXYZI>;
extern template class IsometricRegistration<pcl::PointXYZRGB, pcl::PointXYZRGB>;
extern template class IsometricRegistration<pcl::PointNormal, pcl::PointNormal>;
extern template class IsometricRegistration<pcl::PointXYZRGBNormal, pcl::PointXYZRGBNormal>;

}  // namespace posture
