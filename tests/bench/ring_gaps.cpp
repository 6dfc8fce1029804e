// SPDX-License-Identifier: GPL-3.0-or-later
#include "ring_gaps.h"

#include "analysis/seam_report.h"
#include "known_surfaces.h"
#include "peers.h"
#include "pipeline/blend.h"
#include "samples/analytic_surfaces.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

namespace loopmend::bench {

namespace {

constexpr double half_gap = 0.7;  ///< of the surface's radius

struct RingGap {
  SurfaceModel model;
  std::vector<BoundaryLoop> loops;
  double diameter = 0;
};

RingGap ring_gap(const KnownSurface& surface) {
  RingGap gap;
  gap.model = make_surface_model(cut(surface.mesh, [](const Vec3& p) { return std::abs(p.z()) < half_gap; }));
  for (const BoundaryLoop& loop : find_boundary_loops(gap.model)) {
    if (std::abs(loop.center.z()) > 1.6 * half_gap) continue;
    gap.loops.push_back(loop);
    gap.diameter = std::max(gap.diameter, loop.diameter);
  }
  return gap;
}

struct RingFigures {
  double distance = 0;  ///< rms of the free vertices to the surface, 1e-3 D
  double jump = 0;      ///< rms of the jump of H at the worse seam, times D
};

RingFigures figures_of(const Patch& patch, const KnownSurface& surface, double diameter) {
  RingFigures figures;
  for (int i = 0; i < patch.free_count; ++i)
    figures.distance += std::pow(surface.distance(patch.to_mesh(patch.positions[i])), 2) / patch.free_count;
  figures.distance = 1e3 * std::sqrt(figures.distance) / diameter;
  for (const SeamReport& seam : seam_reports(patch))
    figures.jump = std::max(figures.jump, seam.h_jump_rms_times_diameter);
  return figures;
}

/// The bridge as fairing of order k leaves it (k = 2: CGAL's default; 3: CGAL with continuity 2): CGAL bridges no gap
/// itself, so that it gets our first patch. Empty where it cannot be solved.
std::optional<Patch> faired(Patch patch, int k) {
  const int free = patch.free_count, fixed = patch.vertex_count() - free;
  const auto renumbered = [&](const Triangle& t) {
    Triangle other = t;
    for (int& v : other) v = v < free ? fixed + v : v - free;
    return other;
  };
  const Points around(patch.positions.begin() + free, patch.positions.end());
  Triangles triangles;
  Filling filling;
  filling.points.assign(patch.positions.begin(), patch.positions.begin() + free);
  for (std::size_t f = 0; f < patch.triangles.size(); ++f)
    (static_cast<int>(f) < patch.patch_triangles ? filling.triangles : triangles)
        .push_back(renumbered(patch.triangles[f]));
  if (!make_harmonic(around, triangles, filling, k)) return std::nullopt;
  std::copy(filling.points.begin(), filling.points.end(), patch.positions.begin());
  return patch;
}

Patch on_surface(Patch patch, const KnownSurface& surface) {
  for (int i = 0; i < patch.free_count; ++i) {
    Vec3& p = patch.positions[static_cast<std::size_t>(i)];
    p = patch.to_frame(surface.project(patch.to_mesh(p)));
  }
  return patch;
}

void add_row(const KnownSurface& surface, MeshKind kind, int around, Table& table) {
  const RingGap gap = ring_gap(surface);
  SurfaceModel model = gap.model;
  const BlendResult result = blend_loops(model, gap.loops, {}, {});
  if (result.outcome.status == PatchStatus::failed) throw std::runtime_error(result.outcome.message.english());
  const RingFigures ours = figures_of(result.outcome.patch, surface, gap.diameter);
  const RingFigures exact = figures_of(on_surface(result.outcome.patch, surface), surface, gap.diameter);
  constexpr double none = std::numeric_limits<double>::infinity();
  RingFigures best{none, none};
  for (int k : {2, 3})
    for (const Patch* start : {&result.bridge->membrane, &result.bridge->start})
      if (const auto patch = faired(*start, k)) {
        const RingFigures peer = figures_of(*patch, surface, gap.diameter);
        best.distance = std::min(best.distance, peer.distance);
        best.jump = std::min(best.jump, peer.jump);
      }
  table.add({surface.name, to_string(kind), number(around), to_string(result.outcome.status),
             number(result.outcome.patch.free_count), number(result.outcome.steps), number(ours.distance),
             number(best.distance), number(ours.jump), number(best.jump), number(exact.jump)});
}

}  // namespace

Table run_ring_gaps() {
  Table table({"surface", "mesh", "around", "status", "free", "steps", "rms, 1e-3 D", "best peer", "jump x D",
               "best peer", "exact surface"});
  for (int around : {24, 32, 40, 60, 96})
    for (MeshKind kind : {MeshKind::regular, MeshKind::jittered, MeshKind::irregular}) {
      add_row(with_mesh(known_cylinder(6, around), kind, 5), kind, around, table);
      add_row(with_mesh(known_unduloid(0.3, 3, around), kind, 5), kind, around, table);
      std::fprintf(stderr, "rings %d %s\n", around, to_string(kind));
    }
  return table;
}

}  // namespace loopmend::bench
