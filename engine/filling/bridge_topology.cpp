// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/bridge_topology.h"

#include "core/rotation.h"
#include "filling/delaunay.h"
#include "mesh/loop_facing.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace loopmend {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double surely = 0.05;  ///< below this cosine a sense is not distinguished from the other
constexpr double around_center =
    0.01;  ///< distance of a loop's centre from that of all, in radii, below which they are one
constexpr double widest_cap = 1.3;     ///< radians: less than a hemisphere
constexpr double room_between = 0.85;  ///< share of the angle between two directions that their caps may take together

Vec3 mean_of(const Points& points) {
  return std::accumulate(points.begin(), points.end(), Vec3(Vec3::Zero())) / static_cast<double>(points.size());
}

/// The direction in which the surface goes on at a loop: its conormals, helped by the direction of the centre where these cancel.
/// A loop around the centre has no such direction: rounding would choose it.
Vec3 onward_to(const BridgeEnd& end, const Vec3& center) {
  const Vec3 own = mean_of(end.points), direction = center - own;
  const double distance = direction.norm();
  return distance > around_center * (end.points.front() - own).norm() ? Vec3(end.onward + 0.5 * direction / distance)
                                                                      : end.onward;
}

/// A circle on the unit sphere that stands for a loop.
struct Cap {
  Vec3 direction;
  double radius;              ///< angular
  std::vector<double> angle;  ///< of each vertex, about the direction
};

/// Fractions of the perimeter at each vertex, 0 at the first.
std::vector<double> chord_fractions(const Points& points) {
  std::vector<double> at(points.size(), 0);
  double length = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    at[i] = length;
    length += (points[(i + 1) % points.size()] - points[i]).norm();
  }
  for (double& x : at) x /= length;
  return at;
}

/// Angles by chord length, turned so that they agree as well as they can with those of the real vertices, the loop's
/// plane being laid square to the direction.
std::vector<double> cap_angles(const BridgeEnd& end, const Vec3& direction, int sense) {
  const Vec3 e1 = direction.unitOrthogonal(), e2 = direction.cross(e1), center = mean_of(end.points);
  const Eigen::Quaterniond lay = rotation_between(-sense * end.axis, direction);
  std::vector<double> angle = chord_fractions(end.points);
  double cosine = 0, sine = 0;
  for (std::size_t i = 0; i < angle.size(); ++i) {
    angle[i] *= -sense * 2 * pi;
    const Vec3 real = lay * (end.points[i] - center);
    const double difference = std::atan2(real.dot(e2), real.dot(e1)) - angle[i], weight = real.norm();
    cosine += weight * std::cos(difference);
    sine += weight * std::sin(difference);
  }
  const double phase = std::atan2(sine, cosine);
  for (double& a : angle) a += phase;
  return angle;
}

/// Where the loops see each other from: the mean of their centres, moved the way the surfaces go on.
Vec3 meeting_point(const std::vector<BridgeEnd>& ends) {
  Vec3 center = Vec3::Zero(), onward = Vec3::Zero();
  for (const BridgeEnd& end : ends) center += mean_of(end.points) / static_cast<double>(ends.size());
  double distance = 0;
  for (const BridgeEnd& end : ends) {
    onward += end.onward / static_cast<double>(ends.size());
    distance += (mean_of(end.points) - center).norm() / static_cast<double>(ends.size());
  }
  return center + distance * onward;
}

std::vector<Cap> caps_of(const std::vector<BridgeEnd>& ends, const Vec3& center) {
  std::vector<Cap> caps;
  for (const BridgeEnd& end : ends) {
    const Vec3 from = mean_of(end.points) - center;
    const double distance = from.norm();
    if (!(distance > 0) || end.axis.isZero()) return {};
    const int sense = turning_sense(end, center);
    if (sense == 0) return {};
    double radius = 0;
    for (const Vec3& p : end.points) radius += (p - center - from).norm() / static_cast<double>(end.points.size());
    caps.push_back({from / distance, std::min(widest_cap, std::atan2(radius, distance)), {}});
    caps.back().angle = cap_angles(end, caps.back().direction, sense);
  }
  double share = 1;
  for (std::size_t k = 0; k < caps.size(); ++k)
    for (std::size_t l = 0; l < k; ++l) {
      const double apart = std::acos(std::clamp(caps[k].direction.dot(caps[l].direction), -1.0, 1.0));
      share = std::min(share, room_between * apart / (caps[k].radius + caps[l].radius));
    }
  if (share < 0.02) return {};  // two loops lie in one direction
  for (Cap& cap : caps) cap.radius *= share;
  return caps;
}

}  // namespace

std::vector<BridgeEnd> ends_of(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::vector<BridgeEnd> ends;
  for (const BoundaryLoop& loop : loops) {
    const LoopFacing facing = loop_facing(model, loop);
    BridgeEnd end{{}, facing.axis, facing.onward, facing.conormals};
    for (int v : loop.vertices) end.points.push_back(model.mesh.point(TriMesh::VertexHandle(v)));
    ends.push_back(std::move(end));
  }
  return ends;
}

int turning_sense(const BridgeEnd& end, const Vec3& center) {
  const double cosine = end.axis.dot(onward_to(end, center));
  return cosine > surely ? 1 : cosine < -surely ? -1 : 0;
}

Triangles bridge_by_hull(const std::vector<BridgeEnd>& ends) {
  const std::vector<Cap> caps = caps_of(ends, meeting_point(ends));
  if (caps.size() < 2) return {};
  Points points;
  std::vector<int> owner;
  std::size_t edges = 0;
  for (std::size_t k = 0; k < caps.size(); ++k) {
    const Vec3 e1 = caps[k].direction.unitOrthogonal(), e2 = caps[k].direction.cross(e1);
    for (double angle : caps[k].angle) {
      const Vec3 round = std::cos(angle) * e1 + std::sin(angle) * e2;
      points.push_back(std::cos(caps[k].radius) * caps[k].direction + std::sin(caps[k].radius) * round);
      owner.push_back(static_cast<int>(k));
    }
    edges += caps[k].angle.size();
  }
  Triangles triangles;
  const int sense = turning_sense(ends.front(), meeting_point(ends));
  for (Triangle t : hull_facets(points)) {
    if (owner[t[0]] == owner[t[1]] && owner[t[1]] == owner[t[2]]) continue;
    if (sense < 0) std::swap(t[1], t[2]);
    triangles.push_back(t);
  }
  // A sphere with k holes whose vertices all lie on the holes.
  return triangles.size() == edges + 2 * caps.size() - 4 ? triangles : Triangles{};
}

}  // namespace loopmend
