// SPDX-License-Identifier: GPL-3.0-or-later
// Who is next to whom: one-rings of vertices and faces in flat arrays, built once for a connectivity.
#pragma once

#include "core/types.h"

#include <span>
#include <vector>

namespace loopmend {

/// Immutable. All lists ascend, so that every sum over them has one order and every result one set of bits.
class Topology {
 public:
  Topology(int vertex_count, const Triangles& triangles);

  int vertex_count() const { return static_cast<int>(neighbor_offset_.size()) - 1; }
  /// One-ring of v without v.
  std::span<const int> neighbors(int v) const;
  /// Triangles at v; not to be asked for after forget_faces().
  std::span<const int> faces(int v) const;
  /// Gives back the memory that faces() needs, half of all.
  void forget_faces();
  /// True if some edge at v has only one triangle (or v has none).
  bool is_boundary(int v) const { return boundary_[v] != 0; }
  int valence(int v) const { return static_cast<int>(neighbors(v).size()); }

  /// Vertices within `rings` edges of v, without v; in breadth-first order, nearer rings first. `mark` is scratch of
  /// size vertex_count(), all 0, and is handed back so.
  void k_ring(int v, int rings, std::vector<int>& result, std::vector<char>& mark) const;

 private:
  std::vector<int> face_offset_, face_, neighbor_offset_, neighbor_;
  std::vector<char> boundary_;
};

}  // namespace loopmend
