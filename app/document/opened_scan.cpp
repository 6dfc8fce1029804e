// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/opened_scan.h"

#include "mesh/pieces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <bit>
#include <numeric>

namespace loopmend {

ScanPieces scan_pieces(const TriMesh& mesh) {
  // Each piece by its lowest vertex first, in the order of these; a vertex without faces counts to the first piece.
  std::vector<int> vertex_piece = lowest_connected_vertices(mesh);
  std::vector<ScanPieces::Piece> found;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const auto v : mesh.vertices()) {
    int& piece = vertex_piece[v.idx()];
    if (mesh.is_isolated(v)) {
      piece = 0;
      continue;
    }
    if (piece == v.idx()) {
      piece = static_cast<int>(found.size());
      found.push_back({0, 0, v.idx()});
      boxes.emplace_back();
    } else {
      piece = vertex_piece[piece];  // lower, numbered already
    }
    boxes[piece].extend(mesh.point(v));
  }
  for (const auto face : mesh.faces()) {
    const int v = mesh.to_vertex_handle(mesh.halfedge_handle(face)).idx();
    ++found[vertex_piece[v]].triangles;
  }
  for (std::size_t k = 0; k < found.size(); ++k) found[k].diameter = boxes[k].diagonal().norm();
  std::vector<int> order(found.size()), rank(found.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const ScanPieces::Piece &x = found[a], &y = found[b];
    return x.triangles != y.triangles ? x.triangles > y.triangles : x.first_vertex < y.first_vertex;
  });
  ScanPieces pieces;
  for (std::size_t k = 0; k < order.size(); ++k) {
    rank[order[k]] = static_cast<int>(k);
    pieces.list.push_back(found[order[k]]);
  }
  if (pieces.list.size() < 2) return pieces;
  for (int& piece : vertex_piece) piece = rank[piece];
  pieces.of_vertex = std::move(vertex_piece);
  return pieces;
}

std::uint64_t fingerprint_of(const TriangleSoup& soup) {
  std::uint64_t hash = 0xCBF29CE484222325ull;  // FNV-1a, a word at a time
  const auto mix = [&hash](std::uint64_t word) { hash = (hash ^ word) * 0x100000001B3ull; };
  mix(soup.points.size());
  for (const Vec3& p : soup.points)
    for (double x : p) mix(std::bit_cast<std::uint64_t>(x));
  mix(soup.triangles.size());
  for (const Triangle& t : soup.triangles)
    for (int v : t) mix(static_cast<std::uint64_t>(v));
  return hash;
}

}  // namespace loopmend
