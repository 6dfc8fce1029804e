// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scan_pieces.h"

#include "mesh/pieces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace loopmend {

ScanPieces scan_pieces(const TriMesh& mesh) {
  const std::vector<int> lowest_face = pieces_of(mesh);
  // Each piece by its lowest face first, in the order of these.
  std::vector<int> number(lowest_face.size(), -1), vertex_piece(mesh.n_vertices(), 0);
  std::vector<ScanPieces::Piece> found;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const auto face : mesh.faces()) {
    int& piece = number[static_cast<std::size_t>(lowest_face[static_cast<std::size_t>(face.idx())])];
    if (piece < 0) {
      piece = static_cast<int>(found.size());
      found.push_back({0, 0, static_cast<int>(mesh.n_vertices())});
      boxes.emplace_back();
    }
    const auto at = static_cast<std::size_t>(piece);
    ++found[at].triangles;
    for (const auto v : mesh.fv_range(face)) {
      vertex_piece[static_cast<std::size_t>(v.idx())] = piece;
      found[at].first_vertex = std::min(found[at].first_vertex, v.idx());
      boxes[at].extend(mesh.point(v));
    }
  }
  for (std::size_t k = 0; k < found.size(); ++k) found[k].diameter = boxes[k].diagonal().norm();
  std::vector<int> order(found.size()), rank(found.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    const ScanPieces::Piece &x = found[static_cast<std::size_t>(a)], &y = found[static_cast<std::size_t>(b)];
    return x.triangles != y.triangles ? x.triangles > y.triangles : x.first_vertex < y.first_vertex;
  });
  ScanPieces pieces;
  for (std::size_t k = 0; k < order.size(); ++k) {
    rank[static_cast<std::size_t>(order[k])] = static_cast<int>(k);
    pieces.list.push_back(found[static_cast<std::size_t>(order[k])]);
  }
  if (pieces.list.size() < 2) return pieces;
  for (int& piece : vertex_piece) piece = rank[static_cast<std::size_t>(piece)];
  pieces.of_vertex = std::move(vertex_piece);
  return pieces;
}

}  // namespace loopmend
