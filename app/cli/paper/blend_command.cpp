// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/outputs.h"
#include "cli/report.h"
#include "exit_codes.h"
#include "opened_parts.h"
#include "paper_commands.h"
#include "usage_error.h"

#include "core/path_text.h"
#include "core/seconds_since.h"
#include "core/version.h"
#include "pipeline/blend.h"
#include "pipeline/continue_attributes.h"
#include "pipeline/rim_groups.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace loopmend {

namespace {

using Json = nlohmann::ordered_json;

/// One patch and the loops that it joins.
struct Joint {
  std::vector<NamedLoop> loops;
  BlendResult result;
};

std::string names_of(const std::vector<NamedLoop>& loops) {
  std::string names;
  for (const NamedLoop& loop : loops) names += (names.empty() ? "" : ",") + loop.name;
  return names;
}

Json joint_json(const Joint& joint) {
  const PatchResult& outcome = joint.result.outcome;
  Json json = patch_json(outcome);
  json["turned_faces"] = joint.result.turned_faces;
  json["seconds"]["bridge"] = outcome.seconds.initial_patch;
  json["seconds"]["total"] = outcome.seconds.total;
  for (std::size_t k = 0; k < joint.loops.size(); ++k) {
    Json loop = loop_json(joint.loops[k].loop);
    loop["name"] = joint.loops[k].name;
    if (k < outcome.seams.size()) {
      loop["seam_before"] = seam_json(outcome.seams_before[k]);
      loop["seam_after"] = seam_json(outcome.seams[k]);
    }
    json["loops"].push_back(std::move(loop));
  }
  return json;
}

/// One patch stands at the top, several in "patches".
Json blend_report(const BlendCommand& command, const OpenedParts& parts, const std::vector<Joint>& joints) {
  Json json;
  json["version"] = version();
  json["command_line"] = command.command_line;
  for (std::size_t k = 0; k < parts.paths.size(); ++k)
    json["inputs"].push_back(input_json(parts.paths[k], parts.imports[k], parts.repairs[k]));
  if (joints.size() == 1) json.update(joint_json(joints.front()));
  for (std::size_t k = 0; joints.size() > 1 && k < joints.size(); ++k) json["patches"].push_back(joint_json(joints[k]));
  return json;
}

void print_joint(std::FILE* out, const Joint& joint) {
  const PatchResult& outcome = joint.result.outcome;
  if (joint.result.turned_faces > 0)
    std::fprintf(out, "Loops %s: %zu faces were turned round, whose inside faced the gap.\n",
                 names_of(joint.loops).c_str(), joint.result.turned_faces);
  std::fprintf(out, "%6s  %6s  %21s  %21s\n", "loop", "edges", "angle at seam, deg", "jump of H x diameter");
  for (std::size_t k = 0; k < joint.loops.size(); ++k)
    std::fprintf(out, "%6s  %6d  %9.4f -> %8.4f  %9.4f -> %8.4f\n", joint.loops[k].name.c_str(),
                 joint.loops[k].loop.edges(), outcome.seams_before[k].g1_rms_deg, outcome.seams[k].g1_rms_deg,
                 outcome.seams_before[k].h_jump_rms_times_diameter, outcome.seams[k].h_jump_rms_times_diameter);
  std::fprintf(out, "%zu loops joined by %d new vertices: %s (%s) after %d steps%s%s", joint.loops.size(),
               outcome.patch.free_count, to_string(outcome.status), method_name(outcome).c_str(), outcome.steps,
               outcome.message.empty() ? "" : ", ", outcome.message.english().c_str());
}

void print_findings(std::FILE* out, const Joint& joint) {
  const std::vector<Verdict>& verdicts = joint.result.outcome.verdicts;
  for (std::size_t k = 0; k < verdicts.size(); ++k)
    if (!verdicts[k].findings.empty())
      std::fprintf(out, "loop %s: %s: %s.\n", joint.loops[k].name.c_str(), to_string(verdicts[k].grade),
                   verdicts[k].message().english().c_str());
  if (worst(verdicts) == Grade::bad)
    std::fprintf(out,
                 "The patch has a fault: another --density may give a sound one; 'loopmend fill' closes each loop.\n");
  print_reason(out, joint.result.outcome.reason);
}

void print_summary(std::FILE* out, const BlendCommand& command, const std::vector<Joint>& joints, double seconds) {
  for (std::size_t k = 0; k < joints.size(); ++k) {
    print_joint(out, joints[k]);
    if (k + 1 == joints.size())
      std::fprintf(out, "; %s written in %.2f s\n", path_text(command.output).c_str(), seconds);
    else
      std::fprintf(out, "\n");
  }
  for (const Joint& joint : joints) print_findings(out, joint);
}

/// What to do where no surface joins the loops.
std::string next_step(const OpenedParts& parts, const std::vector<NamedLoop>& loops) {
  if (parts.paths.size() == 1 && loops.size() == 2)
    if (const std::optional<RimGroup> gap = find_gap(parts.joined.model, loops[0].loop, loops[1].loop))
      return gap_cure(*gap).english();
  if (parts.paths.size() == 1) {
    const std::vector<BoundaryLoop>& all = parts.joined.loops.front();
    for (const RimGroup& face : find_walls(parts.joined.model, all, CancelToken())) {
      const auto is_of_it = [&](const NamedLoop& named) {
        return std::ranges::any_of(face.loops, [&](int k) {
          return all[static_cast<std::size_t>(k)].vertices.front() == named.loop.vertices.front();
        });
      };
      if (face.loops.size() > loops.size() && std::ranges::all_of(loops, is_of_it))
        return advice(face, face.loops.front()).english();
    }
  }
  return "name other loops (--loops), or close each by itself ('loopmend fill')";
}

/// The loops of each patch. @throws UsageError where one is named for two.
std::vector<Joint> asked_joints(const BlendCommand& command, const JoinedParts& parts) {
  std::vector<Joint> joints;
  std::set<int> named;
  for (const std::string& loops : command.loops.empty() ? std::vector<std::string>{{}} : command.loops) {
    joints.push_back({choose_part_loops(parts, loops), {}});
    for (const NamedLoop& loop : joints.back().loops)
      if (!named.insert(loop.loop.number).second)
        throw UsageError("loop " + loop.name + " is named for two patches: a loop can be in one --loops only");
  }
  return joints;
}

std::vector<int> points_of(const SurfaceModel& model, const BoundaryLoop& loop) {
  std::vector<int> points;
  for (const int v : loop.vertices) points.push_back(model.soup_vertex[v]);
  std::ranges::sort(points);
  return points;
}

/// The loops of `first`, as they stand in the same model with patches between others; fewer where a patch has changed some.
std::vector<BoundaryLoop> loops_now(const SurfaceModel& first, const std::vector<NamedLoop>& asked,
                                    const SurfaceModel& model) {
  std::vector<BoundaryLoop> result;
  const std::vector<BoundaryLoop> all = find_boundary_loops(model);
  for (const NamedLoop& named : asked) {
    const std::vector<int> points = points_of(first, named.loop);
    const auto same =
        std::ranges::find_if(all, [&](const BoundaryLoop& loop) { return points_of(model, loop) == points; });
    if (same != all.end()) result.push_back(*same);
  }
  return result;
}

}  // namespace

int run_blend(const BlendCommand& command) {
  const auto start = std::chrono::steady_clock::now();
  CommandFiles files;
  for (const std::filesystem::path& input : command.inputs) files.reads("the input", input);
  files.writes(NamedFile::Kind::mesh, "-o", command.output).writes_report("--report", command.words.report).check();
  OpenedParts parts = open_parts(command.inputs);
  std::vector<Joint> joints = asked_joints(command, parts.joined);
  SurfaceModel model = parts.joined.model;
  Grade grade = Grade::good;
  for (Joint& joint : joints) {
    ProgressLine(command.words.verbosity()).say("joining " + std::to_string(joint.loops.size()) + " loops");
    const std::vector<BoundaryLoop> loops = loops_now(parts.joined.model, joint.loops, model);
    if (loops.size() < joint.loops.size()) {
      std::fprintf(
          stderr,
          "loopmend: the loops %s were not joined: a patch between others has changed one of them, which touches it. "
          "Nothing was written.\n",
          names_of(joint.loops).c_str());
      return exit_loops_failed;
    }
    joint.result = blend_loops(model, loops, options_of(command.words), CancelToken());
    if (joint.result.outcome.status == PatchStatus::failed) {
      std::fprintf(stderr, "loopmend: the loops %s were not joined: %s; %s. Nothing was written.\n",
                   names_of(joint.loops).c_str(), joint.result.outcome.message.english().c_str(),
                   next_step(parts, joint.loops).c_str());
      return exit_loops_failed;
    }
    grade = std::max(grade, worst(joint.result.outcome.verdicts));
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
  Json json = blend_report(command, parts, joints);
  json["exterior_unchanged"] = losses.largest_exterior_rounding == 0;
  json["output"] = losses_json(losses);
  json["total_seconds"] = seconds;
  commit_with_report(outputs, command.words.report, json);
  if (!command.words.quiet) {
    std::FILE* out = command.words.report == "-" ? stderr : stdout;
    print_summary(out, command, joints, seconds);
    print_losses(out, command.output, losses);
  }
  return grade == Grade::bad ? exit_loops_failed : exit_done;
}

}  // namespace loopmend
