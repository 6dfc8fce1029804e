// SPDX-License-Identifier: GPL-3.0-or-later
// loopmend-stress: hundreds of random hole problems, default settings; which share is filled validly, and why not.
#include "core/threads.h"
#include "filling_result.h"
#include "io/write_mesh.h"
#include "isolated_runs.h"
#include "mesh/mesh_arrays.h"
#include "output_check.h"
#include "region_cut.h"
#include "scans.h"
#include "stress_problem.h"
#include "table.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cstdio>
#include <map>
#include <optional>
#include <sstream>

namespace {

using namespace loopmend;
using namespace loopmend::bench;

struct Arguments {
  int count = 500, jobs = 1;
  std::uint64_t seed = 1;
  std::optional<std::uint64_t> one;
  double time_limit = 300;
  std::string save, markdown, csv;
};

/// How a problem ended, from good to bad.
enum class Ending { finished, not_finished, refused, invalid };

const char* to_string(Ending ending) {
  switch (ending) {
    case Ending::finished: return "at its end";
    case Ending::not_finished: return "valid, stalled";
    case Ending::refused: return "refused";
    case Ending::invalid: return "invalid";
  }
  return "";
}

struct Outcome {
  std::uint64_t seed = 0;
  std::string surface = "?", shape = "?", mesh = "?";
  double size = 0, seconds = 0;
  int removed = 0, added = 0;
  Ending ending = Ending::invalid;
  double d = 0;  ///< rms distance from the answer, 1e-3 diameters; 0 where the equation has another one
  std::string reason;
  std::string attempt = "none";  ///< Filling::attempt
};

/// Where the surface turns back by more than 150 degrees, though the smallest triangulation of the boundary does not.
int count_folds_of_its_own(const HoleProblem& problem, const Filling& filling) {
  TriangleSoup given;
  given.points = points_of(problem.model.mesh);
  given.triangles = triangles_of(problem.model.mesh);
  TriangleSoup filled = given;
  filled.points.insert(filled.points.end(), filling.points.begin(), filling.points.end());
  filled.triangles.insert(filled.triangles.end(), filling.triangles.begin(), filling.triangles.end());
  int folds = 0;
  for (const FilledPart& part : check_output(given, filled).parts) folds += part.folds;
  return folds;
}

/// Empty if the patch is what a user may be given.
std::string what_is_invalid(const HoleProblem& problem, const Filling& filling, const PatchFigures& figures) {
  constexpr double farthest = 2.5;      // loop diameters
  constexpr double tiny_energy = 1e-6;  // ∫‖∇H‖² times the diameter squared
  if (!filling.exterior_unchanged) return "the neighborhood was changed";
  if (!(figures.reach < farthest)) return "unbounded: " + number(figures.reach) + " diameters away";
  if (figures.cuts > 0) return number(figures.cuts) + " self-intersections";
  if (figures.folds > 0)
    if (const int folds = count_folds_of_its_own(problem, filling)) return number(folds) + " folded edges";
  const double unit = problem.diameter() * problem.diameter();
  if (filling.energy_after > filling.energy_before * (1 + 1e-9) && filling.energy_after * unit > tiny_energy)
    return "the energy rose from " + number(filling.energy_before * unit) + " to " +
           number(filling.energy_after * unit);
  return "";
}

void judge(const HoleProblem& problem, const Filling& filling, Outcome& outcome) {
  if (!filling.complete) {
    const bool changed = !filling.exterior_unchanged || !filling.triangles.empty();
    outcome.ending = changed || filling.message.empty() ? Ending::invalid : Ending::refused;
    outcome.reason = changed ? "refused, but the model was changed: " + filling.message : filling.message;
    return;
  }
  const PatchFigures figures = measure(problem, filling);
  outcome.d = figures.d_rms;
  const std::string fault = what_is_invalid(problem, filling, figures);
  // Without a free vertex there is nothing that could converge.
  const bool at_end = filling.status == "converged" || filling.status == "early_stop" || filling.status == "faired" ||
                      filling.points.empty();
  outcome.ending = !fault.empty() ? Ending::invalid : at_end ? Ending::finished : Ending::not_finished;
  outcome.reason = !fault.empty() ? fault : at_end ? "" : filling.status + ": " + filling.message;
}

/// As one line for the pipe, fields in the order of Outcome.
std::string to_line(const Outcome& o) {
  std::ostringstream line;
  line << o.seed << '\t' << o.surface << '\t' << o.shape << '\t' << o.mesh << '\t' << o.size << '\t' << o.seconds
       << '\t' << o.removed << '\t' << o.added << '\t' << static_cast<int>(o.ending) << '\t' << o.d << '\t' << o.reason
       << '\t' << o.attempt << '\n';
  return line.str();
}

Outcome from_line(const std::string& text) {
  std::vector<std::string> f;
  std::istringstream line(text);
  for (std::string field; std::getline(line, field, '\t');) f.push_back(field.substr(0, field.find('\n')));
  f.resize(12);
  return {std::stoull(f[0]),
          f[1],
          f[2],
          f[3],
          std::stod(f[4]),
          std::stod(f[5]),
          std::stoi(f[6]),
          std::stoi(f[7]),
          static_cast<Ending>(std::stoi(f[8])),
          std::stod(f[9]),
          f[10],
          f[11]};
}

void save(const std::string& folder, std::uint64_t seed, const HoleProblem& problem, const Filling& filling) {
  if (folder.empty()) return;
  std::filesystem::create_directories(folder);
  const std::string stem = folder + "/" + std::to_string(seed);
  TriangleSoup soup = problem.model.soup;
  write_mesh(stem + "_open.ply", soup);
  // Vertices of view and soup are the same on these surfaces.
  soup.points.insert(soup.points.end(), filling.points.begin(), filling.points.end());
  soup.triangles.insert(soup.triangles.end(), filling.triangles.begin(), filling.triangles.end());
  write_mesh(stem + "_filled.ply", soup);
}

/// Where the scan itself is at fault, a refusal may well be true.
std::string note_on_original(const StressProblem& made, Ending ending) {
  if (ending == Ending::finished) return "";
  const OriginalFaults faults = faults_of_original(made.removed, made.problem.model.soup);
  if (faults.cuts + faults.folds == 0) return "";
  return " (the original there: " + number(faults.cuts) + " self-intersections, " + number(faults.folds) + " folds)";
}

/// Says what the problem is before it is tried, and how it ended after.
void run_seed(std::uint64_t seed, const Arguments& arguments, const Say& say) {
  Outcome outcome;
  outcome.seed = seed;
  const std::optional<StressProblem> made = make_stress_problem(seed);
  if (!made) throw std::runtime_error("no problem could be made from this seed");
  outcome.surface = made->surface;
  outcome.shape = made->shape;
  outcome.mesh = made->mesh;
  outcome.size = made->size;
  outcome.removed = made->problem.removed;
  say(to_line(outcome));
  const Filling filling = fill_by_engine(made->problem);
  outcome.seconds = filling.seconds;
  outcome.added = static_cast<int>(filling.points.size());
  outcome.attempt = filling.attempt;
  judge(made->problem, filling, outcome);
  if (!made->has_answer || !(outcome.d >= 0)) outcome.d = 0;
  outcome.reason += note_on_original(*made, outcome.ending);
  if (arguments.one || outcome.ending != Ending::finished) save(arguments.save, seed, made->problem, filling);
  say(to_line(outcome));
}

Outcome outcome_of(std::uint64_t seed, const IsolatedResult& result) {
  Outcome outcome;
  outcome.seed = seed;
  std::istringstream lines(result.text);
  for (std::string line; std::getline(lines, line);) outcome = from_line(line);
  if (result.fault.empty()) return outcome;
  outcome.ending = Ending::invalid;
  outcome.reason = result.fault;
  outcome.seconds = result.seconds;
  return outcome;
}

void print(const Outcome& o) {
  std::printf("seed %-6llu %-16s %-15s %-9s %4.0f %%  removed %4d  new %4d  %6.2f s  %s%s%s\n",
              static_cast<unsigned long long>(o.seed), o.surface.c_str(), o.shape.c_str(), o.mesh.c_str(), 100 * o.size,
              o.removed, o.added, o.seconds, to_string(o.ending), o.reason.empty() ? "" : ": ", o.reason.c_str());
  std::fflush(stdout);
}

/// Shares by one property of the problems.
Table shares(const std::string& title, const std::vector<Outcome>& outcomes,
             const std::function<std::string(const Outcome&)>& property) {
  std::map<std::string, std::array<int, 4>> counts;
  for (const Outcome& o : outcomes) {
    ++counts[property(o)][static_cast<int>(o.ending)];
    ++counts["all"][static_cast<int>(o.ending)];
  }
  Table table({title, "problems", "at its end %", "valid, stalled %", "refused %", "invalid %"});
  for (const auto& [name, count] : counts) {
    const int all = count[0] + count[1] + count[2] + count[3];
    std::vector<std::string> row{name, number(all)};
    for (int c : count) row.push_back(number(100.0 * c / all));
    table.add(row);
  }
  return table;
}

std::string size_class(const Outcome& o) {
  return o.size < 0.1 ? "up to 10 %" : o.size < 0.3 ? "10 to 30 %" : o.size < 0.45 ? "30 to 45 %" : "over 45 %";
}

std::string count_class(const Outcome& o) {
  return o.removed < 30 ? "3 to 29" : o.removed < 300 ? "30 to 299" : o.removed < 1500 ? "300 to 1499" : "1500 to 5000";
}

/// The flow may come to rest in a bubble: bounded, smooth, and wrong.
std::string far_ones(const std::vector<Outcome>& outcomes) {
  constexpr double far = 20;
  Table table({"seed", "surface", "shape", "mesh", "size %", "cut away", "d"});
  for (const Outcome& o : outcomes)
    if (o.ending == Ending::finished && o.d > far)
      table.add(
          {std::to_string(o.seed), o.surface, o.shape, o.mesh, number(100 * o.size), number(o.removed), number(o.d)});
  if (table.empty()) return "";
  return "\nConverged on surfaces of constant mean curvature, yet more than " + number(far) +
         " thousandths of the diameter away from them:\n\n" + table.markdown();
}

std::string report(const std::vector<Outcome>& outcomes) {
  std::string text = shares("surface", outcomes, [](const Outcome& o) { return o.surface; }).markdown() + '\n';
  text += shares("shape", outcomes, [](const Outcome& o) { return o.shape; }).markdown() + '\n';
  text += shares("mesh", outcomes, [](const Outcome& o) { return o.mesh; }).markdown() + '\n';
  text += shares("size of the hole", outcomes, size_class).markdown() + '\n';
  text += shares("vertices cut away", outcomes, count_class).markdown() + '\n';
  text += shares("attempt", outcomes, [](const Outcome& o) { return o.attempt; }).markdown() + '\n';
  Table failures({"seed", "surface", "shape", "mesh", "size %", "cut away", "ending", "reason"});
  for (const Outcome& o : outcomes)
    if (o.ending != Ending::finished)
      failures.add({std::to_string(o.seed), o.surface, o.shape, o.mesh, number(100 * o.size), number(o.removed),
                    to_string(o.ending), o.reason});
  if (!failures.empty()) text += failures.markdown();
  return text + far_ones(outcomes);
}

std::string csv(const std::vector<Outcome>& outcomes) {
  Table table({"seed", "surface", "shape", "mesh", "size", "removed", "new", "seconds", "ending", "d", "reason"});
  for (const Outcome& o : outcomes)
    table.add({std::to_string(o.seed), o.surface, o.shape, o.mesh, number(o.size), number(o.removed), number(o.added),
               number(o.seconds), to_string(o.ending), number(o.d), o.reason});
  return table.csv();
}

int run_all(const Arguments& arguments) {
  for (const std::string& name : scan_names()) scan(name);  // once, for all processes
  std::vector<Outcome> outcomes;
  run_isolated(
      arguments.count, {arguments.jobs, arguments.time_limit},
      [&](int k, const Say& say) {
        with_thread_budget(arguments.jobs > 1 ? 1 : 0,
                           [&] { run_seed(arguments.seed + static_cast<std::uint64_t>(k), arguments, say); });
      },
      [&](int k, const IsolatedResult& result) {
        outcomes.push_back(outcome_of(arguments.seed + static_cast<std::uint64_t>(k), result));
        print(outcomes.back());
      });
  std::sort(outcomes.begin(), outcomes.end(), [](const Outcome& a, const Outcome& b) { return a.seed < b.seed; });
  const std::string text = report(outcomes);
  std::printf("\n%s", text.c_str());
  write_text(arguments.markdown, text);
  write_text(arguments.csv, csv(outcomes));
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  Arguments arguments;
  CLI::App app("Random hole problems in numbers: what is filled validly, and what is not.", "loopmend-stress");
  app.add_option("--count", arguments.count, "Problems (500)");
  app.add_option("--seed", arguments.seed, "Seed of the first; the others follow by one (1)");
  app.add_option("--one", arguments.one, "Run this seed alone, in this process");
  app.add_option("--jobs", arguments.jobs, "Problems at once (1)");
  app.add_option("--time-limit", arguments.time_limit, "Seconds for each problem (300)");
  app.add_option("--save", arguments.save, "Folder for the meshes of what did not converge (of any, with --one)");
  app.add_option("--markdown", arguments.markdown, "Write the tables to this file");
  app.add_option("--csv", arguments.csv, "Write every problem to this file");
  CLI11_PARSE(app, argc, argv);
  if (!arguments.one) return run_all(arguments);
  run_seed(*arguments.one, arguments, [](const std::string& line) { print(from_line(line)); });
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "loopmend-stress: %s\n", error.what());
  return 1;
}
