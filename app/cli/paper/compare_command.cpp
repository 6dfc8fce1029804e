#include "cli/commands.h"
#include "cli/exit_codes.h"
#include "cli/report.h"
#include "comparison_files.h"
#include "paper_commands.h"
#include "part_loops.h"
#include "vertex_selection.h"

#include "core/version.h"
#include "filling/bridge_loops.h"
#include "io/atomic_file.h"
#include "mesh/region.h"

#include <chrono>
#include <cstdio>
#include <memory>

namespace loopmend {

namespace {

/// The patch pasted into the model.
ComparisonStart pasted_start(SurfaceModel model, Patch patch) {
  const auto shared = std::make_shared<const SurfaceModel>(std::move(model));
  return {std::move(patch), [shared](const Patch& evolved) {
            SurfaceModel whole = *shared;
            append_patch(whole, patch_geometry(evolved));
            return whole.soup;
          }};
}

ComparisonStart region_start(const CompareCommand& command) {
  if (command.inputs.size() != 1) throw UsageError("a region is compared in one mesh");
  const auto opened = std::make_shared<const OpenedModel>(open_model(command.inputs[0]));
  const auto region = std::make_shared<const Region>(
      make_region(opened->model, command.where.empty() ? read_vertex_numbers(command.region)
                                                       : vertices_where(opened->model, command.where)));
  return {region->patch,
          [opened, region](const Patch& evolved) { return with_region(opened->model, *region, evolved); }};
}

ComparisonStart blend_start(const CompareCommand& command) {
  OpenedParts parts = open_parts(command.inputs);
  std::vector<BoundaryLoop> loops;
  for (const NamedLoop& named : choose_part_loops(parts.joined, command.loops)) loops.push_back(named.loop);
  SurfaceModel model = std::move(parts.joined.model);
  turn_opposed_pieces(model, loops, find_opposed_loops(model, loops));
  BridgeOutcome outcome = bridge_loops(model, loops, options_of(command.words).filler, CancelToken());
  if (!outcome.bridge) throw UsageError("the loops were not joined: " + outcome.message);
  return pasted_start(std::move(model), std::move(outcome.bridge->start));
}

ComparisonStart hole_start(const CompareCommand& command) {
  OpenedModel opened = open_model(command.inputs[0]);
  std::vector<BoundaryLoop> holes;
  for (const BoundaryLoop& loop : find_boundary_loops(opened.model))
    if (loop.kind == LoopKind::hole) holes.push_back(loop);
  if (holes.empty()) throw UsageError("the mesh has no hole; --loops or --where say what else is to be compared");
  PatchStart start = start_patch(opened.model, holes, options_of(command.words).filler, CancelToken());
  if (!start.patch) throw UsageError("no hole could be filled: " + start.fillers.front().message);
  return pasted_start(std::move(opened.model), std::move(*start.patch));
}

ComparisonStart start_of(const CompareCommand& command) {
  const bool region = !command.region.empty() || !command.where.empty();
  if (region && !command.loops.empty()) throw UsageError("--loops and a region exclude each other");
  if (!command.region.empty() && !command.where.empty())
    throw UsageError("a region is given by --region FILE or by --where CONDITION: one of the two");
  if (region) return region_start(command);
  return command.inputs.size() > 1 || !command.loops.empty() ? blend_start(command) : hole_start(command);
}

}  // namespace

void make_output_folder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error || !std::filesystem::is_directory(folder))
    throw WriteError(folder, "cannot be made a folder: " + (error ? error.message() : std::string("a file is there")),
                     "Choose another name.");
  check_writable(folder / "table.csv");
}

int run_compare(const CompareCommand& command) {
  const auto begin = std::chrono::steady_clock::now();
  const ComparisonStart start = start_of(command);
  make_output_folder(command.output);
  ProgressLine progress(command.words.verbosity());
  const FlowComparison comparison = compare_flows(
      start.patch, *options_of(command.words).evolution, [&](FlowKind flow) { progress.say(upper_name(flow)); },
      CancelToken());
  write_comparison(start, comparison, command.inputs[0].filename().string(), command.output);
  if (!command.words.report.empty()) {
    nlohmann::ordered_json json;
    json["version"] = version();
    json["command_line"] = command.command_line;
    json["free_vertices"] = start.patch.free_count;
    json["flows"] = comparison_json(comparison);
    write_report(command.words.report, json);
  }
  if (!command.words.quiet) {
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    std::fprintf(command.words.report == "-" ? stderr : stdout, "%s%d free vertices; %s written in %.2f s\n",
                 comparison_table(comparison).c_str(), start.patch.free_count, command.output.c_str(), seconds);
  }
  return exit_done;
}

}  // namespace loopmend
