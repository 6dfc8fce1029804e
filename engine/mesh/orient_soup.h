// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a soup orientable and manifold by splitting vertices and turning faces, in linear time. Faces must have three
// different corners, and no two the same three. `origin` (#vertices) is extended by those of the new vertices.
#pragma once

#include "core/types.h"

#include <vector>

namespace loopmend {

/// Where more than two faces meet at an edge, pairs of them that run on into each other with the least angle stay
/// together, as where two sheets touch along the edge or a fin stands on a sheet; the rest are cut off there. Each fan
/// of faces around a vertex gets a vertex of its own; the first keeps its number. @param points  of the origins
void separate_at_edges(const Points& points, Triangles& triangles, std::vector<int>& origin);

/// Turns the faces that disagree with most of their component, and cuts where that does not help: at edges that still
/// have more than two faces, and across one-sided components. Each fan gets a vertex of its own; the first keeps its
/// number. The order of the faces stays, that of their corners does not. @returns for each face whether it is turned.
std::vector<char> orient_soup(Triangles& triangles, std::vector<int>& origin);

}  // namespace loopmend
