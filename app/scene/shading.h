// SPDX-License-Identifier: GPL-3.0-or-later
// How a surface is shaded, and the words for it.
#pragma once

namespace loopmend {

enum class Shading {
  curvature,  ///< coloured by mean curvature H
  gaussian,   ///< coloured by Gaussian curvature K
  plain,      ///< one colour; patches in another
  zebra,      ///< reflected stripes: a kink where tangents jump, a bend where curvature jumps
  isophotes,  ///< bands of equal brightness under one distant light
  scan,       ///< the scan's own colours or texture; patches continue them
};

inline bool is_colored(Shading shading) { return shading == Shading::curvature || shading == Shading::gaussian; }
/// Whether a patch is drawn with the rings around it.
inline bool is_drawn_over_the_scan(Shading shading) { return shading != Shading::plain && shading != Shading::scan; }
inline bool has_stripes(Shading shading) { return shading == Shading::zebra || shading == Shading::isophotes; }

enum class Edges { hidden, shown };
enum class Seams { hidden, shown };

}  // namespace loopmend
