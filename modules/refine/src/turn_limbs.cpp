// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/parallel.h>
#include <posture/mesh/rigid_motion.h>
#include <posture/refine/rigid_ends.h>
#include <posture/refine/turn_limbs.h>

#include "limb_pair.h"
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace posture {
namespace {

/// Lengths in square roots of the area: a hand or a foot turns as a whole, and what is beyond the
/// elbow, or beyond the shoulder, does not. A whole turn between hand and shoulder never was right.
constexpr std::array<LimbTurn, 6> TURNS{{{M_PI, 0.1, 0.35},
                                         {-M_PI, 0.1, 0.35},
                                         {2 * M_PI, 0.1, 0.35},
                                         {-2 * M_PI, 0.1, 0.35},
                                         {M_PI, 0.15, 0.6},
                                         {-M_PI, 0.15, 0.6}}};

/// How far from its tip a limb is looked at: an arm with the shoulder.
constexpr double REACH = 0.7;

/// Of the misfit as it is. What is right on a finer mesh had at most 1.012 of it on the coarse one.
constexpr double NEARLY_AS_GOOD = 1.02;

/// A hand or a hoof is turned as a whole, so far from the tip, and what follows it up to one of the
/// joints takes the turn up.
constexpr double TURNED_WHOLE = 0.1;
constexpr std::array<double, 2> JOINTS{0.25, 0.35};
constexpr std::array<double, 5> END_ANGLES{0, M_PI / 2, -M_PI / 2, M_PI, -M_PI};

/// How far beyond what turns a limb is looked at.
constexpr double MARGIN = 0.1;

/// What takes up how an end is moved that is laid as it fits, and how much beyond is looked at: a
/// head with a quarter of the body around it would be no limb any more.
constexpr double NECK = 0.1, BESIDE_NECK = 0.05;

/// The end of a limb by which turns of it are judged, and how much is looked at to see what a turn
/// did to the rest.
constexpr double END = 0.2, AROUND = JOINTS.back() + MARGIN;

/// Vertices of an end on either side. A tail of six vertices around fits where those of both meshes
/// happen to fall on each other: of six ends with 36 to 47 vertices four were turned wrongly, of
/// those with 74 and more next to none.
constexpr std::size_t FEWEST_TO_JUDGE = 64;

/// Misfit of an end below which it is left alone: normals less than about 20 degrees off, all else
/// right. Ends that gained by a turn had 0.45 and more.
constexpr double FITS = 0.4;

/// Of the end's misfit as it is, and of that unturned. Annealing what fits again changes it by up
/// to 0.08.
constexpr double CLEARLY_BETTER = 0.9;

/// Misfit of an end from which on it does not fit, however it is turned: something else is wrong
/// with it (it has no counterpart, or is crushed), which a turn can make better and the map worse.
/// Ends that were turned rightly came to 0.73 and less.
constexpr double FITS_NOWHERE = 1;

/// The end of a limb of both surfaces.
class EndPair {
 public:
  EndPair(const SpectralSurface& a,
          const SpectralSurface& b,
          int tip,
          double reach,
          double softness,
          const BentPair& pair)
      : whole_a_(a),
        whole_b_(b),
        a_(limbAt(a, tip, reach)),
        b_(limbAt(b, pair.maps.forward[tip], reach)),
        softness_(softness) {}

  /// Whether there is enough of it to tell which way it is turned.
  bool isEnd() const { return std::min(a_.vertex.size(), b_.vertex.size()) >= FEWEST_TO_JUDGE; }

  /// \param pair  here and below of the whole surfaces.
  double gap(const BentPair& pair) const {
    return oneWayGap(whole_a_, a_.vertex, whole_b_, softness_, pair) +
           oneWayGap(whole_b_, b_.vertex, whole_a_, softness_, reversed(pair));
  }

  double misfit(const BentPair& pair) const {
    return oneWayMisfit(whole_a_, {a_.vertex, a_.surface->arap}, whole_b_, softness_, pair) +
           oneWayMisfit(
               whole_b_, {b_.vertex, b_.surface->arap}, whole_a_, softness_, reversed(pair));
  }

 private:
  const SpectralSurface &whole_a_, &whole_b_;
  Limb a_, b_;
  double softness_;
};

/// Both whole surfaces as they lie.
struct Lying {
  double misfit = std::numeric_limits<double>::infinity();  ///< of a limb's end
  BentPair whole;

  bool operator<(const Lying& other) const { return misfit < other.misfit; }
};

/// One for each of END_ANGLES.
std::vector<Lying> endsTurned(const LimbPair& limb,
                              double joint,
                              const EndPair& end,
                              const BentPair& pair) {
  std::vector<Lying> laid(END_ANGLES.size());
  parallelFor(static_cast<int>(laid.size()), [&](int k) {
    try {
      laid[k].whole = pair;
      limb.putInto(limb.annealed({END_ANGLES[k], TURNED_WHOLE, joint}), laid[k].whole);
      const double misfit = end.misfit(laid[k].whole);
      if (std::isfinite(misfit)) laid[k].misfit = misfit;
    } catch (const TornSurface&) {  // a crumb of the limb that nothing holds
    }
  });
  return laid;
}

/// The motion of vertices from where they lie to where another motion takes them from rest.
Eigen::Isometry3d moveTo(const Eigen::Isometry3d& motion,
                         const Points& rest,
                         const Points& bent,
                         const std::vector<int>& vertices) {
  return rigidMotion(bent(vertices, Eigen::all), moved(motion, rest(vertices, Eigen::all)));
}

/// With the end laid as it fits as a rigid body, where it does so in one way only and lies turned:
/// a head, about whatever axis. The neck takes up what that moves it by.
Lying laidAsItFits(const SpectralSurface& a,
                   const SpectralSurface& b,
                   int tip,
                   double softness,
                   const EndPair& end,
                   const BentPair& pair) {
  Lying lying;
  const std::vector<RigidEnd> fitting = rigidEnds(a, b, {tip}, pair.maps);
  if (fitting.empty() || !fitting.front().turned) return lying;
  const RigidEnd& rigid = fitting.front();
  EndMove move;
  for (int v : rigid.vertices) move.end = std::max(move.end, a.distances.from(tip)[v]);
  move.body = move.end + NECK;
  const LimbPair limb(a, b, tip, move.body + BESIDE_NECK, softness, pair);
  if (!limb.isLimb()) return lying;
  move.of_a = moveTo(rigid.motion, a.mesh.vertices, pair.bent_a, rigid.vertices);
  move.of_b = moveTo(rigid.motion.inverse(), b.mesh.vertices, pair.bent_b, rigid.of_b);
  lying.whole = pair;
  limb.putInto(limb.annealed(move), lying.whole);
  const double misfit = end.misfit(lying.whole);
  if (std::isfinite(misfit)) lying.misfit = misfit;
  return lying;
}

}  // namespace

std::vector<LimbTurn> likelyTurns(const SpectralSurface& a,
                                  const SpectralSurface& b,
                                  int tip,
                                  double softness,
                                  const BentPair& pair,
                                  std::size_t most) {
  const LimbPair limb(a, b, tip, REACH, softness, pair);
  if (!limb.isLimb()) return {};
  std::vector<LimbTurn> likely;
  for (const Trial& trial : trials(limb, {TURNS.begin(), TURNS.end()}))
    if (likely.size() < most && trial.misfit < NEARLY_AS_GOOD) likely.push_back(trial.turn);
  return likely;
}

bool turnLimb(const SpectralSurface& a,
              const SpectralSurface& b,
              int tip,
              double softness,
              const std::vector<LimbTurn>& turns,
              BentPair& pair) {
  if (turns.empty()) return false;
  const LimbPair limb(a, b, tip, REACH, softness, pair);
  if (!limb.isLimb()) return false;
  const Trial best = trials(limb, turns).front();
  if (!(best.misfit < 1)) return false;
  limb.putInto(best.limb, pair);
  return true;
}

bool refitLimbEnd(
    const SpectralSurface& a, const SpectralSurface& b, int tip, double softness, BentPair& pair) {
  const EndPair end(a, b, tip, END, softness, pair);
  if (!end.isEnd()) return false;
  const double in_place = end.misfit(pair);
  if (!(in_place >= FITS && std::isfinite(in_place))) return false;
  const double good = CLEARLY_BETTER * in_place;
  Lying best{in_place, pair}, turned;
  for (double joint : JOINTS) {
    const LimbPair limb(a, b, tip, joint + MARGIN, softness, pair);
    if (!limb.isLimb()) continue;
    std::vector<Lying> laid = endsTurned(limb, joint, end, pair);
    if (laid.front() < best) best = std::move(laid.front());
    const auto least = std::min_element(laid.begin() + 1, laid.end());
    if (*least < turned) turned = std::move(*least);
    // Heads, which mostly fit no better in any way, are done with sooner.
    if (!(std::min(best.misfit, turned.misfit) < good)) break;
  }
  if (turned.misfit < CLEARLY_BETTER * best.misfit) best = std::move(turned);
  if (best.misfit >= FITS) {
    // Chosen by how the end fits as a body, not among turns: it need not be clearly better than
    // these.
    try {
      Lying fitting = laidAsItFits(a, b, tip, softness, end, pair);
      if (fitting < best) best = std::move(fitting);
    } catch (const TornSurface&) {  // a crumb of the limb that nothing holds
    }
  }
  if (!(best.misfit < good && best.misfit < FITS_NOWHERE)) return false;
  pair = std::move(best.whole);
  return true;
}

bool limbFitsBetter(const SpectralSurface& a,
                    const SpectralSurface& b,
                    int tip,
                    double softness,
                    const BentPair& before,
                    const BentPair& after) {
  const EndPair limb(a, b, tip, AROUND, softness, before);
  return limb.isEnd() && limb.gap(after) < limb.gap(before);
}

}  // namespace posture
