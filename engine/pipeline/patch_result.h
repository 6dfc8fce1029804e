// SPDX-License-Identifier: GPL-3.0-or-later
// The one outcome: what a job made of one patch, and how.
#pragma once

#include "analysis/seam_report.h"
#include "core/message.h"
#include "evolution/evolution.h"
#include "mesh/patch.h"
#include "mesh/validity.h"
#include "mirror/mirror_patch.h"
#include "neighborhood/boundary_fits.h"
#include "pipeline/expected_deviation.h"
#include "pipeline/judge.h"

#include <algorithm>
#include <string>
#include <vector>

namespace loopmend {

struct PatchResult {
  PatchStatus status = PatchStatus::failed;
  FlowKind flow = FlowKind::mmcvf;        ///< that was asked for
  Method method = Method::initial_patch;  ///< what shaped the patch
  Message message;                        ///< for a person: what is to be known of the patch; empty when all is well
  Message reason;  ///< why it was not the flow that was asked for, and how to get that; empty if it was
  std::vector<std::string> attempts;  ///< candidates that were computed, in order
  std::string made_by;                ///< the candidate that was kept; empty where it is the initial patch
  Patch patch;
  int steps = 0;                    ///< accepted steps, over all runs that made the patch
  double bending = 0;               ///< EvolutionOptions::bending that was used
  std::vector<StepRecord> history;  ///< of the run that made the patch
  struct Seconds {
    double initial_patch = 0;
    double survey = 0;  ///< of the neighborhood, beyond the initial patch that is made beside it
    double assemble = 0, solve = 0;
    double choice = 0;     ///< of candidates: sharp edges, outliers, what a fairing sets out from
    double checks = 0;     ///< folds, intersections, seams, verdict of what was kept
    double rejected = 0;   ///< attempts that were not kept
    double deviation = 0;  ///< its estimate
    double total = 0;
    double other() const {
      return std::max(0.0, total - initial_patch - survey - choice - assemble - solve - checks - rejected - deviation);
    }
  } seconds;
  struct {
    double initial = 0, final = 0;
  } energy;  ///< units as in StepRecord
  Validity validity;
  DeviationEstimate deviation;  ///< empty without an estimate
  MirrorFit mirror;             ///< of the mirror image, where one was asked for
  // One for each loop of the patch; empty: not measured.
  std::vector<Verdict> verdicts;
  std::vector<SeamReport> seams_before;  ///< of the initial patch
  std::vector<SeamReport> seams;
  std::vector<BoundarySummary> neighborhood;
};

/// Takes steps, times, energies and history of a run.
void take_figures(const Evolution& evolution, PatchResult& result);

/// Behind what is said already.
void add_message(PatchResult& result, Message message);

/// The word of reports for what shaped the patch; empty where there is none.
std::string method_name(const PatchResult& result);

/// What a run came to, as far as the run from another start may be preferred.
struct StartRating {
  bool usable = false;
  bool at_end = false;
  bool faired = true;  ///< false: it set out from the patch as given, since fairing did not pay
  int steps = 0;
  double energy = 0;  ///< at the end; the same for all runs, up to the mesh

  /// Several steady states may exist, and inflated ones are high where the right one is smooth: among what is at its end
  /// the lowest energy counts.
  bool beats(const StartRating& other) const {
    if (usable != other.usable || at_end != other.at_end) return usable != other.usable ? usable : at_end;
    return usable && energy < other.energy;
  }
};

/// @param usable  whether the result may be kept.
StartRating rating_of(const PatchResult& result, bool usable);

}  // namespace loopmend
