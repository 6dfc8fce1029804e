// SPDX-License-Identifier: GPL-3.0-or-later
#include "words.h"

namespace loopmend {

// The words of app/cli/flow_words.cpp.
GroupOptions group_options(const pybind11::dict& options) {
  GroupOptions result;
  result.initial.density = option<double>(options, "density");
  check(result.initial);
  EvolutionOptions evolution;
  const auto flow = worded<std::optional<FlowKind>>(options, "flow",
                                                    {{"mmcvf", FlowKind::mmcvf},
                                                     {"wf", FlowKind::wf},
                                                     {"sdf", FlowKind::sdf},
                                                     {"mcf", FlowKind::mcf},
                                                     {"none", std::nullopt}});
  evolution.flow = flow.value_or(evolution.flow);
  evolution.boundary = worded<BoundaryTrust>(
      options, "boundary",
      {{"auto", BoundaryTrust::automatic}, {"exact", BoundaryTrust::exact}, {"robust", BoundaryTrust::robust}});
  evolution.continuity = worded<SeamContinuity>(options, "continuity",
                                                {{"position", SeamContinuity::position},
                                                 {"tangent", SeamContinuity::tangent},
                                                 {"curvature", SeamContinuity::curvature}});
  evolution.mode =
      worded<EvolutionMode>(options, "mode", {{"steady", EvolutionMode::steady}, {"steps", EvolutionMode::steps}});
  evolution.solver = worded<SolverKind>(
      options, "solver",
      {{"auto", SolverKind::automatic}, {"direct", SolverKind::direct}, {"gmres", SolverKind::gmres}});
  evolution.sigma = option<double>(options, "sigma");
  if (!options["steps"].is_none()) evolution.max_steps = option<int>(options, "steps");
  evolution.relief = {
      worded<ReliefChoice::Kind>(
          options, "relief", {{"smooth", ReliefChoice::Kind::smooth}, {"continued", ReliefChoice::Kind::continued}}),
      option<std::uint64_t>(options, "relief_seed")};
  evolution.edges =
      worded<SharpEdges>(options, "edges", {{"auto", SharpEdges::continued}, {"round", SharpEdges::rounded}});
  check(evolution);
  result.evolution.reset();
  if (flow) result.evolution = evolution;
  return result;
}

}  // namespace loopmend
