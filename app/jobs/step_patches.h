// SPDX-License-Identifier: GPL-3.0-or-later
// Flows on open patches step by step, off the window's thread.
#pragma once

#include "jobs/fill_run.h"

#include <map>
#include <memory>
#include <vector>

namespace loopmend {

/// An evolution that can be taken up again: it belongs to `state`, and to no other.
struct EvolutionSession {
  std::shared_ptr<Evolution> evolution;
  PatchStatePtr state;
};

struct StepTask {
  struct Item {
    OpenPatch patch;
    std::shared_ptr<Evolution> session;  ///< to go on with, or empty
    ScanContextPtr scan_context;
    std::vector<BoundaryLoop> loops;  ///< those of the patch
  };
  std::vector<Item> items;
  EvolutionOptions options;
  Pace pace = Pace::time_step;
  Vec3 origin = Vec3::Zero();
};

struct StepResult {
  std::map<int, EvolutionSession> sessions;  ///< by patch id
  std::map<int, Message> failures;           ///< by a loop of the patch: it could not even start
};

/// Every accepted state goes to the recorder.
StepResult step_patches(const StepTask& task, RunRecorder& recorder, const Job& job);

}  // namespace loopmend
