// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "pieces.h"

#include <posture/core/parallel.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/normals.h>

#include "moments.h"
#include <algorithm>
#include <cmath>
#include <utility>

namespace posture {
namespace {

using Eigen::Vector3d;

constexpr int ROUNDS = 8;              // of a fit that starts near
constexpr double LEAST_SHARE = 0.005;  // of the area
constexpr double LARGE_SHARE = 0.02;   // likely to hold some of a joint, which must not count
}  // namespace

PosedBody::PosedBody(const TriangleMesh& at_rest,
                     const std::vector<Points>& places,
                     const Vector& face_areas)
    : rest(at_rest), areas(face_areas), normals(vertexNormals(at_rest)) {
  for (const Points& pose : places) poses.emplace_back(pose, rest.faces);
}

double weightAlong(double area) {
  // Registrations err along the surface by several times what they err across it, and by the same
  // over whole limbs: it counts little, and no more on a large piece than on one of a patch's size.
  constexpr double WEIGHT = 0.02, PATCH = 0.005;
  return WEIGHT * std::min(1.0, PATCH / area);
}

std::vector<WeighedVertex> verticesOf(const PosedBody& body, const std::vector<int>& faces) {
  std::map<int, double> weight;
  for (int f : faces)
    for (int v : body.rest.faces.row(f)) weight[v] += body.areas[f] / 3;
  std::vector<WeighedVertex> vertices;
  vertices.reserve(weight.size());
  for (const auto& [v, w] : weight) vertices.push_back({v, w});
  return vertices;
}

Pieces::Pieces(const PosedBody& body, const std::vector<int>& label) : body_(body) {
  const Faces& faces = body.rest.faces;
  const Faces across = facesAcross(faces);
  std::map<int, std::vector<Moments>> moments;
  for (int f = 0; f < faces.rows(); ++f) {
    Piece& piece = pieces_[label[f]];
    std::vector<Moments>& own = moments[label[f]];
    own.resize(body.poses.size());
    piece.faces.push_back(f);
    for (int c = 0; c < 3; ++c) {
      const int v = faces(f, c), g = across(f, c);
      for (std::size_t k = 0; k < own.size(); ++k)
        own[k].add(body.rest.vertices.row(v), body.poses[k].places().row(v), body.areas[f] / 3);
      if (g >= 0 && label[g] != label[f])
        piece.adjacent[label[g]].add(body.rest.vertices.row(v),
                                     body.rest.vertices.row(faces(f, (c + 1) % 3)));
    }
    total_area_ += body.areas[f];
  }
  std::vector<std::pair<Piece*, std::vector<Eigen::Isometry3d>>> starts;
  for (auto& [number, piece] : pieces_) {
    starts.push_back({&piece, {}});
    for (const Moments& m : moments[number]) starts.back().second.push_back(m.motion());
  }
  parallelFor(static_cast<int>(starts.size()),
              [&](int i) { fit(*starts[i].first, starts[i].second); });
}

void Pieces::fit(Piece& piece, const std::vector<Eigen::Isometry3d>& start) const {
  const std::vector<WeighedVertex> vertices = verticesOf(body_, piece.faces);
  piece.area = 0;
  piece.stiffness = {};
  for (const auto& [v, weight] : vertices) {
    piece.area += weight;
    piece.stiffness.add(body_.rest.vertices.row(v), body_.normals.row(v), weight);
  }
  piece.motion.clear();
  piece.misfit = 0;
  for (std::size_t k = 0; k < start.size(); ++k) {
    const SlidingFit found =
        slideOnto(body_.poses[k],
                  body_.rest.vertices,
                  vertices,
                  start[k],
                  {weightAlong(piece.area), ROUNDS, piece.area > LARGE_SHARE * total_area_});
    piece.motion.push_back(found.motion);
    piece.misfit += found.misfit;
  }
}

Pieces::Pair Pieces::pairOf(int a, int b) const {
  const Piece &one = pieces_.at(a), &other = pieces_.at(b);
  const Vector3d place = one.adjacent.at(b).middle();
  const Joint joint(place,
                    one.stiffness.about(place, weightAlong(one.area)),
                    other.stiffness.about(place, weightAlong(other.area)));
  Pair pair;
  for (std::size_t k = 0; k < one.motion.size(); ++k)
    pair.cost += joint.cost(one.motion[k], other.motion[k]);
  pair.turn = joint.turn(pair.cost / static_cast<double>(one.motion.size()));
  return pair;
}

std::vector<double> Pieces::turns() const {
  std::vector<double> turns;
  for (const auto& [a, piece] : pieces_)
    for (const auto& [b, border] : piece.adjacent)
      if (a < b) turns.push_back(pairOf(a, b).turn);
  return turns;
}

/// Whether the cost of moving two pieces as one is what noise makes. Twelve numbers fitted to noise
/// save as much misfit as a handful of faces have; that errors of neighbours are alike, and pieces
/// chosen for little misfit, makes that some tens of times more.
bool Pieces::isNoise(const Piece& a, const Piece& b, double cost) {
  constexpr double FACES = 300;
  return cost <
         FACES * (a.misfit + b.misfit) / static_cast<double>(a.faces.size() + b.faces.size());
}

bool Pieces::belongTogether(int a, int b, const Pair& pair, double turn) const {
  const Piece &one = pieces_.at(a), &other = pieces_.at(b);
  return pair.turn < turn || std::min(one.area, other.area) < LEAST_SHARE * total_area_ ||
         isNoise(one, other, pair.cost);
}

/// Where to begin to look for the motion of two pieces as one.
std::vector<Eigen::Isometry3d> Pieces::commonMotion(const Piece& a, const Piece& b) const {
  std::vector<Moments> moments(body_.poses.size());
  for (const Piece* piece : {&a, &b})
    for (const auto& [v, weight] : verticesOf(body_, piece->faces)) {
      const Vector3d at = body_.rest.vertices.row(v);
      for (std::size_t k = 0; k < moments.size(); ++k)
        moments[k].add(at, piece->motion[k] * at, weight);
    }
  std::vector<Eigen::Isometry3d> motion;
  motion.reserve(moments.size());
  for (const Moments& m : moments) motion.push_back(m.motion());
  return motion;
}

void Pieces::merge(int a, int b) {
  Piece& kept = pieces_.at(a);
  const std::vector<Eigen::Isometry3d> start = commonMotion(kept, pieces_.at(b));
  const Piece gone = std::move(pieces_.at(b));
  pieces_.erase(b);
  kept.faces.insert(kept.faces.end(), gone.faces.begin(), gone.faces.end());
  for (const auto& [c, border] : gone.adjacent) {
    if (c == a) continue;
    Piece& beside = pieces_.at(c);
    beside.adjacent.erase(b);
    beside.adjacent[a].add(border);
    kept.adjacent[c].add(border);
  }
  kept.adjacent.erase(b);
  fit(kept, start);
}

void Pieces::mergeBelow(double turn) {
  std::map<std::pair<int, int>, Pair> pairs;
  const auto look = [&](int a, int b) { pairs[std::minmax(a, b)] = pairOf(a, b); };
  for (const auto& [a, piece] : pieces_)
    for (const auto& [b, border] : piece.adjacent)
      if (a < b) look(a, b);
  for (;;) {
    auto best = pairs.end();
    for (auto pair = pairs.begin(); pair != pairs.end(); ++pair)
      if (belongTogether(pair->first.first, pair->first.second, pair->second, turn) &&
          (best == pairs.end() || pair->second.cost < best->second.cost))
        best = pair;
    if (best == pairs.end()) return;
    const auto [a, b] = best->first;
    for (int gone : {a, b})
      for (const auto& [c, border] : pieces_.at(gone).adjacent) pairs.erase(std::minmax(gone, c));
    merge(a, b);
    for (const auto& [c, border] : pieces_.at(a).adjacent) look(a, c);
  }
}

std::vector<int> Pieces::labels() const {
  std::vector<const Piece*> order;
  for (const auto& [number, piece] : pieces_) order.push_back(&piece);
  std::stable_sort(
      order.begin(), order.end(), [](const Piece* a, const Piece* b) { return a->area > b->area; });
  std::vector<int> label(body_.areas.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    for (int f : order[i]->faces) label[f] = static_cast<int>(i);
  return label;
}

}  // namespace posture
