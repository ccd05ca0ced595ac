// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/completion/draw_piece.h"

#include <posture/core/parallel.h>
#include <posture/mesh/moment_axes.h>
#include <posture/mesh/rigid_motion.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace posture {
namespace {

/// How far from where the motion takes it a piece may begin, in sizes of the body.
constexpr double REACH = 0.35;

/// Of a piece's vertices, to call it placed.
constexpr double MOST = 0.6;

/// In edges: how far off in the mean a piece that fits is at most, where it is expected and at the
/// end of its reach, and that a perfect fit may be; a point counts FARTHEST at most.
constexpr double FITS_HERE = 0.8, FITS_FAR = 0.5, PERFECT = 0.1, FARTHEST = 4;

/// Of two places so far apart in the mean, in sizes of the body, where the misfit of one is less
/// than so many times that of the other, it is open which is right.
constexpr double ELSEWHERE = 0.1, AS_WELL = 2;

/// Of the misfit of a piece, beyond that of a perfect fit, its mirror image's where it is the one
/// that belongs there: a right foot on a left one.
constexpr double OTHER_SIDE = 0.75;

/// Ways to lay the mirror image of a piece where the piece lies, about its longest axis.
constexpr int MIRRORED = 8;

/// So much of what goes on around a piece may do so where the piece does not end.
constexpr double MOST_GOING_ON = 0.1;

/// Fewer points do not tell where they belong, nor does what is smaller than a hand: in sizes of
/// the body.
constexpr Eigen::Index LEAST_DRAWN = 30;
constexpr double LEAST_EXTENT = 0.05;

/// Of a piece so many points are drawn, and so many at first.
constexpr int FEW = 200, FEWER = 40;

/// Starts: so many places of the target, places of the piece and turns about their normal. Of what
/// they lead to at first, so many that differ by more than so much of the body's size go on.
constexpr int PLACES = 40, OF_PIECE = 4, TURNS = 8, GO_ON = 30;
constexpr double DIFFER = 0.015;

/// How many steps, and from where matches count at first, in sizes of the body.
struct Pull {
  int steps;
  double reach;
};
constexpr Pull AT_FIRST{6, 0.1}, THEN{20, 0.1};
constexpr std::size_t LEAST_MATCHES = 6;

/// The axes of a piece's own moments, which turn with it; the last one is the longest.
Eigen::Matrix3d ownAxes(const Points& points) {
  return momentAxes(points.rowwise() - points.colwise().mean(), Vector::Ones(points.rows()));
}

/// The diagonal of a box along its own axes.
double extentOf(const Points& points) {
  const Points along = points * ownAxes(points);
  return (along.colwise().maxCoeff() - along.colwise().minCoeff()).norm();
}

Piece some(const Piece& piece, const std::vector<int>& points) {
  return {piece.points(points, Eigen::all), piece.normals(points, Eigen::all), 0, {}, piece.edge};
}

/// At most so many of its points, evenly along its longest axis.
Piece thinned(const Piece& piece, int most) {
  const Points along = piece.points * ownAxes(piece.points);
  const int n = static_cast<int>(along.rows()), few = std::min(n, most);
  std::vector<int> order(n);
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    for (int k = 2; k >= 0; --k)
      if (along(a, k) != along(b, k)) return along(a, k) < along(b, k);
    return a < b;
  });
  std::vector<int> chosen(few);
  for (int i = 0; i < few; ++i)
    chosen[i] = order[static_cast<std::size_t>(i) * static_cast<std::size_t>(n) / few];
  return some(piece, chosen);
}

/// Motions that lay places of a piece on places of the target and their normals on the normals
/// there, turned about these every way; the least turned from `motion` first.
std::vector<Eigen::Isometry3d> startsFrom(const TargetPart& target,
                                          const Piece& piece,
                                          const std::vector<int>& of_piece,
                                          const std::vector<int>& of_target,
                                          const Eigen::Isometry3d& motion) {
  const PieceTarget& surface = target.surface();
  std::vector<Eigen::Isometry3d> starts{motion};
  for (int t : of_target)
    for (int p : of_piece) {
      const Eigen::Vector3d there = surface.normals.row(t),
                            here = motion.linear() * piece.normals.row(p).transpose();
      const Eigen::Matrix3d least =
          Eigen::Quaterniond::FromTwoVectors(here, there).toRotationMatrix() * motion.linear();
      for (int k = 0; k < TURNS; ++k)
        starts.push_back(Eigen::Translation3d(surface.mesh.vertices.row(t).transpose()) *
                         Eigen::AngleAxisd(2 * M_PI * k / TURNS, there.normalized()) *
                         Eigen::Isometry3d(least) *
                         Eigen::Translation3d(-piece.points.row(p).transpose()));
    }
  return starts;
}

/// Iterated closest points within a shrinking reach; nothing where too few are in reach.
std::optional<Eigen::Isometry3d> drawn(const TargetPart& target,
                                       const Piece& piece,
                                       const Pull& pull,
                                       Eigen::Isometry3d motion) {
  for (int step = 0; step < pull.steps; ++step) {
    const double share = 1 - static_cast<double>(step) / pull.steps;
    const double reach = std::max(ON_SURFACE, share * pull.reach * target.size() / target.edge());
    const std::vector<TargetPart::Near> near = target.nearest(piece, motion);
    std::vector<int> rows;
    Points goals(static_cast<Eigen::Index>(near.size()), 3);
    for (std::size_t i = 0; i < near.size(); ++i) {
      if (near[i].distance > reach || !near[i].same_way) continue;
      goals.row(static_cast<Eigen::Index>(rows.size())) = near[i].place;
      rows.push_back(static_cast<int>(i));
    }
    if (rows.size() < LEAST_MATCHES) return {};
    const Points places = moved(motion, piece.points(rows, Eigen::all));
    motion = rigidMotion(places, goals.topRows(places.rows())) * motion;
  }
  return motion;
}

/// Mean distance in edges; a place that looks the other way, or far off, counts as FARTHEST.
double misfit(const TargetPart& target, const Piece& piece, const Eigen::Isometry3d& motion) {
  double sum = 0;
  const std::vector<TargetPart::Near> near = target.nearest(piece, motion);
  for (const TargetPart::Near& at : near)
    sum += at.same_way ? std::min(FARTHEST, at.distance) : FARTHEST;
  return sum / static_cast<double>(near.size());
}

double meanDistance(const Points& a, const Points& b) { return (a - b).rowwise().norm().mean(); }

struct Fit {
  Eigen::Isometry3d motion;
  double misfit = 0;
};

/// Where all the starts lead, by increasing misfit.
std::vector<Fit> fitsFrom(const TargetPart& target,
                          const Piece& piece,
                          const Pull& pull,
                          const std::vector<Eigen::Isometry3d>& starts) {
  std::vector<std::optional<Fit>> reached(starts.size());
  parallelFor(static_cast<int>(starts.size()), [&](int i) {
    if (const auto there = drawn(target, piece, pull, starts[i]))
      reached[i] = Fit{*there, misfit(target, piece, *there)};
  });
  std::vector<Fit> fits;
  for (const std::optional<Fit>& fit : reached)
    if (fit) fits.push_back(*fit);
  std::stable_sort(
      fits.begin(), fits.end(), [](const Fit& a, const Fit& b) { return a.misfit < b.misfit; });
  return fits;
}

/// Whether the mirror image of a piece fits clearly better where it lies.
bool isOfOtherSide(const TargetPart& target, const Piece& piece, const Fit& fit) {
  // Mirrored in its plane of moments through the longest axis; any other such plane comes to that,
  // and a turn about the axis.
  const Eigen::Matrix3d axes = ownAxes(piece.points);
  const Eigen::RowVector3d middle = piece.points.colwise().mean();
  const Eigen::Matrix3d mirror =
      Eigen::Matrix3d::Identity() - 2 * axes.col(0) * axes.col(0).transpose();
  Piece image = piece;
  image.points = ((piece.points.rowwise() - middle) * mirror).rowwise() + middle;
  image.normals = piece.normals * mirror;
  std::vector<Eigen::Isometry3d> starts;
  starts.reserve(MIRRORED);
  for (int k = 0; k < MIRRORED; ++k)
    starts.push_back(fit.motion * Eigen::Translation3d(middle.transpose()) *
                     Eigen::AngleAxisd(2 * M_PI * k / MIRRORED, axes.col(2)) *
                     Eigen::Translation3d(-middle.transpose()));
  const std::vector<Fit> mirrored = fitsFrom(target, image, THEN, starts);
  return !mirrored.empty() &&
         mirrored.front().misfit + PERFECT < OTHER_SIDE * (fit.misfit + PERFECT);
}

/// The best of them that differ.
std::vector<Eigen::Isometry3d> different(const std::vector<Fit>& fits,
                                         const Piece& piece,
                                         double least) {
  std::vector<Eigen::Isometry3d> chosen;
  std::vector<Points> places;
  for (const Fit& fit : fits) {
    if (chosen.size() == GO_ON) break;
    Points there = moved(fit.motion, piece.points);
    if (std::any_of(places.begin(), places.end(), [&](const Points& other) {
          return meanDistance(there, other) < least;
        }))
      continue;
    chosen.push_back(fit.motion);
    places.push_back(std::move(there));
  }
  return chosen;
}

}  // namespace

bool liesOn(const TargetPart& target, const Piece& piece, const Eigen::Isometry3d& motion) {
  if (target.empty()) return false;
  const std::vector<TargetPart::Near> near = target.nearest(piece, motion);
  const auto on = std::count_if(near.begin(), near.end(), [](const TargetPart::Near& at) {
    return at.distance < ON_SURFACE && at.same_way;
  });
  return static_cast<double>(on) >= MOST * static_cast<double>(near.size());
}

std::optional<Eigen::Isometry3d> drawPiece(const TargetPart& target,
                                           const Piece& piece,
                                           const Eigen::Isometry3d& motion) {
  if (target.empty() || piece.points.rows() < LEAST_DRAWN ||
      !(extentOf(piece.points) > LEAST_EXTENT * target.size()))
    return {};
  const auto begins = [&](const Eigen::Isometry3d& at) -> Eigen::Vector3d {
    return at * Eigen::Vector3d(piece.points.row(piece.first));
  };
  const double reach = REACH * target.size();
  // How far from where it is expected it begins, in its reach.
  const auto shift = [&](const Eigen::Isometry3d& at) {
    return (begins(at) - begins(motion)).norm() / reach;
  };
  const Piece few = thinned(piece, FEW), fewer = thinned(few, FEWER);
  const std::vector<Eigen::Isometry3d> starts =
      startsFrom(target,
                 few,
                 farthestPoints(few.points, 0, OF_PIECE),
                 target.spread(begins(motion).transpose(), reach, PLACES),
                 motion);
  const std::vector<Eigen::Isometry3d> best =
      different(fitsFrom(target, fewer, AT_FIRST, starts), fewer, DIFFER * target.size());
  std::vector<Fit> fits = fitsFrom(target, few, THEN, best);
  fits.erase(std::remove_if(fits.begin(),
                            fits.end(),
                            [&](const Fit& fit) {
                              return fit.misfit >= AS_WELL * FITS_HERE || shift(fit.motion) > 1 ||
                                     target.goingOn(piece, fit.motion) > MOST_GOING_ON;
                            }),
             fits.end());
  if (fits.empty()) return {};
  const Fit& best_fit = fits.front();
  const auto fitsAtAll = [&](const Fit& fit) {
    return fit.misfit < FITS_HERE + (FITS_FAR - FITS_HERE) * shift(fit.motion);
  };
  if (!fitsAtAll(best_fit) || !liesOn(target, piece, best_fit.motion) ||
      isOfOtherSide(target, few, best_fit))
    return {};
  const Points places = moved(best_fit.motion, few.points);
  for (const Fit& fit : fits)
    if (fitsAtAll(fit) && fit.misfit < AS_WELL * std::max(PERFECT, best_fit.misfit) &&
        meanDistance(moved(fit.motion, few.points), places) > ELSEWHERE * target.size())
      return {};
  return best_fit.motion;
}

}  // namespace posture
