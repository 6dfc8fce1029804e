// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes of irregular valence on surfaces whose answer is known.
#pragma once

#include "mesh/triangle_soup.h"

#include <functional>

namespace loopmend {

/// Moves every point by `jitter` × the mean edge length in a random tangential direction (seeded) and puts it back onto
/// the surface with `project`; then flips a share of the edges at random. Makes meshes of irregular valence.
/// @param jitter      0..0.4; above 0.25 the smallest angles of a regular mesh get below 15°.
/// @param flip_share  0..1, of the inner edges; a flip that would make a fold, an angle under 15° or a valence under 4
///                    is left out, so that fewer are done.
TriangleSoup roughen(const TriangleSoup& soup, double jitter, double flip_share, unsigned seed,
                     const std::function<Vec3(const Vec3&)>& project);

}  // namespace loopmend
