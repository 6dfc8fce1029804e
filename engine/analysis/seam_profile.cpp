// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/seam_profile.h"

#include "analysis/seam_sides.h"
#include "core/error.h"

#include <Eigen/Geometry>

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
        scratch_(patch.vertex_count()) {
    for (std::size_t f = 0; f < triangles.size(); ++f)
      for (int k = 0; k < 3; ++k) face_[{triangles[f][k], triangles[f][(k + 1) % 3]}] = static_cast<int>(f);
  }

  double H(int v) {
    const auto [entry, added] = known_.try_emplace(v, std::numeric_limits<double>::quiet_NaN());
    if (added && fit_polynomial(patch_.positions, topology_, v, normals_[v], one_sided_fit(), scratch_, fit_))
      entry->second = fit_.H / patch_.scale;
    return entry->second;
  }

  double sigma(int v) const {
    if (H_sigma_.empty() || v < patch_.free_count) return std::numeric_limits<double>::quiet_NaN();
    return H_sigma_[v - patch_.free_count];
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
  FitScratch scratch_;
  PolynomialFit fit_;
  std::map<std::pair<int, int>, int> face_;
  std::map<int, double> known_;
};

const std::vector<int>& loop_of(const Patch& patch, int loop) {
  if (loop < 0 || loop >= static_cast<int>(patch.loops.size()))
    throw InvalidArgument(say("the patch has no loop %1", loop));
  return patch.loops[loop];
}

/// A quadratic height field over three rings, all weights one.
constexpr FitOptions wide_fit() {
  FitOptions options;
  options.rings = options.most_rings = 3;
  options.spare = 1;
  options.coordinates = Coordinates::projected;
  options.weighting = Weighting::equal;
  return options;
}

}  // namespace

std::vector<ProfilePoint> seam_profile(const Patch& patch, int loop, int edge, double reach,
                                       std::span<const float> H_sigma) {
  if (!H_sigma.empty() && H_sigma.size() != static_cast<std::size_t>(patch.vertex_count() - patch.free_count))
    throw InvalidArgument(say("the standard deviation of H must be given at each fixed vertex"));
  const std::vector<int>& boundary = loop_of(patch, loop);
  const int count = static_cast<int>(boundary.size());
  if (edge < 0 || edge >= count) throw InvalidArgument(say("the loop has no edge %1", edge));
  const int a = boundary[edge], b = boundary[(edge + 1) % count];
  std::vector<ProfilePoint> profile = Side(patch, triangles_around(patch), H_sigma).walk(a, b, reach);
  for (ProfilePoint& p : profile) p.distance = 0 - p.distance;  // no −0
  std::reverse(profile.begin(), profile.end());
  const std::vector<ProfilePoint> inside = Side(patch, own_triangles(patch)).walk(a, b, reach);
  profile.insert(profile.end(), inside.begin(), inside.end());
  return profile;
}

std::vector<double> seam_jumps(const Patch& patch, int loop) {
  SeamSides sides(patch);
  std::vector<double> jumps;
  for (int v : loop_of(patch, loop))
    jumps.push_back(sides.fit(v, one_sided_fit()) ? std::abs(sides.in.H - sides.out.H) / patch.scale
                                                  : std::numeric_limits<double>::quiet_NaN());
  return jumps;
}

double wide_curvature_jump(const Patch& patch) {
  SeamSides sides(patch);
  double sum = 0, count = 0;
  for (const auto& loop : patch.loops)
    for (int v : loop)
      if (sides.fit(v, wide_fit())) {
        sum += (sides.in.H - sides.out.H) * (sides.in.H - sides.out.H);
        ++count;
      }
  return count > 0 ? std::sqrt(sum / count) / patch.scale : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace loopmend
