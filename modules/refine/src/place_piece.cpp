// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/median.h>
#include <posture/core/parallel.h>
#include <posture/refine/place_piece.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace posture {
namespace {

constexpr int ANCHORS = 4;

/// Anchors go to the first samples of the whole only, the rest of the piece to all of them.
constexpr int ANCHOR_PLACES = 150;

using Anchors = std::array<int, ANCHORS>;

/// The piece is a twentieth of the whole at least, and may come out a little larger than it.
constexpr double LEAST_SCALE = 0.22, MOST_SCALE = 1.15, SCALE_STEP = 1.08;

/// Distances that differ by less than this agree, beside what the samples leave open.
constexpr double STRETCH = 0.06;

/// A sample that has no place adds so much of the mean distance and no more.
constexpr double WORST = 0.25;

/// How many samples tell which anchors are worth a second look, and how many anchors get one.
constexpr int FIRST_LOOK = 16;
constexpr std::size_t FIRST_LOOKS_A_SCALE = 20000, LOOKS_A_SCALE = 40, SECOND_LOOKS = 240;
constexpr int ROUNDS = 6;

struct Try {
  double scale = 1;
  Anchors at{};
  double misfit = 0;
};

/// The `most` of least misfit, in order; of equal ones the smaller scale, then those found first.
void keepBest(std::size_t most, std::vector<Try>& tries) {
  const auto better = [](const Try& a, const Try& b) {
    return std::tie(a.misfit, a.scale, a.at) < std::tie(b.misfit, b.scale, b.at);
  };
  const auto kept = static_cast<std::ptrdiff_t>(std::min(most, tries.size()));
  std::partial_sort(tries.begin(), tries.begin() + kept, tries.end(), better);
  tries.resize(kept);
}

/// How far a point of the whole may be from the places of anchors: as the farthest sample is or,
/// where all samples are places, as the last one is from those before it.
double spacingOf(const Matrix& whole, int places) {
  const auto last = places - 1;
  return places < whole.rows() ? whole.topRows(places).colwise().minCoeff().maxCoeff()
                               : whole.row(last).head(last).minCoeff();
}

class Placer {
 public:
  Placer(const Matrix& piece, const Matrix& whole)
      : piece_(piece),
        whole_(whole),
        anchor_places_(std::min<int>(ANCHOR_PLACES, static_cast<int>(whole.rows()))),
        spacing_(spacingOf(whole, anchor_places_)),
        mean_(piece.mean()) {}

  /// Of the places anchors may have.
  double spacing() const { return spacing_; }

  /// The best places of the anchors at one scale.
  std::vector<Try> tries(double scale) const {
    std::vector<Try> found;
    for (Try& current : firstThree(scale)) {
      current.at[3] = nearestTo(scale, current.at, 3, 3);
      if (!agrees(scale, current.at, 3)) continue;
      current.misfit = firstLook(scale, current.at);
      found.push_back(current);
    }
    keepBest(LOOKS_A_SCALE, found);
    return found;
  }

  /// All samples placed, from the anchors on.
  PiecePlace place(const Try& first) const {
    const int s = static_cast<int>(piece_.rows());
    PiecePlace place{std::vector<int>(s), first.scale, 0};
    for (int i = 0; i < s; ++i)
      place.sample[i] = i < ANCHORS ? first.at[i] : nearestTo(first.scale, first.at, i);
    for (int round = 0; round < ROUNDS; ++round) {
      place.scale = scaleOf(place);
      const std::vector<int> before = place.sample;
      for (int i = 0; i < s; ++i) place.sample[i] = bestPlace(place.scale, before, i);
      if (place.sample == before) break;
    }
    place.scale = scaleOf(place);
    double sum = 0;
    for (int i = 0; i < s; ++i) sum += misfitAt(place.scale, place.sample, i, place.sample[i]);
    place.misfit = sum / (s * place.scale * mean_ * s);
    return place;
  }

  /// Mean distance between where two places have the samples.
  double gap(const PiecePlace& a, const PiecePlace& b) const {
    double sum = 0;
    for (std::size_t i = 0; i < a.sample.size(); ++i) sum += whole_(a.sample[i], b.sample[i]);
    return sum / static_cast<double>(a.sample.size());
  }

 private:
  /// Where the first three anchors agree with each other; of too many, those that agree best.
  std::vector<Try> firstThree(double scale) const {
    const int t = anchor_places_;
    std::vector<Try> found;
    Try current;
    current.scale = scale;
    Anchors& q = current.at;
    for (q[0] = 0; q[0] < t; ++q[0])
      for (q[1] = 0; q[1] < t; ++q[1]) {
        if (!agrees(scale, q, 1)) continue;
        for (q[2] = 0; q[2] < t; ++q[2]) {
          if (!agrees(scale, q, 2)) continue;
          current.misfit = std::max({off(scale, 0, 1, q[0], q[1]),
                                     off(scale, 0, 2, q[0], q[2]),
                                     off(scale, 1, 2, q[1], q[2])});
          found.push_back(current);
        }
        if (found.size() > 8 * FIRST_LOOKS_A_SCALE) keepBest(FIRST_LOOKS_A_SCALE, found);
      }
    keepBest(FIRST_LOOKS_A_SCALE, found);
    return found;
  }

  /// Whether anchor k agrees with those before it.
  bool agrees(double scale, const Anchors& q, int k) const {
    for (int j = 0; j < k; ++j)
      if (!(off(scale, j, k, q[j], q[k]) <= tolerance(scale * piece_(j, k)))) return false;
    return true;
  }

  double off(double scale, int i, int k, int at_i, int at_k) const {
    return std::abs(scale * piece_(i, k) - whole_(at_i, at_k));
  }

  double tolerance(double distance) const { return STRETCH * distance + spacing_; }

  double worst(double scale) const { return WORST * scale * mean_; }

  /// By how much sample i, at that place, misses its distances to the anchors: the most.
  double missed(double scale, const Anchors& q, int anchors, int i, int at) const {
    double most = 0;
    for (int k = 0; k < anchors; ++k) most = std::max(most, off(scale, i, k, at, q[k]));
    return most;
  }

  int nearestTo(double scale, const Anchors& q, int i, int anchors = ANCHORS) const {
    int best = 0;
    double least = missed(scale, q, anchors, i, 0);
    for (int at = 1; at < anchor_places_; ++at) {
      const double here = missed(scale, q, anchors, i, at);
      if (here < least) {
        least = here;
        best = at;
      }
    }
    return best;
  }

  double firstLook(double scale, const Anchors& q) const {
    const int count = std::min<int>(FIRST_LOOK, static_cast<int>(piece_.rows()));
    double sum = 0;
    for (int i = 0; i < count; ++i) {
      const int at = i < ANCHORS ? q[i] : nearestTo(scale, q, i);
      sum += std::min(worst(scale), missed(scale, q, ANCHORS, i, at));
    }
    return sum / (count * scale * mean_);
  }

  double misfitAt(double scale, const std::vector<int>& sample, int i, int at) const {
    const double most = worst(scale);
    double sum = 0;
    for (int k = 0; k < piece_.rows(); ++k) sum += std::min(most, off(scale, i, k, at, sample[k]));
    return sum;
  }

  int bestPlace(double scale, const std::vector<int>& sample, int i) const {
    int best = sample[i];
    double least = misfitAt(scale, sample, i, best);
    for (int at = 0; at < whole_.rows(); ++at) {
      const double here = misfitAt(scale, sample, i, at);
      if (here < least) {
        least = here;
        best = at;
      }
    }
    return best;
  }

  /// Median ratio of distances.
  double scaleOf(const PiecePlace& place) const {
    std::vector<double> ratios;
    for (int i = 0; i < piece_.rows(); ++i)
      for (int k = 0; k < i; ++k)
        if (piece_(i, k) > 0)
          ratios.push_back(whole_(place.sample[i], place.sample[k]) / piece_(i, k));
    return std::max(median(std::move(ratios)), LEAST_SCALE);
  }

  const Matrix& piece_;
  const Matrix& whole_;
  int anchor_places_;
  double spacing_, mean_;
};

}  // namespace

std::vector<PiecePlace> placePiece(const Matrix& piece, const Matrix& whole, int most) {
  require(piece.rows() == piece.cols() && whole.rows() == whole.cols() &&
              std::min(piece.rows(), whole.rows()) >= ANCHORS,
          "placePiece: square tables of at least four samples");
  require(piece.allFinite() && whole.allFinite() && piece.maxCoeff() > 0,
          "placePiece: distances that are not finite, or none at all");
  const Placer placer(piece, whole);
  const int scales =
      1 + static_cast<int>(std::log(MOST_SCALE / LEAST_SCALE) / std::log(SCALE_STEP));
  std::vector<std::vector<Try>> at_scale(scales);
  parallelFor(scales,
              [&](int i) { at_scale[i] = placer.tries(LEAST_SCALE * std::pow(SCALE_STEP, i)); });
  std::vector<Try> tries;
  for (const std::vector<Try>& some : at_scale) tries.insert(tries.end(), some.begin(), some.end());
  keepBest(SECOND_LOOKS, tries);
  std::vector<PiecePlace> places(tries.size());
  parallelFor(static_cast<int>(tries.size()), [&](int i) { places[i] = placer.place(tries[i]); });
  std::stable_sort(places.begin(), places.end(), [](const PiecePlace& a, const PiecePlace& b) {
    return a.misfit < b.misfit;
  });
  std::vector<PiecePlace> different;
  for (PiecePlace& place : places) {
    if (static_cast<int>(different.size()) >= most) break;
    if (std::none_of(different.begin(), different.end(), [&](const PiecePlace& known) {
          return placer.gap(place, known) < 2 * placer.spacing();
        }))
      different.push_back(std::move(place));
  }
  return different;
}

}  // namespace posture
