// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/plane_face.h"

#include "core/quantile.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <vector>

namespace loopmend {

namespace {

constexpr double off_plane = 1e-5;  ///< in diameters; more than single precision leaves, less than any scanned face
constexpr double other_share = 0.1;
/// Of a noisy scan: rms distance of the loops from their plane, in diameters; sines of the angles of the faces beside them against it. Of
/// these at least a tenth rise, a tenth fall, and at most a tenth lie between the rising or falling ones and those in the plane.
constexpr double noisy_planarity = 5e-3, steep = 0.5, level = 0.2;
constexpr std::size_t fewest_vertices = 4;  ///< three always lie in a plane
/// Of a fillet at the loop: radians against the plane; curvature in half diameters, of which a ball that is so nearly tangent has a tenth.
constexpr double tangent_angle = 0.1, least_bend = 1;

/// Of the loops.
struct Plane {
  Vec3 center = Vec3::Zero(), normal = Vec3::Zero();
  double diameter = 0;
  double planarity = 0;   ///< rms distance of the loops' vertices, in diameters
  bool is_exact = false;  ///< none of them is_off()

  double height(const Vec3& p) const { return normal.dot(p - center); }
  bool is_off(const Vec3& p) const { return std::abs(height(p)) > off_plane * diameter; }
};

/// Nothing where too few vertices tell.
std::optional<Plane> plane_of_loops(const Patch& patch) {
  std::vector<Vec3> points;
  for (const std::vector<int>& loop : patch.loops)
    for (int v : loop) points.push_back(patch.positions[v]);
  if (points.size() < fewest_vertices) return std::nullopt;
  Plane plane;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) plane.center += p / static_cast<double>(points.size());
  for (const Vec3& p : points) spread += (p - plane.center) * (p - plane.center).transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
  plane.normal = axes.eigenvectors().col(0);
  const Vec3 along = axes.eigenvectors().col(2);
  const auto [low, high] = std::ranges::minmax(points, {}, [&](const Vec3& p) { return along.dot(p); });
  plane.diameter = along.dot(high - low);
  if (!(plane.diameter > 0)) return std::nullopt;
  plane.planarity =
      std::sqrt(std::max(0.0, axes.eigenvalues()[0]) / static_cast<double>(points.size())) / plane.diameter;
  plane.is_exact = std::ranges::none_of(points, [&](const Vec3& p) { return plane.is_off(p); });
  return plane;
}

/// Those of the neighborhood with two vertices or more on the loop.
Triangles faces_beside(const Patch& patch, const std::vector<int>& loop) {
  const std::set<int> vertices(loop.begin(), loop.end());
  Triangles beside;
  std::copy_if(
      patch.triangles.begin() + patch.patch_triangles, patch.triangles.end(), std::back_inserter(beside),
      [&](const Triangle& t) { return std::ranges::count_if(t, [&](int v) { return vertices.contains(v); }) >= 2; });
  return beside;
}

/// The share of these faces that does not leave the plane to the side to which most do.
double share_of_others(const Patch& patch, const Plane& plane, const Triangles& beside) {
  const double most = off_plane * plane.diameter;
  int above = 0, below = 0;
  for (const Triangle& t : beside) {
    above += std::ranges::any_of(t, [&](int v) { return plane.height(patch.positions[v]) > most; });
    below += std::ranges::any_of(t, [&](int v) { return plane.height(patch.positions[v]) < -most; });
  }
  return beside.empty() ? 0 : 1 - std::max(above, below) / static_cast<double>(beside.size());
}

/// Whether of these faces some rise from the plane like walls, and some fall, as at the tread of a step.
bool lies_between_walls(const Patch& patch, const Plane& plane, const Triangles& beside) {
  int rising = 0, falling = 0, inclined = 0, count = 0;
  for (const Triangle& t : beside) {
    const auto apex = std::ranges::find_if(t, [&](int v) { return patch.ring[v] == 2; });
    if (apex == t.end() || std::ranges::count_if(t, [&](int v) { return patch.ring[v] == 1; }) != 2) continue;
    const auto k = static_cast<std::size_t>(apex - t.begin());
    const Vec3 &p = patch.positions[t[(k + 1) % 3]], &q = patch.positions[t[(k + 2) % 3]];
    const Vec3 along = (q - p).normalized(), away = patch.positions[*apex] - p;
    const double sine = plane.normal.dot((away - along.dot(away) * along).normalized());
    ++count;
    rising += sine > steep;
    falling += sine < -steep;
    inclined += std::abs(sine) > level && std::abs(sine) <= steep;
  }
  return std::min(rising, falling) >= other_share * count && inclined <= other_share * count && count > 0;
}

/// Whether the surface is tangent to the plane at the loops and bends out of it to one side. The angle at a loop follows from those of the first two
/// rows of faces, as on a circle.
bool rounds_out(const Patch& patch, const Plane& plane) {
  struct Mean {
    Vec3 sum = Vec3::Zero();
    int count = 0;
    Vec3 value() const { return sum / count; }
  };
  std::map<int, std::array<Mean, 2>> beside;  // of each vertex of ring 2, those of rings 1 and 3
  for (std::size_t f = patch.patch_triangles; f < patch.triangles.size(); ++f)
    for (const int v : patch.triangles[f])
      for (const int w : patch.triangles[f]) {
        if (patch.ring[v] != 2 || (patch.ring[w] != 1 && patch.ring[w] != 3)) continue;
        Mean& mean = beside[v][patch.ring[w] == 1 ? 0 : 1];
        mean.sum += patch.positions[w];
        ++mean.count;
      }
  const auto slope = [&](const Vec3& step) {
    const double rise = plane.normal.dot(step);
    return std::atan2(rise, (step - rise * plane.normal).norm());
  };
  std::vector<double> angles, bends;
  for (const auto& [v, rows] : beside) {
    if (rows[0].count == 0 || rows[1].count == 0) continue;
    const Vec3 first = patch.positions[v] - rows[0].value(), second = rows[1].value() - patch.positions[v];
    const double width = first.norm() + second.norm(), turn = slope(second) - slope(first);
    if (!(width > 0)) continue;
    angles.push_back(std::abs(slope(first) - turn * first.norm() / width));
    bends.push_back(turn / width * plane.diameter);  // over half of the width, times half of the diameter
  }
  if (angles.empty() || median(angles) > tangent_angle) return false;
  const bool is_one_sided = quantile(bends, 0.25) * quantile(bends, 0.75) > 0;
  return is_one_sided && std::abs(median(bends)) >= least_bend;
}

}  // namespace

bool bounds_plane_face(const Patch& patch) {
  const std::optional<Plane> plane = plane_of_loops(patch);
  if (!plane || plane->planarity > noisy_planarity) return false;
  const auto each_loop = [&](const auto& holds) {
    return std::ranges::all_of(patch.loops, [&](const auto& loop) { return holds(faces_beside(patch, loop)); });
  };
  if (!plane->is_exact)
    return each_loop([&](const Triangles& beside) { return lies_between_walls(patch, *plane, beside); });
  const bool bends = std::any_of(patch.positions.begin() + patch.free_count, patch.positions.end(),
                                 [&](const Vec3& p) { return plane->is_off(p); });
  const auto has_others = [&](const Triangles& beside) {
    return share_of_others(patch, *plane, beside) >= other_share;
  };
  return bends && (each_loop(has_others) || rounds_out(patch, *plane));
}

}  // namespace loopmend
