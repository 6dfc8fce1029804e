// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/side_work.h"

#include <algorithm>

namespace loopmend {

namespace {

/// The loops and what is around them, with nothing in them.
Patch without_fillers(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::vector<LoopFiller> empty(loops.size());
  for (std::size_t k = 0; k < loops.size(); ++k) empty[k].points.resize(loops[k].vertices.size());
  return make_patch(model, loops, empty);
}

}  // namespace

SideWork::SideWork(const FillSite& site, const std::vector<BoundaryLoop>& group, const FillOptions& options,
                   const CancelToken& cancel)
    : site_(site),
      group_(group),
      options_(options),
      cancel_(cancel),
      surveyable_(std::all_of(group.begin(), group.end(), [](const auto& loop) { return loop.diameter > 0; })),
      survey_([this] { return survey_rim(without_fillers(site_.model, group_)); }),
      report_([this] {
        const Patch& filler = *filler_.load();
        return FillerReport{seam_reports(filler), rim_fits(filler, FixedSurface(filler))};
      }) {
  if (!options.evolution || !has_first_fairing(group, options.filler.density, *options.evolution)) return;
  first_fairing_ = std::make_shared<FirstFairing>([this]() -> std::optional<FairedPatch> {
    try {
      const LoopFiller coarse = coarse_made_.get();
      if (cancel_.cancelled()) return std::nullopt;
      return fair_from_coarse(site_.model, group_.front(), coarse, options_.filler.density, cancel_);
    } catch (const std::future_error&) {
      return std::nullopt;  // the filler had no coarse mesh
    }
  });
}

void SideWork::help() {
  if (surveyable_) survey_.help();
  if (first_fairing_) first_fairing_->task.help();
  if (filler_) report_.help();
}

PatchStart SideWork::make_start() {
  std::promise<LoopFiller> coarse = std::move(coarse_);  // broken at the end, if it is not kept: then nobody waits for it
  OnCoarseFiller on_coarse;
  if (first_fairing_) on_coarse = [&](const LoopFiller& filler) { coarse.set_value(filler); };
  return start_patch(site_.model, group_, options_.filler, cancel_, on_coarse);
}

RimSurvey SideWork::survey(const PatchStart& start) {
  const bool for_all = surveyable_ && start.patch->loops.size() == group_.size();
  return for_all ? survey_.take() : survey_rim(*start.patch);
}

}  // namespace loopmend
