// SPDX-License-Identifier: GPL-3.0-or-later
#include "words.h"

namespace loopmend {

GroupOptions group_options(const pybind11::dict& options) {
  GroupOptions result;
  result.initial.density = option<double>(options, "density");
  check(result.initial);
  EvolutionOptions evolution;
  const auto flow = option<std::string>(options, "flow");
  const bool flows = flow != "none";
  if (flows && !value_named(flow_names, flow))
    throw InvalidArgument(say("flow takes one of mmcvf, wf, sdf, mcf, none, not '%1'", flow));
  if (flows) evolution.flow = named(options, "flow", flow_names);
  evolution.boundary = named(options, "boundary", boundary_names);
  evolution.continuity = named(options, "continuity", continuity_names);
  evolution.mode = named(options, "mode", mode_names);
  evolution.solver = named(options, "solver", solver_names);
  evolution.sigma = option<double>(options, "sigma");
  if (!options["steps"].is_none()) evolution.max_steps = option<int>(options, "steps");
  evolution.relief = {named(options, "relief", relief_names), option<std::uint64_t>(options, "relief_seed")};
  evolution.edges = named(options, "edges", edges_names);
  check(evolution);
  result.evolution.reset();
  if (flows) result.evolution = evolution;
  return result;
}

}  // namespace loopmend
