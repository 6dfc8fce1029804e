// SPDX-License-Identifier: GPL-3.0-or-later
// Points of a scan that were not measured: of bridges, and of patches that became a part of it.
#pragma once

#include "mesh/triangle_soup.h"

#include <cstddef>

namespace loopmend {

/// With the points of `after` that lie where none of `before` does. @param laid  sorted, and so is what is returned
Points with_laid_points(Points laid, const Points& before, const Points& after);

/// Triangles with such a corner, and their area; mesh units.
struct LaidTriangles {
  std::size_t count = 0;
  double area = 0;
};
LaidTriangles laid_triangles(const TriangleSoup& soup, const Points& laid);

}  // namespace loopmend
