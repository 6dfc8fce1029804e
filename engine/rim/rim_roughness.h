// SPDX-License-Identifier: GPL-3.0-or-later
// How rough the surroundings of a patch are, told from the surroundings alone.
#pragma once

#include "mesh/patch.h"
#include "rim/fixed_surface.h"

#include <array>

namespace loopmend {

/// What a sixth-order patch may make of its surroundings.
enum class Surroundings {
  smooth,  ///< the curvature at the rim is what it seems
  noisy,   ///< a smooth surface under white noise
  rough,   ///< relief on every scale: the curvature at the rim says little about the hole
};

const char* to_string(Surroundings surroundings);

/// Sixth order takes the curvature at the rim literally; where that is roughness, the patch blows up
/// (docs/dev/numerics.md, "Rough boundaries").
/// The kinds run into one another: the two shares say how far, continuously in the surroundings, and the patch follows
/// them without a jump. Smooth surroundings have both at 0 exactly.
struct RimRoughness {
  Surroundings kind = Surroundings::smooth;
  double rough_share = 0;     ///< 0..1: share of the robust fairing in the patch; above 0 where the kind is rough
  double noise_share = 0;     ///< 0..1: share of the white noise that the flow should not meet
  double unevenness = 0;      ///< q = R · rms(H₂ − H₄): curvature of two-ring against four-ring fits, no unit
  double correlation = 1;     ///< C of H₄ at a quarter of the patch radius, 0.01..1: 1 is smooth
  double noise_per_edge = 0;  ///< the noise in mean edges of the surroundings
  double noise = 0;  ///< σ: median residual of cubic two-ring fits, patch frame; the standard deviation of white noise
  /// log₂ of the median residual of four-ring over that of two-ring fits: 0 white noise, 3 and more smooth.
  double growth = 4;
  /// The median of the same ratio taken vertex by vertex: two medians are of two different vertices where a smooth surface
  /// bends more here than there.
  double local_growth = 4;
  double evenness = 1;  ///< of that growth: from two to three rings over from three to four, each per log of the width.
      ///< About 1 on scans, whose relief is alike on all scales; less where weak white noise lies on a
      ///< smooth surface, since then it is all in the wide fits
  double spread =
      1;  ///< of the residuals of three-ring fits: the quantile of 84 % over that of 16 %. White noise, which is
          ///< alike everywhere, has 1.2 to 1.5, scans mostly 1.7 to 10 and more
  double bending = 0;  ///< αR² of the order blend ∫‖∇H‖² + α∫H² that these ask for; 0 on smooth surroundings
  double radius = 0;  ///< R = sqrt(patch area / (π · loops)), patch frame
};

/// What the surroundings alone say: fits at their vertices.
struct SurroundingFits {
  std::vector<int> vertices;                ///< with both fits: fixed vertices, counted from the first
  std::vector<double> H2, H4;               ///< at these: H by two-ring and by four-ring fits, patch frame
  std::array<double, 3> residual{0, 0, 0};  ///< median, of cubic fits over 2, 3 and 4 rings near the patch, patch frame
  double local_growth = 0;                  ///< see RimRoughness; 0 where no vertex has both residuals
  double spread = 1;                        ///< of those over 3 rings, see RimRoughness
};

/// @param around  of this patch, for all three of RimSurvey.
SurroundingFits fit_surroundings(const Patch& patch, const FixedSurface& around);

/// @param fits  of this patch's surroundings.
RimRoughness rim_roughness(const Patch& patch, const SurroundingFits& fits);
RimRoughness rim_roughness(const Patch& patch);

}  // namespace loopmend
