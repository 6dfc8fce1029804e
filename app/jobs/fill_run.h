// SPDX-License-Identifier: GPL-3.0-or-later
// Holes of the document filled by the engine's solve_holes(), as `loopmend fill` does it, off the window's thread.
#pragma once

#include "document/document.h"
#include "jobs/run_recorder.h"
#include "jobs/scan_context.h"
#include "jobs/task_runner.h"
#include "pipeline/fill_holes.h"

#include <functional>
#include <map>
#include <set>
#include <vector>

namespace loopmend {

enum class Pace {
  time_step,   ///< one semi-implicit time step (paper, §4) of every patch
  time_steps,  ///< one after another until all are at rest or a pause is asked for
  steady,      ///< every patch straight to its steady state, with the fallbacks of the command line
  watched,     ///< the same, every step shown for a moment
};

inline bool is_to_steady_state(Pace pace) { return pace == Pace::steady || pace == Pace::watched; }

/// Holes of one scan that are filled with the same options.
struct FillTask {
  ScanContextPtr scan_context;
  int first_loop = 0;                  ///< index of the scan's first loop in the document
  std::map<int, BoundaryLoop> wanted;  ///< by index in the document
  /// Filled before. One whose neighborhood overlaps that of a wanted loop is filled again, jointly: the two could not
  /// know of each other otherwise.
  std::map<int, BoundaryLoop> filled;
  std::set<int> closed;  ///< numbers of loops that have a patch which stays
  /// Patches that a flow has moved, and their loops: on from there.
  std::vector<std::pair<PatchStatePtr, std::vector<BoundaryLoop>>> moved;
  FillOptions options;
};

/// More holes than this appear when they are done: the steps of so many cannot be followed.
inline constexpr int most_live = 40;

struct FillRun {
  std::vector<FillTask> tasks;  ///< a loop belongs to the first that has it
  Pace pace = Pace::steady;
  int patches = 1;  ///< that share the time in which a step is shown, where they are watched
  Vec3 origin = Vec3::Zero();
  /// Of loops, and of the work that they are. On several threads, one call at a time; may be empty.
  std::function<void(int done, int total, double share_of_work)> progress;

  /// How long it will still take, seconds; may be empty. Of one hole alone: of several, progress() has the share.
  std::function<void(double seconds)> expects;
  double seconds_per_vertex = 0;  ///< that were measured

  int loops() const;
  double work() const;
};

struct FillOutcome {
  std::map<int, Message> failures;  ///< by index in the document
  std::map<int, Message> remarks;   ///< of filled holes, beside what their patches say
};

/// Every patch goes to the recorder as it starts, where a flow follows, at each accepted step, and when it is done. What memory
/// does not allow is left open. When the job is paused or cancelled, what is recorded by then stays.
FillOutcome fill_patches(const FillRun& run, RunRecorder& recorder, const Job& job);

}  // namespace loopmend
