// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/repair_surface.h"

#include "mesh/boundary_loops.h"
#include "mesh/directed_edges.h"
#include "mesh/pieces.h"
#include "mesh/self_intersections.h"
#include "mesh/surface_model.h"
#include "repair/inverted_shells.h"
#include "repair/tiny_handles.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

/// A component of at most so many faces and of at most this share of the largest one's extent is a fragment of the scan.
constexpr int most_faces_of_a_fragment = 10;
constexpr double extent_of_a_fragment = 0.05;
constexpr double area_of_a_fin = 0.05;  ///< the same for the area of one that hangs at an edge of others
/// Openings of a body that is closed but for small holes, as a part of its area.
constexpr double most_open_of_a_body = 0.05;
constexpr int most_joins_of_separated = 10;  ///< 2 were the most in 24 scans

/// For each component whether it is open and hangs at an edge where others have two faces or more.
std::vector<char> hanging(const SurfaceModel& model, const std::vector<int>& component) {
  const std::vector<int> place = merged_by_place(model.soup.points);
  const auto place_of = [&](TriMesh::VertexHandle v) { return place[model.soup_vertex[v.idx()]]; };
  std::vector<char> is_open(component.size(), 0), hangs(component.size(), 0);
  std::vector<std::array<int, 3>> edges;  // both ends, and the component of a face at it
  for (const auto face : model.mesh.faces())
    for (const auto h : model.mesh.fh_range(face)) {
      const int from = place_of(model.mesh.from_vertex_handle(h)), to = place_of(model.mesh.to_vertex_handle(h));
      const auto [a, b] = std::minmax(from, to);
      edges.push_back({a, b, component[face.idx()]});
      if (model.mesh.is_boundary(model.mesh.opposite_halfedge_handle(h))) is_open[component[face.idx()]] = 1;
    }
  std::ranges::sort(edges);
  for (auto first = edges.begin(); first != edges.end();) {
    const auto last =
        std::find_if(first, edges.end(), [&](const auto& e) { return e[0] != (*first)[0] || e[1] != (*first)[1]; });
    for (auto e = first; e != last; ++e) {
      const auto own = std::count_if(first, last, [&](const auto& other) { return other[2] == (*e)[2]; });
      if (last - first - own >= 2) hangs[(*e)[2]] = is_open[(*e)[2]];
    }
    first = last;
  }
  return hangs;
}

/// For each view face whether its component is a fragment. @param count  is set to the number of fragments.
std::vector<char> in_fragments(const SurfaceModel& model, std::size_t& count) {
  const TriMesh& mesh = model.mesh;
  const std::vector<int> component = pieces_of(mesh);
  const std::vector<char> hangs = hanging(model, component);
  std::vector<int> faces(component.size(), 0);
  std::vector<double> area(component.size(), 0);
  std::vector<Eigen::AlignedBox3d> box(component.size());
  for (const auto face : mesh.faces()) {
    const int c = component[face.idx()];
    ++faces[c];
    area[c] += mesh.calc_face_area(face);
    for (const auto v : mesh.fv_range(face)) box[c].extend(mesh.point(v));
  }
  const auto extent = [&](std::size_t c) { return faces[c] > 0 ? box[c].diagonal().norm() : 0.0; };
  double largest = 0;
  for (std::size_t c = 0; c < faces.size(); ++c) largest = std::max(largest, extent(c));
  const double largest_area = area.empty() ? 0 : std::ranges::max(area);
  std::vector<char> is_fragment(faces.size(), 0), result(component.size());
  for (std::size_t c = 0; c < faces.size(); ++c) {
    if (faces[c] == 0 || faces[c] > most_faces_of_a_fragment) continue;
    is_fragment[c] =
        extent(c) <= extent_of_a_fragment * largest || (hangs[c] && area[c] <= area_of_a_fin * largest_area);
    count += is_fragment[c];
  }
  for (std::size_t f = 0; f < component.size(); ++f) result[f] = is_fragment[component[f]];
  return result;
}

/// The soup without the triangles for which `gone` is 1, and all points.
TriangleSoup without(const TriangleSoup& soup, const std::vector<char>& gone) {
  TriangleSoup result;
  result.points = soup.points;
  result.colors = soup.colors;
  std::vector<int> points(soup.points.size()), faces;
  std::iota(points.begin(), points.end(), 0);
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    if (gone[f]) continue;
    result.triangles.push_back(soup.triangles[f]);
    faces.push_back(static_cast<int>(f));
  }
  copy_rows(soup, points, faces, result);
  return result;
}

std::size_t remove(TriangleSoup& soup, const std::vector<char>& gone) {
  const auto count = static_cast<std::size_t>(std::count(gone.begin(), gone.end(), 1));
  if (count > 0) soup = without(soup, gone);
  return count;
}

/// For each corner of the soup a point of its place: the least of those that its fan has once all copies are one, or its own where
/// the place is `left`. Faces that the view does not hold, such as duplicates, go with some fan.
Triangles joined_by_fan(const TriangleSoup& soup, const std::vector<int>& place, const std::vector<char>& left) {
  TriangleSoup joined;
  joined.points = soup.points;
  joined.triangles = soup.triangles;
  for (Triangle& t : joined.triangles)
    for (int& v : t) v = place[v];
  const SurfaceModel model = make_surface_model(std::move(joined));
  const int none = static_cast<int>(soup.points.size());
  std::vector<int> of_fan(model.soup_vertex.size(), none), of_place(soup.points.size(), none);
  std::vector<char> in_view(soup.triangles.size(), 0);
  Triangles result = soup.triangles;
  const auto for_each_corner = [&](const auto& visit) {
    for (const auto face : model.mesh.faces())
      for (int& v : result[model.soup_face[face.idx()]])
        for (const auto w : model.mesh.fv_range(face))
          if (model.soup_vertex[w.idx()] == place[v]) visit(v, w.idx());
  };
  for_each_corner([&](int v, int fan) { of_fan[fan] = std::min(of_fan[fan], v); });
  for (std::size_t fan = 0; fan < of_fan.size(); ++fan) {
    int& least = of_place[model.soup_vertex[fan]];
    least = std::min(least, of_fan[fan]);
  }
  for_each_corner([&](int& v, int fan) {
    if (!left[place[v]]) v = of_fan[fan];
  });
  for (int f : model.soup_face) in_view[f] = 1;
  for (std::size_t f = 0; f < in_view.size(); ++f)
    if (!in_view[f])
      for (int& v : result[f])
        if (!left[place[v]]) v = of_place[place[v]] == none ? place[v] : of_place[place[v]];
  return result;
}

/// Copies of a point become one where the surface round it is then one fan, and stays one fan. Others stay: they would have to be
/// separated again.
/// @returns how many points lost their faces to an earlier one in the same place.
std::size_t join_coincident(TriangleSoup& soup) {
  const std::vector<int> place = merged_by_place(soup.points);
  if (std::adjacent_find(place.begin(), place.end(), std::greater_equal<>()) == place.end()) return 0;  // no copies
  std::vector<char> left(soup.points.size(), 0);
  // What is joined at one place decides how the surface parts at another, so that a few have to be left after all.
  for (bool stays = false; !stays;) {
    TriangleSoup next;
    next.points = soup.points;
    next.triangles = joined_by_fan(soup, place, left);
    std::vector<char> given_up(soup.points.size(), 0), taken(soup.points.size(), 0);
    for (std::size_t f = 0; f < next.triangles.size(); ++f)
      for (int k = 0; k < 3; ++k) {
        const int from = soup.triangles[f][k], to = next.triangles[f][k];
        if (from != to) given_up[from] = taken[to] = 1;
      }
    const Triangles triangles = next.triangles;
    const SurfaceModel model = make_surface_model(std::move(next));
    stays = true;
    std::vector<char> seen(soup.points.size(), 0);
    for (int point : model.soup_vertex)
      if (std::exchange(seen[point], 1) && taken[point]) {
        left[place[point]] = 1;
        stays = false;
      }
    if (!stays) continue;
    soup.triangles = triangles;
    return static_cast<std::size_t>(std::count(given_up.begin(), given_up.end(), 1));
  }
  return 0;
}

std::vector<char> degenerate(const Triangles& triangles) {
  std::vector<char> result(triangles.size());
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    const Triangle& t = triangles[f];
    result[f] = t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
  }
  return result;
}

/// Triangles over the same three vertices: one stays. But where as many face one side as the other, and the triangles at
/// each of their edges do as well, the surface is folded flat onto itself there: none stays, and nothing opens.
std::vector<char> duplicates(const Triangles& triangles) {
  struct Entry {
    Triangle sorted;
    int face;
    int side;  ///< 1 or -1
  };
  std::vector<Entry> entries;
  for (std::size_t f = 0; f < triangles.size(); ++f) {
    Triangle t = triangles[f];
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    const int side = t[1] < t[2] ? 1 : -1;
    entries.push_back({side > 0 ? t : Triangle{t[0], t[2], t[1]}, static_cast<int>(f), side});
  }
  std::sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
    return a.sorted != b.sorted ? a.sorted < b.sorted : a.face < b.face;
  });
  const DirectedEdges directed(triangles, static_cast<int>(triangles.size()));
  const auto balanced = [&directed](int a, int b) {
    const auto count = [&](const DirectedEdges::Edge& edge) {
      const auto [first, last] = std::equal_range(directed.all().begin(), directed.all().end(), edge);
      return last - first;
    };
    return count({a, b}) == count({b, a});
  };
  std::vector<char> gone(triangles.size(), 0);
  for (auto first = entries.begin(); first != entries.end();) {
    const auto last = std::find_if(first, entries.end(), [&](const Entry& e) { return e.sorted != first->sorted; });
    int side = 0;
    for (auto e = first; e != last; ++e) side += e->side;
    const Triangle& t = first->sorted;
    const bool cancel_out = side == 0 && balanced(t[0], t[1]) && balanced(t[1], t[2]) && balanced(t[2], t[0]);
    const auto kept = std::find_if(first, last, [&](const Entry& e) { return side * e.side >= 0; });
    for (auto e = first; e != last; ++e) gone[e->face] = cancel_out || e != kept;
    first = last;
  }
  return gone;
}

/// For each face the number of its piece of surface where that is closed but for small holes; −1: open, or the face is no part of
/// the surface.
std::vector<int> body_of_faces(const TriangleSoup& soup) {
  const SurfaceModel model = make_surface_model(soup);
  const std::vector<int> piece = pieces_of(model.mesh);
  std::vector<double> area(piece.size(), 0), open(piece.size(), 0);
  for (const auto face : model.mesh.faces()) area[piece[face.idx()]] += model.mesh.calc_face_area(face);
  for (const BoundaryLoop& loop : find_boundary_loops(model)) open[piece_beside(model.mesh, piece, loop)] += loop.area;
  std::vector<int> result(soup.triangles.size(), -1);
  for (std::size_t f = 0; f < piece.size(); ++f)
    if (open[piece[f]] <= most_open_of_a_body * area[piece[f]]) result[model.soup_face[f]] = piece[f];
  return result;
}

/// Closed bodies stay closed, except where they cross themselves. Small holes will be filled.
std::vector<char> intersecting(const TriangleSoup& soup, RepairCounts& counts, const CancelToken& cancel) {
  std::vector<char> result(soup.triangles.size(), 0);
  const std::vector<int> body = body_of_faces(soup);
  std::set<int> overlapping;
  const auto count = static_cast<int>(soup.triangles.size());
  for (const auto& [f, g] : self_intersections(soup.points, soup.triangles, count, cancel)) {
    const bool are_one = body[f] == body[g];
    if (body[f] < 0 || are_one) result[f] = 1;
    if (body[g] < 0 || are_one) result[g] = 1;
    if (body[f] >= 0 && body[g] >= 0 && !are_one) overlapping.insert({body[f], body[g]});
  }
  counts.overlapping_bodies = overlapping.size();
  return result;
}

/// What crosses itself and is cut there may be closed no more, so that what it crosses is cut next.
/// @param next_round  called before the second round, and before each that follows
void cut_intersections(TriangleSoup& soup, RepairCounts& counts, const CancelToken& cancel,
                       const std::function<void()>& next_round) {
  for (bool changes = true, is_first = true; changes;) {
    if (!std::exchange(is_first, false)) next_round();
    const std::size_t removed = remove(soup, intersecting(soup, counts, cancel));
    counts.intersecting_faces += removed;
    changes = removed > 0 && counts.overlapping_bodies > 0;
  }
}

/// The oriented view of the soup becomes the soup.
void separate(TriangleSoup& soup, RepairCounts& counts) {
  const SurfaceModel model = make_surface_model(soup);
  counts.degenerate_faces += model.repairs.degenerate_faces;
  counts.duplicate_faces += model.repairs.duplicate_faces;
  counts.separated_edges = model.repairs.non_manifold_edges;
  counts.turned_faces = model.repairs.reoriented_faces;
  TriangleSoup result;
  result.points = soup.points;
  result.colors = soup.colors;
  // The first view vertex of a point keeps its number; the others are new points.
  std::vector<char> used(soup.points.size(), 0);
  std::vector<int> number(model.soup_vertex.size());
  std::vector<int> points(soup.points.size()), faces;
  std::iota(points.begin(), points.end(), 0);
  for (std::size_t v = 0; v < model.soup_vertex.size(); ++v) {
    const int point = model.soup_vertex[v];
    number[v] = point;
    if (used[point]) {
      number[v] = static_cast<int>(result.points.size());
      result.points.push_back(Vec3(soup.points[point]));
      points.push_back(point);
      if (!soup.colors.empty()) result.colors.push_back(soup.colors[point]);
      counts.separated_vertices += used[point] == 1;
      used[point] = 2;
    } else {
      used[point] = 1;
    }
  }
  for (const auto face : model.mesh.faces()) {
    // As it begins in the file.
    const Triangle& given = model.soup.triangles[model.soup_face[face.idx()]];
    std::array<int, 3> corner;
    int k = 0;
    for (const auto v : model.mesh.fv_range(face)) corner[k++] = v.idx();
    while (model.soup_vertex[corner[0]] != given[0]) std::rotate(corner.begin(), corner.begin() + 1, corner.end());
    result.triangles.push_back({number[corner[0]], number[corner[1]], number[corner[2]]});
    faces.push_back(model.soup_face[face.idx()]);
  }
  copy_rows(soup, points, faces, result);
  soup = std::move(result);
}

/// Of a closed piece of surface: whether all of it lies in the plane of its largest face, but for rounding to single precision.
bool is_flat(const TriMesh& mesh, const std::vector<int>& faces) {
  constexpr double rounding = 0x1p-21;  // 4 units in the last place
  Vec3 normal = Vec3::Zero(), origin = Vec3::Zero();
  double largest = 0;
  for (const int f : faces) {
    Vec3 corner[3];
    int k = 0;
    for (const auto v : mesh.fv_range(TriMesh::FaceHandle(f))) corner[k++] = mesh.point(v);
    const Vec3 n = (corner[1] - corner[0]).cross(corner[2] - corner[0]);
    if (!(n.squaredNorm() > normal.squaredNorm())) continue;
    normal = n;
    origin = corner[0];
  }
  normal.normalize();
  double off = 0;
  for (const int f : faces)
    for (const auto v : mesh.fv_range(TriMesh::FaceHandle(f))) {
      const Vec3 p = mesh.point(v);
      off = std::max(off, std::abs(normal.dot(p - origin)));
      largest = std::max(largest, p.cwiseAbs().maxCoeff());
    }
  return off <= rounding * largest;
}

/// Bodies that touch along a face, with its corners in common, leave this face of both when they are separated there: a closed piece
/// without volume.
void remove_flat_bodies(TriangleSoup& soup, RepairCounts& counts) {
  constexpr std::size_t most_faces = 10000;
  const SurfaceModel model = make_surface_model(soup);
  const std::vector<int> piece = pieces_of(model.mesh);
  std::vector<std::vector<int>> faces(piece.size());
  std::vector<char> is_open(piece.size(), 0), gone(soup.triangles.size(), 0);
  for (const auto face : model.mesh.faces()) {
    const auto own = static_cast<std::size_t>(piece[static_cast<std::size_t>(face.idx())]);
    if (faces[own].size() <= most_faces) faces[own].push_back(face.idx());
    for (const auto h : model.mesh.fh_range(face))
      if (model.mesh.is_boundary(model.mesh.opposite_halfedge_handle(h))) is_open[own] = 1;
  }
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (faces[k].empty() || is_open[k] || faces[k].size() > most_faces || !is_flat(model.mesh, faces[k])) continue;
    for (const int f : faces[k]) gone[static_cast<std::size_t>(model.soup_face[static_cast<std::size_t>(f)])] = 1;
  }
  counts.duplicate_faces += remove(soup, gone);
}

/// Bodies whose faces look inward are turned. The soup is an oriented manifold.
void turn_outward(TriangleSoup& soup, RepairCounts& counts) {
  const SurfaceModel model = make_surface_model(soup);
  const InvertedShells shells = find_inverted_shells(model, find_boundary_loops(model));
  counts.turned_shells = shells.closed;
  counts.turned_faces += shells.face_count;
  for (std::size_t f = 0; f < shells.faces.size(); ++f)
    if (shells.faces[f]) std::swap(soup.triangles[f][1], soup.triangles[f][2]);
}

void unite(TriangleSoup& soup, RepairCounts& counts, const CancelToken& cancel) {
  UnitedSurface united = unite_bodies(soup, cancel);
  counts.united = united.counts;
  soup = std::move(united.soup);
}

void cut_handles(TriangleSoup& soup, RepairCounts& counts, const CancelToken& cancel) {
  const SurfaceModel model = make_surface_model(soup);
  const TinyHandles handles = find_tiny_handles(model.mesh, cancel);
  std::vector<char> gone(soup.triangles.size(), 0);
  for (int face : handles.faces) gone[model.soup_face[face]] = 1;
  counts.cut_handles = static_cast<std::size_t>(handles.count);
  counts.handle_faces = remove(soup, gone);
}

void remove_fragments(TriangleSoup& soup, RepairCounts& counts) {
  const SurfaceModel model = make_surface_model(soup);
  const std::vector<char> fragment = in_fragments(model, counts.removed_pieces);
  std::vector<char> gone(soup.triangles.size(), 0);
  for (std::size_t f = 0; f < fragment.size(); ++f) gone[model.soup_face[f]] = fragment[f];
  counts.removed_faces = remove(soup, gone);
}

RepairStage stage_of(Defect defect) {
  switch (defect) {
    case Defect::coincident_points: return RepairStage::join_vertices;
    case Defect::degenerate_faces: return RepairStage::remove_degenerate;
    case Defect::duplicate_faces: return RepairStage::remove_duplicates;
    case Defect::intersections: return RepairStage::cut_intersections;
    case Defect::non_manifold: return RepairStage::separate;
    case Defect::overlaps: return RepairStage::unite;
    case Defect::handles: return RepairStage::cut_handles;
    case Defect::fragments: return RepairStage::remove_fragments;
  }
  return RepairStage::survey;
}

}  // namespace

RepairedSurface repair_surface(const TriangleSoup& soup, const std::set<Defect>& defects, const CancelToken& cancel,
                               const OnRepairStep& on_step) {
  RepairedSurface result{soup, {}};
  RepairCounts& counts = result.counts;
  std::size_t number = 0;
  const auto begin = [&](RepairStage stage) {
    if (on_step) on_step({stage, number, defects.size(), counts});
  };
  for (const Defect defect : defects) {
    if (cancel.cancelled()) break;
    ++number;
    begin(stage_of(defect));
    switch (defect) {
      case Defect::coincident_points: counts.joined_points = join_coincident(result.soup); break;
      case Defect::degenerate_faces:
        counts.degenerate_faces = remove(result.soup, degenerate(result.soup.triangles));
        break;
      case Defect::duplicate_faces:
        counts.duplicate_faces = remove(result.soup, duplicates(result.soup.triangles));
        break;
      case Defect::intersections:
        cut_intersections(result.soup, counts, cancel, [&] { begin(RepairStage::cut_intersections); });
        if (defects.contains(Defect::overlaps)) counts.overlapping_bodies = 0;  // they are united next
        break;
      case Defect::non_manifold:
        separate(result.soup, counts);
        if (counts.separated_edges > 0) remove_flat_bodies(result.soup, counts);
        begin(RepairStage::turn_outward);
        turn_outward(result.soup, counts);
        // Copies that this made may be one fan with what lies beside them now. They are not counted: they were one before.
        for (int k = 0; defects.contains(Defect::coincident_points) && k < most_joins_of_separated; ++k) {
          RepairCounts again;
          if (join_coincident(result.soup) == 0) break;
          separate(result.soup, again);
        }
        break;
      case Defect::overlaps:
        if (!defects.contains(Defect::non_manifold)) {
          separate(result.soup, counts);
          if (counts.separated_edges > 0) remove_flat_bodies(result.soup, counts);
          turn_outward(result.soup, counts);
        }
        unite(result.soup, counts, cancel);
        break;
      case Defect::handles: cut_handles(result.soup, counts, cancel); break;
      case Defect::fragments:
        remove_fragments(result.soup, counts);
        if (defects.contains(Defect::coincident_points)) counts.joined_points += join_coincident(result.soup);
        break;
    }
  }
  return result;
}

bool has_open_fragments(const SurfaceModel& model) {
  std::size_t count = 0;
  const std::vector<char> fragment = in_fragments(model, count);
  return count > 0 && std::ranges::any_of(model.mesh.faces(), [&](const auto face) {
           return fragment[face.idx()] && model.mesh.is_boundary(face);
         });
}

RepairCounts count_defects(const TriangleSoup& soup, const CancelToken& cancel) {
  const auto alone = [&](Defect defect) {
    return cancel.cancelled() ? RepairCounts{} : repair_surface(soup, {defect}, cancel).counts;
  };
  RepairCounts counts = alone(Defect::non_manifold);
  const RepairCounts fragments = alone(Defect::fragments);
  counts.removed_pieces = fragments.removed_pieces;
  counts.removed_faces = fragments.removed_faces;
  const RepairCounts handles = alone(Defect::handles);
  counts.cut_handles = handles.cut_handles;
  counts.handle_faces = handles.handle_faces;
  counts.joined_points = alone(Defect::coincident_points).joined_points;
  counts.degenerate_faces = alone(Defect::degenerate_faces).degenerate_faces;
  counts.duplicate_faces = alone(Defect::duplicate_faces).duplicate_faces;
  counts.intersecting_faces = alone(Defect::intersections).intersecting_faces;
  counts.united = alone(Defect::overlaps).united;
  return counts;
}

}  // namespace loopmend
