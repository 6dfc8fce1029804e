// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/proportion.h"

#include "evolution/state.h"
#include "operators/curvature_energy.h"
#include "pipeline/validate.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace loopmend {

namespace {

/// Of the part that one loop bounds.
struct Part {
  double area = 0;
  std::vector<int> triangles;
};

/// About the mean of a part's corners.
struct Ball {
  Vec3 center = Vec3::Zero();
  double radius = 0;

  Ball(const Patch& patch, const Part& part) {
    for (int f : part.triangles)
      for (int v : patch.triangles[f])
        center += patch.positions[v] / (3.0 * static_cast<double>(part.triangles.size()));
    for (int f : part.triangles)
      for (int v : patch.triangles[f]) radius = std::max(radius, (patch.positions[v] - center).norm());
  }
};

std::vector<Part> parts_of(const Patch& patch) {
  const std::vector<int> loop = loop_of_triangles(patch);
  std::vector<Part> parts(patch.loops.size());
  for (int f = 0; f < patch.patch_triangles; ++f) {
    const Triangle& t = patch.triangles[f];
    const Vec3 &a = patch.positions[t[0]], &b = patch.positions[t[1]], &c = patch.positions[t[2]];
    Part& part = parts[loop[f]];
    part.area += (b - a).cross(c - a).norm() / 2;
    part.triangles.push_back(f);
  }
  return parts;
}

}  // namespace

std::vector<Proportion> proportions_of(const Patch& patch, const Patch& initial) {
  const std::vector<Part> now = parts_of(patch), first = parts_of(initial);
  const EvolutionState state =
      make_state(patch, {FlowKind::mmcvf, 0, energy_reach}, Stencil::two_ring, nullptr, Fits::curvatures);
  std::vector<Proportion> result(now.size());
  for (std::size_t l = 0; l < std::min(now.size(), first.size()); ++l) {
    if (now[l].triangles.empty() || !(first[l].area > 0)) continue;
    Proportion& part = result[l];
    part.area = now[l].area / first[l].area;
    const Ball ball(initial, first[l]);
    for (int f : now[l].triangles) {
      const Triangle& t = patch.triangles[f];
      const auto weight = half_cotangents(patch.positions, t);
      for (int k = 0; k < 3; ++k) {
        const double difference = state.ops.H[t[(k + 1) % 3]] - state.ops.H[t[(k + 2) % 3]];
        part.energy += weight[k] * difference * difference * now[l].area;
        part.depth = std::max(part.depth, (patch.positions[t[k]] - ball.center).norm() / ball.radius / 2 - 0.5);
      }
    }
  }
  return result;
}

bool is_out_of_proportion(const Proportion& proportion, const Proportion& most) {
  // The other way round, so that what is not a number is out of proportion.
  return !(proportion.energy <= most.energy) && (!(proportion.area <= most.area) || !(proportion.depth <= most.depth));
}

}  // namespace loopmend
