// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/registration/impl/cloud_side.hpp>
#include <posture/registration/isometric_registration.h>

#include <pcl/conversions.h>
#include <pcl/memory.h>

namespace posture {

template <typename PointSource, typename PointTarget, typename Scalar>
IsometricRegistration<PointSource, PointTarget, Scalar>::IsometricRegistration() {
  this->reg_name_ = "IsometricRegistration";
  withdraw("nothing was aligned yet");
}

template <typename PointSource, typename PointTarget, typename Scalar>
IsometricRegistration<PointSource, PointTarget, Scalar>::IsometricRegistration(
    const IsometricRegistration& other)
    : Base(other) {
  *this = other;
}

template <typename PointSource, typename PointTarget, typename Scalar>
IsometricRegistration<PointSource, PointTarget, Scalar>&
IsometricRegistration<PointSource, PointTarget, Scalar>::operator=(
    const IsometricRegistration& other) {
  if (this == &other) return *this;
  Base::operator=(other);
  source_polygons_ = other.source_polygons_;
  target_polygons_ = other.target_polygons_;
  options_ = other.options_;
  observer_ = other.observer_;
  clouds_ = other.clouds_;
  detach();
  return *this;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricRegistration<PointSource, PointTarget, Scalar>::detach() {
  if (this->indices_) this->indices_ = pcl::make_shared<pcl::Indices>(*this->indices_);
  this->correspondences_ = pcl::make_shared<pcl::Correspondences>(*this->correspondences_);
  if (this->correspondence_estimation_)
    this->correspondence_estimation_ = this->correspondence_estimation_->clone();
  if (!this->force_no_recompute_) {
    this->tree_ = pcl::make_shared<typename Base::KdTree>();
    if (this->target_ && hasFinitePoint(*this->target_)) this->tree_->setInputCloud(this->target_);
  }
  if (!this->force_no_recompute_reciprocal_) {
    this->tree_reciprocal_ = pcl::make_shared<typename Base::KdTreeReciprocal>();
    this->source_cloud_updated_ = true;
  }
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricRegistration<PointSource, PointTarget, Scalar>::withdraw(const std::string& message) {
  clouds_ = {};
  clouds_.result.message = message;
  this->correspondences_ = pcl::make_shared<pcl::Correspondences>();
  this->final_transformation_ = this->transformation_ = Matrix4::Identity();
  this->converged_ = false;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricRegistration<PointSource, PointTarget, Scalar>::setInputSource(
    const PointCloudSourceConstPtr& cloud) {
  if (!cloud->empty()) {
    Base::setInputSource(cloud);
  } else {  // which the base refuses
    this->input_ = cloud;
    this->indices_ = pcl::make_shared<pcl::Indices>();  // those that were set name points not there
    this->fake_indices_ = true;
    this->use_indices_ = false;
  }
  source_polygons_.clear();
  withdraw(cloud->empty() ? "source has no points" : "the source is new and was not aligned yet");
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricRegistration<PointSource, PointTarget, Scalar>::setInputTarget(
    const PointCloudTargetConstPtr& cloud) {
  if (!cloud->empty())
    Base::setInputTarget(cloud);
  else  // which the base refuses
    this->target_ = cloud;
  if (!hasFinitePoint(*cloud)) this->target_cloud_updated_ = false;  // or it builds a search tree
  target_polygons_.clear();
  withdraw(cloud->empty() ? "target has no points" : "the target is new and was not aligned yet");
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricRegistration<PointSource, PointTarget, Scalar>::setSourceMesh(
    const PointCloudSourceConstPtr& cloud, const std::vector<pcl::Vertices>& polygons) {
  setInputSource(cloud);
  source_polygons_ = polygons;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricRegistration<PointSource, PointTarget, Scalar>::setTargetMesh(
    const PointCloudTargetConstPtr& cloud, const std::vector<pcl::Vertices>& polygons) {
  setInputTarget(cloud);
  target_polygons_ = polygons;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricRegistration<PointSource, PointTarget, Scalar>::setSourceMesh(
    const pcl::PolygonMesh& mesh) {
  setSourceMesh(pcl::make_shared<PointCloudSource>(pointsOf<PointSource>(mesh.cloud)),
                mesh.polygons);
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricRegistration<PointSource, PointTarget, Scalar>::setTargetMesh(
    const pcl::PolygonMesh& mesh) {
  setTargetMesh(pcl::make_shared<PointCloudTarget>(pointsOf<PointTarget>(mesh.cloud)),
                mesh.polygons);
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricRegistration<PointSource, PointTarget, Scalar>::setIndices(
    const pcl::IndicesPtr& indices) {
  Base::setIndices(indices);
  withdraw("the indices are new and nothing was aligned yet");
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricRegistration<PointSource, PointTarget, Scalar>::setIndices(
    const pcl::IndicesConstPtr& indices) {
  setIndices(pcl::make_shared<pcl::Indices>(*indices));
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricRegistration<PointSource, PointTarget, Scalar>::setIndices(
    const pcl::PointIndicesConstPtr& indices) {
  setIndices(pcl::make_shared<pcl::Indices>(indices->indices));
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricRegistration<PointSource, PointTarget, Scalar>::setIndices(std::size_t row_start,
                                                                         std::size_t col_start,
                                                                         std::size_t nb_rows,
                                                                         std::size_t nb_cols) {
  Base::setIndices(row_start, col_start, nb_rows, nb_cols);
  withdraw("the indices are new and nothing was aligned yet");
}

template <typename PointSource, typename PointTarget, typename Scalar>
bool IsometricRegistration<PointSource, PointTarget, Scalar>::registerVisualizationCallback(
    VisualizationCallback& callback) {
  if (this->input_ && this->target_) return Base::registerVisualizationCallback(callback);
  if (callback) this->update_visualizer_ = callback;
  return static_cast<bool>(callback);
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricRegistration<PointSource, PointTarget, Scalar>::computeTransformation(
    PointCloudSource& output, const Matrix4&) {
  // Unless neither happens.
  withdraw("the observer ended the last align(), or memory ran out");
  clouds_ = registerClouds(cloudSide(*this->input_, *this->indices_, source_polygons_),
                           cloudSide(*this->target_, allOf(*this->target_), target_polygons_),
                           options_,
                           observer_);
  this->correspondences_ = pcl::make_shared<pcl::Correspondences>(clouds_.matches);
  if (!clouds_.answered()) return;
  writePlaces(clouds_.result.deformed, clouds_.normals, output);
  this->final_transformation_ = this->transformation_ =
      clouds_.T_target_source.matrix().template cast<Scalar>();
  this->converged_ = clouds_.result.status == Status::REGISTERED;
  if (this->update_visualizer_) showOutcome(output);
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricRegistration<PointSource, PointTarget, Scalar>::showOutcome(
    const PointCloudSource& output) const {
  pcl::Indices matched, matches;
  const std::vector<SurfacePoint>& places = clouds_.result.correspondence.on_target;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (places[i].vertex < 0) continue;
    matched.push_back(static_cast<pcl::index_t>(i));
    matches.push_back(places[i].vertex);
  }
  this->update_visualizer_(output, matched, *this->target_, matches);
}

template <typename PointSource, typename PointTarget, typename Scalar>
auto IsometricRegistration<PointSource, PointTarget, Scalar>::deform(
    const PointCloudSource& points) const -> PointCloudSource {
  if (!clouds_.answered()) return {};
  const PointCloud places = deformed(clouds_, toPointCloud(points));
  PointCloudSource moved = points;
  writePlaces(places.points, places.normals, moved);
  return moved;
}

template <typename PointSource, typename PointTarget, typename Scalar>
double IsometricRegistration<PointSource, PointTarget, Scalar>::getFitnessScore(double max_range) {
  if (!clouds_.answered()) return std::numeric_limits<double>::max();
  return meanSquaredDistance(
      clouds_.result.deformed, toPointCloud(*this->target_).points, max_range);
}

}  // namespace posture
