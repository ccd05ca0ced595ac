// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/deformation/mean_value_encoding.h>
#include <posture/mesh/half_edge_mesh.h>
#include <posture/mesh/vertex_neighbors.h>

#include <Eigen/Dense>
#include <ceres/ceres.h>

#include "mean_value_term.h"
#include <algorithm>
#include <cmath>
#include <optional>

namespace posture {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

/// What a polygon says of where it lies.
struct PolygonFrame {
  Vector3d centroid = Vector3d::Zero();
  Vector3d area = Vector3d::Zero();  ///< area vector
  double fan_area = 0;               ///< of the triangles from the centroid, without sign
  double radius = 0;                 ///< s

  explicit PolygonFrame(const std::vector<Vector3d>& corners) {
    const auto count = static_cast<double>(corners.size());
    for (const Vector3d& p : corners) centroid += p / count;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const Vector3d from = corners[k] - centroid;
      const Vector3d twice = from.cross(corners[(k + 1) % corners.size()] - centroid);
      area += 0.5 * twice;
      fan_area += 0.5 * twice.norm();
      radius += from.squaredNorm() / count;
    }
    radius = std::sqrt(radius);
  }

  Vector3d normal() const { return area.normalized(); }
};

/// Of two places as far as rounding can tell the first is taken.
constexpr double CLEARLY_MORE = 1 + 1e-6;

/// Two directions across the normal; the first towards the corner that is farthest from the
/// centroid when seen along the normal.
Matrix3d axes(const PolygonFrame& frame, const std::vector<Vector3d>& corners) {
  const Vector3d n = frame.normal();
  Vector3d tangent = Vector3d::Zero();
  for (const Vector3d& p : corners) {
    const Vector3d from = p - frame.centroid, across = from - n.dot(from) * n;
    if (across.norm() > CLEARLY_MORE * tangent.norm()) tangent = across;
  }
  tangent.normalize();
  Matrix3d axes;
  axes << tangent, n.cross(tangent), n;
  return axes;
}

/// Mean-value coordinates of the origin, not normalised.
std::vector<double> meanValueCoordinates(const std::vector<Vector2d>& corners) {
  constexpr double ON_SIDE = 1e-9;
  const std::size_t count = corners.size();
  std::vector<double> weight(count, 0.0), half_tangent(count);
  double largest = 0;
  for (const Vector2d& p : corners) largest = std::max(largest, p.norm());
  for (std::size_t k = 0; k < count; ++k) {
    if (corners[k].norm() > ON_SIDE * largest) continue;
    weight[k] = 1;
    return weight;
  }
  for (std::size_t k = 0; k < count; ++k) {
    const std::size_t next = (k + 1) % count;
    const Vector2d &a = corners[k], &b = corners[next];
    const double cross = a.x() * b.y() - a.y() * b.x(), dot = a.dot(b);
    const double product = a.norm() * b.norm();
    if (dot < 0 && std::abs(cross) <= ON_SIDE * product) {
      weight[k] = b.norm();
      weight[next] = a.norm();
      return weight;
    }
    half_tangent[k] = dot > 0 ? cross / (product + dot) : (product - dot) / cross;
  }
  for (std::size_t k = 0; k < count; ++k)
    weight[k] = (half_tangent[(k + count - 1) % count] + half_tangent[k]) / corners[k].norm();
  return weight;
}

/// Makes sum w = 1 and sum w p = 0 exact to rounding, by the least change.
void correct(const std::vector<Vector2d>& corners, std::vector<double>& weight) {
  Matrix3d gram = Matrix3d::Zero();
  Vector3d missing(1, 0, 0);
  double largest = 0;
  for (const Vector2d& p : corners) largest = std::max(largest, p.norm());
  const auto row = [&](std::size_t k) -> Vector3d {
    return {1, corners[k].x() / largest, corners[k].y() / largest};
  };
  for (std::size_t k = 0; k < corners.size(); ++k) {
    gram += row(k) * row(k).transpose();
    missing -= weight[k] * row(k);
  }
  const Vector3d change = gram.ldlt().solve(missing);
  for (std::size_t k = 0; k < corners.size(); ++k) weight[k] += change.dot(row(k));
}

/// Normalised mean-value weights; nothing where they cancel or the frame is not sound.
std::optional<std::vector<double>> weightsIn(const Vector3d& place,
                                             const std::vector<Vector3d>& corners,
                                             bool any) {
  constexpr double LEAST_FLATNESS = 0.1, LEAST_AREA = 0.02, MOST_CANCELLING = 5;
  const PolygonFrame frame(corners);
  const double area = frame.area.norm();
  if (!(area > 0)) return std::nullopt;
  if (!any &&
      (area < LEAST_FLATNESS * frame.fan_area || area < LEAST_AREA * frame.radius * frame.radius))
    return std::nullopt;
  const Matrix3d to_plane = axes(frame, corners).transpose();
  std::vector<Vector2d> flat;
  for (const Vector3d& p : corners) flat.push_back((to_plane * (p - place)).head<2>());
  std::vector<double> weight = meanValueCoordinates(flat);
  double sum = 0, absolute = 0;
  for (double w : weight) {
    sum += w;
    absolute += std::abs(w);
  }
  if (!any && !(absolute <= MOST_CANCELLING * std::abs(sum))) return std::nullopt;
  for (double& w : weight) w /= sum;
  correct(flat, weight);
  return weight;
}

class Encoder {
 public:
  explicit Encoder(const TriangleMesh& mesh)
      : places_(mesh.vertices),
        count_(static_cast<int>(mesh.vertices.rows())),
        neighbors_(mesh.faces, count_) {}

  MeanValueEncoding encode(const TriangleMesh& mesh) {
    const ManifoldMesh manifold = cutNonManifold(mesh);
    const HalfEdgeMesh half_edges(manifold.mesh.faces,
                                  static_cast<int>(manifold.mesh.vertices.rows()));
    std::vector<char> cut(count_, 0);
    for (std::size_t v = count_; v < manifold.original_vertex.size(); ++v)
      cut[manifold.original_vertex[v]] = 1;
    encoding_.first.assign(1, 0);
    encoding_.offset.resize(count_);
    frames_.reserve(count_);
    for (int v = 0; v < count_; ++v) {
      require(neighbors_.begin(v) != neighbors_.end(v), "encodeMeanValues: a vertex in no face");
      std::vector<int> ring;
      if (!cut[v])
        for (int w : half_edges.neighbors(v)) ring.push_back(manifold.original_vertex[w]);
      add(v, std::move(ring));
    }
    layOut();
    return std::move(encoding_);
  }

 private:
  struct Frame {
    Matrix3d axes;
    double unit;
  };

  Vector3d place(int v) const { return places_.row(v); }

  std::vector<Vector3d> placesOf(const std::vector<int>& vertices) const {
    std::vector<Vector3d> corners;
    for (int v : vertices) corners.push_back(place(v));
    return corners;
  }

  void add(int v, std::vector<int> polygon) {
    std::optional<std::vector<double>> weight;
    if (polygon.size() > 2) weight = weightsIn(place(v), placesOf(polygon), false);
    if (!weight) {
      polygon = triangleNear(v);
      weight = weightsIn(place(v), placesOf(polygon), true);
    }
    const std::vector<Vector3d> corners = placesOf(polygon);
    const PolygonFrame frame(corners);
    frames_.push_back({axes(frame, corners), frame.radius});
    Vector3d rest = place(v);
    for (std::size_t k = 0; k < corners.size(); ++k) rest -= (*weight)[k] * corners[k];
    encoding_.offset[v] = rest.dot(frame.normal()) / frame.radius;
    encoding_.corner.insert(encoding_.corner.end(), polygon.begin(), polygon.end());
    encoding_.weight.insert(encoding_.weight.end(), weight->begin(), weight->end());
    encoding_.first.push_back(static_cast<int>(encoding_.corner.size()));
  }

  /// Three vertices near v, out of line.
  std::vector<int> triangleNear(int v) const {
    constexpr double LEAST_HEIGHT = 0.05;  // of the longest side
    std::vector<int> near{v};
    for (std::size_t ring_begin = 0;;) {
      const std::size_t ring_end = near.size();
      for (std::size_t i = ring_begin; i < ring_end; ++i)
        for (const int* w = neighbors_.begin(near[i]); w != neighbors_.end(near[i]); ++w)
          if (std::find(near.begin(), near.end(), *w) == near.end()) near.push_back(*w);
      const bool grown = near.size() > ring_end;
      ring_begin = ring_end;
      const std::vector<int> others(near.begin() + 1, near.end());
      const auto [triangle, height] = widestTriangle(others);
      if (height > LEAST_HEIGHT || (!grown && height > 0)) return triangle;
      require(grown, "encodeMeanValues: a part of the mesh lies within a line");
    }
  }

  /// A wide triangle of these vertices, and its height over its first side.
  std::pair<std::vector<int>, double> widestTriangle(const std::vector<int>& of) const {
    const auto farthest = [&](const auto& distance) {
      int best = of.front();
      for (int v : of)
        if (distance(v) > CLEARLY_MORE * distance(best)) best = v;
      return best;
    };
    Vector3d centroid = Vector3d::Zero();
    for (int v : of) centroid += place(v) / static_cast<double>(of.size());
    const int a = farthest([&](int v) { return (place(v) - centroid).norm(); });
    const int b = farthest([&](int v) { return (place(v) - place(a)).norm(); });
    const double length = (place(b) - place(a)).norm();
    if (!(length > 0)) return {{}, 0};
    const Vector3d along = (place(b) - place(a)) / length;
    const auto off_line = [&](int v) { return along.cross(place(v) - place(a)).norm(); };
    const int c = farthest(off_line);
    constexpr double ROUNDING = 1e-9;
    const double height = off_line(c) / length;
    return {{a, b, c}, height > ROUNDING ? height : 0};
  }

  void layOut() {
    std::vector<char> placed(count_, 0);
    for (int root = 0; root < count_; ++root) {
      if (placed[root]) continue;
      placed[root] = 1;
      std::size_t next = encoding_.layout.size();
      encoding_.layout.push_back({root, -1, Vector3d::Zero(), Eigen::Quaterniond::Identity(), 1});
      for (; next < encoding_.layout.size(); ++next) {
        const int u = encoding_.layout[next].vertex;
        for (const int* w = neighbors_.begin(u); w != neighbors_.end(u); ++w) {
          if (placed[*w]) continue;
          placed[*w] = 1;
          const Frame &from = frames_[u], &to = frames_[*w];
          encoding_.layout.push_back(
              {*w,
               u,
               from.axes.transpose() * (place(*w) - place(u)) / from.unit,
               Eigen::Quaterniond(Matrix3d(from.axes.transpose() * to.axes)).normalized(),
               to.unit / from.unit});
        }
      }
    }
  }

  const Points& places_;
  int count_;
  VertexNeighbors neighbors_;
  std::vector<Frame> frames_;
  MeanValueEncoding encoding_;
};

/// Rotation, translation and scale that take `from` to `to` (Umeyama 1991).
Eigen::Affine3d similarity(const Points& from, const Points& to) {
  constexpr double IN_LINE = 1e-9;
  require(from.rows() >= 3, "decodeMeanValues: a part with fewer than three fixed vertices");
  for (const Points* points : {&from, &to}) {
    const Points centred = points->rowwise() - points->colwise().mean();
    const Vector3d spread = Eigen::JacobiSVD<Matrix>(centred).singularValues();
    require(spread[1] > IN_LINE * spread[0],
            "decodeMeanValues: the fixed vertices of a part lie in one line");
  }
  Eigen::Affine3d motion;
  motion.matrix() = Eigen::umeyama(Matrix(from.transpose()), Matrix(to.transpose()), true);
  return motion;
}

/// Each connected part laid out and put onto its fixed vertices.
Points laidOut(const MeanValueEncoding& encoding,
               const std::vector<int>& fixed_row,
               const Points& fixed_places) {
  Points places(encoding.vertexCount(), 3);
  std::vector<Eigen::Quaterniond> turn(encoding.vertexCount());
  std::vector<double> unit(encoding.vertexCount());
  std::vector<int> part;
  const auto finish = [&] {
    std::vector<int> known;
    for (int v : part)
      if (fixed_row[v] >= 0) known.push_back(v);
    Points from(known.size(), 3), to(known.size(), 3);
    for (std::size_t i = 0; i < known.size(); ++i) {
      from.row(i) = places.row(known[i]);
      to.row(i) = fixed_places.row(fixed_row[known[i]]);
    }
    const Eigen::Affine3d motion = similarity(from, to);
    for (int v : part) places.row(v) = (motion * places.row(v).transpose()).transpose();
    part.clear();
  };
  for (const MeanValueEncoding::Step& step : encoding.layout) {
    if (step.from < 0) {
      if (!part.empty()) finish();
      places.row(step.vertex).setZero();
      turn[step.vertex].setIdentity();
      unit[step.vertex] = 1;
    } else {
      places.row(step.vertex) =
          places.row(step.from) + unit[step.from] * (turn[step.from] * step.place).transpose();
      turn[step.vertex] = (turn[step.from] * step.turn).normalized();
      unit[step.vertex] = unit[step.from] * step.ratio;
    }
    part.push_back(step.vertex);
  }
  finish();
  return places;
}

}  // namespace

MeanValueEncoding encodeMeanValues(const TriangleMesh& mesh) { return Encoder(mesh).encode(mesh); }

MeanValueResidual meanValueResidual(const MeanValueEncoding& encoding,
                                    int i,
                                    const Vector3d& place,
                                    const std::vector<Vector3d>& corners,
                                    bool with_jacobian) {
  const PolygonFrame frame(corners);
  const double* weight = encoding.weight.data() + encoding.first[i];
  const double offset = encoding.offset[i], area = frame.area.norm();
  // A collapsed polygon has no normal: the offset then points nowhere.
  const Vector3d normal = area > 0 ? Vector3d(frame.area / area) : Vector3d::Zero();
  const std::size_t count = corners.size();
  MeanValueResidual residual;
  residual.value = place - offset * frame.radius * normal;
  for (std::size_t k = 0; k < count; ++k) residual.value -= weight[k] * corners[k];
  if (!with_jacobian) return residual;
  residual.by_corner.resize(count);
  const Matrix3d across =
      area > 0 ? Matrix3d((Matrix3d::Identity() - normal * normal.transpose()) / area)
               : Matrix3d::Zero();
  for (std::size_t k = 0; k < count; ++k) {
    const Vector3d diagonal = 0.5 * (corners[(k + count - 1) % count] - corners[(k + 1) % count]);
    Matrix3d area_by_corner;  // the cross product with the diagonal
    area_by_corner << 0, -diagonal.z(), diagonal.y(), diagonal.z(), 0, -diagonal.x(), -diagonal.y(),
        diagonal.x(), 0;
    const Vector3d radius_by_corner =
        frame.radius > 0
            ? Vector3d((corners[k] - frame.centroid) / (static_cast<double>(count) * frame.radius))
            : Vector3d::Zero();
    residual.by_corner[k] =
        -weight[k] * Matrix3d::Identity() -
        offset * (normal * radius_by_corner.transpose() + frame.radius * across * area_by_corner);
  }
  return residual;
}

Points decodeMeanValues(const MeanValueEncoding& encoding,
                        const std::vector<int>& fixed,
                        const Points& places,
                        const Points& start) {
  const int n = encoding.vertexCount();
  require(places.rows() == static_cast<Eigen::Index>(fixed.size()),
          "decodeMeanValues: one place a fixed vertex");
  require(start.rows() == 0 || start.rows() == n, "decodeMeanValues: one start a vertex");
  std::vector<int> fixed_row(n, -1);
  for (std::size_t i = 0; i < fixed.size(); ++i) {
    require(fixed[i] >= 0 && fixed[i] < n && fixed_row[fixed[i]] < 0,
            "decodeMeanValues: a fixed vertex twice or out of range");
    fixed_row[fixed[i]] = static_cast<int>(i);
  }
  const Points first = laidOut(encoding, fixed_row, places);
  Points decoded = start.rows() > 0 ? start : first;
  for (int v = 0; v < n; ++v)
    if (fixed_row[v] >= 0) decoded.row(v) = places.row(fixed_row[v]);
  // Some of Ceres' tolerances are absolute: in a frame of size about one. A power of two changes no
  // digit.
  const double size = (first.colwise().maxCoeff() - first.colwise().minCoeff()).norm();
  const double unit = std::exp2(std::round(std::log2(size)));
  decoded /= unit;
  ceres::Problem problem;
  for (int v = 0; v < n; ++v) {
    auto* term = new MeanValueTerm(encoding, v, 1);
    problem.AddResidualBlock(term, nullptr, term->parametersIn(decoded));
  }
  for (int v : fixed) problem.SetParameterBlockConstant(decoded.row(v).data());
  ceres::Solver::Options options;
  options.linear_solver_type = ceres::SPARSE_NORMAL_CHOLESKY;
  options.max_num_iterations = 200;
  options.function_tolerance = 1e-20;
  options.gradient_tolerance = 1e-16;
  options.parameter_tolerance = 1e-14;
  options.logging_type = ceres::SILENT;
  ceres::Solver::Summary summary;
  ceres::Solve(options, &problem, &summary);
  decoded *= unit;
  for (int v : fixed) decoded.row(v) = places.row(fixed_row[v]);
  return decoded;
}

}  // namespace posture
