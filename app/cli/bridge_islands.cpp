// SPDX-License-Identifier: GPL-3.0-or-later
#include "bridge_islands.h"

#include "core/error.h"
#include "evolution/blend_loops.h"

#include <algorithm>

namespace loopmend {

namespace {

BoundaryLoop loop_through(const SurfaceModel& model, int soup_vertex) {
  for (const BoundaryLoop& loop : find_boundary_loops(model))
    for (int v : loop.vertices)
      if (model.soup_vertex[v] == soup_vertex) return loop;
  throw InvalidArgument("another patch closed it already");
}

}  // namespace

std::vector<int> anchors_of(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::vector<int> anchors;
  for (const BoundaryLoop& loop : loops) anchors.push_back(model.soup_vertex[loop.vertices.front()]);
  return anchors;
}

std::vector<LoopResult> bridge_islands(SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                       const std::vector<int>& anchors, const HoleWithIslands& place,
                                       const FillOptions& options) {
  std::vector<int> members{place.hole};
  members.insert(members.end(), place.islands.begin(), place.islands.end());
  std::vector<LoopResult> results(members.size());
  BlendResult blend;
  try {
    std::vector<BoundaryLoop> ends;
    for (int k : members) ends.push_back(loop_through(model, anchors[k]));
    blend = blend_loops(model, ends, options, CancelToken());
  } catch (const std::exception& error) {  // one place does not take the others with it
    blend.message = error.what();
  }
  for (std::size_t k = 0; k < members.size(); ++k) {
    LoopResult& result = results[k];
    result.loop = loops[members[k]];
    result.status = blend.status;
    result.message = blend.message;
    result.method = blend.method;
    result.reason = blend.reason;
    if (k > 0 && blend.status != LoopStatus::failed)
      result.message = "an island: joined to hole " + std::to_string(loops[place.hole].number);
    if (k == 0 && blend.patch) result.free_vertices = blend.patch->free_count;
    result.steps = blend.steps;
    result.bending = blend.bending;
    result.energy = {blend.energy.initial, blend.energy.final};
    result.seconds = {blend.seconds.bridge, blend.seconds.assemble, blend.seconds.solve, blend.seconds.total};
    if (k >= blend.seams_after.size()) continue;
    result.seam_before = blend.seams_before[k];
    result.seam_after = blend.seams_after[k];
  }
  return results;
}

}  // namespace loopmend
