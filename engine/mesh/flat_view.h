// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles of a soup as an oriented manifold, still flat: what the view of a surface is built from.
#pragma once

#include "mesh/surface_model.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace loopmend {

struct FlatView {
  std::vector<int> faces;  ///< soup triangle of each triangle, ascending; empty: all of them
  Triangles triangles;     ///< over `origin`; only if is_own, else those of the soup serve
  bool is_own = false;
  std::vector<int>
      origin;  ///< point of the view → soup point; the soup's own come first, then copies where it was split
  std::vector<char>
      at_boundary;  ///< #origin: whether a boundary runs through the point; where it was split perhaps not
  std::vector<int> turned_faces;  ///< soup triangles that were turned round, ascending
  bool is_split = false;          ///< some points have several copies or fans

  const Triangles& all(const TriangleSoup& soup) const { return is_own ? triangles : soup.triangles; }
  int face(std::size_t k) const { return faces.empty() ? static_cast<int>(k) : faces[k]; }
};

/// Leaves out what is no part of a surface, cuts what is not manifold, and turns what disagrees with most of its piece, in
/// the soup as well. Fills all counts but that of unreferenced vertices. Deterministic. Indices must be in range.
/// @param known  of the soup, where it was made before
/// @throws InvalidArgument if no usable face is left.
FlatView flat_view(TriangleSoup& soup, std::optional<VertexSurvey> known, ModelRepairs& repairs);

/// For each point one point that stands for all that hang together with it by triangles.
std::vector<int> components(const Triangles& triangles, std::size_t point_count);

}  // namespace loopmend
