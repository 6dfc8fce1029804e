// Flows on open patches, off the window's thread.
#pragma once

#include "document/patch_state.h"
#include "jobs/task_runner.h"

#include <functional>
#include <memory>
#include <vector>

namespace loopmend {

enum class Pace {
  one_step,  ///< one step of every patch
  run,       ///< step after step, every patch in turn, until all are at rest or a pause is asked for
  steady,    ///< every patch straight to its steady state
};

/// An evolution that can be taken up again: it belongs to `state`, and to no other.
struct EvolutionSession {
  std::shared_ptr<Evolution> evolution;
  PatchStatePtr state;
};

struct EvolveTask {
  struct Item {
    int patch_id = 0;
    PatchStatePtr start;
    std::shared_ptr<Evolution> session;  ///< to go on with, or empty
  };
  std::vector<Item> items;
  EvolutionOptions options;
  Pace pace = Pace::one_step;
  Vec3 origin = Vec3::Zero();
};

struct EvolveResult {
  std::vector<std::pair<int, EvolutionSession>> sessions;  ///< by patch id
  std::vector<std::pair<int, std::string>> failures;       ///< by patch id: it could not even start
};

/// @param show  every accepted state, on the worker's thread.
EvolveResult evolve_patches(const EvolveTask& task, const std::function<void(int, PatchStatePtr)>& show,
                            const Job& job);

}  // namespace loopmend
