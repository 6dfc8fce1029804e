// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps a soup of triangles from being an oriented manifold, vertex by vertex.
#pragma once

#include "core/types.h"

#include <cstddef>
#include <span>
#include <vector>

namespace loopmend {

/// The corners at each vertex: 3 · triangle + place, ascending.
class CornersAtVertices {
 public:
  CornersAtVertices(const Triangles& triangles, std::size_t vertex_count);
  std::span<const int> operator[](int v) const {
    return {corners_.data() + first_[v], corners_.data() + first_[v + 1]};
  }

 private:
  std::vector<int> first_, corners_;
};

enum class VertexState : char {
  clean,       ///< its triangles agree and are one fan, open or closed
  several,     ///< they agree, and are several fans
  disordered,  ///< an edge has more than two of them, or two that run along it the same way
};

struct VertexSurvey {
  std::vector<VertexState> state;
  std::vector<char> at_boundary;       ///< whether an edge at the vertex has one triangle only
  std::size_t non_manifold_edges = 0;  ///< with more than two triangles
  bool may_repeat = false;             ///< false: no two triangles have the same three vertices
  bool any(VertexState which) const;
};

/// @param triangles  each with three different corners. Two with the same three make their vertices disordered, or are a fan
/// of two: then may_repeat is set.
VertexSurvey survey_vertices(const Triangles& triangles, std::size_t vertex_count);

/// The triangles that name the same three vertices as an earlier one: 1, others 0. Those with a vertex twice are not looked at.
std::vector<char> repeated_triangles(const Triangles& triangles, std::size_t vertex_count);

/// A vertex of its own for each fan of the vertices that are `several`; the first, by its lowest triangle, keeps the number.
/// @param origin  extended by the new vertices: the one that each comes from
void separate_fans(const VertexSurvey& survey, Triangles& triangles, std::vector<int>& origin);

}  // namespace loopmend
