// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/commands.h"
#include "cli/open_model.h"
#include "cli/outputs.h"
#include "cli/report.h"
#include "exit_codes.h"
#include "paper_commands.h"
#include "vertex_selection.h"

#include "core/path_text.h"
#include "core/seconds_since.h"
#include "core/version.h"
#include "pipeline/interpolate.h"

#include <chrono>
#include <cstdio>

namespace loopmend {

int run_interpolate(const InterpolateCommand& command) {
  const auto start = std::chrono::steady_clock::now();
  CommandFiles()
      .reads("the input", command.input)
      .reads("--fixed", command.fixed)
      .writes(NamedFile::Kind::mesh, "-o", command.output)
      .writes_report("--report", command.words.report)
      .check();
  const OpenedModel opened = open_model(command.input);
  SubdivisionOptions subdivision;
  subdivision.subdivisions = command.subdivide;
  subdivision.boundary = command.boundary;
  if (!command.fixed.empty()) subdivision.fixed = read_vertex_numbers(command.fixed);
  ProgressLine(command.words.verbosity()).say("interpolating " + path_text(command.input));
  const Interpolation result =
      interpolate_points(opened.model, subdivision, options_of(command.words).evolution, CancelToken());
  const PatchResult& evolved = result.outcome;
  if (const Message refusal = refusal_of(evolved); !refusal.empty()) {
    std::fprintf(stderr, "loopmend: %s. Nothing was written.\n", refusal.english().c_str());
    return exit_loops_failed;
  }
  OutputTransaction outputs;
  write_mesh(outputs, command.output, result.surface, command.words.encoding());
  const OutputLosses losses = losses_of(command.output, result.surface, command.words.encoding(),
                                        opened.import.not_kept, static_cast<std::size_t>(result.fixed_count));
  const double seconds = seconds_since(start);
  nlohmann::ordered_json json = patch_json(evolved);
  json["version"] = version();
  json["command_line"] = command.command_line;
  json["input"] = input_json(command.input, opened.import, opened.model.repairs);
  json["fixed_vertices"] = result.fixed_count;
  json["output"] = losses_json(losses);
  json["total_seconds"] = seconds;
  commit_with_report(outputs, command.words.report, json);
  if (!command.words.quiet) {
    std::FILE* out = command.words.report == "-" ? stderr : stdout;
    std::fprintf(out,
                 "%d vertices fixed, %d found: %s (%s) after %d steps, energy %.4g -> %.4g%s%s; %s written in %.2f s\n",
                 result.fixed_count, evolved.patch.free_count, to_string(evolved.status), method_name(evolved).c_str(),
                 evolved.steps, evolved.energy.initial, evolved.energy.final, evolved.message.empty() ? "" : ", ",
                 evolved.message.english().c_str(), path_text(command.output).c_str(), seconds);
    print_reason(out, evolved.reason);
    print_losses(out, command.output, losses);
  }
  return exit_done;
}

}  // namespace loopmend
