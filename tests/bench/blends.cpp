// SPDX-License-Identifier: GPL-3.0-or-later
// loopmend_blends: random sets of tubes joined by default settings, their seams under refinement, and ring-shaped gaps.
#include "analysis/seam_profile.h"
#include "flows/flow_terms.h"
#include "mesh/quality.h"
#include "pipeline/blend.h"
#include "pipeline/evolve_patch.h"
#include "pipeline/fill_holes.h"
#include "ring_gaps.h"
#include "table.h"
#include "tube_sets.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>

namespace {

using namespace loopmend;
using namespace loopmend::bench;

struct Problem {
  SurfaceModel model;
  std::vector<BoundaryLoop> boundaries;
};

Problem problem_of(const std::vector<TubeShape>& tubes) {
  Problem problem;
  std::vector<TriangleSoup> parts;
  for (const TubeShape& tube : tubes) parts.push_back(make_tube(tube));
  problem.model = make_surface_model(joined(parts));
  const std::vector<BoundaryLoop> all = find_boundary_loops(problem.model);
  for (const TubeShape& tube : tubes)
    problem.boundaries.push_back(
        *std::min_element(all.begin(), all.end(), [&](const BoundaryLoop& a, const BoundaryLoop& b) {
          return (a.center - tube.start).norm() < (b.center - tube.start).norm();
        }));
  return problem;
}

double worst_jump(const std::vector<SeamReport>& seams) {
  double worst = 0;
  for (const SeamReport& seam : seams) worst = std::max(worst, seam.h_jump_rms_times_diameter);
  return worst;
}

std::string size_text(std::size_t value) { return std::to_string(value); }

constexpr double visible_crease = 5;  ///< degrees at a seam, as the message of a blend has it

void run_sets(std::uint64_t first, int count) {
  struct Shares {
    std::array<int, 3> endings{};  ///< finished, valid only, neither
    int bent = 0, creased = 0;
  };
  std::map<std::string, Shares> shares;
  Table table({"seed", "tubes", "angles", "radii", "status", "free", "steps", "bending", "min angle", "jump x D", "s",
               "message"});
  for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count); ++seed) {
    const TubeSet set = make_tube_set(seed);
    Problem problem = problem_of(set.tubes);
    const BlendResult result = blend_loops(problem.model, problem.boundaries, {}, {});
    const bool valid = result.outcome.status != PatchStatus::failed && result.outcome.validity.folds == 0 &&
                       result.outcome.validity.intersections == 0;
    const bool finished =
        result.outcome.status == PatchStatus::converged || result.outcome.status == PatchStatus::faired;
    const int ending = !valid ? 2 : finished ? 0 : 1;
    const bool creased = std::any_of(result.outcome.seams.begin(), result.outcome.seams.end(),
                                     [](const SeamReport& seam) { return seam.g1_rms_deg > visible_crease; });
    const auto add = [&](Shares& group) {
      ++group.endings[static_cast<std::size_t>(ending)];
      group.bent += result.outcome.bending > 0;
      group.creased += creased;
    };
    for (const std::string& group :
         {std::string("all"), size_text(set.tubes.size()) + " tubes", set.angles + " angles", set.radii + " radii"})
      add(shares[group]);
    table.add({std::to_string(seed), size_text(set.tubes.size()), set.angles, set.radii,
               to_string(result.outcome.status), number(result.outcome.patch.free_count), number(result.outcome.steps),
               number(result.outcome.bending), number(result.outcome.validity.min_angle_deg),
               number(worst_jump(result.outcome.seams)), number(result.outcome.seconds.total),
               result.outcome.message.english()});
    std::fprintf(stderr, "seed %d: %s, %d steps\n", static_cast<int>(seed), to_string(result.outcome.status),
                 result.outcome.steps);
  }
  Table summary({"problems", "converged or faired", "valid, not converged", "invalid or refused", "with bending energy",
                 "with a crease"});
  for (const auto& [group, n] : shares)
    summary.add(
        {group, number(n.endings[0]), number(n.endings[1]), number(n.endings[2]), number(n.bent), number(n.creased)});
  std::printf("%s", summary.markdown().c_str());
  std::fprintf(stderr, "%s", table.markdown().c_str());
}

/// Every step of the flow from each of its starts.
void trace(std::uint64_t seed) {
  const TubeSet set = make_tube_set(seed);
  const Problem problem = problem_of(set.tubes);
  const BridgeOutcome outcome = bridge_loops(problem.model, problem.boundaries, {}, {});
  if (!outcome.bridge) {
    std::printf("%s\n", outcome.message.english().c_str());
    return;
  }
  const Validity& quality = outcome.bridge->quality;
  std::printf("start: %d folds, %d cuts, min angle %.1f\n", quality.folds, quality.intersections,
              quality.min_angle_deg);
  const auto run = [](const Patch& patch, SteadyStart start) {
    EvolutionOptions options;
    options.start = start;
    const PatchResult evolved =
        run_flow(patch, options,
                 [](const Evolution& evolution, const StepRecord& step) {
                   const Patch& p = evolution.patch();
                   std::printf("%3d  E %-10.5g  sigma %-8.3g  move %-8.3g  %d rejected  %d free, min angle %.1f\n",
                               step.step, step.energy, step.sigma, step.max_move, step.rejections, p.free_count,
                               min_angle_deg(p.positions, p.triangles, p.patch_triangles));
                 },
                 {});
    std::printf("%s: %s, %d folds, %d cuts, min angle %.1f\n", evolved.message.english().c_str(),
                to_string(evolved.status), evolved.validity.folds, evolved.validity.intersections,
                evolved.validity.min_angle_deg);
    return evolved.patch;
  };
  for (SteadyStart start : {SteadyStart::faired, SteadyStart::evenly_faired, SteadyStart::as_given})
    run(outcome.bridge->start, start);
}

/// The jump of H at the seams when the edges are halved, and halved again.
void run_refinement(std::uint64_t first, int count) {
  Table table({"seed", "tubes", "flow", "edges 1", "1/2", "1/4", "close fits, edges 1", "1/2", "1/4"});
  for (std::uint64_t seed = first; seed < first + static_cast<std::uint64_t>(count); ++seed)
    for (FlowKind flow : {FlowKind::sdf, FlowKind::wf, FlowKind::mmcvf}) {
      std::vector<std::string> wide, close;
      std::size_t tubes = 0;
      for (int finer : {1, 2, 4}) {
        const TubeSet set = make_tube_set(seed, finer);
        tubes = set.tubes.size();
        Problem problem = problem_of(set.tubes);
        FillOptions options;
        options.evolution->flow = flow;
        const BlendResult result = blend_loops(problem.model, problem.boundaries, options, {});
        const bool good = result.outcome.status == PatchStatus::converged;
        wide.push_back(good ? number(wide_curvature_jump(result.outcome.patch)) : to_string(result.outcome.status));
        double square = 0;
        for (const SeamReport& seam : result.outcome.seams)
          square += seam.h_jump_rms * seam.h_jump_rms / static_cast<double>(result.outcome.seams.size());
        close.push_back(good ? number(std::sqrt(square)) : to_string(result.outcome.status));
      }
      std::vector<std::string> row{std::to_string(seed), size_text(tubes), to_string(flow)};
      row.insert(row.end(), wide.begin(), wide.end());
      row.insert(row.end(), close.begin(), close.end());
      table.add(row);
      std::fprintf(stderr, "seed %d %s\n", static_cast<int>(seed), to_string(flow));
    }
  std::printf("%s\n", table.markdown().c_str());
}

}  // namespace

int main(int argc, char** argv) try {
  CLI::App app("Blends of random tubes, their seams under refinement, ring-shaped gaps.", "loopmend_blends");
  std::uint64_t seed = 0;
  int count = 64, refine = 0;
  bool rings = false;
  std::optional<std::uint64_t> one;
  app.add_option("--one", one, "Every step of this set alone");
  app.add_option("--count", count, "Sets of tubes (64); sixteen in a row hold every combination");
  app.add_option("--seed", seed, "Seed of the first; the others follow by one (0)");
  app.add_option("--refine", refine, "So many sets are also solved with edges of a half and a quarter (0)");
  app.add_flag("--rings", rings, "Ring-shaped gaps too");
  CLI11_PARSE(app, argc, argv);
  if (one) {
    trace(*one);
    return 0;
  }
  if (count > 0) run_sets(seed, count);
  if (refine > 0) run_refinement(seed, refine);
  if (rings) std::printf("%s\n", run_ring_gaps().markdown().c_str());
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "loopmend_blends: %s\n", error.what());
  return 1;
}
