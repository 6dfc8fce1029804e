// SPDX-License-Identifier: GPL-3.0-or-later
// The pieces of a surface that do not hang together, and which of them lie as islands in a hole of another.
#pragma once

#include "mesh/boundary_loops.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <span>
#include <vector>

namespace loopmend {

/// For each view vertex the lowest vertex of its piece of surface; one without edges is a piece of its own.
std::vector<int> lowest_connected_vertices(const TriMesh& mesh);

/// For each view face the lowest face of its piece of surface. Pieces that have a vertex in common are one.
std::vector<int> pieces_of(const TriMesh& mesh);

/// For each soup point the number of its part of the surface, from 0 in the order of their lowest points; −1: in no face. Parts that
/// share a soup point are one. @param count  is set to how many there are
std::vector<int> parts_of_points(const SurfaceModel& model, int& count);

/// The piece that a loop bounds, by the numbers of `piece` (of pieces_of).
int piece_beside(const TriMesh& mesh, const std::vector<int>& piece, const BoundaryLoop& loop);

/// The pieces of a surface by number, their boxes and points, whether the view holds them or not.
class Pieces {
 public:
  /// @param model  must outlive this, and not change.
  explicit Pieces(const SurfaceModel& model);
  Pieces(const Pieces&) = delete;
  Pieces& operator=(const Pieces&) = delete;
  /// The piece that a loop bounds.
  int beside(const BoundaryLoop& loop) const;
  const Eigen::AlignedBox3d& box(int piece) const { return boxes_[piece]; }
  /// visit(piece, point) for all points of all pieces.
  template <class Visit>
  void for_each_point(const Visit& visit) const {
    for (std::size_t v = 0; v < of_point_.size(); ++v)
      if (of_point_[v] >= 0) visit(of_point_[v], point(v));
  }

 private:
  const Vec3& point(std::size_t v) const;

  const SurfaceModel& model_;
  std::vector<int> own_of_point_;               ///< of a whole view
  std::vector<Eigen::AlignedBox3d> own_boxes_;  ///< likewise
  std::span<const int> of_point_;               ///< of the points that point() knows; −1: none
  std::span<const Eigen::AlignedBox3d> boxes_;
};

struct HoleWithIslands {
  int hole = 0;              ///< index into the loops
  std::vector<int> islands;  ///< boundaries of other pieces that lie within it, ascending
};

/// Holes in which other pieces lie: seen square to the hole's best plane, the piece's outer rim is inside the hole, and no
/// further from that plane than half the hole's diameter. An island belongs to the smallest hole around it.
/// @param loops  all of the model. @returns by rising hole; holes without islands are left out.
std::vector<HoleWithIslands> find_islands(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops);

}  // namespace loopmend
