// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/report.h"
#include "exit_codes.h"
#include "opened_parts.h"
#include "paper_commands.h"

#include "core/path_text.h"
#include "core/seconds_since.h"
#include "core/version.h"
#include "pipeline/blend.h"
#include "pipeline/continue_attributes.h"
#include "pipeline/rim_pairs.h"

#include <chrono>
#include <cstdio>
#include <optional>
#include <string>

namespace loopmend {

namespace {

using Json = nlohmann::ordered_json;

Json blend_report(const BlendCommand& command, const OpenedParts& parts, const std::vector<NamedLoop>& loops,
                  const BlendResult& result) {
  Json json;
  json["version"] = version();
  json["command_line"] = command.command_line;
  for (std::size_t k = 0; k < parts.paths.size(); ++k)
    json["inputs"].push_back(input_json(parts.paths[k], parts.imports[k], parts.repairs[k]));
  json.update(patch_json(result.outcome));
  json["turned_faces"] = result.turned_faces;
  json["seconds"]["bridge"] = result.outcome.seconds.initial_patch;
  json["seconds"]["total"] = result.outcome.seconds.total;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    Json loop = loop_json(loops[k].loop);
    loop["name"] = loops[k].name;
    if (k < result.outcome.seams.size()) {
      loop["seam_before"] = seam_json(result.outcome.seams_before[k]);
      loop["seam_after"] = seam_json(result.outcome.seams[k]);
    }
    json["loops"].push_back(std::move(loop));
  }
  return json;
}

void print_summary(std::FILE* out, const BlendCommand& command, const std::vector<NamedLoop>& loops,
                   const BlendResult& result, double seconds) {
  if (result.turned_faces > 0)
    std::fprintf(out, "%zu faces were turned round: their inside faced the gap.\n", result.turned_faces);
  std::fprintf(out, "%6s  %6s  %21s  %21s\n", "loop", "edges", "angle at seam, deg", "jump of H x diameter");
  for (std::size_t k = 0; k < loops.size(); ++k)
    std::fprintf(out, "%6s  %6d  %9.4f -> %8.4f  %9.4f -> %8.4f\n", loops[k].name.c_str(), loops[k].loop.edges(),
                 result.outcome.seams_before[k].g1_rms_deg, result.outcome.seams[k].g1_rms_deg,
                 result.outcome.seams_before[k].h_jump_rms_times_diameter,
                 result.outcome.seams[k].h_jump_rms_times_diameter);
  std::fprintf(out, "%zu loops joined by %d new vertices: %s (%s) after %d steps%s%s; %s written in %.2f s\n",
               loops.size(), result.outcome.patch.free_count, to_string(result.outcome.status),
               method_name(result.outcome).c_str(), result.outcome.steps, result.outcome.message.empty() ? "" : ", ",
               result.outcome.message.english().c_str(), path_text(command.output).c_str(), seconds);
  for (std::size_t k = 0; k < result.outcome.verdicts.size(); ++k)
    if (const Verdict& verdict = result.outcome.verdicts[k]; !verdict.findings.empty())
      std::fprintf(out, "loop %s: %s: %s.\n", loops[k].name.c_str(), to_string(verdict.grade),
                   verdict.message().english().c_str());
  if (worst(result.outcome.verdicts) == Grade::bad)
    std::fprintf(out,
                 "The patch has a fault: another --density may give a sound one; 'loopmend fill' closes each loop.\n");
}

/// What to do where no surface joins the loops.
std::string next_step(const OpenedParts& parts, const std::vector<BoundaryLoop>& loops) {
  if (parts.paths.size() == 1 && loops.size() == 2)
    if (const std::optional<RimPair> gap = find_gap(parts.joined.model, loops[0], loops[1]))
      return gap_cure(*gap).english();
  return "name other loops (--loops), or close each by itself ('loopmend fill')";
}

}  // namespace

int run_blend(const BlendCommand& command) {
  const auto start = std::chrono::steady_clock::now();
  CommandFiles files;
  for (const std::filesystem::path& input : command.inputs) files.reads("the input", input);
  files.writes(NamedFile::Kind::mesh, "-o", command.output).writes_report("--report", command.words.report).check();
  OpenedParts parts = open_parts(command.inputs);
  const std::vector<NamedLoop> loops = choose_part_loops(parts.joined, command.loops);
  std::vector<BoundaryLoop> bare;
  for (const NamedLoop& loop : loops) bare.push_back(loop.loop);
  ProgressLine(command.words.verbosity()).say("joining " + std::to_string(loops.size()) + " loops");
  SurfaceModel model = parts.joined.model;
  const BlendResult result = blend_loops(model, bare, options_of(command.words), CancelToken());
  if (result.outcome.status == PatchStatus::failed) {
    std::fprintf(stderr, "loopmend: the loops were not joined: %s; %s. Nothing was written.\n",
                 result.outcome.message.english().c_str(), next_step(parts, bare).c_str());
    return exit_loops_failed;
  }
  continue_attributes(model.soup);
  OutputTransaction outputs;
  write_mesh(outputs, command.output, model.soup, command.words.encoding());
  std::vector<NotKept> not_read;
  for (const ImportReport& import : parts.imports)
    for (const NotKept& entry : import.not_kept) count_not_kept(not_read, entry.what, entry.count);
  const OutputLosses losses =
      losses_of(command.output, model.soup, command.words.encoding(), not_read, parts.joined.model.soup.points.size());
  const double seconds = seconds_since(start);
  Json json = blend_report(command, parts, loops, result);
  json["exterior_unchanged"] = losses.largest_exterior_rounding == 0;
  json["output"] = losses_json(losses);
  json["total_seconds"] = seconds;
  commit_with_report(outputs, command.words.report, json);
  if (!command.words.quiet) {
    std::FILE* out = command.words.report == "-" ? stderr : stdout;
    print_summary(out, command, loops, result, seconds);
    print_reason(out, result.outcome.reason);
    print_losses(out, command.output, losses);
  }
  return worst(result.outcome.verdicts) == Grade::bad ? exit_loops_failed : exit_done;
}

}  // namespace loopmend
