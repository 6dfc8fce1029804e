// SPDX-License-Identifier: GPL-3.0-or-later
// loopmend_rough_rims: pieces cut out of real scans are filled, by us and by others; who comes closest to what was there?
#include "filling_result.h"
#include "peers.h"
#include "rough_problem.h"
#include "table.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace {

using namespace loopmend;
using namespace loopmend::bench;

struct Arguments {
  int count = 48, first = 0, noise_seeds = 3, first_noise_seed = 100;
  std::uint64_t seed = 1;
  std::string set = "both", markdown, csv;
  bool without_noise = false, noise_only = false;
};

constexpr std::size_t methods = 1 + std::size(all_peers);  // ours first

std::string method_name(std::size_t m) { return m == 0 ? "Loopmend" : to_string(all_peers[m - 1]); }

/// What is compared: distances of points spread over the faces, 1e-3 of the hole's diameter. NaN: not filled.
struct Row {
  int number = 0;
  RoughProblem made;
  std::array<Filling, methods> fillings;
  std::array<PatchFigures, methods> figures;
  std::array<double, methods> d{};

  const Filling& ours() const { return fillings[0]; }

  bool tuning() const { return number % 2 == 0; }
  double best_peer() const {
    double best = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t m = 1; m < methods; ++m) best = std::fmin(best, d[m]);
    return best;
  }
  double score(std::size_t m) const { return d[m] / best_peer(); }
};

Row run_problem(int number, RoughProblem made) {
  Row row;
  row.number = number;
  row.fillings[0] = fill_by_engine(made.problem);
  for (std::size_t m = 1; m < methods; ++m) row.fillings[m] = fill_by_peer(made.problem, all_peers[m - 1]);
  for (std::size_t m = 0; m < methods; ++m) {
    row.figures[m] = measure(made.problem, row.fillings[m]);
    row.d[m] = row.fillings[m].complete ? row.figures[m].d_faces : std::numeric_limits<double>::quiet_NaN();
  }
  row.made = std::move(made);
  row.made.problem.model = {};  // memory
  return row;
}

void print(const Row& row) {
  std::printf("%3d %-8s %-12s %-8s %4.0f %%  removed %4d ", row.number, row.tuning() ? "tuning" : "aside",
              row.made.scan.c_str(), row.made.shape.c_str(), 100 * row.made.size, row.made.problem.removed);
  for (std::size_t m = 0; m < methods; ++m) std::printf(" %s %-6s", method_name(m).c_str(), number(row.d[m]).c_str());
  std::printf(" score %-5s bending %-5s cuts %d folds %d%s %6.2f s %s, %s %s\n", number(row.score(0)).c_str(),
              number(row.ours().bending).c_str(), row.figures[0].cuts, row.figures[0].folds,
              row.ours().exterior_unchanged ? "" : " EXTERIOR CHANGED", row.ours().seconds, row.ours().status.c_str(),
              row.ours().attempt.c_str(), row.ours().message.c_str());
  std::fflush(stdout);
}

/// Geometric mean and worst of one method's scores; what a method did not fill is counted, not averaged.
struct Summary {
  double mean = 0, worst = 0;
  int missing = 0, within = 0;  ///< within: at most 5 % above the best peer
  int cut = 0;                  ///< problems where the patch cuts itself or the surface
};

Summary summarise(const std::vector<const Row*>& rows, std::size_t m) {
  Summary summary;
  double logs = 0;
  int count = 0;
  for (const Row* row : rows) {
    const double score = row->score(m);
    if (row->figures[m].cuts > 0) ++summary.cut;
    if (!std::isfinite(score)) {
      ++summary.missing;
      continue;
    }
    logs += std::log(score);
    ++count;
    summary.worst = std::max(summary.worst, score);
    if (score <= 1.05) ++summary.within;
  }
  summary.mean = std::exp(logs / std::max(count, 1));
  return summary;
}

Table summary_table(const std::vector<Row>& rows) {
  Table table({"problems", "method", "geometric mean of the score", "worst", "within 5 % of the best peer",
               "not filled", "self-intersecting"});
  const auto add = [&](const std::string& name, const std::function<bool(const Row&)>& wanted) {
    std::vector<const Row*> chosen;
    for (const Row& row : rows)
      if (wanted(row)) chosen.push_back(&row);
    for (std::size_t m = 0; m < methods && !chosen.empty(); ++m) {
      const Summary s = summarise(chosen, m);
      table.add({name + " (" + number(static_cast<int>(chosen.size())) + ")", method_name(m), number(s.mean),
                 number(s.worst), number(s.within), number(s.missing), number(s.cut)});
    }
  };
  add("tuning", [](const Row& row) { return row.tuning(); });
  add("set aside", [](const Row& row) { return !row.tuning(); });
  add("all", [](const Row&) { return true; });
  return table;
}

Table problem_table(const std::vector<Row>& rows) {
  Table table({"problem", "set", "shape", "size %", "removed", "d", "d CGAL C1", "d CGAL C2", "d k = 2", "d k = 3",
               "score", "g1", "g2", "bending", "cuts", "folds", "exterior", "status"});
  for (const Row& row : rows) {
    std::vector<std::string> cells{row.made.problem.name, row.tuning() ? "tuning" : "set aside", row.made.shape,
                                   number(100 * row.made.size), number(row.made.problem.removed)};
    for (double d : row.d) cells.push_back(number(d));
    cells.push_back(number(row.score(0)));
    cells.push_back(number(row.figures[0].g1));
    cells.push_back(number(row.figures[0].g2));
    cells.push_back(number(row.ours().bending));
    cells.push_back(number(row.figures[0].cuts));
    cells.push_back(number(row.figures[0].folds));
    cells.push_back(row.ours().exterior_unchanged ? "unchanged" : "CHANGED");
    cells.push_back(row.ours().status);
    table.add(cells);
  }
  return table;
}

/// One row for each problem and method.
std::string csv(const std::vector<Row>& rows) {
  Table table({"problem", "set",        "scan",    "shape",  "size",    "removed", "method",
               "d_faces", "d_vertices", "d_max",   "score",  "g1",      "g2",      "min_angle",
               "cuts",    "folds",      "bending", "status", "message", "seconds"});
  for (const Row& row : rows)
    for (std::size_t m = 0; m < methods; ++m) {
      const PatchFigures& f = row.figures[m];
      table.add({row.made.problem.name,
                 row.tuning() ? "tuning" : "set aside",
                 row.made.scan,
                 row.made.shape,
                 number(row.made.size),
                 number(row.made.problem.removed),
                 method_name(m),
                 number(f.d_faces),
                 number(f.d_rms),
                 number(f.d_max),
                 number(row.score(m)),
                 number(f.g1),
                 number(f.g2),
                 number(f.min_angle),
                 number(f.cuts),
                 number(f.folds),
                 number(row.fillings[m].bending),
                 row.fillings[m].status,
                 row.fillings[m].message,
                 number(row.fillings[m].seconds)});
    }
  return table.csv();
}

/// rms over seeds of the distance of the vertices, for each method; the sixth order without any blending last.
std::vector<double> noisy_distances(NoisySurface surface, double noise, int first_seed, int seeds) {
  std::vector<double> squares(methods + 1, 0);
  for (int seed = 0; seed < seeds; ++seed) {
    const HoleProblem problem = make_noisy_problem(surface, noise, static_cast<unsigned>(first_seed + 2 * seed));
    FillOptions raw;
    raw.evolution->bending = 0.0;
    std::vector<Filling> fillings{fill_by_engine(problem)};
    for (Peer peer : all_peers) fillings.push_back(fill_by_peer(problem, peer));
    fillings.push_back(fill_by_engine(problem, raw));
    for (std::size_t m = 0; m < fillings.size(); ++m) {
      const double d = measure(problem, fillings[m]).d_rms;
      squares[m] += d * d / seeds;
    }
  }
  for (double& d : squares) d = std::sqrt(d);
  return squares;
}

Table noise_table(const Arguments& arguments) {
  Table table(
      {"surface", "noise, % of an edge", "d", "d CGAL C1", "d CGAL C2", "d k = 2", "d k = 3", "d raw sixth order"});
  for (NoisySurface surface : {NoisySurface::sphere, NoisySurface::torus})
    for (double percent : {0.0, 0.1, 0.3, 1.0, 3.0, 10.0}) {
      std::vector<std::string> row{surface == NoisySurface::sphere ? "sphere" : "torus", number(percent)};
      for (double d : noisy_distances(surface, percent / 100, arguments.first_noise_seed, arguments.noise_seeds))
        row.push_back(number(d));
      for (const std::string& cell : row) std::printf("%s  ", cell.c_str());
      std::printf("\n");
      std::fflush(stdout);
      table.add(row);
    }
  return table;
}

bool wanted(const Arguments& arguments, int k) {
  return arguments.set == "both" || (arguments.set == "tuning") == (k % 2 == 0);
}

std::vector<Row> run_scans(const Arguments& arguments) {
  std::vector<Row> rows;
  for (int k = arguments.first; k < arguments.first + arguments.count; ++k) {
    if (!wanted(arguments, k)) continue;
    std::optional<RoughProblem> made = make_rough_problem(arguments.seed, k);
    if (!made) {
      std::printf("%3d no clean cut found\n", k);
      continue;
    }
    rows.push_back(run_problem(k, std::move(*made)));
    print(rows.back());
  }
  return rows;
}

int run(const Arguments& arguments) {
  const std::vector<Row> rows = arguments.noise_only ? std::vector<Row>{} : run_scans(arguments);
  std::string text =
      "d: rms distance of points spread evenly over the patch to the removed original, in 1e-3 of the hole's diameter; "
      "score: d divided by the best of the four others on the same hole.\n\n";
  if (!rows.empty()) {
    text += summary_table(rows).markdown() + '\n' + problem_table(rows).markdown() + '\n';
    std::printf("\n%s\n", summary_table(rows).markdown().c_str());
    write_text(arguments.csv, csv(rows));
  }
  if (!arguments.without_noise) {
    text += "White noise along the normals; d of the vertices to the surface without noise, rms over " +
            number(arguments.noise_seeds) + " seeds from " + number(arguments.first_noise_seed) + ":\n\n" +
            noise_table(arguments).markdown();
  }
  write_text(arguments.markdown, text);
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  Arguments arguments;
  CLI::App app("Regions cut out of real scans: how close do fillings come to what was there?", "loopmend_rough_rims");
  app.add_option("--count", arguments.count, "Problems (48)");
  app.add_option("--first", arguments.first, "Number of the first (0)");
  app.add_option("--seed", arguments.seed, "Seed of all cuts (1)");
  app.add_option("--set", arguments.set, "tuning (even numbers), aside (odd numbers) or both")
      ->check(CLI::IsMember({"tuning", "aside", "both"}));
  app.add_option("--noise-seeds", arguments.noise_seeds, "Runs for each level of noise (3)");
  app.add_option("--first-noise-seed", arguments.first_noise_seed, "The first of these, the others by twos (100)");
  app.add_flag("--no-noise", arguments.without_noise, "Scans alone");
  app.add_flag("--noise-only", arguments.noise_only, "Noise alone");
  app.add_option("--markdown", arguments.markdown, "Write the tables to this file");
  app.add_option("--csv", arguments.csv, "Write every problem to this file");
  CLI11_PARSE(app, argc, argv);
  return run(arguments);
} catch (const std::exception& error) {
  std::fprintf(stderr, "loopmend_rough_rims: %s\n", error.what());
  return 1;
}
