// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow_words.h"

#include "evolution/option_names.h"

#include "cli/option_parser.h"

namespace loopmend {

namespace {

/// Of the patches of holes.
struct HoleOptions {
  CLI::Option *relief = nullptr, *edges = nullptr;
};

HoleOptions add_hole_options(CLI::App& command, EvolutionOptions& options) {
  CLI::Option* edges =
      add_named(command, "--edges", options.edges, edges_names,
                "Sharp edges that end at the hole, for mmcvf: auto, they run on across it where both sides say how; "
                "round, one smooth patch");
  CLI::Option* relief =
      add_named(command, "--relief", options.relief.kind, relief_names,
                "smooth: the patch continues the smooth surface under the scan; continued: and has random relief as "
                "strong as that around the hole");
  command.add_option("--relief-seed", options.relief.seed, "Another seed gives other relief of the same strength")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  return {relief, edges};
}

}  // namespace

void add_flow_options(CLI::App& command, FlowWords& words, DensityOption density, ReliefOption relief) {
  EvolutionOptions& options = words.evolution;
  std::vector<std::string> flows = names_in(flow_names);
  flows.emplace_back("none");
  command.add_option("--flow", words.flow, "The flow that makes the patch smooth; none leaves the first shape")
      ->check(CLI::IsMember(flows))
      ->capture_default_str();
  add_named(command, "--mode", options.mode, mode_names,
            "steady: straight to the steady state; steps: the semi-implicit scheme");
  command.add_option("--steps", options.max_steps, "At most so many steps (default 60)")->check(between(1, 1e6));
  command
      .add_option("--sigma", options.sigma, "Size of a step, dimensionless: 10 is large, 0.1 shows the flow at work")
      ->check(between(1e-6, 1e8))
      ->capture_default_str();
  add_named(command, "--solver", options.solver, solver_names, "Linear solver of the steps");
  CLI::Option* boundary =
      add_named(command, "--boundary", options.boundary, boundary_names,
                "Curvature around the hole, for mmcvf: auto, that of the smooth surface under relief and noise; exact, "
                "as it is (the flow itself); robust, hardly (robust fairing in place of the flow)");
  CLI::Option* continuity =
      add_named(command, "--continuity", options.continuity, continuity_names,
                "What runs through the seam, for mmcvf; position and tangent are linear fairings in place of the flow");
  if (density == DensityOption::offer)
    command.add_option("--density", words.density, "Vertices along a length, relative to the mesh around")
        ->check(between(0.1, 10))
        ->capture_default_str();
  const HoleOptions of_holes = relief == ReliefOption::offer ? add_hole_options(command, options) : HoleOptions();
  command.add_option("--report", words.report, "Write a JSON report to FILE, or to standard output for -")
      ->type_name("FILE|-");
  command.add_flag("--ascii", words.ascii, "Write PLY or STL as text");
  command.add_flag("--quiet", words.quiet, "No progress and no summary");
  command.parse_complete_callback([&words, boundary, continuity, of_holes] {
    const bool steady = words.evolution.mode == EvolutionMode::steady;
    const auto refuse = [&words](const std::string& option, const std::string& what_for) {
      throw CLI::ValidationError(option, "has no effect with --flow " + words.flow + " --mode " +
                                             name_of(mode_names, words.evolution.mode) + ": it is for " + what_for +
                                             " with --mode steady");
    };
    if (words.evolution.relief.kind == ReliefChoice::Kind::continued && (words.flow == "none" || !steady))
      refuse("--relief", "flows");
    if (words.flow == "mmcvf" && steady) return;
    for (const CLI::Option* option : {boundary, continuity, of_holes.edges})
      if (option && option->count() > 0) refuse(option->get_name(), "mmcvf");
  });
}

FillOptions options_of(const FlowWords& words) {
  FillOptions options;
  options.initial.density = words.density;
  options.evolution.reset();
  if (const auto flow = value_named(flow_names, words.flow)) {
    options.evolution = words.evolution;
    options.evolution->flow = *flow;
  }
  return options;
}

}  // namespace loopmend
