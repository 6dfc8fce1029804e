// SPDX-License-Identifier: GPL-3.0-or-later
// What the split of a scan into smooth surface, relief and noise minimises.
#pragma once

namespace loopmend {

/// The parts of J, no units.
struct SplitEnergy {
  double smooth = 0;  ///< 4λ ∫‖∇H‖² of the smooth surface, patch and neighborhood
  double relief = 0;  ///< ∫((Δ − κ²) z)²
  double noise = 0;   ///< ∫e²/γ over the neighborhood
  double total() const { return smooth + relief + noise; }
};

}  // namespace loopmend
