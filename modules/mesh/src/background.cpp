// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/rng.h>
#include <posture/core/unions.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/background.h>
#include <posture/mesh/require_mesh.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>
#include <optional>
#include <set>
#include <utility>

namespace posture {
namespace {

/// Lengths are in square roots of the area, areas as shares of it.
constexpr int SAMPLES = 4096, SEEDS = 256;

/// How far around a seed a plane is begun with, and how far from it such a plane may be.
constexpr double SEED_RADIUS = 0.06, SEED_REACH = 0.005;

/// How thick a scanner makes a plane, at least and at most.
constexpr double LEAST_REACH = 0.002, MOST_REACH = 0.015;

/// Of what is within the most, what is within half of it: of a part of a body that is nearly flat
/// hardly more than half.
constexpr double LEAST_DENSE = 0.85;

/// Of the area: smaller planes are parts of bodies, or hardly matter.
constexpr double LEAST_PLANE = 0.05;

/// The same, of what is in none of the planes: without it there is no body.
constexpr double LEAST_BODY = 0.01;

constexpr int MOST_PLANES = 4;

/// Cosine: faces in a plane look that much along its normal.
constexpr double ALONG_NORMAL = 0.7;

/// Evenly over the area, in a unit in which that is one.
struct AreaSamples {
  explicit AreaSamples(const TriangleMesh& mesh);

  Points points, normals;
};

AreaSamples::AreaSamples(const TriangleMesh& mesh)
    : points(Points::Zero(SAMPLES, 3)), normals(Points::Zero(SAMPLES, 3)) {
  const Vector areas = faceAreas(mesh);
  const double total = areas.sum(), unit = 1 / std::sqrt(total);
  Rng rng(1);
  double before = 0;
  int sample = 0;
  for (int f = 0; f < mesh.faces.rows(); ++f) {
    const double after = before + areas[f];
    const Eigen::RowVector3d a = mesh.vertices.row(mesh.faces(f, 0)),
                             ab = mesh.vertices.row(mesh.faces(f, 1)) - a,
                             ac = mesh.vertices.row(mesh.faces(f, 2)) - a;
    const Eigen::RowVector3d normal = ab.cross(ac).normalized();
    for (; sample < SAMPLES && (sample + 0.5) * total < after * SAMPLES; ++sample) {
      double u = rng.uniform(), v = rng.uniform();
      if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
      }
      points.row(sample) = unit * (a + u * ab + v * ac);
      normals.row(sample) = normal;
    }
    before = after;
  }
  points.conservativeResize(sample, 3);
  normals.conservativeResize(sample, 3);
}

struct Plane {
  Eigen::RowVector3d normal = Eigen::RowVector3d::Zero();
  double offset = 0;
  double reach = SEED_REACH;  ///< what lies as far from it is in it

  double height(const Eigen::RowVector3d& point) const { return point.dot(normal) - offset; }

  bool holds(const AreaSamples& samples, int i) const {
    return std::abs(height(samples.points.row(i))) <= reach &&
           std::abs(samples.normals.row(i).dot(normal)) > ALONG_NORMAL;
  }
};

/// The plane that fits some samples best, and how far they are from it (root of the mean square).
std::pair<Plane, double> fitPlane(const AreaSamples& samples, const std::vector<int>& some) {
  const Points points = samples.points(some, Eigen::all);
  const Eigen::RowVector3d mean = points.colwise().mean();
  const Points about = points.rowwise() - mean;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> moments(about.transpose() * about);
  Plane plane;
  plane.normal = moments.eigenvectors().col(0).transpose();
  plane.offset = mean.dot(plane.normal);
  const double sum = std::max(0.0, moments.eigenvalues()[0]);
  return {plane, std::sqrt(sum / static_cast<double>(some.size()))};
}

std::vector<int> heldBy(const Plane& plane,
                        const AreaSamples& samples,
                        const std::vector<int>& among) {
  std::vector<int> held;
  std::copy_if(among.begin(), among.end(), std::back_inserter(held), [&](int i) {
    return plane.holds(samples, i);
  });
  return held;
}

/// The plane through a sample and what is near it, if that is flat.
std::optional<Plane> planeAround(int seed,
                                 const AreaSamples& samples,
                                 const std::vector<int>& among) {
  std::vector<int> near;
  const Eigen::RowVector3d center = samples.points.row(seed);
  std::copy_if(among.begin(), among.end(), std::back_inserter(near), [&](int i) {
    return (samples.points.row(i) - center).squaredNorm() < SEED_RADIUS * SEED_RADIUS;
  });
  constexpr std::size_t ENOUGH = 8;
  if (near.size() < ENOUGH) return std::nullopt;
  const auto [plane, scatter] = fitPlane(samples, near);
  return scatter < SEED_REACH ? std::optional(plane) : std::nullopt;
}

/// How far what is in a plane lies from it; none: it is no plane, or holds few of some samples.
std::optional<double> reachOf(Plane plane,
                              const AreaSamples& samples,
                              const std::vector<int>& among) {
  plane.reach = MOST_REACH;
  std::vector<double> distances;
  for (int i : heldBy(plane, samples, among))
    distances.push_back(std::abs(plane.height(samples.points.row(i))));
  std::sort(distances.begin(), distances.end());
  const auto n = static_cast<double>(distances.size());
  const auto near =
      std::upper_bound(distances.begin(), distances.end(), 0.5 * MOST_REACH) - distances.begin();
  if (n < LEAST_PLANE * SAMPLES || static_cast<double>(near) < LEAST_DENSE * n) return std::nullopt;
  // Twice what 95 in 100 lie within is four deviations, three of vertices, which scatter more.
  const double most = distances[static_cast<std::size_t>(0.95 * n)];
  return std::clamp(2 * most, LEAST_REACH, MOST_REACH);
}

/// The plane that holds most of some samples, as thick as they make it; none: it holds few.
std::optional<Plane> largestPlane(const AreaSamples& samples, const std::vector<int>& among) {
  std::optional<Plane> best;
  std::size_t most = 0;
  const std::size_t step = std::max<std::size_t>(1, among.size() / SEEDS);
  for (std::size_t k = 0; k < among.size(); k += step) {
    const std::optional<Plane> plane = planeAround(among[k], samples, among);
    if (!plane) continue;
    const std::size_t held = heldBy(*plane, samples, among).size();
    if (held <= most) continue;
    most = held;
    best = plane;
  }
  constexpr int ROUNDS = 3;
  for (int round = 0; round < ROUNDS; ++round) {
    const std::vector<int> held = best ? heldBy(*best, samples, among) : std::vector<int>();
    if (held.size() < LEAST_PLANE * SAMPLES) return std::nullopt;
    best = fitPlane(samples, held).first;
  }
  const std::optional<double> reach = reachOf(*best, samples, among);
  if (!reach) return std::nullopt;
  best->reach = *reach;
  return best;
}

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
  if (body.size() < LEAST_BODY * SAMPLES) return {};
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
