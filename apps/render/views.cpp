// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "views.h"

#include <posture/core/error.h>

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace posture::render {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr double RADIANS = 3.14159265358979323846 / 180;
constexpr double TURN_RAD = 22 * RADIANS;  // of the chosen view, about the vertical
constexpr double TILT_RAD = 12 * RADIANS;  // of the chosen view, from above

using Shapes = std::vector<const Points*>;

/// Spread about the centre; each shape at the same size.
Matrix3d covariance(const Shapes& shapes) {
  Matrix3d sum = Matrix3d::Zero();
  for (const Points* points : shapes) {
    if (points->rows() == 0) continue;
    const Points centred = points->rowwise() - points->colwise().mean();
    const Matrix3d own = centred.transpose() * centred;
    if (own.trace() > 0) sum += own / own.trace();
  }
  return sum;
}

/// Columns by increasing spread.
Matrix3d principalAxes(const Matrix3d& spread) {
  return Eigen::SelfAdjointEigenSolver<Matrix3d>(spread).eigenvectors();
}

/// The value below which a share of the entries lies.
double quantile(Vector values, double share) {
  const auto place = static_cast<Eigen::Index>(share * double(values.size() - 1));
  std::nth_element(values.data(), values.data() + place, values.data() + values.size());
  return values(place);
}

/// Area of the box around the lowest twentieth of a shape that stands upright along `up`,
/// relative to its squared size; a few stray points do not count.
double footprint(const Points& points, const Vector3d& up) {
  const Vector3d across = up.unitOrthogonal();
  const Vector3d along = up.cross(across);
  const Vector height = points * up;
  const double size = (points.colwise().maxCoeff() - points.colwise().minCoeff()).norm();
  const double ground = quantile(height, 0.005);
  const double limit = ground + 0.05 * (quantile(height, 0.995) - ground);
  constexpr double INF = std::numeric_limits<double>::infinity();
  Eigen::Array2d low(INF, INF), high(-INF, -INF);
  for (Eigen::Index i = 0; i < points.rows(); ++i) {
    if (height(i) > limit || height(i) < ground) continue;
    const Eigen::Array2d place(points.row(i) * across, points.row(i) * along);
    low = low.min(place);
    high = high.max(place);
  }
  return size > 0 ? (high - low).max(0).prod() / (size * size) : 0;
}

/// How well a shape stands along `up`. Bodies seldom lie on their broadest side, nor is a large
/// footprint better than a sufficient one.
double stance(const Points& points, const Vector3d& up) {
  if (points.rows() == 0) return 0;
  const Vector3d narrow = principalAxes(covariance({&points})).col(0);
  return std::abs(up.dot(narrow)) > 0.8 ? 0 : std::min(footprint(points, up), 0.06);
}

double stance(const Shapes& shapes, const Vector3d& up) {
  double sum = 0;
  for (const Points* points : shapes) sum += stance(*points, up);
  return sum;
}

View turned(const View& view, double turn_rad, double tilt_rad) {
  const Matrix3d turn = Eigen::AngleAxisd(turn_rad, view.up).toRotationMatrix();
  const Vector3d right = turn * view.right;
  const Matrix3d tilt = Eigen::AngleAxisd(-tilt_rad, right).toRotationMatrix();
  return {right, tilt * view.up, tilt * turn * view.toward_viewer};
}

/// Where the front of data with this direction up is taken to be.
Vector3d frontOf(const Vector3d& up) {
  Eigen::Index axis = 0;
  up.cwiseAbs().maxCoeff(&axis);
  const Vector3d front = axis == 1   ? Vector3d::UnitZ()
                         : axis == 2 ? Vector3d(-Vector3d::UnitY())
                                     : Vector3d::UnitY();
  return (front - front.dot(up) * up).normalized();
}

View lookingFrom(const Vector3d& toward_viewer, const Vector3d& up) {
  return {up.cross(toward_viewer), up, toward_viewer};
}

/// Upright, across the horizontal direction of least spread.
View broadside(const Shapes& shapes, const Vector3d& up) {
  const Vector3d front = frontOf(up);
  const Vector3d side = up.cross(front);
  const Matrix3d spread = covariance(shapes);
  Eigen::Matrix<double, 3, 2> horizontal;
  horizontal << front, side;
  const Eigen::Matrix2d flat = horizontal.transpose() * spread * horizontal;
  Eigen::Vector2d least =
      Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(flat).eigenvectors().col(0);
  // From the front where that is a choice, from the side that right names otherwise.
  if (std::abs(least.x()) > 0.5 ? least.x() < 0 : least.y() < 0) least = -least;
  return lookingFrom((horizontal * least).normalized(), up);
}

/// How much less of a shape one sees than from its own best side, in [0, 1].
double loss(const Points& points, const View& view) {
  const Matrix3d spread = covariance({&points});
  const double best =
      spread.trace() - Eigen::SelfAdjointEigenSolver<Matrix3d>(spread).eigenvalues()(0);
  const double seen = spread.trace() - view.toward_viewer.dot(spread * view.toward_viewer);
  return best > 0 ? 1 - seen / best : 0;
}

/// The direction in which all of the shapes together stand best.
Vector3d guessUp(const Shapes& shapes) {
  const Matrix3d principal = principalAxes(covariance(shapes));
  Vector3d best = Vector3d::UnitY();
  double best_score = 0;
  for (int k = 0; k < 12; ++k) {
    Vector3d up =
        k < 6 ? Vector3d(Vector3d::Unit((k / 2 + 1) % 3)) : Vector3d(principal.col(k / 2 - 3));
    if (k % 2 == 1) up = -up;
    // Nearly all data have y or z up.
    const bool usual = k == 0 || k == 2;
    const double score = stance(shapes, up) * (usual ? 1 : 0.25);
    if (score > best_score) {
      best = up;
      best_score = score;
    }
  }
  return best;
}

}  // namespace

const std::vector<std::string>& viewNames() {
  static const std::vector<std::string> NAMES = {
      "front", "back", "left", "right", "top", "bottom", "three-quarter"};
  return NAMES;
}

std::vector<Vector3d> guessUps(const Shapes& shapes) {
  const Vector3d common = guessUp(shapes);
  std::vector<Vector3d> ups;
  for (const Points* shape : shapes) {
    const Vector3d own = guessUp({shape});
    ups.push_back(stance(*shape, own) > 4 * stance(*shape, common) ? own : common);
  }
  return ups;
}

View namedView(const std::string& name, const Vector3d& up) {
  const Vector3d front = frontOf(up);
  View view = lookingFrom(front, up);
  if (name == "front") return view;
  if (name == "back") return lookingFrom(-front, up);
  if (name == "right") return lookingFrom(view.right, up);
  if (name == "left") return lookingFrom(-view.right, up);
  if (name == "top") return lookingFrom(up, -front);
  if (name == "bottom") return lookingFrom(-up, front);
  require(name == "three-quarter", "no view is named " + name);
  return turned(view, 35 * RADIANS, 20 * RADIANS);
}

std::vector<View> chosenViews(const Shapes& shapes, const std::vector<Vector3d>& ups) {
  std::vector<View> views;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    Shapes alike;
    for (std::size_t k = 0; k < shapes.size(); ++k)
      if (ups[k] == ups[i]) alike.push_back(shapes[k]);
    View view = broadside(alike, ups[i]);
    if (loss(*shapes[i], view) > 0.45) view = broadside({shapes[i]}, ups[i]);
    views.push_back(turned(view, TURN_RAD, TILT_RAD));
  }
  return views;
}

}  // namespace posture::render
