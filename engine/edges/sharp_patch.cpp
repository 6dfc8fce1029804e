// SPDX-License-Identifier: GPL-3.0-or-later
#include "edges/sharp_patch.h"

#include "edges/face_labels.h"
#include "edges/seams.h"
#include "filling/fairing.h"
#include "filling/triangulate_loop.h"
#include "mesh/triangulate_polygon.h"
#include "remeshing/double_edges.h"
#include "remeshing/patch_remesh.h"
#include "remeshing/size_field.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>

namespace loopmend {

namespace {

/// A neighborhood in sides leaves so much of the distance from one polynomial at most.
constexpr double most_rms_ratio = 0.4;
constexpr double most_misfit = 0.012, most_misfit_anywhere = 0.06;  ///< of the loop from the surfaces, diameters
constexpr double most_noisy_misfit = 0.05;                          ///< where noise was filtered
constexpr double most_drawn_misfit = 0.05, most_drawn_misfit_anywhere = 0.2;  ///< where a person drew an edge
constexpr double most_rms_of_lone_side = 0.002;                               ///< diameters, where it is no plane
/// Diameters. Sides of sharp CAD and constructed models leave 1e-15, those that creases of eleven holes of organic
/// scans seem to part 0.008 and more.
constexpr double most_rms_of_clear_sides = 0.005;
constexpr double farthest_seam = 1.2;  ///< from where the labels change, diameters
/// Diameters of the loop: where an edge fades out farther off, its sides are one beyond that. The first that can be continued counts.
constexpr std::array reaches = {1.0, 0.5, 0.25};
constexpr double domain_triangles = 2500;
constexpr int most_joins = 8;  ///< of sides at stopped edges
constexpr int remesh_rounds = 5;

/// The interior of the patch, fine enough for the labels to follow the seams.
Domain domain_of(const Patch& initial) {
  ConstrainedRemesher mesh = open_for_remeshing(initial);
  const auto triangles = static_cast<double>(initial.patch_triangles);
  if (triangles < domain_triangles) mesh.scale_sizes(std::max(0.2, std::sqrt(triangles / domain_triangles)));
  for (int round = 0; round < 2; ++round) {
    mesh.split_long_edges();
    mesh.flip_to_delaunay();
  }
  return {mesh.points(), mesh.triangles(), mesh.locked()};
}

/// Edge lengths of the neighborhood at the loop, over the patch.
SizeField size_field(const Patch& initial) {
  const int n = initial.free_count, loop = static_cast<int>(initial.loops[0].size());
  std::vector<double> sum(loop, 0), count(loop, 0);
  for (std::size_t f = initial.patch_triangles; f < initial.triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = initial.triangles[f][k], b = initial.triangles[f][(k + 1) % 3];
      const double length = (initial.positions[a] - initial.positions[b]).norm();
      for (int v : {a, b})
        if (v - n < loop) {
          sum[v - n] += length;
          count[v - n] += 1;
        }
    }
  for (int i = 0; i < loop; ++i) sum[i] /= std::max(1.0, count[i]);
  return {Points(initial.positions.begin() + n, initial.positions.begin() + n + loop), sum, initial.grading};
}

/// All parts in one mesh: the loop's points first, then new ones; each with the sides that it lies on.
struct Assembly {
  int loop = 0;
  Points points;
  Triangles triangles;
  std::vector<std::set<int>> sides;
};

/// Turned so that the outline is seen along one of the axes.
Points seen_along_an_axis(Points outline) {
  constexpr double along_an_axis = 0.95;
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 0; i < outline.size(); ++i)
    area += (outline[i] - outline[0]).cross(outline[(i + 1) % outline.size()] - outline[0]);
  if (!(area.norm() > 0) || area.cwiseAbs().maxCoeff() > along_an_axis * area.norm()) return outline;
  const auto turn = Eigen::Quaterniond::FromTwoVectors(area, Vec3::UnitZ());
  for (Vec3& p : outline) p = turn * p;
  return outline;
}

/// The least folded triangles over an outline, as if the surface went on beyond it.
Triangles least_folded(const Points& outline, const SideSurface& surface) {
  const std::size_t n = outline.size();
  Vec3 area = Vec3::Zero();
  for (std::size_t i = 0; i < n; ++i) area += outline[i].cross(outline[(i + 1) % n]);
  Points points = outline;
  Triangles beyond;
  std::vector<int> loop;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 &p = outline[i], &q = outline[(i + 1) % n], middle = (p + q) / 2;
    Vec3 normal = surface.normal_at(surface.foot(middle));
    if (normal.dot(area) < 0) normal = -normal;
    points.push_back(middle + (q - p).cross(normal));
    loop.push_back(static_cast<int>(i));
    beyond.push_back({static_cast<int>((i + 1) % n), static_cast<int>(i), static_cast<int>(n + i)});
  }
  return triangulate_loop(points, beyond, loop, {}, TriangulationMethod::cubic);
}

/// Triangles of a part over places of its outline; none where it is not to be had.
Triangles triangulated(const Points& outline, const SideSurface& surface) {
  std::vector<int> all(outline.size());
  std::iota(all.begin(), all.end(), 0);
  Points flat;
  for (const Vec3& p : outline) flat.push_back(surface.in_plane(p));
  flat = seen_along_an_axis(std::move(flat));
  const Triangles triangles = triangulate_seen_flat(flat, all);
  return triangles.empty() ? least_folded(outline, surface) : triangles;
}

Points feet_of(const Points& points, int locked, const SideSurface& surface) {
  Points feet = points;
  for (std::size_t i = locked; i < feet.size(); ++i) feet[i] = surface.foot(feet[i]);
  return feet;
}

/// Meshes one part. @param joined  edges that are there already, between numbers of the assembly; takes up those of the part that have both ends on outlines.
bool add_part(const Part& part, const SideSurface& surface, const SizeField& size,
              std::set<std::pair<int, int>>& joined, Assembly& all) {
  Points points;
  for (int v : part.outline) points.push_back(all.points[v]);
  const int locked = static_cast<int>(points.size());
  Triangles triangles = triangulated(points, surface);
  if (triangles.empty()) return false;
  ConstrainedRemesher mesh(points, triangles, locked, {}, [&size](const Vec3& p) { return size.at(p); });
  for (int round = 0; round < remesh_rounds; ++round) {
    const bool goes_on = remesh_once(mesh);
    mesh.move_towards(feet_of(mesh.points(), locked, surface));
    if (!goes_on) break;
  }
  points = feet_of(mesh.points(), locked, surface);
  triangles = mesh.triangles();

  std::set<std::pair<int, int>> chords;
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3], apart = std::abs(a - b);
      if (a >= locked || b >= locked || apart == 1 || apart == locked - 1) continue;
      if (joined.contains(std::minmax(part.outline[a], part.outline[b]))) chords.insert(std::minmax(a, b));
    }
  split_beside(chords, points, triangles);

  std::vector<int> number = part.outline;
  for (int v : number) all.sides[v].insert(part.side);
  for (std::size_t i = locked; i < points.size(); ++i) {
    number.push_back(static_cast<int>(all.points.size()));
    all.points.push_back(points[i]);
    all.sides.push_back({part.side});
  }
  for (const Triangle& t : triangles) {
    all.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
    for (int k = 0; k < 3; ++k)
      if (t[k] < locked && t[(k + 1) % 3] < locked) joined.insert(std::minmax(number[t[k]], number[t[(k + 1) % 3]]));
  }
  return true;
}

/// Carries what the loop is off the surfaces into the patch: displacements d with Σ ‖d_i − d_j‖² over its edges least.
/// @returns the displacements of the loop.
Points carry_in(const Sides& sides, double reach, Assembly& all) {
  const auto n = static_cast<int>(all.points.size());
  Points moves(n, Vec3::Zero());
  for (int i = 0; i < all.loop; ++i) {
    std::vector<const SideSurface*> surfaces;
    for (int s : all.sides[i]) surfaces.push_back(&sides.surfaces[s]);
    moves[i] = all.points[i] - common_point(surfaces, all.points[i], reach);
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (const Triangle& t : all.triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      for (const auto& [i, j] : {std::pair(a, b), std::pair(b, a)}) {
        entries.emplace_back(i, i, 0.5);
        entries.emplace_back(i, j, -0.5);
      }
    }
  SparseMatrix Q(n, n);
  Q.setFromTriplets(entries.begin(), entries.end());
  minimise_quadratic_form(Q, moves, all.loop, n);
  for (int i = all.loop; i < n; ++i) all.points[i] += moves[i];
  moves.resize(all.loop);
  return moves;
}

/// Edges of the neighborhood between vertices of the loop.
std::set<std::pair<int, int>> chords_outside(const Patch& initial, int loop) {
  std::set<std::pair<int, int>> chords;
  const auto on_loop = [&](int v) { return v >= initial.free_count && v < initial.free_count + loop; };
  for (std::size_t f = initial.patch_triangles; f < initial.triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = initial.triangles[f][k], b = initial.triangles[f][(k + 1) % 3];
      if (on_loop(a) && on_loop(b)) chords.insert(std::minmax(a - initial.free_count, b - initial.free_count));
    }
  return chords;
}

/// Whether the loop's vertices are distinct, and come first of the fixed ones in its own order.
bool is_plain(const Patch& patch) {
  for (std::size_t i = 0; i < patch.loops[0].size(); ++i)
    if (patch.loops[0][i] != patch.free_count + static_cast<int>(i)) return false;
  return true;
}

/// Those of a neighborhood of this reach; nothing where it has no sharp edges, and none are drawn.
std::optional<Sides> sharp_sides(const Patch& patch, double reach, const SideEdits& edits) {
  std::optional<Sides> sides = find_sides(patch, 0, reach, edits);
  if (sides && edits.drawn.empty() && sides->rms >= most_rms_ratio * sides->rms_of_one) sides.reset();
  return sides;
}

/// Whether a side that is continued alone is so simple that its surface is surer than the flow.
bool is_plain_side(const SideSurface& surface, double diameter) {
  return surface.kind() == SideSurface::Kind::plane || surface.rms() < most_rms_of_lone_side * diameter;
}

/// Gives the triangles of a part to the side beside it with the longest common border. @returns false where there is none.
bool give_away(const Domain& domain, const Part& part, std::vector<int>& labels) {
  std::map<std::pair<int, int>, int> face_at;
  for (int f = 0; f < static_cast<int>(domain.triangles.size()); ++f)
    for (int k = 0; k < 3; ++k) face_at[{domain.triangles[f][k], domain.triangles[f][(k + 1) % 3]}] = f;
  std::map<int, double> border;
  for (int f : part.triangles)
    for (int k = 0; k < 3; ++k) {
      const int a = domain.triangles[f][k], b = domain.triangles[f][(k + 1) % 3];
      const auto beyond = face_at.find({b, a});
      if (beyond != face_at.end() && labels[beyond->second] != part.side)
        border[labels[beyond->second]] += (domain.points[a] - domain.points[b]).norm();
    }
  if (border.empty()) return false;
  const int side = std::max_element(border.begin(), border.end(), [](const auto& a, const auto& b) {
                     return a.second < b.second;
                   })->first;
  for (int f : part.triangles) labels[f] = side;
  return true;
}

struct Meshed {
  SeamLayout layout;
  Assembly all;
};

/// Parts that are no discs, or have no triangulation, are given away.
std::optional<Meshed> mesh_parts(const Patch& initial, const Domain& domain, const Sides& sides,
                                 std::vector<int> labels, double reach, const CancelToken& cancel) {
  constexpr int most_rounds = 12;
  const SizeField size = size_field(initial);
  for (int round = 0; round < most_rounds && !cancel.cancelled(); ++round) {
    Meshed result;
    result.layout = lay_out_seams(
        domain, labels, sides, [&](const Vec3& p) { return size.at(p); }, reach);
    result.all = {domain.loop, result.layout.points, {}, std::vector<std::set<int>>(result.layout.points.size())};
    std::set<std::pair<int, int>> joined = chords_outside(initial, domain.loop);
    std::vector<Part>& parts = result.layout.parts;
    const auto extent = [](const Part& part) {
      return part.outline.empty() ? part.triangles.size() : std::numeric_limits<std::size_t>::max();
    };
    auto bad = std::ranges::min_element(parts, {}, extent);  // the smallest part that is no disc
    if (bad != parts.end() && !bad->outline.empty())
      bad = std::ranges::find_if_not(
          parts, [&](const Part& part) { return add_part(part, sides.surfaces[part.side], size, joined, result.all); });
    if (bad == result.layout.parts.end()) return result;
    if (!give_away(domain, *bad, labels)) return std::nullopt;
  }
  return std::nullopt;
}

/// Loop edges on both sides of each seam that begins at a stopped place, but of those that are drawn.
std::vector<std::pair<int, int>> edges_to_join(const SeamLayout& layout, const Sides& sides, const LoopEdits& edits) {
  std::vector<std::pair<int, int>> edges;
  const auto is_drawn = [&](const std::vector<int>& seam) {
    return std::any_of(edits.drawn.begin(), edits.drawn.end(), [&](const std::pair<int, int>& ends) {
      return std::minmax(ends.first, ends.second) == std::minmax(seam.front(), seam.back());
    });
  };
  const auto first_edge = [&](int side) {
    return static_cast<int>(std::find(sides.of_edge.begin(), sides.of_edge.end(), side) - sides.of_edge.begin());
  };
  for (std::size_t k = 0; k < layout.seams.size(); ++k)
    if (!is_drawn(layout.seams[k]) && std::any_of(edits.stopped.begin(), edits.stopped.end(), [&](int place) {
          return layout.seams[k].front() == place || layout.seams[k].back() == place;
        }))
      edges.emplace_back(first_edge(layout.sides_of_seam[k].first), first_edge(layout.sides_of_seam[k].second));
  return edges;
}

/// How far the loop may be from the surfaces, diameters.
struct Tolerance {
  double rms = most_misfit, anywhere = most_misfit_anywhere;
};

/// Under noise the loop is as far from the surfaces as the other vertices of the sides are.
Tolerance with_noise(Tolerance tolerance, const Sides& sides, double diameter) {
  if (sides.are_noisy) {
    tolerance.rms = std::max(tolerance.rms, std::min(2 * sides.rms / diameter, most_noisy_misfit));
    tolerance.anywhere = std::max(tolerance.anywhere, 5 * sides.rms / diameter);
  }
  return tolerance;
}

/// The loop's distances from the surfaces, each vertex on those that it belongs to.
struct Misfit {
  double sum = 0, largest = 0;
  std::size_t count = 0;

  void add(double distance) {
    sum += distance * distance;
    largest = std::max(largest, distance);
    ++count;
  }
  double rms() const { return std::sqrt(sum / static_cast<double>(count)); }
  bool is_within(const Tolerance& tolerance, double diameter) const {
    return rms() <= tolerance.rms * diameter && largest <= tolerance.anywhere * diameter;
  }
};

/// A bound from below that costs nothing: each vertex on the surface nearest to it.
Misfit least_misfit(const Patch& initial, const Sides& sides) {
  Misfit least;
  for (int v : initial.loops[0]) {
    const Vec3& p = initial.positions[v];
    double nearest = std::numeric_limits<double>::infinity();
    for (const SideSurface& surface : sides.surfaces) nearest = std::min(nearest, (p - surface.foot(p)).norm());
    least.add(nearest);
  }
  return least;
}

/// @param sides  of the neighborhood. @param joined  takes up loop edges whose sides a stopped edge parts; the patch is then of no use.
/// @returns nothing where the sides do not fit the loop, or not each other.
std::optional<SharpPatch> continue_sides(const Patch& initial, const Sides& sides, const Tolerance& tolerance,
                                         const LoopEdits& edits, SeamPrice price,
                                         std::vector<std::pair<int, int>>& joined, const CancelToken& cancel) {
  const double diameter = loop_diameter(initial, 0), reach = farthest_seam * diameter;
  if (!least_misfit(initial, sides).is_within(tolerance, diameter)) return std::nullopt;
  const Domain domain = domain_of(initial);
  if (domain.loop != static_cast<int>(initial.loops[0].size())) return std::nullopt;
  const std::vector<int> labels = label_faces(domain, sides, price, cancel);
  if (labels.empty()) return std::nullopt;
  std::optional<Meshed> meshed = mesh_parts(initial, domain, sides, labels, reach, cancel);
  if (!meshed) return std::nullopt;
  Assembly& all = meshed->all;
  Misfit misfit;
  misfit.largest = meshed->layout.gap;
  for (const Vec3& move : carry_in(sides, reach, all)) misfit.add(move.norm());
  if (!misfit.is_within(tolerance, diameter)) return std::nullopt;
  SharpPatch result;
  std::set<int> used;
  for (const Part& part : meshed->layout.parts) used.insert(part.side);
  if (used.size() == 1 && !is_plain_side(sides.surfaces[*used.begin()], diameter)) return std::nullopt;
  result.sides = static_cast<int>(used.size());
  result.edges = meshed->layout.seams;
  result.sharpest_deg = meshed->layout.sharpest_deg;
  if (result.sides > 1 && result.edges.empty()) return std::nullopt;
  for (int i = 0; i < domain.loop; ++i) {
    const int outside = sides.of_edge[i];
    result.creased.push_back(outside >= 0 && outside != meshed->layout.side_inside[i]);
  }
  joined = edges_to_join(meshed->layout, sides, edits);
  for (const Vec3& p : all.points) result.patch.points.push_back(initial.to_mesh(p));
  result.patch.triangles = std::move(all.triangles);
  return result;
}

}  // namespace

bool ends_at_sharp_edges(const Patch& patch) {
  return patch.loops.size() == 1 &&
         std::any_of(reaches.begin(), reaches.end(), [&](double reach) { return sharp_sides(patch, reach, {}); });
}

ContinuedEdges continue_sharp_edges(const Patch& initial, const LoopEdits& edits, const CancelToken& cancel) {
  ContinuedEdges continued;
  if (initial.loops.size() != 1 || !is_plain(initial)) return continued;
  const double diameter = loop_diameter(initial, 0);
  Tolerance tolerance;
  if (!edits.drawn.empty()) tolerance = {most_drawn_misfit, most_drawn_misfit_anywhere};
  for (const SeamPrice price : {SeamPrice::apart, SeamPrice::off_seam})
    for (const double reach : reaches) {
      SideEdits side_edits{edits.drawn, {}};
      // Each round joins two sides, where a surface fits both.
      for (int round = 0; round < most_joins && !cancel.cancelled(); ++round) {
        const std::optional<Sides> sides = sharp_sides(initial, reach, side_edits);
        if (!sides) break;
        continued.are_clear =
            continued.are_clear || (sides->surfaces.size() > 1 && sides->rms < most_rms_of_clear_sides * diameter);
        std::vector<std::pair<int, int>> joined;
        continued.patch =
            continue_sides(initial, *sides, with_noise(tolerance, *sides, diameter), edits, price, joined, cancel);
        if (continued.patch && joined.empty()) return continued;
        continued.patch.reset();
        if (joined.empty()) break;
        side_edits.joined.insert(side_edits.joined.end(), joined.begin(), joined.end());
      }
    }
  return continued;
}

}  // namespace loopmend
