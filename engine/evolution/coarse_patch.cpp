// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/coarse_patch.h"

#include "core/threads.h"
#include "operators/curvature_energy.h"
#include "remeshing/patch_remesh.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cmath>

namespace loopmend {

namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::point<double, 3, bg::cs::cartesian>;
using Entry = std::pair<TreePoint, int>;

constexpr double inward_growth = 0.4;    ///< of edges, per length of way from the boundary
constexpr double edges_per_radius = 13;  ///< of the coarse patch, at least
/// With this growth a coarse patch has about 4 vertices for each edge of its boundary.
constexpr int free_per_boundary_edge = 10;
constexpr int fewest_free = 1200;
constexpr int coarsening_rounds = 4;
constexpr int forms_for_a_point = 9;
constexpr int projections_at_a_time = 64;  ///< by a thread

TreePoint place(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// Fades smoothly from 1 at 0 to 0 at 1 (Wendland).
double fading(double t) { return t < 1 ? std::pow(1 - t, 4) * (4 * t + 1) : 0; }

/// The surface near a coarse mesh: r + t + ½ (tᵀ II t) n at each of its vertices, averaged.
class SurfaceOfForms {
 public:
  explicit SurfaceOfForms(const EvolutionState& state) : state_(state) {
    std::vector<Entry> entries;
    for (int i = 0; i < state.patch.vertex_count(); ++i)
      if (state.ops.valid[i]) entries.emplace_back(place(state.patch.positions[i]), i);
    tree_ = decltype(tree_)(entries);
  }

  Vec3 projected(const Vec3& p) const {
    std::vector<Entry> near;
    tree_.query(bg::index::nearest(place(p), forms_for_a_point), std::back_inserter(near));
    if (near.empty()) return p;
    const auto distance = [&](const Entry& e) { return (state_.patch.positions[e.second] - p).norm(); };
    std::sort(near.begin(), near.end(), [&](const Entry& a, const Entry& b) { return distance(a) < distance(b); });
    const double reach = distance(near.back());
    const Vec3& main_normal = state_.ops.normal[near.front().second];
    Vec3 sum = Vec3::Zero();
    double total = 0;
    for (const Entry& e : near) {
      const Vec3& n = state_.ops.normal[e.second];
      if (n.dot(main_normal) < 0.5) continue;  // another sheet
      const Vec3 d = p - state_.patch.positions[e.second];
      const Vec3 t = d - n.dot(d) * n;
      const double weight = fading(distance(e) / reach);
      sum += weight * (p + (0.5 * t.dot(state_.ops.second_form[e.second] * t) - n.dot(d)) * n);
      total += weight;
    }
    return total > 0 ? Vec3(sum / total) : p;
  }

 private:
  const EvolutionState& state_;
  bg::index::rtree<Entry, bg::index::quadratic<16>> tree_;
};

void remesh(ConstrainedRemesher& mesh) {
  mesh.split_long_edges();
  mesh.flip_to_delaunay();
  mesh.collapse_short_edges();
  mesh.flip_to_delaunay();
  for (int sweep = 0; sweep < 3; ++sweep) mesh.smooth_tangentially();
}

}  // namespace

bool worth_coarsening(const Patch& patch) {
  std::size_t boundary = 0;
  for (const auto& loop : patch.loops) boundary += loop.size();
  return patch.free_count > std::max(fewest_free, free_per_boundary_edge * static_cast<int>(boundary));
}

Patch coarsened(const Patch& patch) {
  Patch start = patch;
  start.grading = {1, inward_growth, patch_radius(patch) / edges_per_radius};
  ConstrainedRemesher mesh = open_for_remeshing(start);
  for (int round = 0; round < coarsening_rounds; ++round) {
    const int before = mesh.free_count();
    mesh.collapse_short_edges();
    mesh.flip_to_delaunay();
    mesh.smooth_tangentially();
    if (mesh.free_count() > before * 9 / 10) break;
  }
  mesh.split_long_edges();
  mesh.flip_to_delaunay();
  for (int sweep = 0; sweep < 3; ++sweep) mesh.smooth_tangentially();
  return with_interior(start, mesh);
}

Patch refined(const EvolutionState& coarse, const Grading& grading) {
  Patch start = coarse.patch;
  start.grading = grading;
  ConstrainedRemesher mesh = open_for_remeshing(start);
  // By way of twice the size, whose edges are then halved all alike: else a fifth more vertices are left.
  for (double size : {2.0, 1.0}) {
    mesh.scale_sizes(size);
    remesh(mesh);
    remesh(mesh);
    mesh.scale_sizes(1 / size);
  }
  Patch result = with_interior(start, mesh);
  const SurfaceOfForms surface(coarse);
  parallel_for(0, result.free_count, projections_at_a_time, [&](int i) {
    for (int pass = 0; pass < 2; ++pass) result.positions[i] = surface.projected(result.positions[i]);
  });
  return result;
}

}  // namespace loopmend
