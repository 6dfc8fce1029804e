// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/seam_profile.h"

#include "analysis/one_sided_fit.h"
#include "core/error.h"
#include "operators/local_fit.h"

#include <Eigen/Geometry>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace loopmend {

namespace {

/// One side of all seams: its triangles by directed edge, and H at its vertices when asked for.
class Side {
 public:
  /// @param H_sigma  at each fixed vertex; may be empty.
  Side(const Patch& patch, const Triangles& triangles, std::span<const float> H_sigma = {})
      : patch_(patch),
        H_sigma_(H_sigma),
        triangles_(triangles),
        topology_(patch.vertex_count(), triangles),
        normals_(angle_weighted_normals(patch.positions, triangles)),
        mark_(patch.vertex_count(), 0) {
    for (std::size_t f = 0; f < triangles.size(); ++f)
      for (int k = 0; k < 3; ++k) face_[{triangles[f][k], triangles[f][(k + 1) % 3]}] = static_cast<int>(f);
  }

  double H(int v) {
    const auto [entry, added] = known_.try_emplace(v, std::numeric_limits<double>::quiet_NaN());
    if (added) {
      const auto fit = one_sided_fit(patch_.positions, topology_, v, normals_[v], mark_);
      if (fit) entry->second = fit->H / patch_.scale;
    }
    return entry->second;
  }

  double sigma(int v) const {
    if (H_sigma_.empty() || v < patch_.free_count) return std::numeric_limits<double>::quiet_NaN();
    return H_sigma_[static_cast<std::size_t>(v - patch_.free_count)];
  }

  /// From the middle of the edge (a, b), which one triangle of this side has, along the plane square to it.
  std::vector<ProfilePoint> walk(int a, int b, double reach) {
    const Vec3 middle = (patch_.positions[a] + patch_.positions[b]) / 2;
    const Vec3 square = (patch_.positions[b] - patch_.positions[a]).normalized();
    const auto height = [&](int v) { return square.dot(patch_.positions[v] - middle); };
    std::vector<ProfilePoint> points{{0, (H(a) + H(b)) / 2, (sigma(a) + sigma(b)) / 2}};
    Vec3 last = middle;
    int below = a, above = b;  // of the edge just crossed, by the plane's side
    auto face = face_.count({a, b}) ? face_.at({a, b}) : face_.count({b, a}) ? face_.at({b, a}) : -1;
    for (std::size_t step = 0; face >= 0 && step < triangles_.size(); ++step) {
      const Triangle& t = triangles_[face];
      const int apex = t[0] != below && t[0] != above ? t[0] : t[1] != below && t[1] != above ? t[1] : t[2];
      (height(apex) < 0 ? below : above) = apex;
      const double low = height(below), high = height(above), share = high > low ? -low / (high - low) : 0.5;
      const Vec3 here = (1 - share) * patch_.positions[below] + share * patch_.positions[above];
      const double distance = points.back().distance + (here - last).norm() * patch_.scale;
      if (distance > reach) break;
      points.push_back(
          {distance, (1 - share) * H(below) + share * H(above), (1 - share) * sigma(below) + share * sigma(above)});
      last = here;
      const auto one = face_.find({below, above}), other = face_.find({above, below});
      const int next = one != face_.end() && one->second != face       ? one->second
                       : other != face_.end() && other->second != face ? other->second
                                                                       : -1;
      face = next;
    }
    return points;
  }

 private:
  const Patch& patch_;
  std::span<const float> H_sigma_;
  Triangles triangles_;
  Topology topology_;
  Points normals_;
  std::vector<char> mark_;
  std::map<std::pair<int, int>, int> face_;
  std::map<int, double> known_;
};

Triangles own_triangles(const Patch& patch) {
  return {patch.triangles.begin(), patch.triangles.begin() + patch.patch_triangles};
}
Triangles triangles_around(const Patch& patch) {
  return {patch.triangles.begin() + patch.patch_triangles, patch.triangles.end()};
}

const std::vector<int>& loop_of(const Patch& patch, int loop) {
  if (loop < 0 || loop >= static_cast<int>(patch.loops.size()))
    throw InvalidArgument("the patch has no loop " + std::to_string(loop));
  return patch.loops[loop];
}

/// H at vertex i from a quadratic height field over three rings of one side, all weights one; NaN where it is too small.
double quadratic_H(const Points& points, const Topology& side, int i, const Vec3& normal, std::vector<char>& mark) {
  std::vector<int> near;
  side.k_ring(i, 3, near, mark);
  const auto count = static_cast<Eigen::Index>(near.size());
  if (count < 6 || normal.isZero()) return std::numeric_limits<double>::quiet_NaN();
  const Vec3 e1 = normal.unitOrthogonal(), e2 = normal.cross(e1);
  double mean = 0;
  for (int j : near) mean += (points[j] - points[i]).norm() / static_cast<double>(count);
  Eigen::MatrixXd A(count, 5);
  Eigen::VectorXd height(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Vec3 d = (points[near[static_cast<std::size_t>(k)]] - points[i]) / mean;
    const double u = d.dot(e1), v = d.dot(e2);
    A.row(k) << u, v, u * u / 2, u * v, v * v / 2;
    height[k] = d.dot(normal);
  }
  const Eigen::VectorXd c = A.colPivHouseholderQr().solve(height);
  const double w2 = 1 + c[0] * c[0] + c[1] * c[1];
  return ((1 + c[1] * c[1]) * c[2] - 2 * c[0] * c[1] * c[3] + (1 + c[0] * c[0]) * c[4]) / (2 * w2 * std::sqrt(w2)) /
         mean;
}

}  // namespace

std::vector<ProfilePoint> seam_profile(const Patch& patch, int loop, int edge, double reach,
                                       std::span<const float> H_sigma) {
  if (!H_sigma.empty() && H_sigma.size() != static_cast<std::size_t>(patch.vertex_count() - patch.free_count))
    throw InvalidArgument("the standard deviation of H must be given at each fixed vertex");
  const std::vector<int>& rim = loop_of(patch, loop);
  const int count = static_cast<int>(rim.size());
  if (edge < 0 || edge >= count) throw InvalidArgument("the loop has no edge " + std::to_string(edge));
  const int a = rim[edge], b = rim[(edge + 1) % count];
  std::vector<ProfilePoint> profile = Side(patch, triangles_around(patch), H_sigma).walk(a, b, reach);
  for (ProfilePoint& p : profile) p.distance = 0 - p.distance;  // no −0
  std::reverse(profile.begin(), profile.end());
  const std::vector<ProfilePoint> inside = Side(patch, own_triangles(patch)).walk(a, b, reach);
  profile.insert(profile.end(), inside.begin(), inside.end());
  return profile;
}

std::vector<double> seam_jumps(const Patch& patch, int loop) {
  const std::vector<int>& rim = loop_of(patch, loop);
  Side inside(patch, own_triangles(patch)), outside(patch, triangles_around(patch));
  std::vector<double> jumps;
  for (int v : rim) jumps.push_back(std::abs(inside.H(v) - outside.H(v)));
  return jumps;
}

double wide_curvature_jump(const Patch& patch) {
  const Topology inside(patch.vertex_count(), own_triangles(patch)),
      outside(patch.vertex_count(), triangles_around(patch));
  const Points normals = angle_weighted_normals(patch.positions, patch.triangles);
  std::vector<char> mark(patch.vertex_count(), 0);
  double sum = 0, count = 0;
  for (const auto& loop : patch.loops)
    for (int v : loop) {
      const double jump = quadratic_H(patch.positions, inside, v, normals[v], mark) -
                          quadratic_H(patch.positions, outside, v, normals[v], mark);
      if (!std::isfinite(jump)) continue;
      sum += jump * jump;
      ++count;
    }
  return count > 0 ? std::sqrt(sum / count) / patch.scale : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace loopmend
