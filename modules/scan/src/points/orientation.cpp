// SPDX-FileCopyrightText: 2026 the posture authors
// SPDX-License-Identifier: BSD-3-Clause
#include "points/orientation.h"

#include <posture/core/parallel.h>

#include "points/signed_sets.h"
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace posture {
namespace {

/// Closed surfaces are less open, and know their outside better than normals or places of sensors
/// of unknown origin do.
constexpr double CLOSED = 0.2;

/// Of what looks towards a sensor or away from it, by how much what looks one way has to outweigh
/// the rest: 0.75 and 0.95 of it.
constexpr double MOSTLY = 0.5, NEARLY_ALL = 0.9;

struct Link {
  float weight;
  int first, second;
  bool opposed;

  bool operator<(const Link& other) const {
    return std::tie(weight, first, second) < std::tie(other.weight, other.first, other.second);
  }
};

/// How badly two points fit on one smooth surface, and whether their normals then disagree.
Link link(const Points& points, const Points& normals, int i, int j, const Spacing& spacing) {
  const Eigen::RowVector3d offset = points.row(j) - points.row(i);
  const double length = offset.norm();
  const Eigen::RowVector3d d = offset / length;
  const double along_i = normals.row(i).dot(d), along_j = normals.row(j).dot(d);
  // On a circular arc the normals are mirror images in the plane between the points.
  const double c = normals.row(i).dot(normals.row(j)) - 2 * along_i * along_j;
  // Without the second term points stacked along the normal, of opposing sheets, fit perfectly.
  const double stacked = 0.5 * std::max(along_i * along_i, along_j * along_j);
  const double weight =
      1 - std::abs(c) + stacked + 0.02 * length / std::max(spacing.at[i], spacing.at[j]);
  return {static_cast<float>(weight), i, j, c < 0};
}

/// Links to the 12 nearest neighbours within five spacings, each once.
std::vector<Link> surfaceLinks(const Points& points,
                               const NeighborTable& neighbors,
                               const Points& normals,
                               const Spacing& spacing) {
  const int n = static_cast<int>(points.rows());
  const int columns = std::min(12, static_cast<int>(neighbors.cols()));
  std::vector<Link> links(static_cast<std::size_t>(n) * columns, Link{-1, 0, 0, false});
  forEach(n, [&](int i) {
    for (int k = 0; k < columns; ++k) {
      const int j = neighbors(i, k);
      if (j < 0) break;
      const double distance = (points.row(j) - points.row(i)).norm();
      if (distance > 5 * spacing.at[i]) break;
      if (distance == 0) continue;  // there is no way from one to the other
      const auto of_j = neighbors.row(j).head(columns);
      const bool both = std::find(of_j.begin(), of_j.end(), i) != of_j.end();
      if (i < j || !both)
        links[static_cast<std::size_t>(i) * columns + k] =
            link(points, normals, std::min(i, j), std::max(i, j), spacing);
    }
  });
  links.erase(
      std::remove_if(links.begin(), links.end(), [](const Link& l) { return l.weight < 0; }),
      links.end());
  return links;
}

/// From each point to one more, of number n, that stands for the sensor: its sign is known.
void addSensorLinks(const Points& directions, const Points& normals, std::vector<Link>& links) {
  const int n = static_cast<int>(normals.rows());
  for (int i = 0; i < n; ++i) {
    const double c = normals.row(i).dot(directions.row(i));
    if (c != 0) links.push_back({static_cast<float>(1 - std::abs(c)), i, n, c < 0});
  }
}

struct Propagated {
  Points normals;
  std::vector<int> part;  ///< n: equal for points whose signs hang together
};

/// Signs along a minimum spanning tree of the links between the points, and one more.
Propagated propagate(std::vector<Link>& links, const Points& normals) {
  const int n = static_cast<int>(normals.rows());
  std::sort(links.begin(), links.end());
  SignedSets sets(n + 1);
  for (const Link& l : links) sets.join(l.first, l.second, l.opposed);
  Propagated propagated{normals, std::vector<int>(n)};
  for (int i = 0; i < n; ++i) {
    propagated.part[i] = sets.find(i);
    if (sets.isFlipped(i)) propagated.normals.row(i) *= -1;
  }
  return propagated;
}

/// What the points of a part enclose, each standing for the square of its spacing.
struct Enclosure {
  double volume = 0;  ///< three times that, about the centroid: negative where normals look inwards
  double openness = 0;  ///< 0: closed; 1: a plane
};

Enclosure enclosure(const Points& points,
                    const Points& normals,
                    const std::vector<int>& part,
                    const Spacing& spacing) {
  Eigen::RowVector3d center = Eigen::RowVector3d::Zero(), area_vector = center;
  double area = 0;
  for (int i : part) {
    const double a = spacing.at[i] * spacing.at[i];
    center += a * points.row(i);
    area_vector += a * normals.row(i);
    area += a;
  }
  center /= area;
  Enclosure result;
  for (int i : part)
    result.volume += spacing.at[i] * spacing.at[i] * normals.row(i).dot(points.row(i) - center);
  result.openness = area_vector.norm() / area;
  return result;
}

struct HintVote {
  int known = 0;
  int agreeing = 0;
};

HintVote vote(const Points& directions, const Points& normals, const std::vector<int>& part) {
  HintVote votes;
  if (directions.rows() == 0) return votes;
  for (int i : part) {
    const double c = directions.row(i).dot(normals.row(i));
    votes.known += c != 0;
    votes.agreeing += c > 0;
  }
  return votes;
}

/// Whether points, all turned to the sensor, are closed around it or have it in their surface.
bool surroundSensor(const OutsideHints& hints, const Points& normals, const Spacing& spacing) {
  Eigen::RowVector3d area_vector = Eigen::RowVector3d::Zero();
  double area = 0;
  for (int i = 0; i < normals.rows(); ++i) {
    const double a = spacing.at[i] * spacing.at[i];
    area_vector += (hints.directions.row(i).dot(normals.row(i)) < 0 ? -a : a) * normals.row(i);
    area += a;
  }
  return area_vector.norm() <= CLOSED * area;
}

/// Of what looks towards a sensor or away from it, by how squarely it does, what looks the way its
/// part does less what does not: 1 of ideal views.
double oneWayExcess(const OutsideHints& hints,
                    const Points& points,
                    const Points& normals,
                    const Spacing& spacing,
                    const std::vector<int>& part_of) {
  const auto share = [&](const auto& weight) {
    std::map<int, double> towards;
    double all = 0;
    for (Eigen::Index i = 0; i < normals.rows(); ++i) {
      const double c = hints.directions.row(i).dot(normals.row(i)) * weight(i);
      towards[part_of[static_cast<std::size_t>(i)]] += c;
      all += std::abs(c);
    }
    double one_way = 0;
    for (const auto& [part, sum] : towards) one_way += std::abs(sum);
    return all > 0 ? one_way / all : 0;
  };
  // What is near fills the view, and hides the backs of what it is part of; those of closed bodies
  // fill as much of it, however near these are.
  const double by_count = share([](Eigen::Index) { return 1.0; });
  const double by_solid_angle = share([&](Eigen::Index i) {
    const double distance_sq = (points.row(i) - hints.sensor).squaredNorm();
    return distance_sq > 0 ? spacing.at[i] * spacing.at[i] / distance_sq : 0;
  });
  return std::min(by_count, by_solid_angle);
}

}  // namespace

OutsideHints rowsOf(const OutsideHints& hints, const std::vector<int>& rows) {
  OutsideHints some = hints;
  for (Points* part : {&some.directions, &some.normals})
    if (part->rows() > 0) *part = Points((*part)(rows, Eigen::all));
  return some;
}

OutsideHints withoutSensor(const OutsideHints& hints) {
  if (hints.normals.rows() == 0) return {};
  return {hints.normals, HintSource::NORMALS};
}

SensorView sensorView(const OutsideHints& hints,
                      const Points& points,
                      const Points& normals,
                      const Spacing& spacing,
                      const std::vector<int>& part_of) {
  if (hints.is_assumed && surroundSensor(hints, normals, spacing)) return {};
  const double excess = oneWayExcess(hints, points, normals, spacing, part_of);
  const bool is_only_one = excess >= NEARLY_ALL;
  return {hints.is_assumed ? is_only_one : excess >= MOSTLY, is_only_one};
}

bool looksInward(const Points& points,
                 const Points& normals,
                 const std::vector<int>& part,
                 const Spacing& spacing,
                 const OutsideHints& hints,
                 OrientationSummary& summary) {
  // Of normals whose sign was left to chance half agree.
  constexpr double CONSISTENT = 0.9;
  const HintVote votes = vote(hints.directions, normals, part);
  const double share = votes.known > 0 ? static_cast<double>(votes.agreeing) / votes.known : 0.5;
  const bool voted = 2 * votes.known > static_cast<int>(part.size());
  if (hints.source != HintSource::NORMALS && voted) {
    summary.by_sensor = true;
    return share < 0.5;
  }
  const Enclosure enclosed = enclosure(points, normals, part, spacing);
  if (enclosed.openness > CLOSED && voted && std::max(share, 1 - share) >= CONSISTENT) {
    summary.by_normals = true;
    return share < 0.5;
  }
  return enclosed.volume < 0;
}

OrientationSummary orientNormals(const Points& points,
                                 const NeighborTable& neighbors,
                                 const Spacing& spacing,
                                 const OutsideHints& given,
                                 Points& normals) {
  const int n = static_cast<int>(points.rows());
  std::vector<Link> links = surfaceLinks(points, neighbors, normals, spacing);
  Propagated propagated = propagate(links, normals);
  OutsideHints hints = given;
  if (hints.source == HintSource::SENSOR) {
    if (sensorView(hints, points, propagated.normals, spacing, propagated.part).is_seen) {
      addSensorLinks(hints.directions, normals, links);
      propagated = propagate(links, normals);
    } else {
      hints = withoutSensor(given);
    }
  }
  normals = std::move(propagated.normals);
  const std::vector<int>& root = propagated.part;
  std::vector<int> by_part(n);
  std::iota(by_part.begin(), by_part.end(), 0);
  std::stable_sort(by_part.begin(), by_part.end(), [&](int a, int b) { return root[a] < root[b]; });
  OrientationSummary summary;
  for (auto first = by_part.begin(); first != by_part.end();) {
    const auto last =
        std::find_if(first, by_part.end(), [&](int i) { return root[i] != root[*first]; });
    const std::vector<int> part(first, last);
    if (looksInward(points, normals, part, spacing, hints, summary))
      for (int i : part) normals.row(i) *= -1;
    first = last;
  }
  return summary;
}

}  // namespace posture
