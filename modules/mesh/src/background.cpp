// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/unions.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/background.h>
#include <posture/mesh/require_mesh.h>

#include <Eigen/Geometry>

#include "sampled_planes.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace posture {
namespace {

/// Of the area, what is in none of the planes: without it there is no body.
constexpr double LEAST_BODY = 0.01;

constexpr int MOST_PLANES = 4;

/// Where a point lies along a plane.
class Along {
 public:
  explicit Along(const Plane& plane) {
    x_ = plane.normal.unitOrthogonal();
    y_ = plane.normal.cross(x_);
  }
  Eigen::Vector2d operator()(const Eigen::RowVector3d& point) const {
    return {point.dot(x_), point.dot(y_)};
  }

 private:
  Eigen::RowVector3d x_, y_;
};

/// Of the samples in a plane, those that none of the others lies over.
double bareShare(const AreaSamples& samples, const Plane& plane, const Along& along) {
  constexpr double CELLS = 32;  // to a unit: four samples in each of a sheet
  using Cell = std::pair<int, int>;
  const auto cellOf = [&](int i) {
    const Eigen::Vector2d at = along(samples.points.row(i));
    return Cell(static_cast<int>(std::floor(CELLS * at.x())),
                static_cast<int>(std::floor(CELLS * at.y())));
  };
  std::set<Cell> covered;
  std::vector<int> held;
  for (int i = 0; i < samples.points.rows(); ++i) {
    if (plane.holds(samples, i))
      held.push_back(i);
    else
      covered.insert(cellOf(i));
  }
  const auto bare =
      std::count_if(held.begin(), held.end(), [&](int i) { return covered.count(cellOf(i)) == 0; });
  return static_cast<double>(bare) / static_cast<double>(held.size());
}

/// Whether a plane is found in most directions from a place along it.
bool goesAround(const AreaSamples& samples,
                const Plane& plane,
                const Along& along,
                const Eigen::Vector2d& center) {
  constexpr int DIRECTIONS = 8, MOST_DIRECTIONS = 6;
  constexpr double SOME = 0.02;
  std::array<int, DIRECTIONS> count{};
  int held = 0;
  for (int i = 0; i < samples.points.rows(); ++i) {
    if (!plane.holds(samples, i)) continue;
    const Eigen::Vector2d way = along(samples.points.row(i)) - center;
    const double turn = std::atan2(way.y(), way.x()) / (2 * M_PI) + 0.5;
    ++count[std::min(DIRECTIONS - 1, static_cast<int>(DIRECTIONS * turn))];
    ++held;
  }
  return std::count_if(count.begin(), count.end(), [&](int c) { return c > SOME * held; }) >=
         MOST_DIRECTIONS;
}

/// How far a plane goes in directions along it.
class Extent {
 public:
  /// \param without  the share of what is in it that may lie farther out in each direction.
  Extent(const AreaSamples& samples, const Plane& plane, double without = 0) : along_(plane) {
    std::vector<Eigen::Vector2d> held;
    for (int i = 0; i < samples.points.rows(); ++i)
      if (plane.holds(samples, i)) held.push_back(along_(samples.points.row(i)));
    const auto last = static_cast<std::size_t>((1 - without) * static_cast<double>(held.size()));
    for (int k = 0; k < DIRECTIONS; ++k) {
      const double angle = 2 * M_PI * k / DIRECTIONS;
      direction_[k] = {std::cos(angle), std::sin(angle)};
      std::vector<double> ends;
      ends.reserve(held.size());
      for (const Eigen::Vector2d& at : held) ends.push_back(at.dot(direction_[k]));
      std::sort(ends.begin(), ends.end());
      end_[k] = ends[std::min(last, ends.size() - 1)];
    }
  }

  /// Whether a point is over or under it, and not farther than a margin past its ends.
  bool has(const Eigen::RowVector3d& point, double margin = 0) const {
    const Eigen::Vector2d at = along_(point);
    for (int k = 0; k < DIRECTIONS; ++k)
      if (at.dot(direction_[k]) > end_[k] + margin) return false;
    return true;
  }

 private:
  static constexpr int DIRECTIONS = 16;

  Along along_;
  std::array<Eigen::Vector2d, DIRECTIONS> direction_;
  std::array<double, DIRECTIONS> end_;
};

/// Of some samples, those that lie over a plane, and not past its ends. So does a body on a floor,
/// but what a bent sheet has to either side of where it is nearly flat does not.
double shareOver(const AreaSamples& samples, const Plane& plane, const std::vector<int>& some) {
  const Extent extent(samples, plane);
  const auto over = std::count_if(
      some.begin(), some.end(), [&](int i) { return extent.has(samples.points.row(i)); });
  return static_cast<double>(over) / static_cast<double>(some.size());
}

/// Whether a plane is background of the samples in none of the planes. Its normal then points to
/// them.
bool isBehind(const AreaSamples& samples, const std::vector<int>& body, Plane& plane) {
  constexpr double ON_ONE_SIDE = 0.75, MOSTLY_BARE = 0.5, MOSTLY_OVER = 0.5, HIGH = 4;
  std::vector<double> heights;
  heights.reserve(body.size());
  for (int i : body) heights.push_back(plane.height(samples.points.row(i)));
  const auto above =
      std::count_if(heights.begin(), heights.end(), [](double height) { return height > 0; });
  if (2 * above < static_cast<std::ptrdiff_t>(body.size())) {
    plane.normal = -plane.normal;
    plane.offset = -plane.offset;
    for (double& height : heights) height = -height;
  }
  const auto n = static_cast<double>(body.size());
  const auto share = [&](double least) {
    return static_cast<double>(std::count_if(
               heights.begin(), heights.end(), [&](double height) { return height > least; })) /
           n;
  };
  if (share(-HIGH * plane.reach) < ON_ONE_SIDE || share(HIGH * plane.reach) < 0.5) return false;
  const Along along(plane);
  Eigen::Vector2d center = Eigen::Vector2d::Zero();
  for (int i : body) center += along(samples.points.row(i)) / n;
  return bareShare(samples, plane, along) > MOSTLY_BARE &&
         shareOver(samples, plane, body) > MOSTLY_OVER && goesAround(samples, plane, along, center);
}

/// The planes behind or beneath a body, with normals that point to it.
std::vector<Plane> backgroundPlanes(const AreaSamples& samples) {
  std::vector<Plane> planes, background;
  std::vector<int> body(samples.points.rows());
  std::iota(body.begin(), body.end(), 0);
  while (static_cast<int>(planes.size()) < MOST_PLANES) {
    const std::optional<Plane> plane = largestPlane(samples, body);
    if (!plane) break;
    planes.push_back(*plane);
    body.erase(
        std::remove_if(body.begin(), body.end(), [&](int i) { return plane->holds(samples, i); }),
        body.end());
  }
  if (body.size() < LEAST_BODY * AreaSamples::MOST) return {};
  for (Plane& plane : planes)
    if (isBehind(samples, body, plane)) background.push_back(plane);
  return background;
}

/// Marks the faces in a plane and beyond it, but not limbs of the body that hang past its edge:
/// what goes on from the body, and is mostly farther out than the plane goes.
/// \param points  the mesh's vertices, in the unit of the plane.
/// \param extent  without the undersides of limbs that are in the plane, but past the edge.
void markBackground(const Points& points,
                    const Faces& faces,
                    const Plane& plane,
                    const Extent& extent,
                    std::vector<char>& background) {
  constexpr double MARGIN = 0.02;  // samples are 0.016 apart
  const auto isBody = [&](int v) { return plane.height(points.row(v)) > plane.reach; };
  const auto isPlane = [&](int v) {
    return std::abs(plane.height(points.row(v))) <= plane.reach && extent.has(points.row(v));
  };
  std::vector<char> is_at_body(points.rows(), 0);
  std::vector<int> beyond;  // faces that may hang past the edge
  Unions parts(static_cast<int>(points.rows()));
  for (int f = 0; f < faces.rows(); ++f) {
    const auto corners = faces.row(f);
    if (std::any_of(corners.begin(), corners.end(), isBody)) {
      for (int v : corners) is_at_body[v] = 1;
    } else if (std::all_of(corners.begin(), corners.end(), isPlane)) {
      background[f] = 1;
    } else {
      beyond.push_back(f);
      for (int k = 1; k < 3; ++k) parts.join(corners[0], corners[k]);
    }
  }
  const Vector areas = faceAreas({points, faces(beyond, Eigen::all)});
  std::vector<double> outside(points.rows(), 0);  // of each part: its area, what is under less
  std::vector<char> goes_on(points.rows(), 0);
  for (std::size_t i = 0; i < beyond.size(); ++i) {
    const Eigen::RowVector3i corners = faces.row(beyond[i]);
    const int part = parts.root(corners[0]);
    const Eigen::RowVector3d middle = points(corners, Eigen::all).colwise().mean();
    const double area = areas[static_cast<Eigen::Index>(i)];
    outside[part] += extent.has(middle, MARGIN) ? -area : area;
    for (int v : corners) goes_on[part] |= is_at_body[v];
  }
  for (int f : beyond) {
    const int part = parts.root(faces(f, 0));
    if (goes_on[part] == 0 || outside[part] <= 0) background[f] = 1;
  }
}

}  // namespace

std::vector<char> backgroundFaces(const TriangleMesh& mesh) {
  requireMesh(mesh);
  std::vector<char> background(mesh.faces.rows(), 0);
  const double unit = 1 / rootArea(mesh);
  if (!std::isfinite(unit)) return background;
  const AreaSamples samples(mesh);
  // Of what is in a plane: undersides of limbs that lie in it, but past its edge.
  constexpr double KNEES = 0.01;
  for (const Plane& plane : backgroundPlanes(samples))
    markBackground(
        unit * mesh.vertices, mesh.faces, plane, Extent(samples, plane, KNEES), background);
  return background;
}

}  // namespace posture
