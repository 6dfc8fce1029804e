// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow_words.h"

#include "number_range.h"

#include "evolution/option_names.h"

#include "cli/option_parser.h"

namespace loopmend {

namespace {

/// Of the patches of holes.
struct HoleOptions {
  CLI::Option *relief = nullptr, *edges = nullptr;
};

HoleOptions add_hole_options(CLI::App& command, FlowWords& words) {
  CLI::Option* edges =
      command
          .add_option(
              "--edges", words.edges,
              "Sharp edges that end at the hole, for mmcvf: auto, they run on across it where both sides say how; "
              "round, one smooth patch")
          ->check(CLI::IsMember(names_in(edges_names)))
          ->capture_default_str();
  CLI::Option* relief =
      command
          .add_option(
              "--relief", words.relief,
              "smooth: the patch continues the smooth surface under the scan; continued: and has random relief as "
              "strong as that around the hole")
          ->check(CLI::IsMember(names_in(relief_names)))
          ->capture_default_str();
  command.add_option("--relief-seed", words.relief_seed, "Another seed gives other relief of the same strength")
      ->check(CLI::NonNegativeNumber)
      ->capture_default_str();
  return {relief, edges};
}

}  // namespace

void add_flow_options(CLI::App& command, FlowWords& words, DensityOption density, ReliefOption relief) {
  std::vector<std::string> flows = names_in(flow_names);
  flows.emplace_back("none");
  command.add_option("--flow", words.flow, "The flow that makes the patch smooth; none leaves the first shape")
      ->check(CLI::IsMember(flows))
      ->capture_default_str();
  command.add_option("--mode", words.mode, "steady: straight to the steady state; steps: the semi-implicit scheme")
      ->check(CLI::IsMember(names_in(mode_names)))
      ->capture_default_str();
  command.add_option("--steps", words.steps, "At most so many steps (default 60)")->check(between(1, 1e6));
  command.add_option("--sigma", words.sigma, "Size of a step, dimensionless: 10 is large, 0.1 shows the flow at work")
      ->check(between(1e-6, 1e8))
      ->capture_default_str();
  command.add_option("--solver", words.solver, "Linear solver of the steps")
      ->check(CLI::IsMember(names_in(solver_names)))
      ->capture_default_str();
  CLI::Option* boundary =
      command
          .add_option(
              "--boundary", words.boundary,
              "Curvature around the hole, for mmcvf: auto, that of the smooth surface under relief and noise; exact, "
              "as it is (the flow itself); robust, hardly (robust fairing in place of the flow)")
          ->check(CLI::IsMember(names_in(boundary_names)))
          ->capture_default_str();
  CLI::Option* continuity =
      command
          .add_option(
              "--continuity", words.continuity,
              "What runs through the seam, for mmcvf; position and tangent are linear fairings in place of the flow")
          ->check(CLI::IsMember(names_in(continuity_names)))
          ->capture_default_str();
  if (density == DensityOption::offer)
    command.add_option("--density", words.density, "Vertices along a length, relative to the mesh around")
        ->check(between(0.1, 10))
        ->capture_default_str();
  const HoleOptions of_holes = relief == ReliefOption::offer ? add_hole_options(command, words) : HoleOptions();
  command.add_option("--report", words.report, "Write a JSON report to FILE, or to standard output for -")
      ->type_name("FILE|-");
  command.add_flag("--ascii", words.ascii, "Write PLY or STL as text");
  command.add_flag("--quiet", words.quiet, "No progress and no summary");
  command.parse_complete_callback([&words, boundary, continuity, of_holes] {
    if (of_holes.relief && words.relief == "continued" && (words.flow == "none" || words.mode != "steady"))
      throw CLI::ValidationError("--relief", "has no effect with --flow " + words.flow + " --mode " + words.mode +
                                                 ": it is for flows with --mode steady");
    if (words.flow == "mmcvf" && words.mode == "steady") return;
    for (const CLI::Option* option : {boundary, continuity, of_holes.edges})
      if (option && option->count() > 0)
        throw CLI::ValidationError(option->get_name(), "has no effect with --flow " + words.flow + " --mode " +
                                                           words.mode + ": it is for mmcvf with --mode steady");
  });
}

EvolutionOptions evolution_of(const FlowWords& words, FlowKind flow) {
  EvolutionOptions options;
  options.flow = flow;
  options.boundary = value_named(boundary_names, words.boundary).value();
  options.continuity = value_named(continuity_names, words.continuity).value();
  options.mode = value_named(mode_names, words.mode).value();
  options.solver = value_named(solver_names, words.solver).value();
  options.sigma = words.sigma;
  options.relief = {value_named(relief_names, words.relief).value(), words.relief_seed};
  options.edges = value_named(edges_names, words.edges).value();
  if (words.steps > 0) options.max_steps = words.steps;
  return options;
}

FillOptions options_of(const FlowWords& words) {
  FillOptions options;
  options.initial.density = words.density;
  options.evolution.reset();
  if (const auto flow = value_named(flow_names, words.flow)) options.evolution = evolution_of(words, *flow);
  return options;
}

}  // namespace loopmend
