// SPDX-License-Identifier: GPL-3.0-or-later
// What a scan carries beside its shape goes on over the patches.
#pragma once

#include "mesh/triangle_soup.h"

namespace loopmend {

/// Makes the rows of soup.continued: one for each point and triangle that has none of the file. Colours and numbers with
/// fractions continue those at the edge of the new triangles harmonically (cotan Laplace equation, weights clamped), so that
/// they stay within the range found there; normals are those of the new triangles; whole numbers that are no colours, names
/// of materials and groups, and lists are those of the nearest triangle or point of the file, by edges. Texture coordinates
/// of corners are not continued: there is no picture for them. Where new triangles hang on nothing of the file: 0.
/// To be called last, before the soup is written.
void continue_attributes(TriangleSoup& soup);

}  // namespace loopmend
