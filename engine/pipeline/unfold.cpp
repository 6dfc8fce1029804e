// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/unfold.h"

#include "mesh/quality.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

constexpr int most_rounds = 30;
constexpr double margin_deg =
    5;  ///< beyond the limit, so that a turn for one edge may be undone in part by that for another

int apex(const Triangle& triangle, const Bend& bend) {
  for (int v : triangle)
    if (v != bend.low && v != bend.high) return v;
  return -1;
}

}  // namespace

bool unfold(Patch& patch, double limit_deg, const CancelToken& cancel) {
  const double limit = limit_deg * std::numbers::pi / 180, margin = margin_deg * std::numbers::pi / 180;
  bool has_moved = false;
  for (int round = 0; round < most_rounds && !cancel.cancelled(); ++round) {
    std::vector<Vec3> shift(patch.free_count, Vec3::Zero());
    std::vector<int> count(patch.free_count, 0);
    bool is_folded = false;
    for (const Bend& bend : bends(patch.positions, patch.triangles, static_cast<int>(patch.triangles.size()))) {
      const double angle = std::acos(std::clamp(bend.cosine, -1.0, 1.0));
      if (angle <= limit || bend.face >= patch.patch_triangles) continue;
      is_folded = true;
      const Vec3 &from = patch.positions[bend.low], &to = patch.positions[bend.high];
      const Vec3 axis = (to - from).normalized();
      for (const auto& [own, other] : {std::pair(bend.face, bend.other), std::pair(bend.other, bend.face)}) {
        const int v = apex(patch.triangles[own], bend), w = apex(patch.triangles[other], bend);
        if (v < 0 || w < 0 || v >= patch.free_count) continue;
        const auto beside = [&](int i) {
          const Vec3 d = patch.positions[i] - from;
          return Vec3(d - axis.dot(d) * axis);
        };
        // Away from the other triangle: the angle between the two directions falls from 180° − fold to 180°.
        const Vec3 own_side = beside(v), other_side = beside(w);
        const double sense = axis.dot(other_side.cross(own_side)) < 0 ? -1 : 1;
        const Eigen::AngleAxisd turn(sense * (angle - limit + margin) / 2, axis);
        shift[v] += turn * own_side - own_side;
        ++count[v];
      }
    }
    if (!is_folded) break;
    for (int v = 0; v < patch.free_count; ++v)
      if (count[v] > 0) {
        patch.positions[v] += shift[v] / count[v];
        has_moved = true;
      }
  }
  return has_moved;
}

}  // namespace loopmend
