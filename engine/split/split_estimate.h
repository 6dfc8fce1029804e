// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the neighborhood of a patch is smooth shape, how much relief and how much noise: estimated from the neighborhood alone.
#pragma once

#include "core/cancel.h"
#include "mesh/patch.h"

namespace loopmend {

/// What prevails around a hole.
enum class NeighborhoodKind {
  smooth,  ///< neither relief nor noise that counts
  noisy,   ///< noise more than relief
  rough,   ///< relief more than noise
};

const char* to_string(NeighborhoodKind neighborhood);

/// The split minimises λ ∫4‖∇H‖² + ∫((Δ − κ²) z)² + ∫e²/γ over smooth surface + relief z + noise e = scan. Its parameters by
/// two wavelengths, where the shares are as strong as each other: λ = w², γ = v⁶/w² + v⁴.
struct SplitEstimate {
  /// Limits of is_exact(). Holes: measured on surfaces that are known, relief up to 4e-6 and noise up to 3e-5, and on 293 holes
  /// of 15 models, where from 1e-5 on the split form comes a fifth closer. Bridges and regions, whose neighborhood is mostly
  /// constructed: coarse tubes have up to 1e-3.
  static constexpr double exact_hole = 1e-5, exact_construction = 1e-3;

  double relief = 0;  ///< w: smooth shape against relief, in boundary edges, wavelength by 2π; 0: not estimated
  double noise = 0;   ///< v: their sum against noise, likewise; 0: no noise
  /// Height up to which relief and noise may be errors of discretization, in boundary edges: what a smooth surface as
  /// curved as this one shows on edges as long as these. 0 where these are too long to tell.
  double resolution = 0;
  double edge = 0;    ///< mean boundary edge, patch frame
  double radius = 1;  ///< of the hole, patch frame: κ = 1/radius in SplitProblem
  double relief_height = 0,
         noise_height = 0;  ///< rms of the part of z that is finer than ten edges, and of e, patch frame

  double lambda() const { return relief * relief * edge * edge; }
  double noise_variance() const;  ///< γ; 0 without noise
  /// The neighborhood is smooth as far as that matters: the flow itself may take them literally.
  /// @param relief  height up to which relief does not matter, in boundary edges; never less than `resolution`
  bool is_exact(double relief = exact_hole) const;
  NeighborhoodKind kind() const;
};

/// By restricted maximum likelihood (Patterson, Thompson 1971): docs/math/irregular_boundaries.md, "The two parameters". Of large neighborhood, parts.
/// @param patch  its free vertices and own triangles are not looked at. @returns exact where there is too little to tell, and
/// something of no use when cancelled; of infinite relief where the split cannot be made.
SplitEstimate estimate_split(const Patch& patch, const CancelToken& cancel = {});

}  // namespace loopmend
