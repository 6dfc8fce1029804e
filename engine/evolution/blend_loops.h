// SPDX-License-Identifier: GPL-3.0-or-later
// Joining loops by one fair patch from end to end: bridge, evolution, checks, paste. What `loopmend blend` calls.
#pragma once

#include "analysis/seam_report.h"
#include "evolution/fill_loops.h"
#include "filling/bridge_loops.h"

#include <string>
#include <vector>

namespace loopmend {

struct BlendResult {
  LoopStatus status = LoopStatus::failed;
  std::string message;                                ///< why it failed or stopped early; empty when all is well
  std::string method, reason;                         ///< as in LoopResult
  std::vector<BoundaryLoop> loops;                    ///< as given
  std::size_t turned_faces = 0;                       ///< of parts whose inside faced the gap
  std::optional<Bridge> bridge;                       ///< the shapes before the flow
  std::optional<Patch> patch;                         ///< the result; empty when failed
  std::vector<SeamReport> seams_before, seams_after;  ///< per loop: of the membrane, of the result
  FillerQuality quality;                              ///< of the result
  int steps = 0;
  double bending = 0;  ///< EvolutionOptions::bending that was used
  struct {
    double bridge = 0, assemble = 0, solve = 0, total = 0;
  } seconds;
  struct {
    double initial = 0, final = 0;
  } energy;
};

/// Joins the loops and pastes the patch. Pieces of surface that face the gap with their inside are turned round first,
/// the piece of the first loop being right. When the result is `failed` or cancelled, the model is as it was.
/// @throws InvalidArgument as bridge_loops, and where pieces cannot be made to agree.
BlendResult blend_loops(SurfaceModel& model, const std::vector<BoundaryLoop>& loops, const FillOptions& options,
                        const CancelToken& cancel, const Evolution::OnStep& on_step = nullptr);

}  // namespace loopmend
