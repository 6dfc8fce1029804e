// SPDX-License-Identifier: GPL-3.0-or-later
// loopmend_accuracy: how close fillings come to surfaces that are known, ours and those of the programs used instead.
// Distances in 1e-3 of the hole's diameter. One call, default settings.
#include "accuracy_problems.h"
#include "filling_result.h"
#include "peers.h"
#include "table.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>
#include <regex>

namespace {

using namespace loopmend;
using namespace loopmend::bench;

struct Arguments {
  std::string only = ".*", markdown, csv, meshes = "all";
  bool without_peers = false;
};

struct Measured {
  std::string method;
  Filling filling;
  PatchFigures figures;
};

/// Everybody's results on one problem; ours first.
struct Comparison {
  const AccuracyCase& problem;
  MeshKind mesh;
  int removed;
  std::vector<Measured> measured;

  const Measured& ours() const { return measured.front(); }
  /// Least figure of the peers; infinite when none filled the hole.
  double best_peer(double PatchFigures::*figure) const {
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t k = 1; k < measured.size(); ++k) best = std::fmin(best, measured[k].figures.*figure);
    return best;
  }
};

std::string target_in_words(const AccuracyCase& problem) {
  std::string text = problem.target > 0 ? "d < " + number(problem.target) : "d ≤ best peer";
  return problem.compares_g2 ? text + ", g2 < best peer" : text;
}

/// Empty when the peers that it depends on were not run.
std::optional<bool> target_met(const Comparison& comparison) {
  const PatchFigures& ours = comparison.ours().figures;
  if (comparison.problem.target > 0 && !(ours.d_rms < comparison.problem.target)) return false;
  const bool needs_peers = comparison.problem.target == 0 || comparison.problem.compares_g2;
  if (needs_peers && comparison.measured.size() == 1) return std::nullopt;
  if (comparison.problem.target == 0 && !(ours.d_rms <= comparison.best_peer(&PatchFigures::d_rms))) return false;
  return !comparison.problem.compares_g2 || ours.g2 < comparison.best_peer(&PatchFigures::g2);
}

std::string met_in_words(const Comparison& comparison) {
  const std::optional<bool> met = target_met(comparison);
  return !met ? "?" : *met ? "met" : "**not met**";
}

Measured run_engine(const HoleProblem& problem, double density) {
  FillOptions options;
  options.initial.density = density;
  Filling filling = fill_by_engine(problem, options);
  const PatchFigures figures = measure(problem, filling);
  return {"Loopmend", std::move(filling), figures};
}

void print_line(const std::string& name, MeshKind mesh, const Measured& m) {
  std::printf("%-24s %-9s %-8s d %-9s max %-9s g1 %-8s g2 %-8s angle %4.1f new %5zu steps %2d %6.2f s  %s %s\n",
              name.c_str(), to_string(mesh), m.method.c_str(), number(m.figures.d_rms).c_str(),
              number(m.figures.d_max).c_str(), number(m.figures.g1).c_str(), number(m.figures.g2).c_str(),
              m.figures.min_angle, m.filling.points.size(), m.filling.steps, m.filling.seconds,
              m.filling.status.c_str(), m.filling.message.c_str());
  std::fflush(stdout);
}

Comparison compare(const AccuracyCase& accuracy_case, MeshKind mesh, bool without_peers) {
  const HoleProblem problem = accuracy_case.make(mesh);
  Comparison comparison{accuracy_case, mesh, problem.removed, {}};
  comparison.measured.push_back(run_engine(problem, 1));
  print_line(accuracy_case.name, mesh, comparison.measured.back());
  if (without_peers) return comparison;
  for (Peer peer : all_peers) {
    Filling filling = fill_by_peer(problem, peer);
    const PatchFigures figures = measure(problem, filling);
    comparison.measured.push_back({to_string(peer), std::move(filling), figures});
    print_line(accuracy_case.name, mesh, comparison.measured.back());
  }
  return comparison;
}

void add_rows(const Comparison& comparison, Table& markdown, Table& csv) {
  const auto name = [&] {
    return comparison.problem.name +
           (comparison.mesh == MeshKind::regular ? "" : std::string(", ") + to_string(comparison.mesh));
  };
  const PatchFigures& ours = comparison.ours().figures;
  std::vector<std::string> row{name(),
                               number(comparison.removed),
                               number(static_cast<int>(comparison.ours().filling.points.size())),
                               number(ours.d_rms),
                               number(ours.d_max),
                               number(ours.g1),
                               number(ours.g2),
                               number(ours.min_angle),
                               number(comparison.ours().filling.steps),
                               comparison.ours().filling.status};
  for (std::size_t k = 0; k < std::size(all_peers); ++k)
    row.push_back(k + 1 < comparison.measured.size() ? number(comparison.measured[k + 1].figures.d_rms) : "");
  row.push_back(comparison.measured.size() > 1 ? number(comparison.best_peer(&PatchFigures::g2)) : "");
  row.push_back(target_in_words(comparison.problem));
  row.push_back(met_in_words(comparison));
  markdown.add(row);
  for (const Measured& m : comparison.measured)
    csv.add({comparison.problem.name,
             to_string(comparison.mesh),
             m.method,
             number(comparison.removed),
             number(static_cast<int>(m.filling.points.size())),
             number(m.figures.d_rms),
             number(m.figures.d_max),
             number(m.figures.d_faces),
             number(m.figures.g1),
             number(m.figures.g2),
             number(m.figures.min_angle),
             number(m.figures.folds),
             number(m.figures.cuts),
             number(m.filling.steps),
             m.filling.status,
             m.filling.attempt,
             m.filling.message,
             number(m.filling.seconds),
             target_in_words(comparison.problem),
             &m == &comparison.ours() ? met_in_words(comparison) : ""});
}

/// The same holes at several densities of the patch.
Table run_densities(const Arguments& arguments) {
  Table table({"problem", "density", "new", "d", "max", "g2", "smallest angle", "status"});
  for (const AccuracyCase& accuracy_case : density_cases()) {
    if (!std::regex_search(accuracy_case.name + ", densities", std::regex(arguments.only))) continue;
    const HoleProblem problem = accuracy_case.make(MeshKind::regular);
    for (double density : {0.5, 1.0, 2.0, 4.0}) {
      const Measured m = run_engine(problem, density);
      print_line(accuracy_case.name + " x" + number(density), MeshKind::regular, m);
      table.add({accuracy_case.name, number(density), number(static_cast<int>(m.filling.points.size())),
                 number(m.figures.d_rms), number(m.figures.d_max), number(m.figures.g2), number(m.figures.min_angle),
                 m.filling.status});
    }
  }
  return table;
}

struct Targets {
  int met = 0, missed = 0;
};

void write_results(const Arguments& arguments, const Table& results, const Table& csv, const Table& densities,
                   const Targets& targets) {
  std::string text =
      "d: rms distance of the new vertices to the exact surface, in 1e-3 of the hole's diameter; max: the largest; g1: "
      "rms angle in degrees between the one-sided normals at the loop; g2: rms jump of H times the diameter; smallest "
      "angle of the patch in degrees. " +
      number(targets.met) + " of " + number(targets.met + targets.missed) + " targets are met.\n\n" +
      results.markdown();
  if (!densities.empty())
    text += "\nThe same hole at several densities of the patch (edges per length):\n\n" + densities.markdown();
  write_text(arguments.markdown, text);
  write_text(arguments.csv, csv.csv());
}

std::vector<MeshKind> mesh_kinds(const std::string& which) {
  if (which == "regular") return {MeshKind::regular};
  return {MeshKind::regular, MeshKind::jittered, MeshKind::irregular};
}

int run(const Arguments& arguments) {
  Table results({"problem", "removed", "new", "d", "max", "g1", "g2", "smallest angle", "steps", "status", "d CGAL C1",
                 "d CGAL C2", "d k = 2", "d k = 3", "best peer's g2", "target", "met"});
  Table csv({"problem",   "mesh",  "method", "removed", "new",    "d",       "d_max",   "d_faces", "g1",     "g2",
             "min_angle", "folds", "cuts",   "steps",   "status", "attempt", "message", "seconds", "target", "met"});
  Table densities({});
  Targets targets;
  for (const AccuracyCase& accuracy_case : accuracy_cases()) {
    for (MeshKind mesh : mesh_kinds(arguments.meshes)) {
      if (!std::regex_search(accuracy_case.name + ", " + to_string(mesh), std::regex(arguments.only))) continue;
      const Comparison comparison = compare(accuracy_case, mesh, arguments.without_peers);
      add_rows(comparison, results, csv);
      if (const auto reached = target_met(comparison)) ++(*reached ? targets.met : targets.missed);
      write_results(arguments, results, csv, densities, targets);
    }
  }
  densities = run_densities(arguments);
  write_results(arguments, results, csv, densities, targets);
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  Arguments arguments;
  CLI::App app("How close fillings come to surfaces that are known.", "loopmend_accuracy");
  app.add_option("--only", arguments.only,
                 "Regular expression: problems to run, by \"NAME, MESH\" or \"NAME, densities\"");
  app.add_option("--meshes", arguments.meshes, "all or regular")->check(CLI::IsMember({"all", "regular"}));
  app.add_option("--markdown", arguments.markdown, "Write the tables to this file");
  app.add_option("--csv", arguments.csv, "Write all figures to this file");
  app.add_flag("--no-peers", arguments.without_peers, "Measure the engine alone");
  CLI11_PARSE(app, argc, argv);
  return run(arguments);
} catch (const std::exception& error) {
  std::fprintf(stderr, "loopmend_accuracy: %s\n", error.what());
  return 1;
}
