// SPDX-License-Identifier: GPL-3.0-or-later
// What a scan carries beside its shape, where faces were divided.
#pragma once

#include "mesh/triangle_soup.h"

#include <vector>

namespace loopmend {

/// Faces of a soup that stay, and parts of others.
struct DividedFaces {
  std::vector<int> kept;     ///< faces of the soup, one for each of the first triangles of the new one
  std::vector<int> part_of;  ///< faces of the soup, one for each triangle after them
  std::vector<int> beneath;  ///< faces of the soup in which the new points lie, one for each
};

/// Gives `to` the attributes and colours of `from`. Its points are those of `from` and new ones behind them. Parts have the
/// materials, names and other values of their face. What changes within a face, such as texture coordinates and colours, is
/// linear in it; whole numbers that are no colours are those of the nearest corner.
void copy_divided_rows(const TriangleSoup& from, const DividedFaces& faces, TriangleSoup& to);

}  // namespace loopmend
