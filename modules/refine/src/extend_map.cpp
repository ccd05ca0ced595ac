// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/normals.h>
#include <posture/refine/extend_map.h>
#include <posture/refine/let_go.h>
#include <posture/refine/settle.h>

#include "lay_anew.h"
#include "rings_around.h"
#include <limits>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// A map whose score is higher by so much is e times less likely to be right.
constexpr double FAR_WORSE = 1;

/// A strip so many edges wide is taken in each time: of a limb that bends no more than this lies
/// near its place when it is laid as the rest goes. From head to foot are about 50.
constexpr int STRIP = 3, MOST_TIMES = 40;

/// In edges: how far from its counterpart what is taken in may lie, and how far from where it began
/// the way there and back may end - an arm laid across the trunk lies on what the trunk is matched
/// with.
constexpr double NEAR = 1.5, BACK = 3;

/// Of the area: to draw the surfaces together once more is not worth less.
constexpr double LEAST_MORE = 0.003;

/// Cosine of the angle between normals, and what normals that are opposite add to a distance.
constexpr double ALIKE = 0.5, OPPOSITE = 2;

/// The vertices that are apart and no farther from those that are not than a strip is wide.
std::vector<int> strip(const BendableSurface& a, const std::vector<char>& apart) {
  std::vector<int> front;
  std::vector<char> seen(apart.size(), 0);
  for (int v = 0; v < static_cast<int>(apart.size()); ++v)
    if (apart[v] == 0) {
      seen[v] = 1;
      front.push_back(v);
    }
  return ringsAround(a, std::move(front), std::move(seen), STRIP);
}

/// What a vertex of a, bent, lies on.
struct Counterpart {
  int vertex = 0;
  bool fits = false;  ///< near enough, and looks the same way
};

Counterpart counterpartOf(const BendableSurface& b,
                          double edge,
                          const Eigen::RowVector3d& place,
                          const Eigen::RowVector3d& normal) {
  Counterpart counterpart;
  double least = std::numeric_limits<double>::infinity();
  for (int t = 0; t < b.mesh.vertices.rows(); ++t) {
    const double away = (b.mesh.vertices.row(t) - place).squaredNorm() / (edge * edge),
                 alike = b.normals.row(t).dot(normal), cost = away + OPPOSITE * (1 - alike);
    if (!(cost < least)) continue;
    least = cost;
    counterpart = {t, away < NEAR * NEAR && alike > ALIKE};
  }
  return counterpart;
}

/// Matches vertices of a, those of the strip, with what they lie on, and takes in those that fit.
/// \return  whether any was.
bool takeIn(const BendableSurface& a,
            const BendableSurface& b,
            const std::vector<int>& vertices,
            const std::vector<char>& apart_b,
            BentPair& pair) {
  const double edge_a = meanEdgeLength(a.mesh), edge_b = meanEdgeLength(b.mesh);
  const Points normals = vertexNormals({pair.bent_a, a.mesh.faces});
  std::vector<char> taken(vertices.size(), 0);
  parallelFor(static_cast<int>(vertices.size()), [&](int i) {
    const int v = vertices[i];
    const Counterpart there = counterpartOf(b, edge_b, pair.bent_a.row(v), normals.row(v));
    pair.maps.forward[v] = there.vertex;
    if (!there.fits) return;
    const int back = pair.maps.backward[there.vertex];
    taken[i] = apart_b[there.vertex] != 0 ||
               (a.mesh.vertices.row(back) - a.mesh.vertices.row(v)).norm() < BACK * edge_a;
  });
  bool any = false;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (taken[i] != 0) {
      pair.apart_a[vertices[i]] = 0;
      any = true;
    }
  return any;
}

/// The matches of what stays apart say where it lies.
void matchWhatIsApart(const BendableSurface& a, const BendableSurface& b, BentPair& pair) {
  const double edge = meanEdgeLength(b.mesh);
  const Points normals = vertexNormals({pair.bent_a, a.mesh.faces});
  parallelFor(static_cast<int>(pair.apart_a.size()), [&](int v) {
    if (pair.apart_a[v] != 0)
      pair.maps.forward[v] = counterpartOf(b, edge, pair.bent_a.row(v), normals.row(v)).vertex;
  });
}

/// Takes in strip after strip.
void grow(const SpectralSurface& a, const SpectralSurface& b, double softness, BentPair& pair) {
  pair.bent_a = placesAnew(a, pair.apart_a, softness, pair.bent_a);
  pair.bent_b = placesAnew(b, pair.apart_b, softness, pair.bent_b);
  for (int time = 0; time < MOST_TIMES; ++time) {
    const std::vector<char> apart_a = pair.apart_a, apart_b = pair.apart_b;
    const std::vector<int> of_a = strip(a, apart_a), of_b = strip(b, apart_b);
    bool any = takeIn(a, b, of_a, apart_b, pair);
    pair = reversed(pair);
    any |= takeIn(b, a, of_b, apart_a, pair);
    pair = reversed(pair);
    if (!any) break;
    settle(a, b, softness, SETTLING_ROUNDS, pair);
  }
}

/// Whether the way there and back ends near v.
bool comesBack(const SpectralSurface& a, const BentPair& pair, double near, int v) {
  const int back = pair.maps.backward[pair.maps.forward[v]];
  return (a.mesh.vertices.row(back) - a.mesh.vertices.row(v)).norm() < near;
}

/// The vertices of a that stay apart: those, too, that came in and do not come back, or do not hang
/// together with what was in before.
std::vector<char> apartStill(const SpectralSurface& a,
                             const std::vector<char>& before,
                             const BentPair& pair) {
  const double near = BACK * meanEdgeLength(a.mesh);
  std::vector<char> apart(before.size(), 1), may_come(before.size(), 0);
  std::vector<int> front;
  for (int v = 0; v < static_cast<int>(before.size()); ++v) {
    if (isApart(pair.apart_a, v)) continue;
    if (before[v] != 0) {
      may_come[v] = comesBack(a, pair, near, v);
    } else {
      apart[v] = 0;
      front.push_back(v);
    }
  }
  while (!front.empty()) {
    const int v = front.back();
    front.pop_back();
    for (const int* w = a.neighbors.begin(v); w != a.neighbors.end(v); ++w)
      if (may_come[*w] != 0 && apart[*w] != 0) {
        apart[*w] = 0;
        front.push_back(*w);
      }
  }
  return apart;
}

double mappedArea(const SpectralSurface& a, const SpectralSurface& b, const BentPair& pair) {
  return a.laplacian.mass.sum() * (1 - areaShare(a, pair.apart_a)) +
         b.laplacian.mass.sum() * (1 - areaShare(b, pair.apart_b));
}

/// Draws the surfaces, with what is apart, onto what is nearest in both poses, time after time
/// while more comes in: where the known map had slid, all of it goes back.
void drawTogether(const SpectralSurface& a,
                  const SpectralSurface& b,
                  double softness,
                  BentPair& pair) {
  const double least_more = LEAST_MORE * (a.laplacian.mass.sum() + b.laplacian.mass.sum());
  double mapped = 0;
  for (int time = 0; time < MOST_TIMES; ++time) {
    BentPair more = laidAnew(a, b, pair.apart_a, pair.apart_b, softness, pair);
    std::vector<char> apart_a = apartStill(a, pair.apart_a, more),
                      apart_b = apartStill(b, pair.apart_b, reversed(more));
    more.apart_a = std::move(apart_a);
    more.apart_b = std::move(apart_b);
    const double now = mappedArea(a, b, more);
    if (now < mapped + least_more) break;
    pair = std::move(more);
    mapped = now;
  }
}

MapScore settleWithoutMisplaced(const SpectralSurface& a,
                                const SpectralSurface& b,
                                double softness,
                                BentPair& pair) {
  addApart(pair.apart_a, misplaced(a, b, pair.maps.forward, pair.apart_a));
  addApart(pair.apart_b, misplaced(b, a, pair.maps.backward, pair.apart_b));
  settleSoftening(a, b, softness, pair);
  matchWhatIsApart(a, b, pair);
  pair = reversed(pair);
  matchWhatIsApart(b, a, pair);
  pair = reversed(pair);
  dropIfNothingIsApart(pair);
  return scoreBent(a, b, pair, false);
}

}  // namespace

ScoredPair extendMap(const SpectralSurface& a,
                     const SpectralSurface& b,
                     double softness,
                     BentPair pair) {
  pair.apart_a.resize(a.mesh.vertices.rows(), 0);
  pair.apart_b.resize(b.mesh.vertices.rows(), 0);
  grow(a, b, softness, pair);
  BentPair drawn = pair;
  const MapScore score = settleWithoutMisplaced(a, b, softness, pair);
  try {
    drawTogether(a, b, softness, drawn);
    const MapScore drawn_score = settleWithoutMisplaced(a, b, softness, drawn);
    if (mappedArea(a, b, drawn) > mappedArea(a, b, pair) &&
        drawn_score.total() < score.total() + FAR_WORSE)
      return {std::move(drawn), drawn_score};
  } catch (const TornSurface&) {
  }
  return {std::move(pair), score};
}

}  // namespace posture
