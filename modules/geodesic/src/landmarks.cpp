// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/parallel.h>
#include <posture/geodesic/landmarks.h>
#include <posture/mesh/corners.h>
#include <posture/mesh/edges.h>

#include <algorithm>
#include <limits>

namespace posture {
namespace {

int farthestFromCentroid(const TriangleMesh& mesh, const std::vector<int>& face_of) {
  std::vector<int> in_faces;
  for (int v = 0; v < mesh.vertices.rows(); ++v)
    if (face_of[v] >= 0) in_faces.push_back(v);
  const Eigen::RowVector3d centroid = mesh.vertices(in_faces, Eigen::all).colwise().mean();
  int farthest = -1;
  double most = -1;
  for (const int v : in_faces) {
    const double distance = (mesh.vertices.row(v) - centroid).squaredNorm();
    if (distance > most) {
      most = distance;
      farthest = v;
    }
  }
  return farthest;
}

/// Finds the vertex with the greatest distance, the first of several, while distances fall: an
/// entry of the heap is brought up to date when it comes to the top.
class FarthestVertex {
 public:
  /// Of the vertices in a face.
  FarthestVertex(const std::vector<double>& distance, const std::vector<int>& face_of)
      : distance_(distance) {
    for (int v = 0; v < static_cast<int>(distance.size()); ++v)
      if (face_of[v] >= 0) heap_.push_back({distance[v], v});
    std::make_heap(heap_.begin(), heap_.end());
  }

  int find() {
    while (heap_.front().distance != distance_[heap_.front().vertex]) {
      std::pop_heap(heap_.begin(), heap_.end());
      heap_.back().distance = distance_[heap_.back().vertex];
      std::push_heap(heap_.begin(), heap_.end());
    }
    return heap_.front().vertex;
  }

 private:
  struct Entry {
    double distance;
    int vertex;

    bool operator<(const Entry& that) const {
      return distance != that.distance ? distance < that.distance : vertex > that.vertex;
    }
  };

  const std::vector<double>& distance_;
  std::vector<Entry> heap_;
};

/// For each vertex, the vertices it is joined to by a boundary edge.
class BoundaryEdges {
 public:
  explicit BoundaryEdges(const TriangleMesh& mesh) : joined_(mesh.vertices.rows()) {
    for (const Edge& e : meshEdges(mesh.faces))
      if (e.faces == 1) {
        joined_[e.first].push_back(e.second);
        joined_[e.second].push_back(e.first);
      }
  }

  bool contains(int a, int b) const {
    return std::find(joined_[a].begin(), joined_[a].end(), b) != joined_[a].end();
  }

 private:
  std::vector<std::vector<int>> joined_;
};

/// 1 - m_h / m along the way back to the source, for every vertex reached.
void pathConfidence(const GeodesicField& field,
                    const BoundaryEdges& boundary,
                    std::vector<int>& edges,
                    std::vector<int>& hole_edges) {
  for (int v : field.order) {
    const int from = field.predecessor[v];
    edges[v] = from < 0 ? 0 : edges[from] + 1;
    hole_edges[v] = from < 0 ? 0 : hole_edges[from] + boundary.contains(from, v);
  }
}

}  // namespace

Landmarks voronoiSamples(const TriangleMesh& mesh, const FastMarching& marching, int most) {
  return voronoiSamples(mesh, marching, most, meanEdgeLength(mesh));
}

Landmarks voronoiSamples(const TriangleMesh& mesh,
                         const FastMarching& marching,
                         int most,
                         double spacing) {
  require(mesh.faces.rows() > 0, "voronoiSamples: the mesh has no faces");
  const int n = static_cast<int>(mesh.vertices.rows());
  const std::vector<int> face_of = faceOfEachVertex(mesh.faces, n);
  Landmarks landmarks;
  landmarks.nearest.assign(n, -1);
  std::vector<double> distance(n, std::numeric_limits<double>::infinity());
  GeodesicField field;
  const auto add = [&](int v) {
    const int label = static_cast<int>(landmarks.vertices.size());
    landmarks.vertices.push_back(v);
    marching.marchWithin(v, label, distance, landmarks.nearest, field);
  };
  add(farthestFromCentroid(mesh, face_of));
  FarthestVertex farthest(distance, face_of);
  while (true) {
    const int next = farthest.find();
    landmarks.covering_radius = distance[next];
    if (distance[next] <= spacing || static_cast<int>(landmarks.vertices.size()) >= most)
      return landmarks;
    add(next);
  }
}

Landmarks computeLandmarks(const TriangleMesh& mesh, const FastMarching& marching, int most) {
  Landmarks landmarks = voronoiSamples(mesh, marching, most);
  const int s = static_cast<int>(landmarks.vertices.size());
  const int n = static_cast<int>(mesh.vertices.rows());
  landmarks.distances.resize(s, n);
  landmarks.confidence.resize(s, s);
  const BoundaryEdges boundary(mesh);
  constexpr int BLOCK = 8;
  forBlocks(s, BLOCK, [&](int first, int last) {
    GeodesicField field;
    std::vector<int> edges, hole_edges;
    for (int i = first; i < last; ++i) {
      edges.assign(n, 0);
      hole_edges.assign(n, 0);
      marching.march(landmarks.vertices[i], field);
      for (int v = 0; v < n; ++v) landmarks.distances(i, v) = static_cast<float>(field.distance[v]);
      pathConfidence(field, boundary, edges, hole_edges);
      for (int j = 0; j < s; ++j) {
        const int v = landmarks.vertices[j];
        landmarks.confidence(i, j) =
            edges[v] == 0 ? 1.0f : 1.0f - static_cast<float>(hole_edges[v]) / edges[v];
      }
    }
  });
  landmarks.confidence = (0.5f * (landmarks.confidence + landmarks.confidence.transpose())).eval();
  return landmarks;
}

Matrix sampleDistances(const Landmarks& landmarks) {
  const int s = static_cast<int>(landmarks.vertices.size());
  Matrix distances(s, s);
  for (int i = 0; i < s; ++i)
    for (int j = 0; j < s; ++j)
      distances(i, j) = 0.5 * (static_cast<double>(landmarks.distances(i, landmarks.vertices[j])) +
                               landmarks.distances(j, landmarks.vertices[i]));
  return distances;
}

}  // namespace posture
