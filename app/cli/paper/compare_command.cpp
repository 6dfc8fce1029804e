// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/report.h"
#include "comparison_files.h"
#include "exit_codes.h"
#include "opened_parts.h"
#include "paper_commands.h"
#include "vertex_selection.h"

#include "core/path_text.h"
#include "core/seconds_since.h"
#include "core/version.h"
#include "flows/flow_terms.h"
#include "io/atomic_file.h"
#include "pipeline/problem.h"
#include "problems/comparison_table.h"

#include <chrono>
#include <cmath>
#include <cstdio>
#include <memory>

namespace loopmend {

namespace {

PosedProblem region_problem(const CompareCommand& command) {
  if (command.inputs.size() != 1) throw UsageError("a region is compared in one mesh");
  const auto model = std::make_shared<const SurfaceModel>(open_model(command.inputs[0]).model);
  return pose_region(
      model, command.where.empty() ? read_vertex_numbers(command.region) : vertices_where(*model, command.where));
}

PosedProblem blend_problem(const CompareCommand& command) {
  OpenedParts parts = open_parts(command.inputs);
  std::vector<BoundaryLoop> loops;
  for (const NamedLoop& named : choose_part_loops(parts.joined, command.loops)) loops.push_back(named.loop);
  return pose_bridge(std::make_shared<const SurfaceModel>(std::move(parts.joined.model)), loops,
                     options_of(command.words).initial, CancelToken());
}

PosedProblem hole_problem(const CompareCommand& command) {
  const auto model = std::make_shared<const SurfaceModel>(open_model(command.inputs[0]).model);
  std::vector<BoundaryLoop> holes;
  for (const BoundaryLoop& loop : find_boundary_loops(*model))
    if (loop.kind == LoopKind::hole) holes.push_back(loop);
  if (holes.empty()) throw UsageError("the mesh has no hole; --loops or --where say what else is to be compared");
  return pose_holes(model, holes, options_of(command.words).initial, CancelToken());
}

PosedProblem points_problem(const CompareCommand& command) {
  if (command.inputs.size() != 1) throw UsageError("--subdivide takes one polyhedron");
  SubdivisionOptions options;
  options.subdivisions = command.subdivide;
  options.boundary = command.boundary;
  if (!command.fixed.empty()) options.fixed = read_vertex_numbers(command.fixed);
  return pose_points(std::make_shared<const SurfaceModel>(open_model(command.inputs[0]).model), options);
}

PosedProblem problem_of(const CompareCommand& command) {
  const bool points = command.subdivide > 0;
  if (!points && (!command.fixed.empty() || command.boundary == PolyhedronBoundary::smooth))
    throw UsageError("--fixed and --open belong to --subdivide");
  const bool region = !command.region.empty() || !command.where.empty();
  if (region && !command.loops.empty()) throw UsageError("--loops and a region exclude each other");
  if (!command.region.empty() && !command.where.empty())
    throw UsageError("a region is given by --region FILE or by --where CONDITION: one of the two");
  if (points && (region || !command.loops.empty())) throw UsageError("--subdivide excludes --loops and regions");
  if (points) return points_problem(command);
  if (region) return region_problem(command);
  return command.inputs.size() > 1 || !command.loops.empty() ? blend_problem(command) : hole_problem(command);
}

nlohmann::ordered_json comparison_json(const FlowComparison& comparison) {
  nlohmann::ordered_json json;
  for (const ComparedFlow& run : comparison.runs) {
    nlohmann::ordered_json one = patch_json(run.outcome);
    one["flow"] = to_string(run.outcome.flow);
    one["area"] = run.energies.area;
    one["bending_energy"] = run.energies.bending;
    one["variation_energy"] = run.energies.variation;
    const SeamFigures seam = seam_figures(run.outcome.seams);
    one["h_jump_wide"] = run.wide_jump;
    one["h_jump_rms"] = std::isfinite(seam.jump) ? nlohmann::ordered_json(seam.jump) : nlohmann::ordered_json(nullptr);
    for (const SeamReport& report : run.outcome.seams) one["seams"].push_back(seam_json(report));
    json.push_back(std::move(one));
  }
  return json;
}

}  // namespace

int run_compare(const CompareCommand& command) {
  const auto begin = std::chrono::steady_clock::now();
  CommandFiles files;
  for (const std::filesystem::path& input : command.inputs) files.reads("the input", input);
  files.reads("--region", command.region).reads("--fixed", command.fixed);
  for (const std::filesystem::path& file : comparison_files(command.output))
    files.writes(NamedFile::Kind::other, "the file", file);
  files.writes_report("--report", command.words.report).check_identity();
  const Problem problem = problem_of(command).problem;
  OutputTransaction outputs;
  outputs.add_folder(command.output);
  files.check();
  ProgressLine progress(command.words.verbosity());
  const FlowComparison comparison = compare_flows(
      problem.start, *options_of(command.words).evolution, [&](FlowKind flow) { progress.say(upper_name(flow)); },
      CancelToken());
  write_comparison(outputs, problem, comparison, path_text(command.inputs[0].filename()), command.output);
  nlohmann::ordered_json json;
  json["version"] = version();
  json["command_line"] = command.command_line;
  json["free_vertices"] = problem.start.free_count;
  json["flows"] = comparison_json(comparison);
  commit_with_report(outputs, command.words.report, json);
  if (!command.words.quiet) {
    const double seconds = seconds_since(begin);
    std::fprintf(command.words.report == "-" ? stderr : stdout, "%s%d free vertices; %s written in %.2f s\n",
                 comparison_table(comparison).c_str(), problem.start.free_count, path_text(command.output).c_str(),
                 seconds);
  }
  return exit_done;
}

}  // namespace loopmend
