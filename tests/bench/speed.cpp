// SPDX-License-Identifier: GPL-3.0-or-later
// loopmend_speed: how long forming, factoring, solving, a step, the steady state and a whole fill take, for the sizes of
// the paper's Table 5.1 and from 10 thousand free vertices on; beside CGAL's fairing of the same patch and its whole call
// on the same hole. The arguments are those of Google Benchmark (--benchmark_filter, --benchmark_out), and:
//   --large          also 100k, 250k and 1M free vertices (needs some 12 GB and many minutes)
//   --cpu            processor time of all threads instead of time on the wall: for a machine that is not idle
//   --markdown FILE  tables with ratios and growth exponents
#include "core/memory.h"
#include "evolution/evolution.h"
#include "flows/decay_rate.h"
#include "flows/flow_terms.h"
#include "flows/gauss_newton.h"
#include "memory_use.h"
#include "operators/topology.h"
#include "peers.h"
#include "ringed_cap.h"
#include "solvers/linear_solver.h"
#include "speed_report.h"
#include "stopwatch.h"

#include <benchmark/benchmark.h>

#include <cstring>
#include <map>
#include <memory>

namespace {

using namespace loopmend;
using namespace loopmend::bench;

constexpr double hole_angle = 0.7;  ///< radians: a cap of 64 % of the sphere's diameter
constexpr int surrounding_rings = 8;

/// The cap of one size, and its patch; only the last is kept.
struct Sized {
  explicit Sized(int free)
      : cap(make_ringed_cap(free, hole_angle, surrounding_rings)),
        patch(make_patch(cap.problem.model, cap.problem.loops, {cap.initial_patch})) {}
  RingedCap cap;
  Patch patch;
};

const Sized& sized(int free) {
  static std::unique_ptr<Sized> kept;
  if (!kept || kept->patch.free_count != free) {
    kept.reset();
    kept = std::make_unique<Sized>(free);
  }
  return *kept;
}

/// Most memory of the measurement beyond what was there before, bytes.
std::map<std::string, double>& memory_book() {
  static std::map<std::string, double> book;
  return book;
}

std::string key_of(const char* name, const benchmark::State& state) { return name + std::to_string(state.range(0)); }

/// Times work() alone. The first time, which is reported only where a measurement is made once, its memory is noted as
/// well: for that all free pages are given back, and to get them again takes time that CGAL's calls do not need either.
template <class Work>
void measure_once(benchmark::State& state, const char* name, const Work& work) {
  const std::string key = key_of(name, state);
  const bool first = memory_book().count(key) == 0;
  if (first) start_memory_peak();
  const double before = first ? memory_now() : 0;
  const Stopwatch watch;
  work();
  state.SetIterationTime(watch.seconds());
  if (first) memory_book()[key] = memory_peak() - before;
}

void note_memory(benchmark::State& state, const char* name) {
  const double bytes = memory_book()[key_of(name, state)];
  state.counters["bytes"] = bytes;
  state.counters["bytes_per_vertex"] = bytes / static_cast<double>(state.range(0));
}

OperatorSet operators_of(const Patch& patch) {
  std::vector<char> wanted(patch.vertex_count());
  for (int i = 0; i < patch.vertex_count(); ++i) wanted[i] = patch.ring[i] <= flow_reach;
  return compute_operators(patch.positions, patch.triangles, Topology(patch.vertex_count(), patch.triangles),
                           Stencil::two_ring, wanted);
}

SparseMatrix step_matrix(const Patch& patch, const GaussNewtonSystem& system) {
  constexpr double sigma = 500;
  const SparseMatrix mass(system.mass.asDiagonal());
  return system.curvature() + slowest_decay_rate(FlowKind::mmcvf, patch) / (2 * sigma) * mass;
}

/// Fits, operators and the matrix of one Gauss-Newton step.
void form(benchmark::State& state) {
  const Patch& patch = sized(static_cast<int>(state.range(0))).patch;
  for (auto _ : state)
    measure_once(state, "form", [&] {
      benchmark::DoNotOptimize(assemble_gauss_newton(patch, operators_of(patch), {1, 0}).curvature());
    });
  note_memory(state, "form");
}

/// Symbolic and numeric factorisation, as at the first step.
void factor(benchmark::State& state) {
  const Patch& patch = sized(static_cast<int>(state.range(0))).patch;
  const SparseMatrix A = step_matrix(patch, assemble_gauss_newton(patch, operators_of(patch), {1, 0}));
  for (auto _ : state) {
    const std::unique_ptr<SpdSolver> solver = make_spd_solver();
    measure_once(state, "factor", [&] {
      if (!solver->factorize(A)) state.SkipWithError("not positive definite");
    });
  }
  note_memory(state, "factor");
}

void solve(benchmark::State& state) {
  const Patch& patch = sized(static_cast<int>(state.range(0))).patch;
  const GaussNewtonSystem system = assemble_gauss_newton(patch, operators_of(patch), {1, 0});
  const std::unique_ptr<SpdSolver> solver = make_spd_solver();
  if (!solver->factorize(step_matrix(patch, system))) return state.SkipWithError("not positive definite");
  Eigen::MatrixXd s;
  for (auto _ : state) measure_once(state, "solve", [&] { solver->solve(-system.half_gradient, s); });
}

/// The flow as far as `options` say, from the bump; making the evolution is not counted.
void evolve(benchmark::State& state, const char* name, const EvolutionOptions& options) {
  const Patch& patch = sized(static_cast<int>(state.range(0))).patch;
  std::size_t steps = 0;
  double energy_left = 1;
  std::string ending;
  for (auto _ : state) {
    Evolution evolution(patch, options);
    measure_once(state, name, [&] { evolution.run(nullptr, {}); });
    steps = evolution.history().size();
    energy_left = evolution.energy() / evolution.initial_energy();
    ending = to_string(evolution.status());
  }
  note_memory(state, name);
  state.counters["steps"] = static_cast<double>(steps);
  state.counters["energy_left"] = energy_left;
  state.SetLabel(ending);
}

EvolutionOptions one_step_of(EvolutionMode mode) {
  EvolutionOptions options;
  options.mode = mode;
  options.max_steps = 1;
  options.start = SteadyStart::as_given;
  options.bending = 0.0;
  return options;
}

/// Seconds per step of the paper's scheme, over ten: the first factors, the others mostly need not.
void flow_steps(benchmark::State& state) {
  const Patch& patch = sized(static_cast<int>(state.range(0))).patch;
  EvolutionOptions options = one_step_of(EvolutionMode::steps);
  options.max_steps = 10;
  for (auto _ : state) {
    Evolution evolution(patch, options);
    const Stopwatch watch;
    evolution.run(nullptr, {});
    state.SetIterationTime(watch.seconds() / static_cast<double>(std::max<std::size_t>(1, evolution.history().size())));
    state.counters["steps"] = static_cast<double>(evolution.history().size());
  }
}

EvolutionOptions to_the_end() {
  EvolutionOptions options;
  options.bending = 0.0;
  return options;
}

/// The one call: initial patch, remeshing, flow, checks, report, paste.
void fill(benchmark::State& state) {
  const HoleProblem& problem = sized(static_cast<int>(state.range(0))).cap.problem;
  Filling filling;
  for (auto _ : state) measure_once(state, "fill", [&] { filling = fill_by_engine(problem); });
  note_memory(state, "fill");
  state.counters["new"] = static_cast<double>(filling.points.size());
  state.counters["steps"] = filling.steps;
  state.SetLabel(filling.status);
}

void peer_fill(benchmark::State& state, Peer peer) {
  const HoleProblem& problem = sized(static_cast<int>(state.range(0))).cap.problem;
  Filling filling;
  for (auto _ : state) {
    filling = fill_by_peer(problem, peer);
    state.SetIterationTime(filling.seconds);
  }
  state.counters["new"] = static_cast<double>(filling.points.size());
  state.SetLabel(filling.status);
}

/// CGAL's fairing alone, on our patch.
void peer_fair(benchmark::State& state, unsigned continuity) {
  const Patch& patch = sized(static_cast<int>(state.range(0))).patch;
  for (auto _ : state) {
    const double seconds = seconds_of_cgal_fairing(patch.positions, patch.triangles, patch.free_count, continuity);
    if (seconds < 0) return state.SkipWithError("CGAL failed");
    state.SetIterationTime(seconds);
  }
}

void add(const std::string& name, const std::vector<int>& sizes, const std::function<void(benchmark::State&)>& run) {
  for (int free : sizes)
    benchmark::RegisterBenchmark(name.c_str(), run)->Arg(free)->UseManualTime()->Unit(benchmark::kMillisecond);
}

void register_all(bool large) {
  std::vector<int> sizes = table_sizes();
  for (int free : {500, 5000, 10000, 50000}) sizes.push_back(free);
  std::vector<int> moderate = sizes;  // what the flow and the peers are asked for
  if (large) sizes.insert(sizes.end(), {100000, 250000, 1000000});
  if (large) moderate.push_back(100000);
  std::vector<int> steady = sizes;
  if (large) steady.pop_back();  // a million: one step, not the steady state
  // Grouped by size, so that each cap is built once.
  for (int free : sizes) {
    const auto has = [free](const std::vector<int>& list) {
      return std::find(list.begin(), list.end(), free) != list.end();
    };
    add("form", {free}, form);
    add("factor", {free}, factor);
    add("solve", {free}, solve);
    add("step", {free}, [](benchmark::State& s) { evolve(s, "step", one_step_of(EvolutionMode::steady)); });
    if (has(moderate)) {
      add("flow_step", {free}, [](benchmark::State& s) { evolve(s, "flow_step", one_step_of(EvolutionMode::steps)); });
      add("flow_steps", {free}, flow_steps);
    }
    if (has(steady)) add("steady", {free}, [](benchmark::State& s) { evolve(s, "steady", to_the_end()); });
    if (has(steady)) add("fill", {free}, fill);
    if (!has(moderate)) continue;
    add("cgal_c1_fair", {free}, [](benchmark::State& s) { peer_fair(s, 1); });
    add("cgal_c2_fair", {free}, [](benchmark::State& s) { peer_fair(s, 2); });
    add("cgal_c1_fill", {free}, [](benchmark::State& s) { peer_fill(s, Peer::cgal_c1); });
    add("cgal_c2_fill", {free}, [](benchmark::State& s) { peer_fill(s, Peer::cgal_c2); });
  }
}

/// Takes our own options out of the command line.
std::string take_option(int& argc, char** argv, const char* name, bool with_value) {
  for (int i = 1; i < argc; ++i) {
    if (std::strcmp(argv[i], name) != 0) continue;
    const int taken = with_value && i + 1 < argc ? 2 : 1;
    const std::string value = taken == 2 ? argv[i + 1] : "yes";
    std::copy(argv + i + taken, argv + argc, argv + i);
    argc -= taken;
    return value;
  }
  return "";
}

}  // namespace

int main(int argc, char** argv) try {
  keep_freed_memory();
  const bool large = !take_option(argc, argv, "--large", false).empty();
  const bool cpu = !take_option(argc, argv, "--cpu", false).empty();
  if (cpu) measure_by(TimeSource::processor);
  const std::string markdown = take_option(argc, argv, "--markdown", true);
  register_all(large);
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  SpeedReporter reporter;
  benchmark::RunSpecifiedBenchmarks(&reporter);
  reporter.write(markdown, cpu ? "Processor seconds of all threads" : "Seconds");
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "loopmend_speed: %s\n", error.what());
  return 1;
}
