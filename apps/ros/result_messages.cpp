// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "result_messages.h"

#include <posture/pipeline/deformed_surface.h>
#include <posture/report/colors.h>
#include <posture/report/table.h>

#include "cloud_message.h"
#include <algorithm>
#include <cmath>

namespace posture::app {
namespace {

using diagnostic_msgs::DiagnosticStatus;
using sensor_msgs::PointCloud2;
using visualization_msgs::Marker;
using visualization_msgs::MarkerArray;

PointCloud2 colored(const SideView& side, const Colors& colors) {
  PointCloud cloud;
  cloud.points = side.shape.cloud.points;
  cloud.colors = colors;
  cloud.width = side.shape.cloud.width;
  return messageOf(cloud, side.message.header);
}

void appendCounterparts(PointCloud2& message, const std::string& name, const Correspondence& map) {
  std::vector<std::int32_t> counterpart;
  std::vector<float> confidence;
  for (std::size_t i = 0; i < map.on_target.size(); ++i) {
    counterpart.push_back(map.on_target[i].vertex);
    confidence.push_back(static_cast<float>(map.confidence[static_cast<Eigen::Index>(i)]));
  }
  appendField(message, name, counterpart);
  appendField(message, "confidence", confidence);
}

std_msgs::ColorRGBA rgba(const Colors& colors, Eigen::Index i) {
  std_msgs::ColorRGBA color;
  color.r = static_cast<float>(colors(i, 0)) / 255;
  color.g = static_cast<float>(colors(i, 1)) / 255;
  color.b = static_cast<float>(colors(i, 2)) / 255;
  color.a = 1;
  return color;
}

geometry_msgs::Point pointAt(const Points& points, Eigen::Index i) {
  geometry_msgs::Point point;
  point.x = points(i, 0);
  point.y = points(i, 1);
  point.z = points(i, 2);
  return point;
}

Marker emptyMarker(const std_msgs::Header& header, const std::string& ns, int type) {
  Marker marker;
  marker.header = header;
  marker.ns = ns;
  marker.type = type;
  marker.pose.orientation.w = 1;
  return marker;
}

/// Side of the square each point of a shape stands for.
double spacingOf(const ShapeSummary& summary, const Shape& shape) {
  return std::sqrt(summary.area /
                   static_cast<double>(std::max<Eigen::Index>(1, shape.cloud.points.rows())));
}

DiagnosticStatus status(std::uint8_t level, const std::string& message) {
  DiagnosticStatus status;
  status.level = static_cast<DiagnosticStatus::_level_type>(level);
  status.message = message;
  return status;
}

void add(DiagnosticStatus& status, const std::string& key, const std::string& value) {
  diagnostic_msgs::KeyValue entry;
  entry.key = key;
  entry.value = value;
  status.values.push_back(entry);
}

}  // namespace

PointCloud2 registeredCloud(const SideView& source,
                            const SideView& target,
                            const RegistrationResult& result) {
  const DeformedSurface surface = deformedSurface(source.shape, result);
  PointCloud2 message =
      moved(source.message, result.deformed, turnedNormals(surface, source.shape.cloud));
  message.header = target.message.header;
  return message;
}

PointCloud2 coloredSource(const SideView& source, const RegistrationResult& result) {
  const Colors colors =
      greyWhereRejected(placeColors(source.shape.cloud.points), result.correspondence);
  PointCloud2 message = colored(source, colors);
  appendCounterparts(message, "target", result.correspondence);
  return message;
}

PointCloud2 coloredTarget(const SideView& source,
                          const SideView& target,
                          const RegistrationResult& result) {
  const Colors colors = transferColors(placeColors(source.shape.cloud.points),
                                       result.correspondence,
                                       target.shape,
                                       result.target_scan);
  PointCloud2 message = colored(target, colors);
  if (result.back) appendCounterparts(message, "source", result.back->correspondence);
  return message;
}

Marker correspondenceLines(const SideView& source,
                           const SideView& target,
                           const RegistrationResult& result) {
  const Points &from = source.shape.cloud.points, &to = target.shape.cloud.points;
  const Colors colors = placeColors(from);
  std::vector<int> matched;
  for (int i = 0; i < from.rows(); ++i)
    if (result.correspondence.on_target[i].vertex >= 0) matched.push_back(i);

  Marker marker = emptyMarker(target.message.header, "correspondences", Marker::LINE_LIST);
  marker.scale.x = spacingOf(result.target, target.shape) / 5;
  const std::size_t count = matched.size(), shown = std::min<std::size_t>(count, MOST_LINES);
  for (std::size_t k = 0; k < shown; ++k) {
    const int i = matched[k * count / shown];
    marker.points.push_back(pointAt(from, i));
    marker.points.push_back(pointAt(to, result.correspondence.on_target[i].vertex));
    marker.colors.insert(marker.colors.end(), 2, rgba(colors, i));
  }
  if (shown == 0) marker.action = Marker::DELETE;
  return marker;
}

MarkerArray segmentMarkers(const SideView& source,
                           const RegistrationResult& result,
                           const ShapeSegments* segments) {
  MarkerArray array;
  array.markers.push_back(emptyMarker(source.message.header, "segments", Marker::POINTS));
  array.markers.front().action = Marker::DELETEALL;
  if (segments == nullptr) return array;
  const Colors palette =
      partPalette(segments->parts.count, segments->parts.label, segments->surface.mesh.faces);
  const double size = spacingOf(result.source, source.shape);
  for (int part = 0; part < segments->parts.count; ++part) {
    Marker marker = emptyMarker(source.message.header, "segments", Marker::POINTS);
    marker.id = part;
    marker.scale.x = marker.scale.y = size;
    marker.color = rgba(palette, part);
    array.markers.push_back(marker);
  }
  for (std::size_t i = 0; i < segments->label.size(); ++i)
    if (const int part = segments->label[i]; part >= 0)
      array.markers[static_cast<std::size_t>(part) + 1].points.push_back(
          pointAt(source.shape.cloud.points, static_cast<Eigen::Index>(i)));
  return array;
}

DiagnosticStatus outcome(const RegistrationResult& result,
                         const ShapeSegments* segments,
                         double seconds) {
  const bool registered = result.status == Status::REGISTERED;
  DiagnosticStatus message =
      status(registered ? DiagnosticStatus::OK : DiagnosticStatus::WARN, result.message);
  add(message, "status", registered ? "registered" : "undecided");
  if (!result.alternatives.empty()) add(message, "trust", formatFixed(result.trust, 3));
  add(message, "source points", std::to_string(presentCount(result)));
  add(message, "share mapped", formatFixed(mappedShare(result), 3));
  add(message, "scale", formatShort(result.scale));
  if (segments != nullptr) add(message, "parts", std::to_string(segments->parts.count));
  if (result.back) add(message, "mean miss there and back", formatShort(result.back->mean_miss));
  add(message, "seconds", formatFixed(seconds, 1));
  return message;
}

DiagnosticStatus failure(const std::string& message) {
  return status(DiagnosticStatus::ERROR, message);
}

}  // namespace posture::app
