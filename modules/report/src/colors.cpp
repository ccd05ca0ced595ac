// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include <posture/core/error.h>
#include <posture/core/finite_rows.h>
#include <posture/report/colors.h>

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

namespace posture {
namespace {

using Eigen::RowVector3d;

/// sRGB of a colour in CIELAB (D65), the nearest one that a screen has.
Eigen::Matrix<std::uint8_t, 1, 3> toRgb(double lightness, double a, double b) {
  const auto inverse = [](double t) {
    return t > 6.0 / 29 ? t * t * t : 108.0 / 841 * (t - 4.0 / 29);
  };
  const double y = (lightness + 16) / 116;
  const Eigen::Vector3d xyz(
      0.95047 * inverse(y + a / 500), inverse(y), 1.08883 * inverse(y - b / 200));
  Eigen::Matrix3d to_linear;
  to_linear << 3.2406, -1.5372, -0.4986, -0.9689, 1.8758, 0.0415, 0.0557, -0.2040, 1.0570;
  const Eigen::Vector3d linear = to_linear * xyz;
  Eigen::Matrix<std::uint8_t, 1, 3> rgb;
  for (int c = 0; c < 3; ++c) {
    const double value = std::clamp(linear(c), 0.0, 1.0);
    const double display =
        value <= 0.0031308 ? 12.92 * value : 1.055 * std::pow(value, 1 / 2.4) - 0.055;
    rgb(c) = static_cast<std::uint8_t>(std::lround(255 * display));
  }
  return rgb;
}

/// A sum of colours for each vertex of the target.
class ColorSums {
 public:
  explicit ColorSums(Eigen::Index count)
      : sum_(Points::Zero(count, 3)), weight_(Vector::Zero(count)) {}

  void add(int vertex, double weight, const Colors& colors, Eigen::Index source) {
    require(vertex >= 0 && vertex < sum_.rows(),
            "vertex " + std::to_string(vertex) + " is not on the target");
    sum_.row(vertex) += weight * colors.row(source).cast<double>();
    weight_(vertex) += weight;
  }

  Colors means() const {
    Colors colors = Colors::Constant(sum_.rows(), 3, REJECTED_GREY);
    for (Eigen::Index i = 0; i < sum_.rows(); ++i)
      if (weight_(i) > 0)
        colors.row(i) = (sum_.row(i) / weight_(i)).array().round().cast<std::uint8_t>();
    return colors;
  }

 private:
  Points sum_;
  Vector weight_;
};

/// Of the rows, those that lie no farther beyond the middle 98 % than these are wide, along each
/// axis: a scan's outliers would leave the body in one colour.
std::vector<int> withoutFarOnes(const Points& points, std::vector<int> rows) {
  if (rows.empty()) return rows;
  RowVector3d low, high;
  for (int c = 0; c < 3; ++c) {
    std::vector<double> along;
    along.reserve(rows.size());
    for (int i : rows) along.push_back(points(i, c));
    const auto at = [&](double share) {
      const auto nth = along.begin() + std::lround(share * static_cast<double>(along.size() - 1));
      std::nth_element(along.begin(), nth, along.end());
      return *nth;
    };
    const double first = at(0.01), last = at(0.99);
    const double beyond = last > first ? last - first : std::numeric_limits<double>::infinity();
    low(c) = first - beyond;
    high(c) = last + beyond;
  }
  rows.erase(std::remove_if(rows.begin(),
                            rows.end(),
                            [&](int i) {
                              return (points.row(i).array() < low.array()).any() ||
                                     (points.row(i).array() > high.array()).any();
                            }),
             rows.end());
  return rows;
}

}  // namespace

PlaceColoring::PlaceColoring(const Points& given) {
  const std::vector<int> body = withoutFarOnes(given, finiteRows(given));
  if (body.empty()) return;
  const Points vertices = given(body, Eigen::all);
  centre_ = vertices.colwise().mean();
  const Points centred = vertices.rowwise() - centre_;
  const Eigen::Matrix3d spread = centred.transpose() * centred;
  axes_ = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().rowwise().reverse();
  for (int c = 0; c < 3; ++c) {
    Eigen::Index largest = 0;
    axes_.col(c).cwiseAbs().maxCoeff(&largest);
    if (axes_(largest, c) < 0) axes_.col(c) *= -1;
  }
  const Points along = centred * axes_;
  low_ = along.colwise().minCoeff();
  high_ = along.colwise().maxCoeff();
}

Colors PlaceColoring::operator()(const Points& places) const {
  Colors colors(places.rows(), 3);
  for (Eigen::Index i = 0; i < places.rows(); ++i) {
    if (!places.row(i).allFinite()) {
      colors.row(i).setConstant(REJECTED_GREY);
      continue;
    }
    const RowVector3d along = (places.row(i) - centre_) * axes_;
    RowVector3d share = RowVector3d::Constant(0.5);
    for (int c = 0; c < 3; ++c)
      if (high_(c) > low_(c))
        share(c) = std::clamp((along(c) - low_(c)) / (high_(c) - low_(c)), 0.0, 1.0);
    // The wide axes span the hues. The narrow one makes the two sides of a body light and dark, and
    // moves them to either side of grey, which is thus met inside the body alone.
    const RowVector3d place = share.array() - 0.5;
    colors.row(i) =
        toRgb(66 + 34 * place(2), 160 * place(0) + 80 * place(2), 160 * place(1) - 80 * place(2));
  }
  return colors;
}

Colors placeColors(const Points& vertices) { return PlaceColoring(vertices)(vertices); }

Colors greyWhereRejected(Colors colors, const Correspondence& correspondence) {
  require(colors.rows() == static_cast<Eigen::Index>(correspondence.on_target.size()),
          "colours and correspondence are not of the same shape");
  for (Eigen::Index i = 0; i < colors.rows(); ++i)
    if (correspondence.on_target[i].vertex < 0) colors.row(i).setConstant(REJECTED_GREY);
  return colors;
}

Colors transferColors(const Colors& source,
                      const Correspondence& correspondence,
                      const TriangleMesh& target) {
  require(source.rows() == static_cast<Eigen::Index>(correspondence.on_target.size()),
          "colours and correspondence are not of the same shape");
  ColorSums sums(target.vertices.rows());
  for (Eigen::Index i = 0; i < source.rows(); ++i) {
    const SurfacePoint& place = correspondence.on_target[i];
    if (place.vertex < 0) continue;
    if (place.face < 0) {
      sums.add(place.vertex, 1, source, i);
      continue;
    }
    require(place.face < target.faces.rows(),
            "face " + std::to_string(place.face) + " is not on the target");
    for (int c = 0; c < 3; ++c)
      if (place.barycentric(c) > 0)
        sums.add(target.faces(place.face, c), place.barycentric(c), source, i);
  }
  return sums.means();
}

Colors transferColors(const Colors& source,
                      const Correspondence& correspondence,
                      const Shape& target,
                      const std::optional<ScanSurface>& scan) {
  if (!scan) return transferColors(source, correspondence, {target.cloud.points, target.faces});
  Correspondence on_surface = correspondence;
  for (SurfacePoint& place : on_surface.on_target)
    if (place.face < 0) place.vertex = -1;  // its vertex is a point, not one of the surface
  const Colors of_surface = transferColors(source, on_surface, scan->mesh);
  Colors of_points = Colors::Constant(target.cloud.points.rows(), 3, REJECTED_GREY);
  for (std::size_t i = 0; i < scan->on_mesh.size(); ++i)
    if (scan->on_mesh[i].vertex >= 0)
      of_points.row(static_cast<Eigen::Index>(i)) = of_surface.row(scan->on_mesh[i].vertex);
  return of_points;
}

Colors partPalette(int count, const std::vector<int>& label, const Faces& faces) {
  // Of the qualitative palettes of Harrower and Brewer (2003), paler ones last.
  static constexpr std::array<std::array<std::uint8_t, 3>, 12> COLORS{{{31, 120, 180},
                                                                       {255, 127, 0},
                                                                       {51, 160, 44},
                                                                       {227, 26, 28},
                                                                       {106, 61, 154},
                                                                       {255, 217, 47},
                                                                       {166, 206, 227},
                                                                       {177, 89, 40},
                                                                       {178, 223, 138},
                                                                       {251, 154, 153},
                                                                       {202, 178, 214},
                                                                       {27, 158, 119}}};
  for (int part : label) require(part < count, "part " + std::to_string(part) + " is none");
  std::vector<std::set<int>> beside(count);
  for (Eigen::Index f = 0; f < faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = label[faces(f, k)], b = label[faces(f, (k + 1) % 3)];
      if (a < 0 || b < 0 || a == b) continue;
      beside[a].insert(b);
      beside[b].insert(a);
    }
  std::vector<int> chosen(count, -1), uses(COLORS.size(), 0);
  Colors palette(count, 3);
  for (int part = 0; part < count; ++part) {
    // Prefers what no neighbour has, then what was used least.
    std::vector<int> clashes(COLORS.size(), 0);
    for (int other : beside[part])
      if (chosen[other] >= 0) ++clashes[chosen[other]];
    int best = 0;
    for (int c = 1; c < static_cast<int>(COLORS.size()); ++c)
      if (std::pair(clashes[c], uses[c]) < std::pair(clashes[best], uses[best])) best = c;
    chosen[part] = best;
    ++uses[best];
    for (int k = 0; k < 3; ++k) palette(part, k) = COLORS[best][k];
  }
  return palette;
}

Colors partColors(const std::vector<int>& label, const Colors& palette) {
  Colors colors = Colors::Constant(static_cast<Eigen::Index>(label.size()), 3, REJECTED_GREY);
  for (std::size_t v = 0; v < label.size(); ++v) {
    require(label[v] < palette.rows(), "part " + std::to_string(label[v]) + " has no colour");
    if (label[v] >= 0) colors.row(static_cast<Eigen::Index>(v)) = palette.row(label[v]);
  }
  return colors;
}

Colors errorColors(const Vector& errors, double largest) {
  require(largest > 0, "the largest error shown must be positive");
  constexpr int LAST = 15;
  static constexpr std::array<std::array<int, 3>, LAST + 1> VIRIDIS = {{{68, 1, 84},
                                                                        {72, 26, 108},
                                                                        {71, 47, 125},
                                                                        {65, 68, 135},
                                                                        {57, 86, 140},
                                                                        {49, 104, 142},
                                                                        {42, 120, 142},
                                                                        {35, 136, 142},
                                                                        {31, 152, 139},
                                                                        {34, 168, 132},
                                                                        {53, 183, 121},
                                                                        {84, 197, 104},
                                                                        {122, 209, 81},
                                                                        {165, 219, 54},
                                                                        {210, 226, 27},
                                                                        {253, 231, 37}}};
  Colors colors = Colors::Constant(errors.size(), 3, REJECTED_GREY);
  for (Eigen::Index i = 0; i < errors.size(); ++i) {
    if (std::isnan(errors(i))) continue;
    const double place = LAST * std::clamp(errors(i) / largest, 0.0, 1.0);
    const int lower = std::min(static_cast<int>(place), LAST - 1);
    for (int c = 0; c < 3; ++c)
      colors(i, c) = static_cast<std::uint8_t>(std::lround(
          VIRIDIS[lower][c] + (place - lower) * (VIRIDIS[lower + 1][c] - VIRIDIS[lower][c])));
  }
  return colors;
}

}  // namespace posture
