// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "refined/completion/loose_pieces.h"

#include <posture/core/unions.h>
#include <posture/mesh/areas.h>
#include <posture/mesh/corners.h>
#include <posture/mesh/edges.h>
#include <posture/mesh/point_index.h>
#include <posture/mesh/rigid_motion.h>
#include <posture/mesh/weld.h>

#include "refined/completion/draw_piece.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

namespace posture {
namespace {

/// Of the square root of the area: how much of the surface next to a piece tells its motion.
constexpr double SURROUNDINGS = 0.15;

/// The same: a piece nowhere farther from the main surface - an eye, a button, a crumb - goes where
/// the vertex next to it goes, when it does not find a better place.
constexpr double BESIDE = 0.1;

constexpr std::size_t LEAST_NEIGHBORS = 6;

/// So many vertices tell the motion as well as all of a fine mesh.
constexpr std::size_t MOST_NEIGHBORS = 5000;

/// Fewer vertices have no motion of their own: they stay with the vertex next to them.
constexpr std::size_t LEAST_PIECE = 3;

/// Vertices off the main surface, joined where faces join them or they are at one place; single
/// points in no face are pieces of their own. By their first vertex.
std::vector<std::vector<int>> loosePieces(const GivenShape& shape) {
  const int n = static_cast<int>(shape.input.vertices.rows());
  Unions joined(n);
  const auto loose = [&](int v) { return !shape.clean.isOnMain(v); };
  for (int f = 0; f < shape.input.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = shape.input.faces(f, k), b = shape.input.faces(f, (k + 1) % 3);
      if (loose(a) && loose(b)) joined.join(a, b);
    }
  const std::vector<int> first = weld(shape.input.vertices);
  for (int v = 0; v < n; ++v) joined.join(v, first[v]);

  std::vector<int> number(n, -1);
  std::vector<std::vector<int>> pieces;
  for (int v = 0; v < n; ++v) {
    if (!loose(v)) continue;
    int& piece = number[joined.root(v)];
    if (piece < 0) {
      piece = static_cast<int>(pieces.size());
      pieces.emplace_back();
    }
    pieces[piece].push_back(v);
  }
  return pieces;
}

/// Of those that do not belong to patches.
template <class Keep>
std::vector<int> verticesThat(const GivenShape& shape, const Keep& keep) {
  std::vector<int> kept;
  for (int v = 0; v < shape.ownVertices(); ++v)
    if (keep(v)) kept.push_back(v);
  return kept;
}

class Placing {
 public:
  Placing(const GivenShape& source, const GivenShape& target, LaidSide& laid)
      : source_(source),
        laid_(laid),
        normals_(inputNormals(source)),
        rim_(inputRim(source)),
        edge_(laid.scale * meanEdgeLength(source.clean.mesh)),
        surface_(pieceTarget(target)),
        whole_(surface_, verticesThat(target, [](int) { return true; })),
        free_(surface_,
              verticesThat(target,
                           [claimed = coveredBy(
                                source, laid, target.input.vertices, ON_SURFACE * surface_.edge)](
                               int v) { return claimed[v] == 0; })),
        main_(source.input.vertices, source.clean) {}

  void place(const std::vector<int>& piece) {
    if (piece.size() < LEAST_PIECE) return placeSingly(piece);
    const Piece scaled{laid_.scale * source_.input.vertices(piece, Eigen::all),
                       normals_(piece, Eigen::all),
                       nearestToMain(piece),
                       onRim(piece),
                       edge_};
    const std::optional<Eigen::Isometry3d> beside = motionBeside(piece);
    if (!beside) return leaveOut(piece);
    const bool is_beside = isBeside(piece);
    if (is_beside && liesOn(whole_, scaled, *beside)) return put(piece, scaled, *beside, whole_);
    const std::optional<Eigen::Isometry3d> drawn = drawPiece(free_, scaled, *beside);
    if (drawn) return put(piece, scaled, *drawn, free_);
    laid_.deformed(piece, Eigen::all) = moved(*beside, scaled.points);
    if (!is_beside) leaveOut(piece);
  }

  const std::vector<PlacedPiece>& placed() const { return placed_; }

 private:
  bool isBeside(const std::vector<int>& piece) const {
    return std::all_of(piece.begin(), piece.end(), [&](int v) {
      return laid_.scale * source_.clean.offset[v] < BESIDE * surface_.size;
    });
  }

  void placeSingly(const std::vector<int>& vertices) {
    for (int v : vertices) {
      const TargetPart::Near near = whole_.nearest(laid_.deformed.row(v));
      if (near.distance < ON_SURFACE)
        match(v, near);
      else if (!isBeside({v}))
        leaveOut({v});
    }
  }

  void match(int v, const TargetPart::Near& near) {
    laid_.correspondence.on_target[v] = near.at;
    laid_.correspondence.confidence[v] = laid_.trust * fitAt(near.distance);
  }

  /// The source's main surface, for neighbours.
  class Main {
   public:
    Main(const Points& vertices, const CleanMesh& clean)
        : vertex_(verticesOf(clean)), index_(vertices(vertex_, Eigen::all)) {}

    /// At most MOST_NEIGHBORS, in increasing order; by rounding perhaps some beyond.
    std::vector<int> within(const Eigen::RowVector3d& center, double radius) const {
      const std::vector<int> found = index_.within(center.transpose(), radius);
      const std::size_t stride = 1 + found.size() / (MOST_NEIGHBORS + 1);
      std::vector<int> taken;
      for (std::size_t i = 0; i < found.size(); i += stride) taken.push_back(vertex_[found[i]]);
      return taken;
    }

   private:
    static std::vector<int> verticesOf(const CleanMesh& clean) {
      std::vector<int> vertices;
      for (int v = 0; v < clean.offset.size(); ++v)
        if (clean.isOnMain(v)) vertices.push_back(v);
      return vertices;
    }

    std::vector<int> vertex_;
    PointIndex index_;
  };

  /// The number in it of the vertex of a piece that is nearest to the main surface.
  int nearestToMain(const std::vector<int>& piece) const {
    const auto nearest = std::min_element(piece.begin(), piece.end(), [&](int a, int b) {
      return source_.clean.offset[a] < source_.clean.offset[b];
    });
    return static_cast<int>(nearest - piece.begin());
  }

  std::vector<char> onRim(const std::vector<int>& piece) const {
    std::vector<char> on_rim;
    on_rim.reserve(piece.size());
    for (int v : piece) on_rim.push_back(rim_[v]);
    return on_rim;
  }

  /// That of the main surface around the vertex of it that is nearest to the piece.
  std::optional<Eigen::Isometry3d> motionBeside(const std::vector<int>& piece) {
    const int nearest = piece[nearestToMain(piece)];
    const Points& all = source_.input.vertices;
    const int anchor = source_.clean.clean_vertex[nearest];
    const auto known = motions_.find(anchor);
    if (known != motions_.end()) return known->second;
    const Eigen::RowVector3d center = all.row(source_.clean.input_vertex[anchor]);
    const double radius = SURROUNDINGS * surface_.size / laid_.scale;
    // Places of vertices that have a counterpart say more than those of others.
    std::vector<int> around, mapped;
    for (int v : main_.within(center, radius))
      if ((all.row(v) - center).norm() < radius) {
        around.push_back(v);
        if (laid_.correspondence.on_target[v].vertex >= 0) mapped.push_back(v);
      }
    if (mapped.size() >= LEAST_NEIGHBORS) around = std::move(mapped);
    std::optional<Eigen::Isometry3d>& motion = motions_[anchor];
    if (around.size() >= LEAST_NEIGHBORS)
      motion =
          rigidMotion(laid_.scale * all(around, Eigen::all), laid_.deformed(around, Eigen::all));
    return motion;
  }

  void put(const std::vector<int>& piece,
           const Piece& scaled,
           const Eigen::Isometry3d& motion,
           const TargetPart& part) {
    placed_.push_back({piece, motion});
    laid_.deformed(piece, Eigen::all) = moved(motion, scaled.points);
    const std::vector<TargetPart::Near> near = part.nearest(scaled, motion);
    for (std::size_t i = 0; i < piece.size(); ++i)
      if (near[i].distance < ON_SURFACE && near[i].same_way)
        match(piece[i], near[i]);
      else
        leaveOut({piece[i]});
  }

  void leaveOut(const std::vector<int>& piece) {
    for (int v : piece) dropRow(laid_.correspondence, static_cast<std::size_t>(v));
  }

  const GivenShape& source_;
  LaidSide& laid_;
  Points normals_;
  std::vector<char> rim_;
  double edge_;
  PieceTarget surface_;
  TargetPart whole_, free_;
  Main main_;
  std::map<int, std::optional<Eigen::Isometry3d>> motions_;  // by the vertex next to the piece
  std::vector<PlacedPiece> placed_;
};

}  // namespace

std::vector<char> coveredBy(const GivenShape& shape,
                            const LaidSide& laid,
                            const Points& places,
                            double reach) {
  const std::vector<int> mapped = verticesThat(shape, [&](int v) {
    return shape.clean.isOnMain(v) && laid.correspondence.on_target[v].vertex >= 0;
  });
  std::vector<char> covered(places.rows(), 0);
  constexpr double UNIT = 1;  // distances as they are
  const PieceTarget surface(
      {laid.deformed, shape.input.faces}, Points::Zero(laid.deformed.rows(), 3), UNIT, UNIT);
  const TargetPart part(surface, mapped);
  if (part.empty()) return covered;
  for (Eigen::Index i = 0; i < places.rows(); ++i)
    covered[static_cast<std::size_t>(i)] = part.nearest(places.row(i)).distance < reach;
  return covered;
}

PieceTarget pieceTarget(const GivenShape& target) {
  return {target.input,
          inputNormals(target),
          meanEdgeLength(target.clean.mesh),
          rootArea(target.clean.mesh)};
}

bool hasLoosePieces(const GivenShape& shape) {
  const std::vector<char> on_faces =
      cornersOfFaces(shape.input.faces, static_cast<int>(shape.input.vertices.rows()));
  for (int v = 0; v < shape.ownVertices(); ++v)
    if (on_faces[v] != 0 && !shape.clean.isOnMain(v)) return true;
  return false;
}

std::vector<PlacedPiece> placeLoosePieces(const GivenShape& source,
                                          const GivenShape& target,
                                          LaidSide& laid) {
  const std::vector<std::vector<int>> pieces = loosePieces(source);
  if (pieces.empty()) return {};
  Placing placing(source, target, laid);
  for (const std::vector<int>& piece : pieces) placing.place(piece);
  return placing.placed();
}

}  // namespace posture
