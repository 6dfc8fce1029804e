// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/linear_start.h"

#include "evolution/mesh_care.h"
#include "evolution/stopwatch.h"
#include "filling/fairing.h"
#include "mesh/quality.h"
#include "operators/operator_set.h"

#include <algorithm>

namespace loopmend {

namespace {

std::shared_ptr<const Topology> topology_of(const Patch& patch) {
  return std::make_shared<Topology>(patch.vertex_count(), patch.triangles);
}

}  // namespace

FairedPatch linearly_faired(const Patch& given, const std::shared_ptr<const Topology>& topology, double bending,
                            FairingMesh mesh, SteadyStart start, const CancelToken& cancel) {
  Stopwatch watch;
  const bool even = start == SteadyStart::evenly_faired;
  FairedPatch result;
  const bool remeshes = mesh == FairingMesh::remeshed;
  Patch patch = remeshes ? remeshed(given) : given;
  result.topology = remeshes ? topology_of(patch) : topology;
  const int attempts = mesh == FairingMesh::fixed ? 2 : 3;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    if (attempt == 2) {
      patch = remeshed(result.patch);
      result.topology = topology_of(patch);
    }
    result.assemble_seconds += watch.lap();
    const bool evenly = even || attempt > 0;
    result.patch = patch;
    result.patch.positions = linear_fairing(patch, *result.topology, bending, evenly ? even_clamp : robust_clamp);
    result.solve_seconds += watch.lap();
    result.move = 0;
    for (int i = 0; i < patch.free_count; ++i)
      result.move = std::max(result.move, (result.patch.positions[i] - patch.positions[i]).norm());
    const int folds = count_folds(result.patch.positions, patch.triangles, patch.patch_triangles);
    result.assemble_seconds += watch.lap();
    if (folds == 0 || cancel.cancelled()) break;
  }
  return result;
}

}  // namespace loopmend
