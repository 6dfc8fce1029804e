// SPDX-License-Identifier: GPL-3.0-or-later
// How a surface is shaded, and the words for it.
#pragma once

namespace loopmend {

enum class Shading {
  curvature,   ///< coloured by mean curvature H
  gaussian,    ///< coloured by Gaussian curvature K
  plain,       ///< one colour; patches in another
  zebra,       ///< reflected stripes: a kink where tangents jump, a bend where curvature jumps
  isophotes,   ///< bands of equal brightness under one distant light
  scan,        ///< the scan's own colours or texture; patches continue them
  deviation,   ///< patches coloured by how far each vertex is likely from what was there
  difference,  ///< patches coloured by their signed distance from another surface; of comparisons
};

/// By values at the vertices and a colour map.
inline bool is_colored(Shading shading) {
  return shading == Shading::curvature || shading == Shading::gaussian || shading == Shading::deviation ||
         shading == Shading::difference;
}
/// Whether its values have no sign: the colour map begins at 0.
inline bool begins_at_zero(Shading shading) { return shading == Shading::deviation; }
/// Whether the scan has no values, so that its patches are the only coloured surfaces.
inline bool colors_patches_alone(Shading shading) {
  return shading == Shading::deviation || shading == Shading::difference;
}
/// Whether a patch is drawn with the rings around it.
inline bool is_drawn_over_the_scan(Shading shading) {
  return shading != Shading::plain && shading != Shading::scan && !colors_patches_alone(shading);
}
inline bool has_stripes(Shading shading) { return shading == Shading::zebra || shading == Shading::isophotes; }

enum class Edges { hidden, shown };
enum class Seams { hidden, shown };
/// Whether patches have a tint, so that they are found; a hatching over the colours of curvature.
enum class Tint { none, patches };

}  // namespace loopmend
