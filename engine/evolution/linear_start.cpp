#include "evolution/linear_start.h"

#include "evolution/mesh_care.h"
#include "evolution/stopwatch.h"
#include "filling/fairing.h"

#include <algorithm>

namespace loopmend {

namespace {

/// Whether triangles of the surroundings stand on all edges of the loops: else the fairing leaves out rows that K has.
bool loops_are_surrounded(const EvolutionState& state) {
  const Patch& patch = state.patch;
  for (int i = patch.free_count; i < patch.vertex_count() && patch.ring[i] == 1; ++i)
    if (state.topology->is_boundary(i)) return false;
  return true;
}

}  // namespace

FairedState linearly_faired(const Patch& given, const std::shared_ptr<const Topology>& topology,
                            const Objective& objective, Stencil stencil, FairingMesh mesh, SteadyStart start,
                            const CancelToken& cancel) {
  Stopwatch watch;
  const bool even = start == SteadyStart::evenly_faired;
  FairedState result;
  Patch patch = mesh == FairingMesh::remeshed ? remeshed(given) : given;
  const int attempts = mesh == FairingMesh::fixed ? 2 : 3;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (attempt == 2) patch = remeshed(result.state.patch);
    result.assemble_seconds += watch.lap();
    Patch faired = patch;
    const bool evenly = even || attempt > 0;
    auto solver = make_spd_solver();
    faired.positions = linear_fairing(patch, objective.bending, evenly ? even_clamp : robust_clamp, *solver);
    result.solve_seconds += watch.lap();
    result.move = 0;
    for (int i = 0; i < patch.free_count; ++i)
      result.move = std::max(result.move, (faired.positions[i] - patch.positions[i]).norm());
    const bool same_triangles = attempt == 0 && mesh != FairingMesh::remeshed;
    result.state =
        make_state(std::move(faired), objective, stencil, same_triangles ? topology : nullptr, Fits::curvatures);
    result.assemble_seconds += watch.lap();
    const bool solved = result.move > 0;
    if (solved && result.state.folds == 0 && !evenly && objective.bending == 0 && loops_are_surrounded(result.state))
      result.before = {std::move(solver), barycentric_areas(patch.positions, patch.triangles).head(patch.free_count)};
    if (result.state.folds == 0 || cancel.cancelled()) break;
  }
  return result;
}

}  // namespace loopmend
