#include "evolution/linear_start.h"

#include "evolution/mesh_care.h"
#include "evolution/stopwatch.h"
#include "filling/fairing.h"

#include <algorithm>

namespace loopmend {

FairedState linearly_faired(const EvolutionState& state, const Objective& objective, Stencil stencil, FairingMesh mesh,
                            SteadyStart start, const CancelToken& cancel) {
  Stopwatch watch;
  const bool even = start == SteadyStart::evenly_faired;
  FairedState result;
  Patch patch = mesh == FairingMesh::remeshed ? remeshed(state.patch) : state.patch;
  const int attempts = mesh == FairingMesh::fixed ? 2 : 3;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (attempt == 2) patch = remeshed(result.state.patch);
    result.assemble_seconds += watch.lap();
    Patch faired = patch;
    faired.positions = linear_fairing(patch, objective.bending, even || attempt > 0 ? even_clamp : robust_clamp);
    result.solve_seconds += watch.lap();
    result.move = 0;
    for (int i = 0; i < patch.free_count; ++i)
      result.move = std::max(result.move, (faired.positions[i] - patch.positions[i]).norm());
    result.state = make_state(std::move(faired), objective, stencil);
    result.assemble_seconds += watch.lap();
    if (result.state.folds == 0 || cancel.cancelled()) break;
  }
  return result;
}

}  // namespace loopmend
