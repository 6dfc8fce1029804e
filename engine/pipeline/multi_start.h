// SPDX-License-Identifier: GPL-3.0-or-later
// Which starts of the way to the steady state are tried, and which result is the best.
#pragma once

#include "core/cancel.h"
#include "evolution/evolution.h"
#include "evolution/mesh_improvement.h"
#include "pipeline/patch_result.h"

#include <utility>

namespace loopmend {

/// The result of run(start, options) and, for MMCVF to the steady state where that fails or takes long, of the runs from
/// other starts; where none comes to rest, of runs that go on from the best one's shape on a fresh mesh. The best of them.
/// @param run   from a start and options to a PatchResult. @param rate  from that to its StartRating.
template <class Run, class Rate>
PatchResult best_of_starts(const Patch& patch, const EvolutionOptions& options, const CancelToken& cancel,
                           const Run& run, const Rate& rate) {
  // Straight ways take fewer steps; those that take more may have ended in a bubble.
  constexpr int suspiciously_many_steps = 10;
  constexpr int most_fresh_meshes = 2;
  constexpr int worth_trying_again = 20'000;  // free vertices: above, a run takes long
  auto best = run(patch, options);
  if (options.flow != FlowKind::mmcvf || options.mode != EvolutionMode::steady || options.start != SteadyStart::faired)
    return best;
  const bool faired = rate(best).faired;
  for (const SteadyStart start : {SteadyStart::evenly_faired, SteadyStart::as_given}) {
    const StartRating now = rate(best);
    if ((now.at_end && now.steps <= suspiciously_many_steps) || cancel.cancelled()) return best;
    if (start == SteadyStart::as_given && !faired) continue;  // as the first was
    EvolutionOptions other = options;
    other.start = start;
    auto next = run(patch, other);
    if (rate(next).beats(now)) best = std::move(next);
  }
  // Steps along the normals squeeze triangles, and the fits there stop the flow before it is at rest.
  for (int k = 0; k < most_fresh_meshes && options.triangles == PatchTriangles::free; ++k) {
    const StartRating now = rate(best);
    if (!now.usable || now.at_end || best.patch.free_count > worth_trying_again || cancel.cancelled()) break;
    EvolutionOptions other = options;
    other.start = SteadyStart::as_given;
    auto next = run(remeshed(best.patch), other);
    if (rate(next).beats(now)) best = std::move(next);
  }
  return best;
}

}  // namespace loopmend
