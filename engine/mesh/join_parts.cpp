// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/join_parts.h"

#include "core/error.h"
#include "mesh/pieces.h"
#include "mesh/self_intersections.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <set>

namespace loopmend {

namespace {

Eigen::AlignedBox3d box_of(const TriangleSoup& soup) {
  Eigen::AlignedBox3d box;
  for (const Triangle& t : soup.triangles)
    for (int v : t) box.extend(soup.points[v]);
  return box;
}

/// Triangles of the soup whose boxes meet `box`, with their own points, appended.
void take_near(const TriangleSoup& soup, const Eigen::AlignedBox3d& box, Points& points, Triangles& triangles) {
  for (const Triangle& t : soup.triangles) {
    Eigen::AlignedBox3d own;
    for (int v : t) own.extend(soup.points[v]);
    if (!own.intersects(box)) continue;
    const int first = static_cast<int>(points.size());
    for (int v : t) points.push_back(soup.points[v]);
    triangles.push_back({first, first + 1, first + 2});
  }
}

std::size_t count_cuts(const TriangleSoup& a, const TriangleSoup& b) {
  const Eigen::AlignedBox3d common = box_of(a).intersection(box_of(b));
  if (common.isEmpty()) return 0;
  Points points;
  Triangles triangles;
  take_near(a, common, points, triangles);
  const int own = static_cast<int>(triangles.size());
  take_near(b, common, points, triangles);
  const auto pairs = self_intersections(points, triangles, own);
  return static_cast<std::size_t>(
      std::count_if(pairs.begin(), pairs.end(), [own](const auto& pair) { return pair.second >= own; }));
}

}  // namespace

JoinedParts join_parts(const std::vector<TriangleSoup>& parts) {
  JoinedParts joined;
  TriangleSoup all;
  for (std::size_t k = 0; k < parts.size(); ++k) {
    for (std::size_t l = 0; l < k; ++l)
      if (const std::size_t cuts = count_cuts(parts[l], parts[k]))
        throw InvalidArgument(
            say("parts %1 and %2 overlap: %3 pairs of their triangles cut each other. Move them apart.", l + 1, k + 1,
                cuts));
    joined.first_point.push_back(all.points.size());
    append(all, parts[k]);
  }
  joined.first_point.push_back(all.points.size());
  joined.model = make_surface_model(std::move(all));
  joined.loops.resize(parts.size());
  for (BoundaryLoop& loop : find_boundary_loops(joined.model)) {
    const auto point = static_cast<std::size_t>(joined.model.soup_vertex[loop.vertices.front()]);
    const auto part = std::upper_bound(joined.first_point.begin(), joined.first_point.end(), point) - 1;
    joined.loops[part - joined.first_point.begin()].push_back(std::move(loop));
  }
  return joined;
}

std::size_t turn_opposed_pieces(SurfaceModel& model, std::vector<BoundaryLoop>& loops,
                                const std::vector<int>& opposed) {
  if (opposed.empty()) return 0;
  const std::vector<int> piece = pieces_of(model.mesh);
  std::set<int> to_turn, to_keep;
  for (int k = 0; k < static_cast<int>(loops.size()); ++k) {
    const bool turn = std::binary_search(opposed.begin(), opposed.end(), k);
    (turn ? to_turn : to_keep).insert(piece_beside(model.mesh, piece, loops[k]));
  }
  for (int p : to_turn)
    if (to_keep.count(p))
      throw InvalidArgument(
          say("two of the loops bound one piece of surface, but its inside faces the gap at one of them and its "
              "outside at the other: no two-sided surface joins them"));
  TriangleSoup soup = model.soup;
  std::size_t turned = 0;
  for (std::size_t f = 0; f < piece.size(); ++f)
    if (to_turn.count(piece[f])) {
      Triangle& t = soup.triangles[model.soup_face[f]];
      std::swap(t[1], t[2]);
      ++turned;
    }
  SurfaceModel next = make_surface_model(std::move(soup));
  const std::vector<BoundaryLoop> found = find_boundary_loops(next);
  for (BoundaryLoop& loop : loops) {
    std::set<int> points;
    for (int v : loop.vertices) points.insert(model.soup_vertex[v]);
    const auto same = std::find_if(found.begin(), found.end(), [&](const BoundaryLoop& other) {
      std::set<int> others;
      for (int v : other.vertices) others.insert(next.soup_vertex[v]);
      return others == points;
    });
    if (same == found.end()) throw InvalidArgument(say("a loop was lost when its surface was turned round"));
    loop = *same;
  }
  next.repairs = model.repairs;
  next.repairs.reoriented_faces += turned;
  model = std::move(next);
  return turned;
}

}  // namespace loopmend
