// How a surface is shaded, and the words for it.
#pragma once

namespace loopmend {

enum class Shading {
  curvature,  ///< coloured by H
  plain,      ///< one colour; patches in another
  zebra,      ///< reflected stripes: a kink where tangents jump, a bend where curvature jumps
};

enum class Edges { hidden, shown };

}  // namespace loopmend
