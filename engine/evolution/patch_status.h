// SPDX-License-Identifier: GPL-3.0-or-later
// What has become of a patch: the one word that steps, jobs, reports and the window share.
#pragma once

namespace loopmend {

/// Sessions store it by number, up to `step_limit`: these keep their numbers.
enum class PatchStatus {
  filled,     ///< the initial patch alone: asked for, or because it has fewer faults than all else (see the message)
  ready,      ///< some steps of a flow; more can be taken
  converged,  ///< the flow's steady state: a step of the size that was asked for moves nothing that could be seen, and the
              ///< flow stands still when it starts again from there
  stalled,     ///< no acceptable step was found before the steady state; the patch is the last accepted one
  invalid,     ///< it cuts the surface or itself, or folds where the initial patch did not
  faired,      ///< shaped by linear fairings, or by something between these and a flow: see the method
  early_stop,  ///< on purpose: more steps would lower the energy, but not bring the patch closer to the truth
  step_limit,  ///< stopped at the step limit, before the steady state
  cancelled,   ///< by the token; the patch is the last accepted one
  failed,      ///< there is no patch; the message says why
  skipped,     ///< not asked for
};

/// The word of reports.
const char* to_string(PatchStatus status);

/// True if there is a patch that may be pasted.
bool is_filled(PatchStatus status);

/// True if the patch is at its end: no more steps are planned, or they would change nothing.
inline bool is_at_end(PatchStatus status) {
  return status == PatchStatus::converged || status == PatchStatus::faired || status == PatchStatus::early_stop;
}

}  // namespace loopmend
