// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/loop_patch.h"

#include "core/error.h"
#include "filling/fairing.h"
#include "filling/triangulate_loop.h"
#include "mesh/by_position.h"
#include "mesh/quality.h"
#include "mesh/vertex_fans.h"
#include "remeshing/constrained_remesher.h"
#include "remeshing/double_edges.h"
#include "remeshing/patch_remesh.h"
#include "remeshing/size_field.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <unordered_map>

namespace loopmend {

namespace {

constexpr int longest_for_cubic_first = 100;
constexpr int longest_for_cubic = 350;  // docs/math/filling.md, "Triangulation"
constexpr int longest_for_all_methods = 5000;
constexpr double from_coarse_to_fine = 200;  // vertices
constexpr double one_try_only = 20000;       // vertices: where the best triangulation fails, others would for as long
constexpr int beyond_the_cache = 5000;       // free vertices on the last coarse level

/// Everything the initial patch needs to know about a loop, in the patch frame; the loop's places are 0..n−1. A vertex that
/// the loop passes twice has two places.
struct FillContext {
  int n = 0;
  Points points;             ///< the loop, then the rings around it
  std::vector<int> vertex;   ///< n: for each place the first with the same vertex
  std::vector<char> shared;  ///< n: whether another boundary, or this one again, passes the vertex's position
  Chords taken;              ///< that a patch must not have as edges: the surface has them, or they run along it
  Triangles neighborhood;    ///< over `points`, by the first places
  std::vector<double> size;  ///< n: mean length of the edges of the neighborhood at each loop vertex
  BoundaryNormals boundary_normals;
  ConstrainedRemesher::Watch watch;                             ///< ends remeshing with Cancelled or TooManyVertices
  Patch frame;                                                  ///< an empty patch: its centre and scale
  enum class Cuts { may_come, may_not } cuts = Cuts::may_come;  ///< in exchange for folds, where there were none
};

/// Thrown to end remeshing early; does not leave fill_loop().
enum class Stopped { cancelled, too_many_vertices };

/// Sizes and normals at the boundary.
void measure_neighborhood(FillContext& context) {
  std::vector<double> sum(context.points.size(), 0), count(context.points.size(), 0);
  std::map<std::pair<int, int>, int> boundary;
  for (int i = 0; i < context.n; ++i) boundary[{context.vertex[i], context.vertex[(i + 1) % context.n]}] = i;
  for (const Triangle& t : context.neighborhood)
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      const double length = (context.points[a] - context.points[b]).norm();
      for (int v : {a, b}) {
        sum[v] += length;
        count[v] += 1;
      }
      if (const auto edge = boundary.find({b, a}); edge != boundary.end())
        context.boundary_normals[{edge->second, (edge->second + 1) % context.n}] =
            unit_normal(context.points[t[0]], context.points[t[1]], context.points[t[2]]);
    }
  for (int i = 0; i < context.n; ++i)
    context.size.push_back(sum[context.vertex[i]] / std::max(1.0, count[context.vertex[i]]));
}

void find_taken_chords(const BoundaryLoop& loop, FillContext& context) {
  context.taken = present_chords(context.neighborhood, context.vertex);
  context.taken.insert(loop.joined.begin(), loop.joined.end());
  if (context.n <= longest_for_cubic) context.taken.merge(straight_chords(context.points, context.vertex));
}

FillContext make_context(const SurfaceModel& model, const BoundaryLoop& loop) {
  FillContext context;
  LoopPatch empty;
  for (int v : loop.vertices) empty.points.push_back(model.mesh.point(TriMesh::VertexHandle(v)));
  context.frame = make_patch(model, {loop}, {empty});
  context.n = loop.edges();
  const std::vector<int>& visited = context.frame.loops.front();  // no free vertices, and ring 1 comes first
  const int distinct = 1 + *std::max_element(visited.begin(), visited.end());
  std::vector<int> place(distinct, -1);
  for (int i = 0; i < context.n; ++i) {
    if (place[visited[i]] < 0) place[visited[i]] = i;
    context.vertex.push_back(place[visited[i]]);
    const bool several_fans = fan_count(model.mesh, TriMesh::VertexHandle(loop.vertices[i])) > 1;
    context.shared.push_back(several_fans || (!loop.shared.empty() && loop.shared[i]));
    context.points.push_back(context.frame.positions[visited[i]]);
  }
  context.points.insert(context.points.end(), context.frame.positions.begin() + distinct,
                        context.frame.positions.end());
  context.neighborhood = context.frame.triangles;
  for (Triangle& t : context.neighborhood)
    for (int& v : t) v = v < distinct ? place[v] : v - distinct + context.n;
  find_taken_chords(loop, context);
  measure_neighborhood(context);
  return context;
}

/// The same, but the neighborhood is all triangles of the scan that meet the loop's bounding box.
FillContext make_wide_context(const SurfaceModel& model, const TriangleIndex& index, const BoundaryLoop& loop) {
  FillContext context = make_context(model, loop);
  context.points.resize(context.n);
  context.neighborhood.clear();
  std::unordered_map<int, int> place;  // of soup points
  Eigen::AlignedBox3d box;
  for (int i = 0; i < context.n; ++i) {
    // Where the surface was parted at a vertex, the loop passes several at one point: they are one here.
    context.vertex[i] = place.emplace(model.soup_vertex[loop.vertices[i]], context.vertex[i]).first->second;
    box.extend(model.mesh.point(TriMesh::VertexHandle(loop.vertices[i])));
  }
  Triangles near;
  for (int f : index.near_box(box.min(), box.max())) near.push_back(model.soup.triangles[f]);
  for (Triangle t : sorted_by_position(model.soup.points, std::move(near))) {
    for (int& v : t) {
      const auto [entry, added] = place.emplace(v, static_cast<int>(context.points.size()));
      if (added) context.points.push_back(context.frame.to_frame(model.soup.points[v]));
      v = entry->second;
    }
    context.neighborhood.push_back(t);
  }
  context.cuts = FillContext::Cuts::may_not;
  find_taken_chords(loop, context);
  context.size.clear();
  context.boundary_normals.clear();
  measure_neighborhood(context);
  return context;
}

/// A triangulation on its way to an initial patch: the loop's n points first, then new ones.
struct Candidate {
  Points points;
  Triangles triangles;
  Validity quality;

  int defect_count() const { return quality.folds + quality.intersections; }
  /// One that cuts nothing is better than any that does: on a wall that turns back, each boundary edge may count as a fold.
  bool better_than(const Candidate& other) const {
    const auto rank = [](const Candidate& c) { return std::pair(c.quality.intersections > 0, c.defect_count()); };
    return rank(*this) < rank(other);
  }
  /// Bad enough to try another triangulation: the folds on a boundary that turns back are the boundary's own.
  bool wants_another(int boundary) const {
    return quality.intersections > 0 || (quality.folds > 0 && quality.folds < boundary);
  }
};

/// Patch and neighborhood in one list, the patch's triangles first.
void join(const FillContext& context, const Candidate& c, Points& points, Triangles& triangles) {
  points = c.points;
  points.insert(points.end(), context.points.begin() + context.n, context.points.end());
  triangles = c.triangles;
  for (Triangle& t : triangles)
    for (int& v : t) v = v < context.n ? context.vertex[v] : v;
  const int shift = static_cast<int>(c.points.size()) - context.n;
  for (Triangle t : context.neighborhood) {
    for (int& v : t) v = v < context.n ? v : v + shift;
    triangles.push_back(t);
  }
}

Validity assess(const FillContext& context, const Candidate& c) {
  Points points;
  Triangles triangles;
  join(context, c, points, triangles);
  const int count = static_cast<int>(c.triangles.size());
  Validity quality;
  quality.folds = count_folds(points, triangles, count);
  quality.intersections = static_cast<int>(self_intersections(points, triangles, count).size());
  quality.min_angle_deg = min_angle_deg(points, triangles, count);
  return quality;
}

/// Whether the surface has the edge, or a patch across another gap might have it: it has room for one.
bool must_be_split(const FillContext& context, int a, int b) {
  const int apart = std::abs(a - b);
  if (a >= context.n || b >= context.n || apart == 1 || apart == context.n - 1) return false;
  return (context.shared[a] && context.shared[b]) || context.taken.contains(std::minmax(a, b));
}

void split_taken_chords(const FillContext& context, Candidate& c) {
  Chords chords;
  for (const Triangle& t : c.triangles)
    for (int k = 0; k < 3; ++k)
      if (must_be_split(context, t[k], t[(k + 1) % 3])) chords.insert(std::minmax(t[k], t[(k + 1) % 3]));
  split_beside(chords, c.points, c.triangles);
}

std::vector<TriangulationMethod> methods_for(int edges) {
  if (edges <= longest_for_cubic_first)
    return {TriangulationMethod::cubic, TriangulationMethod::delaunay, TriangulationMethod::planar};
  if (edges <= longest_for_cubic)
    return {TriangulationMethod::delaunay_only, TriangulationMethod::cubic, TriangulationMethod::planar};
  if (edges <= longest_for_all_methods) return {TriangulationMethod::delaunay_only, TriangulationMethod::planar};
  return {TriangulationMethod::planar, TriangulationMethod::delaunay_only};
}

/// As candidates, in the order of the methods; stops at the first that is neither folded nor cut.
std::vector<Candidate> triangulations_without(const Chords& avoided, const FillContext& context,
                                              const CancelToken& cancel) {
  std::vector<Candidate> candidates;
  for (TriangulationMethod method : methods_for(context.n)) {
    if (cancel.cancelled()) break;
    Candidate c;
    c.triangles = triangulate_loop(context.points, context.neighborhood, context.vertex, avoided, method);
    if (c.triangles.empty()) continue;
    c.points.assign(context.points.begin(), context.points.begin() + context.n);
    split_taken_chords(context, c);
    split_double_edges(context.n, c.points, c.triangles);
    c.quality = assess(context, c);
    candidates.push_back(std::move(c));
    if (!candidates.back().wants_another(context.n)) break;
  }
  return candidates;
}

/// The triangulations to try, best first. Where each has a chord that the surface has as an edge, that chord is split.
std::vector<Candidate> first_triangulations(const FillContext& context, const CancelToken& cancel) {
  std::vector<Candidate> candidates = triangulations_without(context.taken, context, cancel);
  if (candidates.empty() && !context.taken.empty())
    candidates = triangulations_without(present_chords({}, context.vertex), context, cancel);
  std::ranges::stable_sort(candidates, &Candidate::better_than);
  return candidates;
}

ConstrainedRemesher guarded(const FillContext& context, const SizeField& size, const Candidate& c) {
  ConstrainedRemesher mesh(c.points, c.triangles, context.n, context.boundary_normals,
                           [&size](const Vec3& p) { return size.at(p); });
  mesh.set_watch(context.watch);
  return mesh;
}

Candidate harvest(const FillContext& context, const ConstrainedRemesher& mesh) {
  Candidate c;
  c.points = mesh.points();
  c.triangles = mesh.triangles();
  split_double_edges(context.n, c.points, c.triangles);
  c.quality = assess(context, c);
  return c;
}

constexpr int remesh_rounds = 5;
constexpr int relax_rounds = 8;
constexpr double still = 0.05;  ///< relaxation that wants no vertex further, in target lengths, is done

bool relax_once(ConstrainedRemesher& mesh) {
  const double wanted = mesh.move_towards(minimal_surface_step(mesh.points(), mesh.triangles(), mesh.locked()));
  mesh.flip_to_delaunay();
  mesh.smooth_tangentially();
  return wanted > still;
}

/// The same, on a mesh that its splits would scatter over the memory.
bool remesh_sorted(ConstrainedRemesher& mesh) {
  if (mesh.free_count() > beyond_the_cache) {
    mesh.split_long_edges();
    mesh.sort_in_space();
  }
  return remesh_once(mesh);
}

/// The same for all but small patches: the shape is found on coarse meshes, where a round costs little.
void coarse_to_fine(ConstrainedRemesher& mesh, InitialShape shape, const CancelToken& cancel) {
  for (double coarser : {8.0, 4.0, 2.0}) {
    mesh.scale_sizes(coarser);
    remesh_sorted(mesh);
    remesh_once(mesh);
    if (cancel.cancelled()) return;
    if (shape == InitialShape::minimal) relax_once(mesh);
    mesh.scale_sizes(1 / coarser);
    if (cancel.cancelled()) return;
  }
  if (remesh_sorted(mesh) && !cancel.cancelled()) remesh_once(mesh);
  if (shape == InitialShape::minimal && !cancel.cancelled()) relax_once(mesh);
}

/// Runs a phase on a copy; keeps its result unless it is worse than what was.
template <class Phase>
bool try_phase(const FillContext& context, const SizeField& size, Candidate& best, const Phase& phase) {
  ConstrainedRemesher mesh = guarded(context, size, best);
  phase(mesh);
  Candidate next = harvest(context, mesh);
  if (next.defect_count() > best.defect_count()) return false;
  if (context.cuts == FillContext::Cuts::may_not && next.quality.intersections > best.quality.intersections)
    return false;
  best = std::move(next);
  return true;
}

/// Where a round would make a patch worse that cuts nothing: those parts of it that do not. Splits leave the shape as it is,
/// only that there are more edges to count along its folds.
void remesh_bit_by_bit(const FillContext& context, const SizeField& size, Candidate& best, const CancelToken& cancel) {
  if (best.quality.intersections > 0 || cancel.cancelled()) return;
  ConstrainedRemesher mesh = guarded(context, size, best);
  mesh.split_long_edges();
  Candidate split = harvest(context, mesh);
  if (context.cuts == FillContext::Cuts::may_not && split.quality.intersections > 0) return;
  best = std::move(split);
  const auto keep_if_no_worse = [&](const auto& part) {
    if (!cancel.cancelled()) try_phase(context, size, best, part);
  };
  keep_if_no_worse([](ConstrainedRemesher& m) { m.flip_to_delaunay(); });
  keep_if_no_worse([](ConstrainedRemesher& m) { m.collapse_short_edges(); });
  keep_if_no_worse([](ConstrainedRemesher& m) { m.smooth_tangentially(); });
}

/// Refinement, remeshing and relaxation (docs/dev/filling.md, "Remeshing and relaxation"). A phase that makes the patch
/// worse is tried again in its first round only, then left out or, if it is the remeshing, taken apart.
Candidate refine(const FillContext& context, const SizeField& size, Candidate best, InitialShape shape, double vertices,
                 const CancelToken& cancel) {
  const bool large = vertices > from_coarse_to_fine, very_large = vertices > one_try_only;
  const auto rounds = [&](int count, bool (*round)(ConstrainedRemesher&)) {
    return [=, &cancel](ConstrainedRemesher& mesh) {
      for (int k = 0; k < count && !cancel.cancelled(); ++k)
        if (!round(mesh)) break;
    };
  };
  if (large && try_phase(context, size, best, [&](ConstrainedRemesher& mesh) { coarse_to_fine(mesh, shape, cancel); }))
    return best;
  if (very_large) {
    try_phase(context, size, best, rounds(1, remesh_once));
    return best;
  }
  if (!try_phase(context, size, best, rounds(remesh_rounds, remesh_once)) &&
      !try_phase(context, size, best, rounds(1, remesh_once)))
    remesh_bit_by_bit(context, size, best, cancel);
  const int most = shape == InitialShape::triangulated ? 0 : large ? 2 : relax_rounds;
  if (most > 0 && !try_phase(context, size, best, rounds(most, relax_once)))
    try_phase(context, size, best, rounds(1, relax_once));
  for (int attempt = 0; attempt < 3 && best.defect_count() > 0 && !cancel.cancelled(); ++attempt) {
    const int before = best.defect_count();
    try_phase(context, size, best, [](ConstrainedRemesher& mesh) {
      mesh.untangle();
      remesh_once(mesh);
    });
    if (best.defect_count() == before) break;
  }
  return best;
}

/// A loop of three edges whose triangle is there already, on the other side: an isolated triangle, not a hole.
bool closes_a_lone_triangle(const FillContext& context) {
  return context.n == 3 && std::any_of(context.neighborhood.begin(), context.neighborhood.end(), [](const Triangle& t) {
           return std::max({t[0], t[1], t[2]}) < 3;
         });
}

Message reason_not_to_fill(const BoundaryLoop& loop) {
  if (!(loop.diameter > 0)) return say("all vertices of the loop are in one place").with_code("no_extent");
  switch (loop.kind) {
    case LoopKind::hole:
    case LoopKind::outer_rim: return {};
    case LoopKind::crack:
      if (loop.coincident < loop.edges())
        return say("a crack: a face at the same place covers it already").with_code("covered");
      return joined(
                 say("a crack: its edges lie exactly on other boundary edges, so that nothing is missing between them"),
                 "; ", say("stitching joins them"))
          .with_code("crack");
    case LoopKind::cut:
      return say("no hole: it runs where the surface had to be cut, along an edge with more than two faces or because "
                 "the surface is one-sided")
          .with_code("cut");
  }
  return {};
}

/// Vertices of equilateral triangles with the boundary's mean edge length over the loop's area.
double expected_vertices(double area, const std::vector<double>& sizes) {
  double mean = 0;
  for (double size : sizes) mean += size / static_cast<double>(sizes.size());
  return area / (0.866 * mean * mean);
}

double expected_vertices(const FillContext& context, const BoundaryLoop& loop, double density) {
  std::vector<double> sizes = context.size;
  for (double& size : sizes) size /= density;
  return expected_vertices(loop.area / (context.frame.scale * context.frame.scale), sizes);
}

ConstrainedRemesher::Watch watch_for(double most_vertices, const CancelToken& cancel) {
  return [most_vertices, &cancel](std::size_t count) {
    if (cancel.cancelled()) throw Stopped::cancelled;
    if (static_cast<double>(count) > most_vertices) throw Stopped::too_many_vertices;
  };
}

/// "3 million", or the number as it is where it is smaller.
Message number_of(double vertices) {
  if (!(vertices < 1e15)) return say("far too many");
  return vertices < 1e6 ? verbatim(std::to_string(static_cast<long>(vertices)))
                        : say("%1 million", static_cast<long>(vertices / 1e6));
}

Message why_no_triangulation(const FillContext& context) {
  int without_length = 0;
  for (int i = 0; i < context.n; ++i) without_length += context.points[i] == context.points[(i + 1) % context.n];
  if (without_length > 0)
    return joined(say("%1 edges of this loop have no length", without_length), "; ", say("--weld joins their vertices"))
        .with_code("edges_without_length");
  return say("no valid triangulation of this loop was found").with_code("no_triangulation");
}

Message remaining_faults(const Validity& quality) {
  const Message faults = faults_of(quality);
  return faults.empty() ? faults : say("the initial patch has %1 left", faults);
}

LoopPatchOutcome finished(const SurfaceModel& model, const BoundaryLoop& loop, const FillContext& context,
                          Candidate best) {
  LoopPatch patch;
  for (int v : loop.vertices) patch.points.push_back(model.mesh.point(TriMesh::VertexHandle(v)));
  for (std::size_t i = context.n; i < best.points.size(); ++i)
    patch.points.push_back(context.frame.to_mesh(best.points[i]));
  patch.triangles = std::move(best.triangles);
  return {std::move(patch), remaining_faults(best.quality), best.quality};
}

}  // namespace

void check(const InitialPatchOptions& options) {
  if (!(options.density >= 0.1 && options.density <= 10))
    throw InvalidArgument(say("the density must lie between 0.1 and 10, not %1", options.density));
}

LoopPatchOutcome fill_loop(const SurfaceModel& model, const BoundaryLoop& loop, const InitialPatchOptions& options,
                           const CancelToken& cancel) {
  check(options);
  LoopPatchOutcome outcome;
  outcome.message = reason_not_to_fill(loop);
  if (!outcome.message.empty()) return outcome;
  FillContext context = make_context(model, loop);
  if (closes_a_lone_triangle(context)) {
    outcome.message = say("the loop is the boundary of a single triangle").with_code("lone_triangle");
    return outcome;
  }
  const double vertices = expected_vertices(context, loop, options.density);
  if (vertices > options.most_vertices) {
    outcome.message = joined(say("the patch would need about %1 vertices", number_of(vertices)), ": ",
                             say("a lower density needs fewer"))
                          .with_code("too_many_vertices");
    return outcome;
  }
  context.watch = watch_for(options.most_vertices + context.n, cancel);
  const std::vector<Candidate> candidates = first_triangulations(context, cancel);
  if (candidates.empty()) {
    if (!cancel.cancelled()) outcome.message = why_no_triangulation(context);
    return outcome;
  }
  const SizeField size(Points(context.points.begin(), context.points.begin() + context.n), context.size,
                       {options.density});
  Candidate best;
  try {
    for (const Candidate& candidate : candidates) {
      Candidate refined = refine(context, size, candidate, options.shape, vertices, cancel);
      if (best.triangles.empty() || refined.better_than(best)) best = std::move(refined);
      if (!best.wants_another(context.n) || vertices > one_try_only || cancel.cancelled()) break;
    }
  } catch (Stopped why) {
    if (why == Stopped::too_many_vertices)
      outcome.message = joined(say("the patch would need more than %1 vertices", number_of(options.most_vertices)),
                               ": ", say("a lower density needs fewer"))
                            .with_code("too_many_vertices");
    return outcome;
  }
  if (cancel.cancelled()) return outcome;
  return finished(model, loop, context, std::move(best));
}

LoopPatchOutcome fill_loop_uncut(const SurfaceModel& model, const TriangleIndex& index, const BoundaryLoop& loop,
                                 const InitialPatchOptions& options, const CancelToken& cancel) {
  check(options);
  FillContext context = make_wide_context(model, index, loop);
  Candidate best;
  best.triangles = triangulate_loop_uncut(context.points, context.neighborhood, context.vertex, context.taken, cancel);
  if (best.triangles.empty()) return {};
  best.points.assign(context.points.begin(), context.points.begin() + context.n);
  split_taken_chords(context, best);
  split_double_edges(context.n, best.points, best.triangles);
  best.quality = assess(context, best);
  if (best.quality.intersections > 0) return {};
  const double vertices = expected_vertices(context, loop, options.density);
  context.watch = watch_for(options.most_vertices + context.n, cancel);
  const SizeField size(Points(context.points.begin(), context.points.begin() + context.n), context.size,
                       {options.density});
  try {
    best = refine(context, size, best, InitialShape::triangulated, vertices, cancel);
    if (cancel.cancelled()) return {};
  } catch (Stopped) {
    return {};
  }
  return finished(model, loop, context, std::move(best));
}

}  // namespace loopmend
