// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "clean/delaunay.h"

#include <posture/core/rng.h>

#include "clean/predicates.h"
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

namespace posture {
namespace {

bool isOnLine(const LatticePoint& p, const LatticePoint& a, const LatticePoint& b) {
  for (int k = 0; k < 3; ++k) {
    LatticePoint aside = a;
    aside[k] += 1;
    if (orientation(a, b, p, aside) != 0) return false;
  }
  return true;
}

class Insertion {
 public:
  explicit Insertion(const Points& points) : places_(points.rows()) {
    constexpr int FINEST = 32, BITS = 51;
    const int size = std::ilogb(points.cwiseAbs().maxCoeff()) + 1;
    const double scale = std::ldexp(1.0, std::min(FINEST, BITS - size));
    for (int i = 0; i < points.rows(); ++i)
      for (int k = 0; k < 3; ++k) places_[i][k] = std::round(points(i, k) * scale);
    infinity_ = static_cast<int>(places_.size());
  }

  std::optional<Tetrahedra> run() {
    std::vector<int> order = rounds();
    if (!begin(order)) return std::nullopt;
    for (std::size_t i = 4; i < order.size(); ++i) insert(order[i]);
    return compact();
  }

 private:
  /// Each round about as many points as all before, so that cells stay round: Amenta, Choi and Rote
  /// (2003). Within a round points keep their order.
  std::vector<int> rounds() const {
    std::vector<int> by_place(places_.size());
    std::iota(by_place.begin(), by_place.end(), 0);
    std::sort(by_place.begin(), by_place.end(), [&](int a, int b) {
      return std::tie(places_[a], a) < std::tie(places_[b], b);
    });
    by_place.erase(std::unique(by_place.begin(),
                               by_place.end(),
                               [&](int a, int b) { return places_[a] == places_[b]; }),
                   by_place.end());
    std::vector<char> is_first(places_.size(), 0);
    for (int i : by_place) is_first[i] = 1;
    Rng rng(3);
    std::vector<std::pair<int, int>> keyed;
    for (int i = 0; i < infinity_; ++i) {
      int round = 0;
      while (round < 20 && rng.below(2) == 0) ++round;
      if (is_first[i]) keyed.emplace_back(-round, i);
    }
    std::sort(keyed.begin(), keyed.end());
    std::vector<int> order;
    order.reserve(keyed.size());
    for (const auto& entry : keyed) order.push_back(entry.second);
    return order;
  }

  /// The first four points not in a plane come first, and make the first tetrahedron.
  bool begin(std::vector<int>& order) {
    const auto at = [&](std::size_t i) { return places_[order[i]]; };
    std::size_t third = 2;
    while (third < order.size() && isOnLine(at(third), at(0), at(1))) ++third;
    std::size_t fourth = third + 1;
    while (fourth < order.size() && orientation(at(0), at(1), at(third), at(fourth)) == 0) ++fourth;
    if (fourth >= order.size()) return false;
    std::swap(order[2], order[third]);
    std::swap(order[3], order[fourth]);
    if (orientation(at(0), at(1), at(2), at(3)) < 0) std::swap(order[0], order[1]);
    const std::array<int, 4> first{order[0], order[1], order[2], order[3]};
    tetrahedra_.corners.push_back(first);
    tetrahedra_.beyond.push_back({1, 2, 3, 4});
    for (int k = 0; k < 4; ++k) {
      // Two others exchanged: seen from beyond, the face turns the other way.
      std::array<int, 4> ghost = first;
      ghost[k] = infinity_;
      const int i = (k + 1) % 4, j = (k + 2) % 4;
      std::swap(ghost[i], ghost[j]);
      std::array<int, 4> beyond{};
      for (int m = 0; m < 4; ++m) {
        const int opposite = m == i ? j : m == j ? i : m;
        beyond[m] = m == k ? 0 : opposite + 1;
      }
      tetrahedra_.corners.push_back(ghost);
      tetrahedra_.beyond.push_back(beyond);
    }
    mark_.assign(5, -1);
    return true;
  }

  bool conflicts(int t, const LatticePoint& p) const {
    const std::array<int, 4>& c = tetrahedra_.corners[t];
    const auto infinite = std::find(c.begin(), c.end(), infinity_);
    if (infinite == c.end())
      return isInSphere(places_[c[0]], places_[c[1]], places_[c[2]], places_[c[3]], p);
    const int corner = static_cast<int>(infinite - c.begin());
    const int seen = side(t, corner, p);
    // In the plane of a face of the hull: within its circle when within the sphere below.
    return seen > 0 || (seen == 0 && conflicts(tetrahedra_.beyond[t][corner], p));
  }

  /// On which side of a face a place lies; positive: that of the corner opposite.
  int side(int t, int corner, const LatticePoint& p) const {
    std::array<const LatticePoint*, 4> place;
    for (int k = 0; k < 4; ++k) place[k] = k == corner ? &p : &places_[tetrahedra_.corners[t][k]];
    return orientation(*place[0], *place[1], *place[2], *place[3]);
  }

  bool isInfinite(int t) const {
    const std::array<int, 4>& c = tetrahedra_.corners[t];
    return std::find(c.begin(), c.end(), infinity_) != c.end();
  }

  /// Walks to a tetrahedron that has a place in it: it ends, as the triangulation is Delaunay.
  int locate(const LatticePoint& p) const {
    int t = last_;
    if (isInfinite(t)) {
      const std::array<int, 4>& c = tetrahedra_.corners[t];
      if (conflicts(t, p)) return t;
      t = tetrahedra_.beyond[t][std::find(c.begin(), c.end(), infinity_) - c.begin()];
    }
    while (!isInfinite(t)) {
      int next = -1;
      for (int k = 0; k < 4 && next < 0; ++k)
        if (side(t, k, p) < 0) next = tetrahedra_.beyond[t][k];
      if (next < 0) break;
      t = next;
    }
    return t;
  }

  void insert(int point) {
    const LatticePoint& p = places_[point];
    cavity_.assign(1, locate(p));
    mark_[cavity_[0]] = point;
    rim_.clear();
    for (std::size_t i = 0; i < cavity_.size(); ++i)
      for (int k = 0; k < 4; ++k) {
        const int t = tetrahedra_.beyond[cavity_[i]][k];
        if (mark_[t] == point) continue;
        if (conflicts(t, p)) {
          mark_[t] = point;
          cavity_.push_back(t);
        } else {
          rim_.push_back({cavity_[i], k, t});
        }
      }
    edges_.clear();
    for (const Facet& facet : rim_) replace(facet, point);
    std::sort(edges_.begin(), edges_.end());
    for (std::size_t e = 0; e + 1 < edges_.size(); e += 2) {
      tetrahedra_.beyond[edges_[e].tetrahedron][edges_[e].corner] = edges_[e + 1].tetrahedron;
      tetrahedra_.beyond[edges_[e + 1].tetrahedron][edges_[e + 1].corner] = edges_[e].tetrahedron;
    }
    for (int t : cavity_) {
      tetrahedra_.corners[t][0] = -1;
      free_.push_back(t);
    }
  }

  struct Facet {
    int inner, corner, outer;
  };

  struct Edge {
    std::pair<int, int> ends;
    int tetrahedron, corner;
    bool operator<(const Edge& other) const { return ends < other.ends; }
  };

  void replace(const Facet& facet, int point) {
    std::array<int, 4> corners = tetrahedra_.corners[facet.inner];
    corners[facet.corner] = point;
    std::array<int, 4> beyond{-1, -1, -1, -1};
    beyond[facet.corner] = facet.outer;
    int t = static_cast<int>(tetrahedra_.corners.size());
    if (free_.empty()) {
      tetrahedra_.corners.push_back(corners);
      tetrahedra_.beyond.push_back(beyond);
      mark_.push_back(-1);
    } else {
      t = free_.back();
      free_.pop_back();
      tetrahedra_.corners[t] = corners;
      tetrahedra_.beyond[t] = beyond;
      mark_[t] = -1;
    }
    // The outer one's face is the one opposite the corner that is not of the facet.
    const std::array<int, 4>& outer = tetrahedra_.corners[facet.outer];
    for (int k = 0; k < 4; ++k)
      if (std::find(corners.begin(), corners.end(), outer[k]) == corners.end())
        tetrahedra_.beyond[facet.outer][k] = t;
    for (int k = 0; k < 4; ++k) {
      if (k == facet.corner) continue;
      std::array<int, 2> ends{};
      int count = 0;
      for (int m = 0; m < 4; ++m)
        if (m != k && m != facet.corner) ends[count++] = corners[m];
      edges_.push_back({std::minmax(ends[0], ends[1]), t, k});
    }
    last_ = t;
  }

  Tetrahedra compact() {
    std::vector<int> number(tetrahedra_.corners.size(), -1);
    Tetrahedra result;
    for (std::size_t t = 0; t < number.size(); ++t) {
      if (tetrahedra_.corners[t][0] < 0) continue;
      number[t] = static_cast<int>(result.corners.size());
      result.corners.push_back(tetrahedra_.corners[t]);
      result.beyond.push_back(tetrahedra_.beyond[t]);
    }
    for (auto& beyond : result.beyond)
      for (int& t : beyond) t = number[t];
    return result;
  }

  std::vector<LatticePoint> places_;
  int infinity_ = 0;
  Tetrahedra tetrahedra_;
  std::vector<int> mark_, cavity_, free_;
  std::vector<Facet> rim_;
  std::vector<Edge> edges_;
  int last_ = 0;
};

}  // namespace

std::array<int, 3> Tetrahedra::face(int t, int k) const {
  constexpr int OTHERS[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  return {corners[t][OTHERS[k][0]], corners[t][OTHERS[k][1]], corners[t][OTHERS[k][2]]};
}

int Tetrahedra::mirror(int t, int k) const {
  const std::array<int, 4>&other = corners[beyond[t][k]], &own = corners[t];
  int corner = 0;
  // Of the other's corners only the one sought is not in the face.
  while (own[k] != other[corner] && std::find(own.begin(), own.end(), other[corner]) != own.end())
    ++corner;
  return corner;
}

Stars starsOf(const Tetrahedra& tetrahedra, int point_count) {
  // The point at infinity counts as one.
  Stars stars;
  stars.first.assign(point_count + 2, 0);
  for (const auto& corners : tetrahedra.corners)
    for (int v : corners) ++stars.first[v + 1];
  std::partial_sum(stars.first.begin(), stars.first.end(), stars.first.begin());
  std::vector<int> next(stars.first.begin(), stars.first.end() - 1);
  stars.tetrahedra.resize(stars.first.back());
  for (int t = 0; t < tetrahedra.size(); ++t)
    for (int v : tetrahedra.corners[t]) stars.tetrahedra[next[v]++] = t;
  return stars;
}

std::optional<Tetrahedra> delaunay(const Points& points) { return Insertion(points).run(); }

}  // namespace posture
