// How rough the surroundings of a patch are, told from the surroundings alone.
#pragma once

#include "mesh/patch.h"

namespace loopmend {

/// Sixth order takes the curvature at the rim literally; where that is roughness, the patch blows up (NUMERICS §12).
struct RimRoughness {
  double unevenness = 0;   ///< q = R · rms(H₂ − H₄): curvature of two-ring against four-ring fits, no unit
  double correlation = 1;  ///< C of H₄ at a quarter of the patch radius, 0.01..1: 1 is smooth
  double bending = 0;  ///< αR² of the order blend ∫‖∇H‖² + α∫H² that these two ask for; 0 on smooth surroundings
  double radius = 0;  ///< R = sqrt(patch area / (π · loops)), patch frame
};

RimRoughness rim_roughness(const Patch& patch);

}  // namespace loopmend
