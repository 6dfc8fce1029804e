// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/bridge_loops.h"

#include "core/error.h"
#include "filling/bridge_topology.h"
#include "filling/fairing.h"
#include "filling/ring_bridge.h"
#include "filling/wall_bridge.h"
#include "mesh/directed_edges.h"
#include "mesh/quality.h"
#include "mesh/self_intersections.h"
#include "mesh/validity.h"
#include "operators/operator_set.h"
#include "remeshing/double_edges.h"
#include "remeshing/patch_remesh.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace loopmend {

namespace {

constexpr int bridge_remesh_rounds = 5, untanglings = 3;
constexpr int membrane_rounds = 2;  ///< more pinch the necks between loops that are far apart
constexpr int fairing_rounds = 4;
/// A fairing that takes so many times the area is a bubble: it would be remeshed into millions of triangles. Those of 64 blends and of
/// the islands of 20 scans take at most a tenth more.
constexpr double bubble = 3;
constexpr double most_vertices = 2e6;
/// Folds and intersections for each triangle of a first bridge. Small ones that have more can be repaired; those of so many vertices
/// took up to a minute, and never were.
constexpr double tangled = 0.5;
constexpr double many_vertices = 5000;

void check_loops(const std::vector<BoundaryLoop>& loops) {
  if (loops.size() < 2) throw InvalidArgument(say("a blend needs at least two loops, not %1", loops.size()));
  std::set<std::pair<int, int>> edges;
  std::set<int> vertices;
  for (const BoundaryLoop& loop : loops) {
    const Message name = say("loop %1", loop.number);
    if (loop.kind == LoopKind::crack)
      throw InvalidArgument(say("%1 is no hole but a crack: it cannot be joined to others", name));
    if (loop.kind == LoopKind::cut)
      throw InvalidArgument(say("%1 is no hole but a cut: it cannot be joined to others", name));
    if (!(loop.diameter > 0)) throw InvalidArgument(say("all vertices of %1 are in one place", name));
    if (!edges.insert({loop.vertices[0], loop.vertices[1]}).second)
      throw InvalidArgument(say("%1 is named twice", name));
    for (int v : loop.vertices)
      if (!vertices.insert(v).second)
        throw InvalidArgument(
            say("%1 touches another loop, or itself, at a vertex: it cannot be joined to others", name));
  }
}

/// The loops and their rings without anything between them.
Patch empty_patch(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::vector<LoopPatch> initial_patches;
  for (const BoundaryLoop& loop : loops) {
    initial_patches.emplace_back();
    for (int v : loop.vertices) initial_patches.back().points.push_back(model.mesh.point(TriMesh::VertexHandle(v)));
  }
  return make_patch(model, loops, initial_patches);
}

int defect_count(const Validity& quality) { return quality.folds + quality.intersections; }

/// No folds within the ring; it may meet the walls at any angle.
bool is_sound_ring(const Patch& ring) {
  const Triangles own(ring.triangles.begin(), ring.triangles.begin() + ring.patch_triangles);
  return count_folds(ring.positions, own, ring.patch_triangles) == 0 &&
         self_intersections(ring.positions, ring.triangles, ring.patch_triangles).empty();
}

/// Whether its triangles survive rounding to floats as those of `first` do: remeshing puts vertices onto long straight edges of the outline.
bool has_no_new_needle(const Patch& ring, const Patch& first) {
  constexpr double thinnest = 0.01;  // degrees
  const double angle = min_angle_deg(ring.positions, ring.triangles, ring.patch_triangles);
  return angle >= std::min(thinnest, min_angle_deg(first.positions, first.triangles, first.patch_triangles));
}

/// At corners of its outline a wall has edges, which are no folds.
bool is_sound_wall(const Patch& wall) {
  constexpr double sharpest = -0.866;  // cosine of 150 degrees
  const Triangles own(wall.triangles.begin(), wall.triangles.begin() + wall.patch_triangles);
  const std::vector<Bend> own_bends = bends(wall.positions, own, wall.patch_triangles);
  return std::none_of(own_bends.begin(), own_bends.end(), [](const Bend& bend) { return bend.cosine < sharpest; }) &&
         self_intersections(wall.positions, wall.triangles, wall.patch_triangles).empty();
}

Patch with_triangles(const Patch& empty, const Triangles& own) {
  Patch patch = empty;
  patch.triangles.insert(patch.triangles.begin(), own.begin(), own.end());
  patch.patch_triangles = static_cast<int>(own.size());
  return patch;
}

/// Edges of the neighborhood between boundary vertices, which a bridge must not have too.
std::set<std::pair<int, int>> edges_between(int boundary, const Patch& empty) {
  std::set<std::pair<int, int>> edges;
  for (const Triangle& t : empty.triangles)
    for (int k = 0; k < 3; ++k)
      if (const int a = t[k], b = t[(k + 1) % 3]; a < boundary && b < boundary) edges.insert(std::minmax(a, b));
  for (const auto& loop : empty.loops)
    for (std::size_t i = 0; i < loop.size(); ++i) edges.erase(std::minmax(loop[i], loop[(i + 1) % loop.size()]));
  return edges;
}

/// The patch over a bridge, whose own vertices are given in mesh units. Edges that the surface has are split.
Patch with_bridge(const Patch& empty, const SweptBridge& bridge) {
  int boundary = 0;
  for (const auto& loop : empty.loops) boundary += static_cast<int>(loop.size());
  Points points(empty.positions.begin(), empty.positions.begin() + boundary);
  for (std::size_t i = boundary; i < bridge.points.size(); ++i) points.push_back(empty.to_frame(bridge.points[i]));
  Triangles triangles = bridge.triangles;
  split_beside(edges_between(boundary, empty), points, triangles);
  if (static_cast<int>(points.size()) == boundary) return with_triangles(empty, triangles);
  return with_interior(empty, ConstrainedRemesher(points, triangles, boundary, {}, [](const Vec3&) { return 1.0; }));
}

double mean_boundary_edge(const std::vector<BridgeEnd>& ends) {
  double length = 0, count = 0;
  for (const BridgeEnd& end : ends)
    for (std::size_t i = 0; i < end.points.size(); ++i, ++count)
      length += (end.points[(i + 1) % end.points.size()] - end.points[i]).norm();
  return length / count;
}

/// A first bridge; its shape is kept as the flow's start where it runs on smoothly from both sides already.
struct FirstBridge {
  Patch patch;
  enum class Shape { smooth, angular } shape;
};

/// What to try, best first: the sweep between two loops; the hull; the strip, which suits wavy boundaries.
std::vector<FirstBridge> first_bridges(const Patch& empty, const std::vector<BridgeEnd>& ends, double density) {
  std::vector<FirstBridge> bridges;
  const auto add = [&](const Triangles& triangles) {
    if (triangles.empty()) return;
    // No edge may run the same way in two triangles, in the strip or beside it.
    if (DirectedEdges(triangles, static_cast<int>(triangles.size())).any_twice()) return;
    Patch patch = with_bridge(empty, {{}, triangles});
    if (!DirectedEdges(patch.triangles, static_cast<int>(patch.triangles.size())).any_twice())
      bridges.push_back({std::move(patch), FirstBridge::Shape::angular});
  };
  if (ends.size() == 2)
    bridges.push_back({with_bridge(empty, bridge_by_sweep(ends[0], ends[1], mean_boundary_edge(ends) / density)),
                       FirstBridge::Shape::smooth});
  add(bridge_by_hull(ends));
  if (ends.size() == 2) add(bridge_by_strip(ends[0].points, ends[1].points));
  return bridges;
}

template <class Phase>
void try_phase(Patch& best, const Phase& phase) {
  ConstrainedRemesher mesh = open_for_remeshing(best);
  phase(mesh);
  Patch next = with_interior(best, mesh);
  if (defect_count(patch_validity(next)) <= defect_count(patch_validity(best))) best = std::move(next);
}

/// ∫‖∇H‖² over the patch and the two rings around it: of two starts the smoother one is nearer to the goal.
double unfairness(const Patch& patch) {
  const Topology topology(patch.vertex_count(), patch.triangles);
  std::vector<char> wanted(patch.vertex_count());
  std::vector<int> faces;
  for (int i = 0; i < patch.vertex_count(); ++i) wanted[i] = patch.ring[i] <= 3;
  for (std::size_t f = 0; f < patch.triangles.size(); ++f) {
    const Triangle& t = patch.triangles[f];
    if (std::min({patch.ring[t[0]], patch.ring[t[1]], patch.ring[t[2]]}) <= 2) faces.push_back(static_cast<int>(f));
  }
  const OperatorSet ops = compute_operators(patch.positions, patch.triangles, topology, Stencil::two_ring, wanted);
  return ops.H.dot(cotan_stiffness(patch.positions, patch.triangles, faces) * ops.H);
}

Patch remeshed(Patch bridge, const CancelToken& cancel) {
  try_phase(bridge, [&](ConstrainedRemesher& mesh) {
    for (int k = 0; k < bridge_remesh_rounds && !cancel.cancelled(); ++k) remesh_once(mesh);
  });
  for (int attempt = 0; attempt < untanglings && defect_count(patch_validity(bridge)) > 0 && !cancel.cancelled();
       ++attempt)
    try_phase(bridge, [](ConstrainedRemesher& mesh) {
      mesh.untangle();
      remesh_once(mesh);
    });
  return bridge;
}

/// Part of the way from the fair shape to the minimal surface, all vertices together: going further pinches, and moving
/// them one by one leaves the patch crumpled.
Patch membrane(Patch bridge, const CancelToken& cancel) {
  for (int k = 0; k < membrane_rounds && !cancel.cancelled(); ++k) {
    const ConstrainedRemesher mesh = open_for_remeshing(bridge);
    const Points goal = minimal_surface_step(mesh.points(), mesh.triangles(), mesh.locked());
    for (double share : {0.5, 0.25, 0.1}) {
      Patch next = bridge;
      for (int i = 0; i < bridge.free_count; ++i)
        next.positions[i] += share * (goal[mesh.locked() + i] - bridge.positions[i]);
      if (defect_count(patch_validity(next)) > defect_count(patch_validity(bridge))) continue;
      bridge = std::move(next);
      break;
    }
    try_phase(bridge, [](ConstrainedRemesher& open) {
      open.flip_to_delaunay();
      open.smooth_tangentially();
    });
  }
  return bridge;
}

/// A patch with the two figures by which starts are compared.
struct Start {
  explicit Start(Patch p) : patch(std::move(p)), quality(patch_validity(patch)), unfair(unfairness(patch)) {}
  bool better_than(const Start& other) const {
    const int a = defect_count(quality), b = defect_count(other.quality);
    return a != b ? a < b : unfair < other.unfair;
  }
  Patch patch;
  Validity quality;
  double unfair;
};

double area_of(const Patch& bridge) {
  double area = 0;
  for (int f = 0; f < bridge.patch_triangles; ++f) {
    const Triangle& t = bridge.triangles[f];
    area +=
        (bridge.positions[t[1]] - bridge.positions[t[0]]).cross(bridge.positions[t[2]] - bridge.positions[t[0]]).norm();
  }
  return area / 2;
}

/// Linear fairing of third order, remeshed under guard, as often as it makes the patch fairer; first without regard to
/// the triangles' shapes, which pinched necks have spoilt.
Start faired(Start best, const CancelToken& cancel) {
  const double largest = bubble * area_of(best.patch);
  const auto take = [&](Points positions) {
    Patch next = best.patch;
    next.positions = std::move(positions);
    if (area_of(next) > largest) return false;
    try_phase(next, [](ConstrainedRemesher& mesh) {
      mesh.untangle();
      remesh_once(mesh);
      remesh_once(mesh);
    });
    Start trial(std::move(next));
    if (!trial.better_than(best)) return false;
    best = std::move(trial);
    return true;
  };
  take(graph_fairing(best.patch, cancel));
  for (int round = 0; round < fairing_rounds && !cancel.cancelled(); ++round)
    if (!take(linear_fairing(best.patch, 0, robust_clamp, cancel))) break;
  return best;
}

/// Vertices of equilateral triangles over the area of the first triangulation.
double expected_vertices(const Patch& bridge, double density) {
  double edges = 0, length = 0;
  for (const auto& loop : bridge.loops)
    for (std::size_t i = 0; i < loop.size(); ++i, ++edges)
      length += (bridge.positions[loop[i]] - bridge.positions[loop[(i + 1) % loop.size()]]).norm();
  const double size = length / edges / density;
  return area_of(bridge) / (0.866 * size * size);
}

}  // namespace

std::vector<int> find_opposed_loops(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  const std::vector<BridgeEnd> ends = ends_of(model, loops);
  Vec3 center = Vec3::Zero();
  for (const BoundaryLoop& loop : loops) center += loop.center / static_cast<double>(loops.size());
  std::vector<int> opposed;
  if (const std::optional<std::size_t> outline = outline_of_a_ring(ends)) {
    // Seen along the walls, the outer loop runs round one way, the inner ones the other way.
    for (std::size_t k = 1; k < ends.size(); ++k)
      if ((ends[0].axis.dot(ends[k].axis) < 0) != (*outline == 0 || *outline == k))
        opposed.push_back(static_cast<int>(k));
    return opposed;
  }
  if (loops.size() == 2 && are_outlines_of_a_plate(loops[0], loops[1], ends[0], ends[1])) {
    // So do both outlines of a plate.
    if (ends[0].axis.dot(ends[1].axis) > 0) opposed.push_back(1);
    return opposed;
  }
  if (loops.size() == 2 && (turning_sense(ends[0], center) == 0 || turning_sense(ends[1], center) == 0)) {
    // An island and its hole: seen from above, one loop runs round one way, the other the other way.
    if (ends[0].axis.dot(ends[1].axis) > 0) opposed.push_back(1);
    return opposed;
  }
  const int first = turning_sense(ends.front(), center);
  for (std::size_t k = 1; k < ends.size(); ++k)
    if (turning_sense(ends[k], center) * first < 0) opposed.push_back(static_cast<int>(k));
  return opposed;
}

namespace {

/// The straight wall between the outlines of a plate's sides; empty where it would fold or cut itself.
std::optional<Bridge> wall_between(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                   const std::vector<BridgeEnd>& ends, double density) {
  const SweptBridge bridge = bridge_by_wall(ends[0], ends[1], mean_boundary_edge(ends) / density);
  if (bridge.triangles.empty() ||
      DirectedEdges(bridge.triangles, static_cast<int>(bridge.triangles.size())).any_twice())
    return std::nullopt;
  if (static_cast<double>(bridge.points.size()) > most_vertices) return std::nullopt;
  Patch wall = with_bridge(empty_patch(model, loops), bridge);
  wall.grading.density = density;
  if (!is_sound_wall(wall)) return std::nullopt;
  return Bridge{wall, wall, patch_validity(wall), Bridge::Kind::ring};
}

}  // namespace

std::optional<Bridge> ring_between(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, double density,
                                   const CancelToken& cancel) {
  const std::vector<BridgeEnd> ends = ends_of(model, loops);
  const bool is_pair = loops.size() == 2;
  if (is_pair && have_a_wall_between(loops[0], loops[1], ends[0], ends[1]))
    return wall_between(model, loops, ends, density);
  if (!outline_of_a_ring(ends) || (is_pair && bend_towards_each_other(model, loops, ends))) return std::nullopt;
  const Patch empty = empty_patch(model, loops);
  for (const SweptBridge& bridge : bridges_by_ring(ends, mean_boundary_edge(ends) / density)) {
    if (DirectedEdges(bridge.triangles, static_cast<int>(bridge.triangles.size())).any_twice()) continue;
    Patch ring = with_bridge(empty, bridge);
    ring.grading.density = density;
    if (expected_vertices(ring, density) > most_vertices) return std::nullopt;
    if (bridge.points.empty()) {
      ConstrainedRemesher mesh = open_for_remeshing(ring);
      for (int k = 0; k < bridge_remesh_rounds && !cancel.cancelled(); ++k) remesh_once(mesh);
      Patch next = with_interior(ring, mesh);
      for (int attempt = 0; attempt < untanglings && !is_sound_ring(next) && !cancel.cancelled(); ++attempt) {
        mesh.untangle();
        remesh_once(mesh);
        next = with_interior(ring, mesh);
      }
      if (is_sound_ring(next) && has_no_new_needle(next, ring)) ring = std::move(next);
    }
    if (is_sound_ring(ring)) return Bridge{ring, ring, patch_validity(ring), Bridge::Kind::ring};
  }
  return std::nullopt;
}

BridgeOutcome bridge_loops(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                           const InitialPatchOptions& options, const CancelToken& cancel) {
  check(options);
  check_loops(loops);
  BridgeOutcome outcome;
  std::optional<Start> best;
  const std::vector<BridgeEnd> ends = ends_of(model, loops);
  outcome.bridge = ring_between(model, loops, options.density, cancel);
  if (cancel.cancelled()) return {};
  if (outcome.bridge) return outcome;
  for (auto& [first, shape] : first_bridges(empty_patch(model, loops), ends, options.density)) {
    first.grading.density = options.density;
    const double vertices = expected_vertices(first, options.density);
    if (vertices > most_vertices) {
      outcome.message = joined(say("the patch would need about %1 million vertices", static_cast<long>(vertices / 1e6)),
                               ": ", say("a lower density needs fewer"))
                            .with_code("too_many_vertices");
      return outcome;
    }
    if (vertices > many_vertices && defect_count(patch_validity(first)) > tangled * first.patch_triangles) {
      outcome.message = joined(say("every first surface between these loops folds or cuts itself all over"), ": ",
                               say("a lower density may help"));
      continue;
    }
    Start start(remeshed(first, cancel));
    const bool ready = shape == FirstBridge::Shape::smooth && defect_count(start.quality) == 0;
    if (!ready) start = faired(std::move(start), cancel);
    if (cancel.cancelled()) return {};
    if (best && !start.better_than(*best)) continue;
    best = std::move(start);
    if (ready) break;
  }
  if (!best && !outcome.message.empty()) return outcome;
  outcome.message = {};
  if (!best) {
    outcome.message =
        say("no surface that joins these loops was found: they do not face a common middle, nor each other");
    return outcome;
  }
  if (defect_count(best->quality) > 0) outcome.message = say("the bridge has %1 left", faults_of(best->quality));
  outcome.bridge = Bridge{membrane(best->patch, cancel), best->patch, best->quality, Bridge::Kind::smooth};
  return outcome;
}

}  // namespace loopmend
