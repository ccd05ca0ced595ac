// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/median.h>
#include <posture/core/parallel.h>
#include <posture/core/unions.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/smooth_noise.h>
#include <posture/mesh/vertex_neighbors.h>
#include <posture/mesh/weld.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// Of an edge; see the header. Noise makes the second two thirds of the first.
constexpr double NOISY = 0.16, NOISY_ALONE = 0.11;

/// Of a round: what varies within about four edges goes, with what Taubin gives as usual weights.
constexpr int PASSES = 10;
constexpr double SHRINK = 0.5, SWELL = -0.53;

/// Noise of two edges takes two; a surface that stays rough after so many is made that way and
/// left so.
constexpr int MOST_ROUNDS = 5;

/// Vertices of a rim: that of a smaller hole would be pulled shut.
constexpr int LONG_RIM = 12;

/// Non-zero for the vertices of long rims.
std::vector<char> longRims(const std::vector<Edge>& edges, int vertex_count) {
  Unions rims(vertex_count);
  for (const Edge& e : edges)
    if (e.faces == 1) rims.join(e.first, e.second);
  std::vector<char> is_long;
  for (int size : rims.sizes()) is_long.push_back(size >= LONG_RIM);
  return is_long;
}

/// How much farther vertices move when smoothed than what is around them.
struct Roughness {
  double from_mean = 0;    ///< than their neighbours in the mean
  double from_likest = 0;  ///< than the second likest of them
};

/// A mesh whose vertices move towards the mean of their neighbours: at a long rim, those along it.
class Smoother {
 public:
  Smoother(const Faces& faces, int vertex_count)
      : faces_(faces), faces_around_(faces, vertex_count), first_(vertex_count + 1, 0) {
    const std::vector<Edge> edges = meshEdges(faces);
    const std::vector<char> at_rim = longRims(edges, vertex_count);
    const auto counts = [&](const Edge& e, int end) { return !at_rim[end] || e.faces == 1; };
    for (const Edge& e : edges)
      for (int end : {e.first, e.second}) first_[end + 1] += counts(e, end);
    for (int v = 0; v < vertex_count; ++v) first_[v + 1] += first_[v];
    neighbors_.resize(first_.back());
    std::vector<int> next(first_.begin(), first_.end() - 1);
    for (const Edge& e : edges) {
      if (counts(e, e.first)) neighbors_[next[e.first]++] = e.second;
      if (counts(e, e.second)) neighbors_[next[e.second]++] = e.first;
    }
  }

  Points smoothed(Points places) const {
    for (int pass = 0; pass < PASSES; ++pass)
      for (double weight : {SHRINK, SWELL}) places = movedToMeans(places, weight);
    return places;
  }

  /// How far places are from the smoothed ones along the normals of these, in edges, less than what
  /// is around them: medians over the vertices that have any. Does not ask which way faces are
  /// turned.
  Roughness roughness(const Points& places, const Points& smoothed) const {
    const int n = static_cast<int>(places.rows());
    Points normals = Points::Zero(n, 3);
    Vector off = Vector::Zero(n);
    forEach(n, [&](int v) {
      if (first_[v] == first_[v + 1]) return;
      normals.row(v) = normalLine(smoothed, v);
      off[v] = (places.row(v) - smoothed.row(v)).dot(normals.row(v));
    });
    std::vector<double> from_mean, from_likest, differences;
    for (int v = 0; v < n; ++v) {
      const int count = first_[v + 1] - first_[v];
      if (count == 0) continue;
      double length = 0, around = 0;
      differences.clear();
      for (int i = first_[v]; i < first_[v + 1]; ++i) {
        const int w = neighbors_[i];
        length += (smoothed.row(w) - smoothed.row(v)).norm();
        const double off_here = normals.row(v).dot(normals.row(w)) < 0 ? -off[w] : off[w];
        around += off_here;
        const double difference = std::abs(off[v] - off_here);
        differences.push_back(std::isfinite(difference) ? difference : 0);
      }
      const double off_neighbors = std::abs(count * off[v] - around) / length;
      from_mean.push_back(std::isfinite(off_neighbors) ? off_neighbors : 0);
      if (count < 2) continue;
      std::nth_element(differences.begin(), differences.begin() + 1, differences.end());
      from_likest.push_back(length > 0 ? count * differences[1] / length : 0);
    }
    return {from_mean.empty() ? 0 : median(std::move(from_mean)),
            from_likest.empty() ? 0 : median(std::move(from_likest))};
  }

 private:
  Points movedToMeans(const Points& places, double weight) const {
    Points moved = places;
    for (int v = 0; v < places.rows(); ++v) {
      const int count = first_[v + 1] - first_[v];
      if (count == 0) continue;
      Eigen::RowVector3d sum = Eigen::RowVector3d::Zero();
      for (int i = first_[v]; i < first_[v + 1]; ++i) sum += places.row(neighbors_[i]);
      moved.row(v) += weight * (sum / count - places.row(v));
    }
    return moved;
  }

  Eigen::RowVector3d normalLine(const Points& places, int v) const {
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const int* f = faces_around_.begin(v); f != faces_around_.end(v); ++f) {
      const Eigen::Vector3d a = places.row(faces_(*f, 0)), b = places.row(faces_(*f, 1)),
                            c = places.row(faces_(*f, 2));
      const Eigen::Vector3d normal = (b - a).cross(c - a).normalized();
      sum += normal * normal.transpose();
    }
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvectors().col(2);
  }

  const Faces& faces_;
  VertexFaces faces_around_;
  std::vector<int> first_, neighbors_;
};

}  // namespace

int smoothNoise(TriangleMesh& mesh) {
  const int n = static_cast<int>(mesh.vertices.rows());
  const std::vector<int> place = weld(mesh.vertices);
  const Faces faces = weldedFaces(mesh.faces, place);
  const Smoother smoother(faces, n);
  Points vertices = mesh.vertices;
  for (int rounds = 0; rounds <= MOST_ROUNDS; ++rounds) {
    Points smoothed = smoother.smoothed(vertices);
    const Roughness rough = smoother.roughness(vertices, smoothed);
    if (!(rough.from_mean > NOISY) || (rounds == 0 && rough.from_likest < NOISY_ALONE)) {
      if (rounds > 0) mesh.vertices = vertices(place, Eigen::all);
      return rounds;
    }
    vertices = std::move(smoothed);
  }
  return 0;
}

}  // namespace posture
