// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <posture/registration/impl/cloud_side.hpp>
#include <posture/registration/isometric_correspondence_estimation.h>

#include <pcl/conversions.h>
#include <pcl/memory.h>

namespace posture {

template <typename PointSource, typename PointTarget, typename Scalar>
IsometricCorrespondenceEstimation<PointSource, PointTarget, Scalar>::
    IsometricCorrespondenceEstimation() {
  this->corr_name_ = "IsometricCorrespondenceEstimation";
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricCorrespondenceEstimation<PointSource, PointTarget, Scalar>::withdraw(
    const std::string& message) {
  clouds_ = {};
  clouds_.result.message = message;
  changed_ = true;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricCorrespondenceEstimation<PointSource, PointTarget, Scalar>::setInputSource(
    const PointCloudSourceConstPtr& cloud) {
  Base::setInputSource(cloud);
  if (cloud->empty()) withdraw("source has no points");
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricCorrespondenceEstimation<PointSource, PointTarget, Scalar>::setInputTarget(
    const PointCloudTargetConstPtr& cloud) {
  if (!cloud->empty()) {
    Base::setInputTarget(cloud);
    return;
  }
  this->target_ = cloud;  // the base refuses it
  withdraw("target has no points");
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricCorrespondenceEstimation<PointSource, PointTarget, Scalar>::setSourceMesh(
    const PointCloudSourceConstPtr& cloud, const std::vector<pcl::Vertices>& polygons) {
  setInputSource(cloud);
  source_mesh_ = cloud;
  source_polygons_ = polygons;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricCorrespondenceEstimation<PointSource, PointTarget, Scalar>::setTargetMesh(
    const PointCloudTargetConstPtr& cloud, const std::vector<pcl::Vertices>& polygons) {
  setInputTarget(cloud);
  target_mesh_ = cloud;
  target_polygons_ = polygons;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricCorrespondenceEstimation<PointSource, PointTarget, Scalar>::setSourceNormals(
    pcl::PCLPointCloud2::ConstPtr normals) {
  source_normals_ = toNormals(*normals);
  changed_ = true;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricCorrespondenceEstimation<PointSource, PointTarget, Scalar>::setTargetNormals(
    pcl::PCLPointCloud2::ConstPtr normals) {
  target_normals_ = toNormals(*normals);
  changed_ = true;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricCorrespondenceEstimation<PointSource, PointTarget, Scalar>::setOptions(
    const RegistrationOptions& options) {
  options_ = options;
  changed_ = true;
}

template <typename PointSource, typename PointTarget, typename Scalar>
bool IsometricCorrespondenceEstimation<PointSource, PointTarget, Scalar>::update() {
  // Cleared, as the base would otherwise build search trees, which are not used.
  changed_ = changed_ || this->source_cloud_updated_ || this->target_cloud_updated_;
  this->source_cloud_updated_ = this->target_cloud_updated_ = false;
  // The base writes into indices of its own making, which copies share.
  if (this->indices_ && this->fake_indices_)
    this->indices_ = pcl::make_shared<pcl::Indices>(*this->indices_);
  if (!this->initCompute()) {
    withdraw("an input was not set");
    return false;
  }
  const bool same_clouds = this->input_ == used_source_ && this->target_ == used_target_ &&
                           this->input_->size() == used_source_size_ &&
                           this->target_->size() == used_target_size_;
  if (!changed_ && same_clouds && used_ == *this->indices_) return true;
  RegistrationOptions options = options_;
  options.both_ways = true;
  // Unless neither happens.
  withdraw("the observer ended the last registration, or memory ran out");
  clouds_ = registerClouds(sourceSide(), targetSide(), options, observer_);
  used_ = *this->indices_;
  used_source_ = this->input_;
  used_target_ = this->target_;
  used_source_size_ = this->input_->size();
  used_target_size_ = this->target_->size();
  changed_ = false;
  return true;
}

template <typename PointSource, typename PointTarget, typename Scalar>
CloudSide IsometricCorrespondenceEstimation<PointSource, PointTarget, Scalar>::sourceSide() const {
  const bool is_mesh = source_mesh_ == this->input_;
  return cloudSide(*this->input_,
                   *this->indices_,
                   is_mesh ? source_polygons_ : std::vector<pcl::Vertices>(),
                   source_normals_);
}

template <typename PointSource, typename PointTarget, typename Scalar>
CloudSide IsometricCorrespondenceEstimation<PointSource, PointTarget, Scalar>::targetSide() const {
  const bool is_mesh = target_mesh_ == this->target_;
  return cloudSide(*this->target_,
                   this->target_indices_ ? *this->target_indices_ : allOf(*this->target_),
                   is_mesh ? target_polygons_ : std::vector<pcl::Vertices>(),
                   target_normals_);
}

template <typename PointSource, typename PointTarget, typename Scalar>
pcl::Correspondences IsometricCorrespondenceEstimation<PointSource, PointTarget, Scalar>::asTheyLie(
    const pcl::Correspondences& matches, double max_distance) const {
  pcl::Correspondences within;
  for (pcl::Correspondence match : matches) {
    const auto& from = (*this->input_)[match.index_query];
    const auto& to = (*this->target_)[match.index_match];
    match.distance = (from.getVector3fMap() - to.getVector3fMap()).squaredNorm();
    if (match.distance <= max_distance * max_distance) within.push_back(match);
  }
  return within;
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricCorrespondenceEstimation<PointSource, PointTarget, Scalar>::determineCorrespondences(
    pcl::Correspondences& correspondences, double max_distance) {
  correspondences.clear();
  if (!update()) return;
  correspondences = asTheyLie(clouds_.matches, max_distance);
  this->deinitCompute();
}

template <typename PointSource, typename PointTarget, typename Scalar>
void IsometricCorrespondenceEstimation<PointSource, PointTarget, Scalar>::
    determineReciprocalCorrespondences(pcl::Correspondences& correspondences, double max_distance) {
  correspondences.clear();
  if (!update()) return;
  correspondences = asTheyLie(clouds_.reciprocal_matches, max_distance);
  this->deinitCompute();
}

template <typename PointSource, typename PointTarget, typename Scalar>
auto IsometricCorrespondenceEstimation<PointSource, PointTarget, Scalar>::clone() const ->
    typename Base::Ptr {
  return pcl::make_shared<IsometricCorrespondenceEstimation>(*this);
}

}  // namespace posture
