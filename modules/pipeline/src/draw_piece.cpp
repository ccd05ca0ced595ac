// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "draw_piece.h"

#include <posture/core/parallel.h>
#include <posture/mesh/moment_axes.h>
#include <posture/mesh/nearest_in_triangle.h>
#include <posture/mesh/rigid_motion.h>
#include <posture/mesh/weld.h>

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

/// So much of what goes on around a piece may do so where the piece does not end.
constexpr double MOST_GOING_ON = 0.1;

/// Fewer points do not tell where they belong, nor does what is smaller than half a hand: in sizes
/// of the body.
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

/// Rows far from each other, from the given one on.
std::vector<int> farthestPoints(const Points& points, int first, int count) {
  std::vector<int> chosen{first};
  Vector distance = (points.rowwise() - points.row(first)).rowwise().norm();
  while (static_cast<int>(chosen.size()) < count) {
    int farthest = 0;
    if (!(distance.maxCoeff(&farthest) > 0)) break;
    chosen.push_back(farthest);
    distance = distance.cwiseMin((points.rowwise() - points.row(farthest)).rowwise().norm());
  }
  return chosen;
}

/// Motions that lay places of a piece on places of the target and their normals on the normals
/// there, turned about these every way; the least turned from `motion` first.
std::vector<Eigen::Isometry3d> startsFrom(const TargetPart& target,
                                          const Piece& piece,
                                          const std::vector<int>& of_piece,
                                          const std::vector<int>& of_target,
                                          const Eigen::Isometry3d& motion) {
  const TargetSurface& surface = target.surface();
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

/// Faces between the first vertices at each place.
TriangleMesh between(TriangleMesh mesh, const std::vector<int>& first) {
  for (int& v : mesh.faces.reshaped()) v = first[v];
  return mesh;
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

double fitAt(double distance) {
  const double miss = distance / ON_SURFACE;
  return 1 / (1 + miss * miss);
}

TargetSurface::TargetSurface(TriangleMesh surface,
                             Points vertex_normals,
                             double mean_edge,
                             double body_size)
    : first(weld(surface.vertices)),
      mesh(between(std::move(surface), first)),
      normals(std::move(vertex_normals)),
      neighbors(mesh.faces, static_cast<int>(first.size())),
      faces_around(mesh.faces, static_cast<int>(first.size())),
      edge(mean_edge),
      size(body_size) {}

TargetPart::TargetPart(const TargetSurface& surface, std::vector<int> vertices)
    : surface_(surface), vertex_(std::move(vertices)), counts_(surface.mesh.vertices.rows(), 0) {
  const auto is_copy = [&](int v) { return surface.first[v] != v; };
  vertex_.erase(std::remove_if(vertex_.begin(), vertex_.end(), is_copy), vertex_.end());
  for (int v : vertex_) counts_[v] = 1;
  if (!vertex_.empty()) index_.emplace(surface.mesh.vertices(vertex_, Eigen::all));
}

TargetPart::Near TargetPart::nearest(const Eigen::RowVector3d& place) const {
  const TriangleMesh& mesh = surface_.mesh;
  Near near;
  near.at.vertex = vertex_[index_->nearest(place.transpose()).index];
  near.place = mesh.vertices.row(near.at.vertex);
  double least = (near.place - place).norm();
  const VertexFaces& around = surface_.faces_around;
  for (const int* f = around.begin(near.at.vertex); f != around.end(near.at.vertex); ++f) {
    const Eigen::RowVector3i corners = mesh.faces.row(*f);
    const Eigen::Matrix3d places = mesh.vertices(corners, Eigen::all);
    const Eigen::Vector3d at = nearestInTriangle<Eigen::Vector3d>(
        place.transpose(), places.row(0), places.row(1), places.row(2));
    const Eigen::RowVector3d there = at.transpose() * places;
    const double distance = (there - place).norm();
    if (near.at.face >= 0 && !(distance < least)) continue;
    least = std::min(least, distance);
    near.place = there;
    near.at.face = *f;
    near.at.barycentric = at;
  }
  near.distance = least / surface_.edge;
  return near;
}

std::vector<TargetPart::Near> TargetPart::nearest(const Piece& piece,
                                                  const Eigen::Isometry3d& motion) const {
  const Points places = moved(motion, piece.points);
  std::vector<Near> near;
  for (int i = 0; i < places.rows(); ++i) {
    near.push_back(nearest(places.row(i)));
    const Eigen::Vector3d normal = motion.linear() * piece.normals.row(i).transpose();
    near.back().same_way = normal.dot(surface_.normals.row(near.back().at.vertex)) >= 0;
  }
  return near;
}

double TargetPart::goingOn(const Piece& piece, const Eigen::Isometry3d& motion) const {
  const Points& vertices = surface_.mesh.vertices;
  const Points places = moved(motion, piece.points);
  const PointIndex on_piece(places);
  std::vector<int> rim;
  for (int i = 0; i < places.rows(); ++i)
    if (piece.on_rim[i] != 0) rim.push_back(i);
  if (rim.size() == piece.on_rim.size()) return 0;
  const std::optional<PointIndex> on_rim =
      rim.empty() ? std::nullopt : std::make_optional<PointIndex>(places(rim, Eigen::all));
  // Between the points of a coarse piece its surface goes on, too.
  const double beyond = FARTHEST * std::max(edge(), piece.edge);
  const auto isNearRim = [&](int i) {
    return on_rim && on_rim->nearest(places.row(i).transpose()).distance < beyond;
  };
  // From where the piece lies on, as far as it is near.
  std::vector<int> reached;
  std::vector<char> seen(vertices.rows(), 0);
  const auto reach = [&](int v) {
    if (seen[v] != 0 || counts_[v] == 0) return;
    seen[v] = 1;
    reached.push_back(v);
  };
  for (const Near& near : nearest(piece, motion))
    if (near.distance < ON_SURFACE && near.same_way) reach(near.at.vertex);
  int ends = 0, goes_on = 0;
  for (std::size_t k = 0; k < reached.size(); ++k) {
    const int v = reached[k];
    const PointIndex::Neighbor near = on_piece.nearest(vertices.row(v).transpose());
    if (near.distance > 2 * beyond) continue;
    if (near.distance > beyond) ++(isNearRim(near.index) ? ends : goes_on);
    std::for_each(surface_.neighbors.begin(v), surface_.neighbors.end(v), reach);
  }
  return goes_on == 0 ? 0 : static_cast<double>(goes_on) / (ends + goes_on);
}

std::vector<int> TargetPart::spread(const Eigen::RowVector3d& around,
                                    double distance,
                                    int count) const {
  std::vector<int> within;
  Eigen::Index first = 0;
  double least = distance;
  for (int v : vertex_) {
    const double d = (surface_.mesh.vertices.row(v) - around).norm();
    if (!(d < distance) || !(surface_.normals.row(v).squaredNorm() > 0)) continue;
    if (d < least) {
      least = d;
      first = static_cast<Eigen::Index>(within.size());
    }
    within.push_back(v);
  }
  if (within.empty()) return within;
  std::vector<int> chosen;
  for (int i :
       farthestPoints(surface_.mesh.vertices(within, Eigen::all), static_cast<int>(first), count))
    chosen.push_back(within[i]);
  return chosen;
}

Points moved(const Eigen::Isometry3d& motion, const Points& points) {
  return (points * motion.linear().transpose()).rowwise() + motion.translation().transpose();
}

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
  const auto extent = piece.points.colwise().maxCoeff() - piece.points.colwise().minCoeff();
  if (target.empty() || piece.points.rows() < LEAST_DRAWN ||
      !(extent.norm() > LEAST_EXTENT * target.size()))
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
  if (!fitsAtAll(best_fit) || !liesOn(target, piece, best_fit.motion)) return {};
  const Points places = moved(best_fit.motion, few.points);
  for (const Fit& fit : fits)
    if (fitsAtAll(fit) && fit.misfit < AS_WELL * std::max(PERFECT, best_fit.misfit) &&
        meanDistance(moved(fit.motion, few.points), places) > ELSEWHERE * target.size())
      return {};
  return best_fit.motion;
}

}  // namespace posture
