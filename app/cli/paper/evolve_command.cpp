// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/open_model.h"
#include "cli/outputs.h"
#include "cli/report.h"
#include "exit_codes.h"
#include "paper_commands.h"
#include "vertex_selection.h"

#include "analysis/seam_report.h"
#include "core/path_text.h"
#include "core/seconds_since.h"
#include "core/version.h"
#include "pipeline/continue_attributes.h"
#include "pipeline/evolve_region.h"

#include <chrono>
#include <cmath>
#include <cstdio>

namespace loopmend {

namespace {

void print_summary(std::FILE* out, const EvolveCommand& command, const Region& region, const PatchResult& evolved,
                   double seconds) {
  if (region.held_at_boundary > 0)
    std::fprintf(out, "%d vertices of the region lie on the surface's boundary: they stay.\n", region.held_at_boundary);
  if (evolved.patch.free_count != region.patch.free_count)
    std::fprintf(out, "The region was remeshed: %d vertices instead of %d.\n", evolved.patch.free_count,
                 region.patch.free_count);
  const std::vector<SeamReport> before = seam_reports(region.patch), after = seam_reports(evolved.patch);
  std::fprintf(out, "%5s  %21s  %21s\n", "loop", "angle at seam, deg", "jump of H x diameter");
  for (std::size_t k = 0; k < after.size() && k < 40; ++k) {
    if (std::isfinite(after[k].g1_rms_deg))
      std::fprintf(out, "%5zu  %9.4f -> %8.4f  %9.4f -> %8.4f\n", k + 1, before[k].g1_rms_deg, after[k].g1_rms_deg,
                   before[k].h_jump_rms_times_diameter, after[k].h_jump_rms_times_diameter);
    else
      std::fprintf(out, "%5zu  the surface's own boundary: nothing beyond to compare with\n", k + 1);
  }
  std::fprintf(out, "%d vertices: %s (%s) after %d steps, energy %.4g -> %.4g%s%s; %s written in %.2f s\n",
               evolved.patch.free_count, to_string(evolved.status), method_name(evolved).c_str(), evolved.steps,
               evolved.energy.initial, evolved.energy.final, evolved.message.empty() ? "" : ", ",
               evolved.message.english().c_str(), path_text(command.output).c_str(), seconds);
  print_reason(out, evolved.reason);
}

}  // namespace

int run_evolve(const EvolveCommand& command) {
  const auto start = std::chrono::steady_clock::now();
  CommandFiles()
      .reads("the input", command.input)
      .reads("--region", command.region)
      .writes(NamedFile::Kind::mesh, "-o", command.output)
      .writes_report("--report", command.words.report)
      .check();
  if (command.region.empty() == command.where.empty())
    throw UsageError("a region is given by --region FILE or by --where CONDITION: one of the two");
  if (command.words.flow == "none") throw UsageError("--flow none would leave the region as it is");
  const OpenedModel opened = open_model(command.input);
  const std::vector<int> vertices =
      command.where.empty() ? read_vertex_numbers(command.region) : vertices_where(opened.model, command.where);
  const Region region = make_region(opened.model, vertices);
  ProgressLine(command.words.verbosity())
      .say("evolving a region of " + std::to_string(region.patch.free_count) + " vertices");
  const PatchResult evolved = evolve_region(region, *options_of(command.words).evolution, nullptr, CancelToken());
  if (const Message refusal = refusal_of(region, evolved); !refusal.empty()) {
    std::fprintf(stderr, "loopmend: %s: nothing was written.\n", refusal.english().c_str());
    return exit_loops_failed;
  }
  TriangleSoup surface = with_region(opened.model, region, evolved.patch);
  continue_attributes(surface);
  OutputTransaction outputs;
  write_mesh(outputs, command.output, surface, command.words.encoding());
  const OutputLosses losses =
      losses_of(command.output, surface, command.words.encoding(), opened.import.not_kept, surface.points.size());
  const double seconds = seconds_since(start);
  nlohmann::ordered_json json = patch_json(evolved);
  json["version"] = version();
  json["command_line"] = command.command_line;
  json["input"] = input_json(command.input, opened.import, opened.model.repairs);
  json["held_at_boundary"] = region.held_at_boundary;
  json["remeshed"] = evolved.patch.free_count != region.patch.free_count;
  for (const SeamReport& seam : seam_reports(region.patch)) json["seams_before"].push_back(seam_json(seam));
  for (const SeamReport& seam : seam_reports(evolved.patch)) json["seams_after"].push_back(seam_json(seam));
  json["output"] = losses_json(losses);
  json["total_seconds"] = seconds;
  commit_with_report(outputs, command.words.report, json);
  if (!command.words.quiet) {
    std::FILE* out = command.words.report == "-" ? stderr : stdout;
    print_summary(out, command, region, evolved, seconds);
    print_losses(out, command.output, losses);
  }
  return exit_done;
}

}  // namespace loopmend
