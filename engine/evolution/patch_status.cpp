// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/patch_status.h"

namespace loopmend {

const char* to_string(PatchStatus status) {
  switch (status) {
    case PatchStatus::filled: return "filled";
    case PatchStatus::ready: return "ready";
    case PatchStatus::converged: return "converged";
    case PatchStatus::stalled: return "stalled";
    case PatchStatus::invalid: return "invalid";
    case PatchStatus::faired: return "faired";
    case PatchStatus::step_limit: return "step_limit";
    case PatchStatus::early_stop: return "early_stop";
    case PatchStatus::cancelled: return "cancelled";
    case PatchStatus::failed: return "failed";
    case PatchStatus::skipped: return "skipped";
  }
  return "";
}

bool is_filled(PatchStatus status) {
  return status != PatchStatus::invalid && status != PatchStatus::cancelled && status != PatchStatus::failed &&
         status != PatchStatus::skipped;
}

}  // namespace loopmend
