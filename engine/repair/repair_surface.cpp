// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/repair_surface.h"

#include "mesh/pieces.h"
#include "mesh/surface_model.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <vector>

namespace loopmend {

namespace {

/// A piece of at most so many faces and of at most this share of the largest one's extent is a crumb of the scan.
constexpr int most_faces_of_a_crumb = 10;
constexpr double extent_of_a_crumb = 0.05;

/// For each view face whether its piece of surface is a crumb. @param pieces  is set to the number of crumbs.
std::vector<char> in_crumbs(const TriMesh& mesh, std::size_t& pieces) {
  const std::vector<int> piece = pieces_of(mesh);
  std::vector<int> faces(piece.size(), 0);
  std::vector<Eigen::AlignedBox3d> box(piece.size());
  for (const auto face : mesh.faces()) {
    ++faces[piece[face.idx()]];
    for (const auto v : mesh.fv_range(face)) box[piece[face.idx()]].extend(mesh.point(v));
  }
  const auto extent = [&](int p) { return faces[p] > 0 ? box[p].diagonal().norm() : 0.0; };
  double largest = 0;
  for (int p = 0; p < static_cast<int>(faces.size()); ++p) largest = std::max(largest, extent(p));
  const auto is_crumb = [&](int p) {
    return faces[p] > 0 && faces[p] <= most_faces_of_a_crumb && extent(p) <= extent_of_a_crumb * largest;
  };
  for (int p = 0; p < static_cast<int>(faces.size()); ++p) pieces += is_crumb(p);
  std::vector<char> result(piece.size());
  for (std::size_t f = 0; f < piece.size(); ++f) result[f] = is_crumb(piece[f]);
  return result;
}

}  // namespace

RepairedSurface repair_surface(const TriangleSoup& soup) {
  const SurfaceModel model = make_surface_model(soup);
  RepairedSurface result;
  RepairCounts& counts = result.counts;
  counts.degenerate_faces = model.repairs.degenerate_faces;
  counts.duplicate_faces = model.repairs.duplicate_faces;
  counts.separated_edges = model.repairs.non_manifold_edges;
  counts.turned_faces = model.repairs.reoriented_faces;
  const std::vector<char> crumb = in_crumbs(model.mesh, counts.removed_pieces);
  result.soup.points = soup.points;
  result.soup.colors = soup.colors;
  // The first view vertex of a point keeps its number; the others are new points.
  std::vector<char> used(soup.points.size(), 0);
  std::vector<int> number(model.soup_vertex.size());
  std::vector<int> points(soup.points.size()), faces;
  std::iota(points.begin(), points.end(), 0);
  for (std::size_t v = 0; v < model.soup_vertex.size(); ++v) {
    const int point = model.soup_vertex[v];
    number[v] = point;
    if (used[point]) {
      number[v] = static_cast<int>(result.soup.points.size());
      result.soup.points.push_back(Vec3(soup.points[point]));
      points.push_back(point);
      if (!soup.colors.empty()) result.soup.colors.push_back(soup.colors[point]);
      counts.separated_vertices += used[point] == 1;
      used[point] = 2;
    } else {
      used[point] = 1;
    }
  }
  for (const auto face : model.mesh.faces()) {
    if (crumb[face.idx()]) {
      ++counts.removed_faces;
      continue;
    }
    // As it begins in the file.
    const Triangle& given = model.soup.triangles[model.soup_face[face.idx()]];
    std::array<int, 3> corner;
    int k = 0;
    for (const auto v : model.mesh.fv_range(face)) corner[k++] = v.idx();
    while (model.soup_vertex[corner[0]] != given[0]) std::rotate(corner.begin(), corner.begin() + 1, corner.end());
    result.soup.triangles.push_back({number[corner[0]], number[corner[1]], number[corner[2]]});
    faces.push_back(model.soup_face[face.idx()]);
  }
  copy_rows(soup, points, faces, result.soup);
  return result;
}

}  // namespace loopmend
