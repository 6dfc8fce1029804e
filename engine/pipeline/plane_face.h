// SPDX-License-Identifier: GPL-3.0-or-later
// Holes in the plane faces of parts.
#pragma once

#include "mesh/patch.h"

namespace loopmend {

/// Whether the loops of a patch lie in one plane, and the surface around them says that a plane face is missing there
/// (docs/math/filling.md, section 6). Exactly, to 1e-5 of their diameter: a tenth of the faces beside them or more lie in that plane,
/// or on the other side of it than the rest, at each loop, as at a concave edge; or the surface rounds out of that plane to one side, as a
/// fillet does; false where the surface is plane farther out, too. But for noise: walls rise along a part of the loops and fall along another.
bool bounds_plane_face(const Patch& patch);

}  // namespace loopmend
