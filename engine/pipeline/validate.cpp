// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/validate.h"

#include "core/single_precision.h"
#include "mesh/chord_faces.h"
#include "mesh/quality.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <functional>
#include <numeric>
#include <unordered_map>

namespace loopmend {

namespace {

/// The patch with the coordinates that its file will have: a scan that floats hold is mostly written as floats, and rounding can make
/// thin triangles cross.
PatchGeometry written_geometry(const ScanIndex& scan, const Patch& patch) {
  PatchGeometry geometry = patch_geometry(patch);
  if (scan.holds_as_floats)
    for (Vec3& p : geometry.points) p = as_floats(p);
  return geometry;
}

/// As cuts_of(), each pair within the patch once.
std::vector<std::pair<int, int>> cuts(const ScanIndex& scan, const PatchGeometry& patch,
                                      const std::function<void(int, int)>& within) {
  const int boundary = static_cast<int>(patch.boundary.size());
  Points points;
  Eigen::AlignedBox3d box;
  const TriangleSoup& soup = scan.model.soup;
  for (int v : patch.boundary) points.push_back(soup.points[scan.model.soup_vertex[v]]);
  points.insert(points.end(), patch.points.begin(), patch.points.end());
  for (const Vec3& p : points) box.extend(p);
  Triangles triangles = patch.triangles;
  std::vector<int> soup_face;
  std::unordered_map<int, int> local;
  for (int i = 0; i < boundary; ++i) local.emplace(scan.model.soup_vertex[patch.boundary[i]], i);
  for (int f : scan.index.near_box(box.min(), box.max())) {
    Triangle t = soup.triangles[f];
    for (int& v : t) {
      const auto [entry, added] = local.emplace(v, static_cast<int>(points.size()));
      if (added) points.push_back(soup.points[v]);
      v = entry->second;
    }
    triangles.push_back(t);
    soup_face.push_back(f);
  }
  const int own = static_cast<int>(patch.triangles.size());
  std::vector<std::pair<int, int>> pairs = self_intersections(points, triangles, own);
  for (auto& [f, g] : pairs) {
    if (g < own) within(f, g);
    g = g < own ? -1 : soup_face[g - own];
  }
  return pairs;
}

/// For each triangle of the patch, how many others it cuts, of the patch or of the model.
std::vector<int> intersections_of(const ScanIndex& scan, const PatchGeometry& patch) {
  std::vector<int> count(patch.triangles.size(), 0);
  for (const auto& [f, g] : cuts(scan, patch, [&](int, int other) { ++count[other]; })) ++count[f];
  return count;
}

}  // namespace

ScanIndex::ScanIndex(const SurfaceModel& surface)
    : model(surface),
      index(surface.soup.points, surface.soup.triangles, triangles_outside(surface)),
      holds_as_floats(loopmend::holds_as_floats(surface.soup.points)) {}

std::vector<std::pair<int, int>> cuts_of(const ScanIndex& scan, const Patch& patch) {
  return cuts(scan, written_geometry(scan, patch), [](int, int) {});
}

int new_nonmanifold_edges(const ScanIndex& scan, const Patch& patch) {
  const TriangleSoup& soup = scan.model.soup;
  const PatchGeometry geometry = written_geometry(scan, patch);
  std::vector<int> at_boundary;
  ChordFaces chords;
  chords.add_chords(scan.model, geometry);
  for (const Vec3& end : chords.ends()) {
    const std::vector<int> near = scan.index.near_box(end, end);
    at_boundary.insert(at_boundary.end(), near.begin(), near.end());
  }
  std::sort(at_boundary.begin(), at_boundary.end());
  at_boundary.erase(std::unique(at_boundary.begin(), at_boundary.end()), at_boundary.end());
  for (int f : at_boundary) chords.add_face(soup.points, soup.triangles[f]);
  return chords.count_crowded(scan.model, geometry);
}

std::vector<int> loop_of_triangles(const Patch& patch) {
  std::vector<int> part(patch.patch_triangles);
  std::iota(part.begin(), part.end(), 0);
  const auto root = [&](int f) {
    while (part[f] != f) f = part[f] = part[part[f]];
    return f;
  };
  // By edges, not by vertices: patches of holes that touch have a vertex in common.
  std::vector<std::array<int, 3>> sides;  // both ends of an edge, and a triangle at it
  sides.reserve(3 * patch.patch_triangles);
  for (int f = 0; f < patch.patch_triangles; ++f)
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = std::minmax(patch.triangles[f][k], patch.triangles[f][(k + 1) % 3]);
      sides.push_back({a, b, f});
    }
  std::sort(sides.begin(), sides.end());
  const auto same_edge = [](const std::array<int, 3>& s, const std::array<int, 3>& t) {
    return s[0] == t[0] && s[1] == t[1];
  };
  for (std::size_t k = 1; k < sides.size(); ++k)
    if (same_edge(sides[k - 1], sides[k])) part[root(sides[k][2])] = root(sides[k - 1][2]);
  std::unordered_map<int, int> loop_at;
  for (std::size_t l = 0; l < patch.loops.size(); ++l) {
    const std::vector<int>& loop = patch.loops[l];
    const auto [a, b] = std::minmax(loop[0], loop[1 % loop.size()]);
    const auto side = std::lower_bound(sides.begin(), sides.end(), std::array<int, 3>{a, b, 0});
    // Of a hole and the islands joined to it, the hole comes first.
    if (side != sides.end() && (*side)[0] == a && (*side)[1] == b)
      loop_at.emplace(root((*side)[2]), static_cast<int>(l));
  }
  std::vector<int> loop(patch.patch_triangles, 0);
  for (int f = 0; f < patch.patch_triangles; ++f)
    if (const auto found = loop_at.find(root(f)); found != loop_at.end()) loop[f] = found->second;
  return loop;
}

std::vector<int> loop_of_free_vertices(const Patch& patch) {
  const std::vector<int> of_triangle = loop_of_triangles(patch);
  std::vector<int> loop(patch.free_count, 0);
  for (int f = 0; f < patch.patch_triangles; ++f)
    for (int v : patch.triangles[f])
      if (v < patch.free_count) loop[v] = of_triangle[f];
  return loop;
}

Validity validate(const ScanIndex& scan, const Patch& patch) {
  Validity validity;
  const auto folds = folded_pairs(patch.positions, patch.triangles, patch.patch_triangles);
  validity.folds = static_cast<int>(folds.size());
  validity.min_angle_deg = min_angle_deg(patch.positions, patch.triangles, patch.patch_triangles);
  validity.nonmanifold_edges = new_nonmanifold_edges(scan, patch);
  validity.intersections_of_loop.assign(patch.loops.size(), 0);
  const std::vector<int> loop = loop_of_triangles(patch), count = intersections_of(scan, written_geometry(scan, patch));
  std::vector<char> spoiled(patch.triangles.size(), 0);
  for (const auto& [f, g] : folds) spoiled[f] = spoiled[g] = 1;
  for (int f = 0; f < patch.patch_triangles; ++f) {
    validity.intersections_of_loop[loop[f]] += count[f];
    validity.intersections += count[f];
    if (spoiled[f] || count[f] > 0) validity.spoiled.push_back(f);
  }
  return validity;
}

int pierced_edges(const ScanIndex& scan, const BoundaryLoop& loop) {
  int count = 0;
  const TriangleSoup& soup = scan.model.soup;
  const auto place = [&](std::size_t k) -> const Vec3& {
    return soup.points[scan.model.soup_vertex[loop.vertices[k % loop.vertices.size()]]];
  };
  for (std::size_t k = 0; k < loop.vertices.size(); ++k)
    count += runs_through(soup.points, soup.triangles, scan.index, place(k), place(k + 1));
  return count;
}

}  // namespace loopmend
