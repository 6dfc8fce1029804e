// SPDX-License-Identifier: GPL-3.0-or-later
// What a second thread does for a group of loops while the first makes the filler and lets it evolve.
#pragma once

#include "analysis/seam_report.h"
#include "core/threads.h"
#include "evolution/fill_loops.h"
#include "evolution/first_fairing.h"
#include "evolution/patch_verdict.h"
#include "rim/rim_survey.h"

#include <future>
#include <memory>

namespace loopmend {

/// What is told of a filler before it evolves: one entry for each loop.
struct FillerReport {
  std::vector<SeamReport> seams;
  std::vector<std::vector<RimFit>> rims;
};

/// The results do not depend on who does the work, nor when. Outlived by all that the constructor is given.
class SideWork {
 public:
  SideWork(const FillSite& site, const std::vector<BoundaryLoop>& group, const FillOptions& options,
           const CancelToken& cancel);

  /// For the second thread: what can be done by now, in the order in which it is needed.
  void help();

  /// The fillers; meanwhile the second thread waits for the coarse one.
  PatchStart make_start();
  /// Of the surroundings of a start that has a patch. Once.
  RimSurvey survey(const PatchStart& start);
  /// The patch lives until the report has been taken.
  void report_on(const Patch& filler) { filler_ = &filler; }
  void help_with_report() { report_.help(); }
  FillerReport report() { return report_.take(); }
  /// Null where there is nothing to be made.
  const std::shared_ptr<FirstFairing>& first_fairing() const { return first_fairing_; }

 private:
  const FillSite& site_;
  const std::vector<BoundaryLoop>& group_;
  const FillOptions& options_;
  const CancelToken& cancel_;
  bool surveyable_;
  std::promise<LoopFiller> coarse_;
  std::future<LoopFiller> coarse_made_ = coarse_.get_future();
  SharedTask<RimSurvey> survey_;
  std::shared_ptr<FirstFairing> first_fairing_;
  std::atomic<const Patch*> filler_{nullptr};
  SharedTask<FillerReport> report_;
};

}  // namespace loopmend
