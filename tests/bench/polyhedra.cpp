// SPDX-License-Identifier: GPL-3.0-or-later
// loopmend_polyhedra: every job on small polyhedra with openings, with all flows, modes, boundary and continuity options. A
// run counts as bad if the program ends by a signal or a sanitizer, or what it says or leaves behind cannot be true.
#include "core/error.h"
#include "mesh/region.h"
#include "neighborhood/trim_boundary.h"
#include "pipeline/blend.h"
#include "pipeline/compare.h"
#include "pipeline/evolve_patch.h"
#include "pipeline/fill_holes.h"
#include "pipeline/interpolate.h"
#include "support/small_polyhedra.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <cstring>
#include <optional>

using namespace loopmend;
using namespace loopmend::test;

namespace {

struct NamedOptions {
  std::string name;
  std::optional<EvolutionOptions> evolution;
};

/// Flows with modes; MMCVF with every boundary and continuity.
std::vector<NamedOptions> all_options() {
  std::vector<NamedOptions> result{{"none", std::nullopt}};
  for (FlowKind flow : {FlowKind::mmcvf, FlowKind::wf, FlowKind::sdf, FlowKind::mcf})
    for (EvolutionMode mode : {EvolutionMode::steady, EvolutionMode::steps})
      for (double sigma : {1.0, 1000.0}) {
        if (mode == EvolutionMode::steady && sigma > 1) continue;
        EvolutionOptions options;
        options.flow = flow;
        options.mode = mode;
        options.sigma = sigma;
        options.max_steps = mode == EvolutionMode::steps ? 8 : 30;
        const std::string name = std::string(flow == FlowKind::mmcvf ? "mmcvf"
                                             : flow == FlowKind::wf  ? "wf"
                                             : flow == FlowKind::sdf ? "sdf"
                                                                     : "mcf") +
                                 (mode == EvolutionMode::steady ? " steady" : " steps sigma " + std::to_string(sigma));
        result.push_back({name, options});
        if (flow != FlowKind::mmcvf || mode != EvolutionMode::steady) continue;
        for (BoundaryTrust boundary : {BoundaryTrust::automatic, BoundaryTrust::exact, BoundaryTrust::robust})
          for (SeamContinuity continuity :
               {SeamContinuity::position, SeamContinuity::tangent, SeamContinuity::curvature}) {
            options.boundary = boundary;
            options.continuity = continuity;
            result.push_back({name + " boundary " + std::to_string(static_cast<int>(boundary)) + " continuity " +
                                  std::to_string(static_cast<int>(continuity)),
                              options});
          }
      }
  return result;
}

/// Why a result cannot be true; empty if it can.
std::string flaw_of(const TriangleSoup& before, const TriangleSoup& after) {
  if (after.points.size() < before.points.size() || after.triangles.size() < before.triangles.size())
    return "something of the input is gone";
  if (!before.points.empty() &&
      std::memcmp(before.points.data(), after.points.data(), before.points.size() * sizeof(Vec3)) != 0)
    return "a vertex of the input has moved";
  for (const Vec3& p : after.points)
    if (!p.allFinite()) return "a vertex is not finite";
  return "";
}

std::string run_fill(const TriangleSoup& soup, const NamedOptions& options, double density) {
  SurfaceModel model = make_surface_model(soup);
  std::vector<BoundaryLoop> loops;
  const std::vector<BoundaryLoop> all = find_boundary_loops(model);
  for (const BoundaryLoop& loop : all)
    if (loop.kind == LoopKind::hole || loop.kind == LoopKind::outer_rim) loops.push_back(loop);
  FillOptions fill;
  fill.initial.density = density;
  fill.evolution = options.evolution;
  const TriangleSoup before = model.soup;
  const std::vector<HoleResult> results = fill_holes(model, loops, fill, nullptr, CancelToken());
  if (results.size() != loops.size()) return "not one result for each loop";
  std::size_t filled = 0;
  for (const HoleResult& result : results) {
    filled += is_filled(result.status);
    if (is_filled(result.status) == result.method().empty()) return "status and method disagree";
    if (result.status == PatchStatus::failed && result.message.empty()) return "a failure without a reason";
    const bool flow_ran = result.method() != "initial_patch" && result.method() != "robust_fairing" &&
                          result.method() != "linear_fairing";
    if (result.status == PatchStatus::converged && !flow_ran) return "converged where no flow ran";
  }
  const std::size_t open = find_boundary_loops(make_surface_model(model.soup)).size();
  if (open > all.size() - filled) return "a loop is open that was said to be filled";
  return flaw_of(before, model.soup);
}

std::string run_blend(const TriangleSoup& soup, const NamedOptions& options, double) {
  SurfaceModel model = make_surface_model(soup);
  std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  std::erase_if(
      loops, [](const BoundaryLoop& loop) { return loop.kind != LoopKind::hole && loop.kind != LoopKind::outer_rim; });
  if (loops.size() < 2) return "";
  FillOptions fill;
  fill.evolution = options.evolution;
  const TriangleSoup before = model.soup;
  const BlendResult result = blend_loops(model, loops, fill, CancelToken());
  if (result.outcome.status == PatchStatus::failed && result.outcome.message.empty())
    return "a failure without a reason";
  return flaw_of(before, model.soup);
}

std::string run_region(const TriangleSoup& soup, const NamedOptions& options, double) {
  if (!options.evolution) return "";
  const SurfaceModel model = make_surface_model(soup);
  const Region region = make_region(model, {soup.triangles.back()[0], soup.triangles.back()[1]});
  const PatchResult evolved = evolve_patch(region.patch, *options.evolution, nullptr, CancelToken());
  for (const Vec3& p : evolved.patch.positions)
    if (!p.allFinite()) return "a vertex is not finite";
  return "";
}

std::string run_compare(const TriangleSoup& soup, const NamedOptions& options, double density) {
  if (!options.evolution) return "";
  const SurfaceModel model = make_surface_model(soup);
  std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  std::erase_if(loops, [](const BoundaryLoop& loop) { return loop.kind != LoopKind::hole; });
  if (loops.empty()) return "";
  const InitialPatch start = make_initial_patch(model, loops, {density}, CancelToken());
  if (!start.patch || start.patch->free_count == 0) return "";
  const FlowComparison comparison = compare_flows(*start.patch, *options.evolution, nullptr, CancelToken());
  for (const ComparedFlow& run : comparison.runs)
    for (const Vec3& p : run.outcome.patch.positions)
      if (!p.allFinite()) return "a vertex is not finite";
  return "";
}

std::string run_points(const TriangleSoup& soup, const NamedOptions& options, double) {
  SubdivisionOptions subdivision;
  subdivision.subdivisions = 1;
  subdivision.boundary = PolyhedronBoundary::smooth;
  const Interpolation result =
      interpolate_points(make_surface_model(soup), subdivision, options.evolution, CancelToken());
  for (const Vec3& p : result.surface.points)
    if (!p.allFinite()) return "a vertex is not finite";
  return "";
}

std::string run_trim(const TriangleSoup& soup, const NamedOptions& options, double density) {
  const SurfaceModel model = make_surface_model(soup);
  const TrimmedModel trimmed = trim_boundary(model, find_boundary_loops(model), 2);
  return run_fill(trimmed.model.soup, options, density);
}

struct Job {
  std::string name;
  std::string (*run)(const TriangleSoup&, const NamedOptions&, double density);
};

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("Runs every job on small polyhedra with openings.");
  int from = 0, every = 1;
  bool names = false;
  app.add_option("--from", from, "First run");
  app.add_option("--every", every, "Only every so-manieth run")->check(CLI::PositiveNumber);
  app.add_flag("--names", names, "Name each run before it starts, to find the one that ends the program");
  CLI11_PARSE(app, argc, argv);

  const std::vector<Job> jobs{{"fill", run_fill},       {"blend", run_blend},   {"evolve", run_region},
                              {"compare", run_compare}, {"points", run_points}, {"trim and fill", run_trim}};
  const std::vector<NamedMesh> meshes = small_polyhedra();
  const std::vector<NamedOptions> options = all_options();
  int number = 0, runs = 0, bad = 0, refused = 0;
  for (const Job& job : jobs)
    for (const NamedMesh& mesh : meshes)
      for (const NamedOptions& option : options)
        for (double density : {1.0, 3.0}) {
          const bool dense = density > 1;
          if (dense && job.name != "fill") continue;
          if (job.name == "compare" && option.name.find("boundary") != std::string::npos) continue;
          const int own = number++;
          if (own < from || own % every != 0) continue;
          if (names)
            std::fprintf(stderr, "%d: %s, %s, %s, density %g\n", own, job.name.c_str(), mesh.name.c_str(),
                         option.name.c_str(), density);
          std::string flaw;
          try {
            flaw = job.run(mesh.soup, option, density);
          } catch (const Error&) {
            ++refused;  // a typed error with its sentence is an answer
          } catch (const std::exception& error) {
            flaw = error.what();
          }
          ++runs;
          if (flaw.empty()) continue;
          ++bad;
          std::printf("%d: %s, %s, %s, density %g: %s\n", own, job.name.c_str(), mesh.name.c_str(), option.name.c_str(),
                      density, flaw.c_str());
        }
  std::printf("%d runs, %d bad, %d refused with a reason\n", runs, bad, refused);
  return bad == 0 && runs > 0 ? 0 : 1;
}
