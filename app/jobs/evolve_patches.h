// SPDX-License-Identifier: GPL-3.0-or-later
// Flows on open patches, off the window's thread.
#pragma once

#include "document/document.h"
#include "jobs/run_recorder.h"
#include "jobs/scan_context.h"
#include "jobs/task_runner.h"
#include "pipeline/initial_patch.h"

#include <functional>
#include <memory>
#include <optional>
#include <vector>

namespace loopmend {

enum class Pace {
  time_step,   ///< one semi-implicit time step (paper, §4) of every patch
  time_steps,  ///< one after another until all are at rest or a pause is asked for
  steady,      ///< every patch straight to its steady state, with the fallbacks of the command line
  watched,     ///< the same, every step shown for a moment
};

inline bool is_to_steady_state(Pace pace) { return pace == Pace::steady || pace == Pace::watched; }

/// An evolution that can be taken up again: it belongs to `state`, and to no other.
struct EvolutionSession {
  std::shared_ptr<Evolution> evolution;
  PatchStatePtr state;
};

struct EvolveTask {
  struct Item {
    OpenPatch patch;
    std::shared_ptr<Evolution> session;  ///< to go on with, or empty
    ScanContextPtr scan_context;
    std::vector<BoundaryLoop> loops;  ///< those of the patch
    std::vector<int> spare_ids;  ///< one for each loop: of patches of their own, should they have to be solved apart
    std::optional<InitialPatch> initial;  ///< where more is known of it than the patch
  };
  std::vector<Item> items;
  EvolutionOptions options;
  Pace pace = Pace::time_step;
  Vec3 origin = Vec3::Zero();
  std::function<void(int done)> progress;  ///< patches at their end; called on the worker's threads
};

struct EvolveResult {
  std::map<int, EvolutionSession> sessions;  ///< by patch id
  std::map<int, Message> failures;           ///< by patch id: it could not even start
  /// By patch id: holes that could only be solved each by itself, as patches of their own (ids not set).
  std::map<int, std::vector<OpenPatch>> splits;
};

/// Every accepted state goes to the recorder. On the way to the steady state, holes of one patch that ask for different treatment of the
/// boundary data become patches of their own first.
EvolveResult evolve_patches(const EvolveTask& task, RunRecorder& recorder, const Job& job);

}  // namespace loopmend
