// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/refine/tip_maps.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <utility>

namespace posture {
namespace {

/// Ears and nose are one tip.
constexpr double TIP_RADIUS = 0.2;

/// A body has a head, a tail and four limbs. So many are matched at least, which is the fewest that
/// tell where other places are, and so many may be left out of those that could be.
constexpr std::size_t MOST_TIPS = 8, LEAST_MATCHED = 4, MOST_LEFT_OUT = 2;

/// A limb is compared by how much of the surface is within these distances of its tip.
constexpr std::array<double, 4> LIMB_RADII{0.1, 0.2, 0.3, 0.45};

/// Tips whose distances differ by more than this, relative to their mean, are not the same two:
/// the trunks of cats stretch by half.
constexpr double TOLERANCE = 0.6;

/// What a tip without a partner costs: as much as distances that differ by a tenth.
constexpr double LEFT_OUT = 0.1;

double relativeDifference(double a, double b) { return 2 * std::abs(a - b) / (a + b); }

/// The share of the surface within each radius of a place, by its logarithm.
using Thickness = std::array<double, LIMB_RADII.size()>;

Thickness thicknessAt(const Matrix& distances, int tip) {
  Thickness thickness{};
  for (std::size_t k = 0; k < thickness.size(); ++k)
    thickness[k] =
        std::log(static_cast<double>((distances.col(tip).array() < LIMB_RADII[k]).count()) /
                 static_cast<double>(distances.rows()));
  return thickness;
}

double difference(const Thickness& a, const Thickness& b) {
  double sum = 0;
  for (std::size_t k = 0; k < a.size(); ++k) sum += std::abs(a[k] - b[k]);
  return sum / static_cast<double>(a.size());
}

/// Tips of one shape and where they go on the other.
struct TipMatch {
  std::vector<std::pair<int, int>> pairs;
  double misfit = 0;
};

/// The best of all ways to match the tips of two shapes.
class TipMatcher {
  static constexpr std::size_t ROOM = 1000;

 public:
  TipMatcher(const Matrix& a,
             const Matrix& b,
             std::vector<int> tips_a,
             std::vector<int> tips_b,
             std::size_t kept)
      : a_(a),
        b_(b),
        tips_a_(std::move(tips_a)),
        tips_b_(std::move(tips_b)),
        kept_(kept),
        most_(std::min(tips_a_.size(), tips_b_.size())),
        used_(tips_b_.size(), 0),
        unlike_(tips_a_.size(), tips_b_.size()) {
    for (std::size_t i = 0; i < tips_a_.size(); ++i)
      for (std::size_t j = 0; j < tips_b_.size(); ++j)
        unlike_(i, j) = difference(thicknessAt(a, tips_a_[i]), thicknessAt(b, tips_b_[j]));
    if (most_ >= LEAST_MATCHED) matchFrom(0);
    keepBest();
  }

  /// By increasing misfit.
  const std::vector<TipMatch>& best() const { return matches_; }

 private:
  void matchFrom(std::size_t i) {
    const std::size_t least = std::max(LEAST_MATCHED, most_ - std::min(most_, MOST_LEFT_OUT));
    if (current_.size() + (tips_a_.size() - i) < least) return;
    if (i == tips_a_.size()) {
      matches_.push_back(currentMatch());
      if (matches_.size() == kept_ + ROOM) keepBest();
      return;
    }
    for (std::size_t j = 0; j < tips_b_.size(); ++j) {
      if (used_[j] || !agrees(tips_a_[i], tips_b_[j])) continue;
      used_[j] = 1;
      current_.emplace_back(i, j);
      matchFrom(i + 1);
      current_.pop_back();
      used_[j] = 0;
    }
    matchFrom(i + 1);
  }

  bool agrees(int p, int q) const {
    return std::all_of(current_.begin(), current_.end(), [&](const auto& pair) {
      return relativeDifference(a_(p, tips_a_[pair.first]), b_(q, tips_b_[pair.second])) <
             TOLERANCE;
    });
  }

  TipMatch currentMatch() const {
    TipMatch match;
    double far = 0, unlike = 0;
    for (auto [i, j] : current_) {
      unlike += unlike_(i, j);
      for (auto [p, q] : match.pairs)
        far += relativeDifference(a_(tips_a_[i], p), b_(tips_b_[j], q));
      match.pairs.emplace_back(tips_a_[i], tips_b_[j]);
    }
    const auto n = static_cast<double>(current_.size());
    match.misfit =
        far / (0.5 * n * (n - 1)) + unlike / n + LEFT_OUT * (static_cast<double>(most_) - n);
    return match;
  }

  void keepBest() {
    std::stable_sort(matches_.begin(), matches_.end(), [](const TipMatch& x, const TipMatch& y) {
      return x.misfit < y.misfit;
    });
    matches_.resize(std::min(matches_.size(), kept_));
  }

  const Matrix& a_;
  const Matrix& b_;
  std::vector<int> tips_a_, tips_b_;
  std::size_t kept_, most_;
  std::vector<char> used_;
  Matrix unlike_;
  std::vector<std::pair<std::size_t, std::size_t>> current_;
  std::vector<TipMatch> matches_;
};

/// Whether a match is another one with tips left out. Pairs are in the order of the first shape's
/// tips.
bool isPartOf(const TipMatch& part, const TipMatch& whole) {
  std::size_t found = 0;
  for (const auto& pair : whole.pairs)
    if (found < part.pairs.size() && part.pairs[found] == pair) ++found;
  return found == part.pairs.size();
}

std::vector<int> nearestRows(const Matrix& from, const Matrix& to) {
  std::vector<int> nearest(from.rows());
  for (int i = 0; i < from.rows(); ++i) {
    Eigen::Index best = 0;
    (to.rowwise() - from.row(i)).rowwise().squaredNorm().minCoeff(&best);
    nearest[i] = static_cast<int>(best);
  }
  return nearest;
}

SampleMap mapOf(const TipMatch& match, const SampledShape& a, const SampledShape& b) {
  std::vector<int> of_a, of_b;
  for (auto [p, q] : match.pairs) {
    of_a.push_back(p);
    of_b.push_back(q);
  }
  return mapBetweenPlaces(a, a.distances(Eigen::all, of_a), b, b.distances(Eigen::all, of_b));
}

}  // namespace

std::vector<int> tipsOf(const SampledShape& shape) {
  const Vector remoteness = shape.distances.rowwise().mean();
  std::vector<int> order(remoteness.size()), tips;
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
      order.begin(), order.end(), [&](int i, int j) { return remoteness[i] > remoteness[j]; });
  for (const int i : order) {
    if (tips.size() == MOST_TIPS) break;
    const auto near = shape.distances.col(i).array() < TIP_RADIUS;
    const bool known = std::any_of(tips.begin(), tips.end(), [&](int tip) { return near[tip]; });
    if (!known && near.select(remoteness.array(), 0).maxCoeff() <= remoteness[i]) tips.push_back(i);
  }
  return tips;
}

std::vector<SampleMap> tipMaps(const SampledShape& a, const SampledShape& b, int most) {
  const TipMatcher matcher(
      a.distances, b.distances, tipsOf(a), tipsOf(b), 8 * static_cast<std::size_t>(most));
  std::vector<TipMatch> matches;
  for (const TipMatch& match : matcher.best()) {
    if (static_cast<int>(matches.size()) == most) break;
    if (std::none_of(matches.begin(), matches.end(), [&](const TipMatch& better) {
          return isPartOf(match, better);
        }))
      matches.push_back(match);
  }
  std::vector<SampleMap> maps(matches.size());
  parallelFor(static_cast<int>(maps.size()), [&](int i) { maps[i] = mapOf(matches[i], a, b); });
  return maps;
}

SampleMap mapBetweenPlaces(const SampledShape& a,
                           const Matrix& from_a,
                           const SampledShape& b,
                           const Matrix& from_b) {
  // What is near a known place says more: limbs keep their lengths, trunks do not.
  const double spacing = std::max(a.spacing, b.spacing);
  const Matrix near_a = (from_a.array() + spacing).rsqrt(),
               near_b = (from_b.array() + spacing).rsqrt();
  SampleMap map{nearestRows(near_a, near_b), nearestRows(near_b, near_a), 0};
  map.distortion = distortion(a, b, map);
  return map;
}

}  // namespace posture
