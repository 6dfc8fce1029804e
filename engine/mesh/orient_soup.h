// SPDX-License-Identifier: GPL-3.0-or-later
// Makes a soup orientable and manifold by turning faces and splitting vertices (through CGAL).
#pragma once

#include "core/types.h"

namespace loopmend {

struct OrientedSoup {
  Triangles triangles;      ///< same order as given; corners may be turned round or renumbered
  std::vector<int> origin;  ///< vertex of the oriented soup → vertex given (identity for the first #points)
};

/// Faces must have three different corners, and no two the same three.
OrientedSoup orient_soup(const Points& points, const Triangles& triangles);

}  // namespace loopmend
