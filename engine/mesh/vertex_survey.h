// SPDX-License-Identifier: GPL-3.0-or-later
// What keeps a soup of triangles from being an oriented manifold, vertex by vertex.
#pragma once

#include "core/types.h"

#include <cstddef>
#include <vector>

namespace loopmend {

inline bool has_three_corners(const Triangle& t) { return t[0] != t[1] && t[1] != t[2] && t[2] != t[0]; }

enum class VertexState : char {
  clean,       ///< its triangles agree and are one fan, open or closed
  several,     ///< they agree, and are several fans
  disordered,  ///< an edge has more than two of them, or two that run along it the same way
};

struct VertexSurvey {
  std::vector<VertexState> state;
  std::vector<char> at_boundary;        ///< whether an edge at the vertex has one triangle only
  std::size_t non_manifold_edges = 0;   ///< with more than two triangles
  std::size_t collapsed_triangles = 0;  ///< with a corner twice; none of the above counts them
  bool may_repeat = false;              ///< false: no two triangles have the same three vertices
  bool any(VertexState which) const;
};

/// Two triangles with the same three vertices make these disordered, or are a fan of two: then may_repeat is set.
VertexSurvey survey_vertices(const Triangles& triangles, std::size_t vertex_count);

/// The triangles that name the same three vertices as an earlier one: 1, others 0. Those with a vertex twice are not looked at.
std::vector<char> repeated_triangles(const Triangles& triangles, std::size_t vertex_count);

/// Vertices around which the triangles do not close, ascending: going round, a neighbor is not entered as often as it is left.
std::vector<int> open_vertices(const VertexSurvey& survey, const Triangles& triangles);

/// A vertex of its own for each fan of the vertices that are `several`; the first, by its lowest triangle, keeps the number.
/// @param triangles  each with three different corners, as they were surveyed
/// @param origin  extended by the new vertices: the one that each comes from
void separate_fans(const VertexSurvey& survey, Triangles& triangles, std::vector<int>& origin);

}  // namespace loopmend
