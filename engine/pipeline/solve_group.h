// SPDX-License-Identifier: GPL-3.0-or-later
// One group of holes from the initial patch to finished patches.
#pragma once

#include "core/message.h"
#include "mirror/mirror_plane.h"
#include "pipeline/initial_patch.h"
#include "pipeline/patch_result.h"
#include "pipeline/validate.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace loopmend {

/// What became of one hole.
struct HoleResult {
  BoundaryLoop loop;
  PatchStatus status = PatchStatus::skipped;  ///< of its patch, or why there is none
  Message message;                            ///< what is to be known of this hole; empty when all is well
  /// Shared by holes that were solved together; null where there is none. Where the hole was left open all the same, `status`
  /// and `message` say so, and this is what was not pasted.
  std::shared_ptr<const PatchResult> patch;
  int place = 0;  ///< of the hole among the patch's loops
  int first_point = -1,
      first_triangle = -1;  ///< the patch's own in the surface that it was pasted into; -1: not pasted
  int free_vertices = 0;    ///< of the part of the patch that the hole bounds
  double seconds = 0;       ///< from the group's start to this result
  MirrorFit mirror;         ///< of the mirror image at this hole, where one was asked for

  /// The patch's, or an empty one where there is none.
  const PatchResult& outcome() const {
    static const PatchResult none;
    return patch ? *patch : none;
  }
  /// The word of reports for what shaped the patch; empty where there is none.
  std::string method() const { return is_filled(status) ? method_name(outcome()) : std::string(); }
  Message reason() const { return is_filled(status) ? outcome().reason : Message(); }
  int steps() const { return outcome().steps; }
  /// Zero where there is no patch, or it was not measured.
  SeamReport seam_before() const { return entry(&PatchResult::seams_before); }
  SeamReport seam_after() const { return entry(&PatchResult::seams); }
  /// Good where there is no patch: its status says more.
  Proportion proportion() const { return verdict().proportion; }
  Verdict verdict() const { return is_filled(status) ? entry(&PatchResult::verdicts) : Verdict(); }
  /// Not known where there is no patch, or no estimate.
  ExpectedDeviation deviation() const {
    const std::vector<ExpectedDeviation>& all = outcome().deviation.loops;
    return is_filled(status) && place < static_cast<int>(all.size()) ? all[place] : ExpectedDeviation();
  }
  BoundarySummary neighborhood() const { return entry(&PatchResult::neighborhood); }

 private:
  template <class T>
  T entry(std::vector<T> PatchResult::*list) const {
    const std::vector<T>& all = outcome().*list;
    return place < static_cast<int>(all.size()) ? all[place] : T{};
  }
};

/// What is expected of each vertex that the patches of these holes add to the surface, in its order there (pipeline/paste.h), mesh
/// units; NaN without an estimate.
std::vector<double> expected_deviations(const std::vector<HoleResult>& holes);

/// A hole that was left open.
HoleResult open_hole(const BoundaryLoop& loop, PatchStatus status, Message why);

/// Why nothing can fill the loop: its own edges run through the surface. Empty where they do not. Fast: asked before any patch
/// is made.
Message why_no_patch_exists(const ScanIndex& scan, const BoundaryLoop& loop);

struct GroupResult {
  std::vector<std::shared_ptr<const PatchResult>> patches;  ///< one that is `invalid` must not be pasted
  std::vector<HoleResult> holes;                            ///< in the order of the group's loops
};

struct GroupOptions {
  InitialPatchOptions initial;
  std::optional<EvolutionOptions> evolution = EvolutionOptions{};  ///< empty: leave the initial patch
  /// A hole of which the surface around fits one of these mirror images is closed by a copy of it. Not without `evolution`.
  std::vector<MirrorPlane> mirror_planes{};
};

/// What holes are closed by before any flow.
struct StartPatch {
  const Patch& patch;
  Message message;  ///< what is to be said of it; empty when all is well
  enum class Kind { holes, bridge } kind = Kind::holes;
};

/// What is seen of holes while they are solved; each may be empty. Called on several threads, but for one patch on one of them.
struct SolveObserver {
  /// One patch closes these holes from now on. Holes that were in one patch may come again in several.
  std::function<void(const StartPatch&)> on_start;
  Evolution::OnStep on_step;                        ///< every accepted step of every attempt
  std::function<void(const GroupResult&)> on_done;  ///< the final result of some of the holes
};

/// The group in parts whose holes ask for the same treatment of the boundary data: what solve_group() solves one after another.
/// @returns the group alone where there is one part only.
std::vector<InitialPatch> parts_alike(const ScanIndex& scan, const InitialPatch& initial, const GroupOptions& options,
                                      const CancelToken& cancel);

/// Holes that ask for the same treatment of the boundary data are solved jointly; where that leaves one of them open, out of
/// proportion or with the initial patch, each by itself. What goes wrong in one hole leaves the others alone.
/// @param initial  with more than one loop and no outcomes, these are made again.
/// @param observer  does not hear of the start of `initial` itself.
/// @returns nothing of use when cancelled.
GroupResult solve_group(const ScanIndex& scan, const InitialPatch& initial, const GroupOptions& options,
                        const SolveObserver& observer, const CancelToken& cancel);

}  // namespace loopmend
