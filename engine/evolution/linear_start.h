// SPDX-License-Identifier: GPL-3.0-or-later
// The start of the way to the steady state: linear third-order fairing, which large openings need
// (docs/dev/numerics.md, "Starts").
#pragma once

#include "core/cancel.h"
#include "evolution/evolution.h"
#include "mesh/patch.h"
#include "operators/topology.h"

#include <memory>

namespace loopmend {

enum class FairingMesh {
  fixed,     ///< the triangles stay, come what may
  kept,      ///< they stay unless the fairing folds them
  remeshed,  ///< brought back to the size of the rim's edges first
};

struct FairedPatch {
  Patch patch;
  std::shared_ptr<const Topology> topology;
  double move = 0;  ///< longest way of a vertex, patch frame
  double assemble_seconds = 0, solve_seconds = 0;
};

/// The patch after one linear fairing of ∫‖∇H‖² + bending ∫H². Where that folds it: the same with even weights, then on the mesh
/// that remeshing makes of what came out. The caller judges whether it is an improvement.
/// @param topology  of the patch. @param bending  patch frame.
FairedPatch linearly_faired(const Patch& patch, const std::shared_ptr<const Topology>& topology, double bending,
                            FairingMesh mesh, SteadyStart start, const CancelToken& cancel);

}  // namespace loopmend
