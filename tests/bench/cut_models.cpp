// SPDX-License-Identifier: GPL-3.0-or-later
// loopmend_cut_models: holes of 8 to 300 boundary edges, cut into many models at random places; which method comes closest to what
// was there?
#include "filling_result.h"
#include "peers.h"
#include "region_cut.h"
#include "scans.h"
#include "table.h"

#include "core/error.h"
#include "io/read_mesh.h"
#include "mesh/mesh_arrays.h"
#include "mesh/quality.h"
#include "pipeline/validate.h"
#include "samples/analytic_surfaces.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>
#include <sstream>

namespace {

using namespace loopmend;
using namespace loopmend::bench;

struct Arguments {
  std::vector<std::string> models;
  std::string half = "tuning", methods = "all", at = "anywhere", markdown, csv, reference;
  std::uint64_t seed = 1;
  int count = 10;
};

constexpr int fewest_edges = 8, most_edges = 300, surrounding_rings = 30;
constexpr double least_distance = 1e-3;  ///< a millionth of the diameter: below it, all are as good
constexpr const char* exact_name = "exact";
constexpr const char* reference_name = "reference";
constexpr const char* mirror_name = "mirror";
constexpr double notably_worse = 1.1;  ///< a copy than the default

/// Methods by name, ours first; `mirror` is the default where no image is copied; `reference` is ours in a former run, and no one is measured against it.
const std::vector<std::string>& method_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all{"auto", exact_name};
    for (Peer peer : all_peers) all.emplace_back(to_string(peer));
    all.emplace_back(mirror_name);
    all.emplace_back(reference_name);
    return all;
  }();
  return names;
}

/// FNV-1a: the same on every machine.
std::uint32_t hash_of(const std::string& text) {
  std::uint32_t hash = 2166136261U;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 16777619U;
  return hash;
}

/// Which half a model belongs to is told by its name alone, so that a new model changes nothing for the others.
bool is_tuning(const std::string& model) { return (hash_of(model) >> 8U) % 2 == 0; }

struct Hole {
  std::string name, model, shape;
  int edges = 0, removed = 0;
  std::map<std::string, double> d;  ///< by method, 1e-3 of the diameter; NaN: not filled
  std::string status, attempt;      ///< of `auto`
  DeviationPredictors predictors;   ///< of `auto`; 0: not known
  double at_vertices = 0;           ///< PatchFigures::d_rms of `auto`
  MirrorFit mirror;                 ///< where it was measured
  double seconds = 0;

  double best() const {
    double best = std::numeric_limits<double>::quiet_NaN();
    for (const auto& [method, distance] : d)
      if (method != reference_name) best = std::fmin(best, distance);
    return best;
  }
  double score(const std::string& method) const {
    const auto found = d.find(method);
    if (found == d.end() || std::isnan(found->second)) return std::numeric_limits<double>::quiet_NaN();
    return std::max(found->second, least_distance) / std::max(best(), least_distance);
  }
};

TriangleSoup load(const std::filesystem::path& path) {
  const SurfaceModel model = make_surface_model(read_mesh(path).soup);
  const TriangleSoup soup{points_of(model.mesh), triangles_of(model.mesh), {}};
  return largest_component(soup.points.size() > most_kept_whole ? soup : trim_boundaries(soup));
}

double mean_edge(const TriangleSoup& soup) {
  double sum = 0;
  for (const Triangle& t : soup.triangles)
    for (std::size_t k = 0; k < 3; ++k) sum += (soup.points[t[k]] - soup.points[t[(k + 1) % 3]]).norm();
  return sum / (3.0 * static_cast<double>(std::max<std::size_t>(1, soup.triangles.size())));
}

/// Vertices where a hole may have its centre: all, or the ends of edges bent by more than 30°.
std::vector<int> centers_of(const TriangleSoup& whole, const std::string& at) {
  std::vector<int> centers(whole.points.size());
  std::iota(centers.begin(), centers.end(), 0);
  if (at != "edges") return centers;
  centers.clear();
  for (const Bend& bend : bends(whole.points, whole.triangles, static_cast<int>(whole.triangles.size())))
    if (bend.cosine < std::cos(std::numbers::pi / 6)) centers.insert(centers.end(), {bend.low, bend.high});
  std::sort(centers.begin(), centers.end());
  centers.erase(std::unique(centers.begin(), centers.end()), centers.end());
  return centers;
}

struct Cut {
  HoleProblem problem;
  std::string shape;
};

enum class Methods { all, default_alone, mirror };

/// Number k of a model's holes; nothing where no clean cut was found. For `mirror` the whole model is kept.
std::optional<Cut> make_cut(const TriangleSoup& whole, const std::vector<int>& centers, const std::string& model,
                            std::uint64_t seed, int k, Methods methods) {
  if (centers.empty()) return std::nullopt;
  constexpr ShapeKind shapes[] = {ShapeKind::disc, ShapeKind::ellipse, ShapeKind::star, ShapeKind::slit};
  Random random(seed * 1000003 + static_cast<std::uint64_t>(k) * 7919 + hash_of(model));
  const double h = mean_edge(whole);
  for (int attempt = 0; attempt < 60; ++attempt) {
    RegionPlan plan;
    plan.shape = random_shape(shapes[k % 4], random);
    plan.center = centers[random.next() % centers.size()];
    const double edges = fewest_edges * std::pow(static_cast<double>(most_edges) / fewest_edges, random.uniform());
    plan.radius = edges * h / (2 * std::numbers::pi);
    plan.turn = random.uniform(0, 2 * std::numbers::pi);
    plan.clearance = 6;
    if (plan.radius > 0.3 * extent(whole)) continue;
    std::optional<RegionCut> cut = cut_region(whole, plan);
    if (!cut || cut->removed_vertices < 1) continue;
    if (methods != Methods::mirror) crop_around_cut(*cut, surrounding_rings);
    Cut made{problem_of(model + " " + std::to_string(k), std::move(*cut)), to_string(plan.shape.kind)};
    if (made.problem.loops.size() != 1) continue;
    const int found = made.problem.loops.front().edges();
    if (found < fewest_edges || found > most_edges) continue;
    if (made.problem.removed > 4 * 0.092 * found * found)
      continue;  // 0.092 n²: vertices of a disc; here a limb came off
    if (pierced_edges(ScanIndex(made.problem.model), made.problem.loops.front()) > 0) continue;
    return made;
  }
  return std::nullopt;
}

Hole run_hole(const Cut& cut, const std::string& model, Methods methods) {
  const HoleProblem& problem = cut.problem;
  Hole hole;
  hole.name = problem.name;
  hole.model = model;
  hole.shape = cut.shape;
  hole.edges = problem.loops.front().edges();
  hole.removed = problem.removed;
  const auto take = [&](const std::string& method, const Filling& filling) {
    hole.d[method] = filling.complete ? measure(problem, filling).d_faces : std::numeric_limits<double>::quiet_NaN();
  };
  const Filling ours = fill_by_engine(problem);
  take("auto", ours);
  hole.status = ours.status;
  hole.attempt = ours.attempt;
  hole.predictors = ours.predictors;
  if (ours.complete) hole.at_vertices = measure(problem, ours).d_rms;
  hole.seconds = ours.seconds;
  if (methods == Methods::mirror) {
    FillOptions mirrored;
    mirrored.mirror = FillOptions::Mirror::find;
    const Filling copy = fill_by_engine(problem, mirrored);
    take(mirror_name, copy);
    hole.mirror = copy.mirror;
  }
  if (methods != Methods::all) return hole;
  FillOptions exact;
  exact.evolution->boundary = BoundaryTrust::exact;
  take(exact_name, fill_by_engine(problem, exact));
  for (Peer peer : all_peers) take(to_string(peer), fill_by_peer(problem, peer));
  return hole;
}

void print(const Hole& hole) {
  std::printf("%-24s %-8s %4d edges %5d removed ", hole.name.c_str(), hole.shape.c_str(), hole.edges, hole.removed);
  for (const std::string& method : method_names())
    if (hole.d.contains(method)) std::printf(" %s %-7s", method.c_str(), number(hole.d.at(method)).c_str());
  if (hole.d.contains(mirror_name))
    std::printf(" %s, misfit %s of %s", to_string(hole.mirror.answer), number(hole.mirror.misfit).c_str(),
                number(hole.mirror.difference).c_str());
  std::printf(" score %-5s %5.2f s %s, %s\n", number(hole.score("auto")).c_str(), hole.seconds, hole.status.c_str(),
              hole.attempt.c_str());
  std::fflush(stdout);
}

struct Summary {
  double mean = 0, worst = 0;
  int filled = 0, above = 0;  ///< above: more than 1.5 times the best
};

Summary summarise(const std::vector<const Hole*>& holes, const std::string& method) {
  Summary summary;
  double logs = 0;
  for (const Hole* hole : holes) {
    const double score = hole->score(method);
    if (!std::isfinite(score)) continue;
    ++summary.filled;
    logs += std::log(score);
    summary.above += score > 1.5;
    summary.worst = std::max(summary.worst, score);
  }
  summary.mean = std::exp(logs / std::max(1, summary.filled));
  return summary;
}

Table summary_table(const std::vector<Hole>& holes) {
  Table table({"holes", "method", "filled", "geometric mean", "above 1.5", "worst"});
  const auto add = [&](const std::string& name, const std::function<bool(const Hole&)>& wanted) {
    std::vector<const Hole*> chosen;
    for (const Hole& hole : holes)
      if (wanted(hole)) chosen.push_back(&hole);
    if (chosen.empty()) return;
    for (const std::string& method : method_names()) {
      const Summary s = summarise(chosen, method);
      if (s.filled > 0)
        table.add({name + " (" + number(static_cast<int>(chosen.size())) + ")", method, number(s.filled),
                   number(s.mean), number(s.above), number(s.worst)});
    }
  };
  add("all", [](const Hole&) { return true; });
  add("up to 25 edges", [](const Hole& hole) { return hole.edges <= 25; });
  add("26 to 90 edges", [](const Hole& hole) { return hole.edges > 25 && hole.edges <= 90; });
  add("more than 90 edges", [](const Hole& hole) { return hole.edges > 90; });
  return table;
}

/// Geometric mean of the scores of `auto`, model by model.
Table model_table(const std::vector<Hole>& holes) {
  Table table({"model", "holes", "auto", "above 1.5", "worst", "exact"});
  std::map<std::string, std::vector<const Hole*>> by_model;
  for (const Hole& hole : holes) by_model[hole.model].push_back(&hole);
  for (const auto& [model, chosen] : by_model) {
    const Summary ours = summarise(chosen, "auto"), exact = summarise(chosen, exact_name);
    table.add({model, number(static_cast<int>(chosen.size())), number(ours.mean), number(ours.above),
               number(ours.worst), number(exact.mean)});
  }
  return table;
}

/// Where an image was copied: the copy's distance divided by the default's.
Table mirror_table(const std::vector<Hole>& holes) {
  Table table({"model", "holes", "copied", "geometric mean of copy / default", "worse than 1.1", "largest"});
  std::map<std::string, std::vector<const Hole*>> by_model;
  for (const Hole& hole : holes) {
    if (!hole.d.contains(mirror_name)) continue;
    by_model[hole.model].push_back(&hole);
    by_model["all"].push_back(&hole);
  }
  for (const auto& [model, chosen] : by_model) {
    double logs = 0, largest = 0;
    int copied = 0, worse = 0;
    for (const Hole* hole : chosen) {
      const double ratio =
          std::max(hole->d.at(mirror_name), least_distance) / std::max(hole->d.at("auto"), least_distance);
      if (!hole->mirror.is_proposed() || !std::isfinite(ratio)) continue;
      ++copied;
      logs += std::log(ratio);
      worse += ratio > notably_worse;
      largest = std::max(largest, ratio);
    }
    table.add({model, number(static_cast<int>(chosen.size())), number(copied),
               copied > 0 ? number(std::exp(logs / copied)) : "-", number(worse), number(largest)});
  }
  return table;
}

std::string csv(const std::vector<Hole>& holes) {
  Table table({"hole", "model", "shape", "edges", "removed", "method", "d", "score", "status", "attempt", "seconds",
               "d_vertices", "second_order", "area", "seam_deg", "initial_seam_deg", "mirror", "misfit", "difference"});
  for (const Hole& hole : holes)
    for (const auto& [method, d] : hole.d) {
      const bool is_default = method == "auto", is_mirror = method == mirror_name;
      const auto of_default = [&](const std::string& text) { return is_default ? text : std::string(); };
      const auto of_mirror = [&](const std::string& text) { return is_mirror ? text : std::string(); };
      table.add({hole.name, hole.model, hole.shape, number(hole.edges), number(hole.removed), method, number(d),
                 number(hole.score(method)), of_default(hole.status), of_default(hole.attempt),
                 of_default(number(hole.seconds)), of_default(number(hole.at_vertices)),
                 of_default(number(hole.predictors.second_order)), of_default(number(hole.predictors.area)),
                 of_default(number(hole.predictors.seam_deg)), of_default(number(hole.predictors.initial_seam_deg)),
                 of_mirror(to_string(hole.mirror.answer)), of_mirror(number(hole.mirror.misfit)),
                 of_mirror(number(hole.mirror.difference))});
    }
  return table.csv();
}

/// Distances of `auto` in a former run, by hole. @throws Error where the file cannot be read.
std::map<std::string, double> read_reference(const std::string& path) {
  std::map<std::string, double> d;
  if (path.empty()) return d;
  std::ifstream in(path);
  if (!in) throw InvalidArgument(verbatim("the reference " + path + " cannot be read"));
  for (std::string line; std::getline(in, line);) {
    std::vector<std::string> cells;
    std::istringstream row(line);
    for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
    if (cells.size() > 6 && cells[5] == "auto" && cells[6] != "-") d[cells[0]] = std::strtod(cells[6].c_str(), nullptr);
  }
  return d;
}

std::vector<std::filesystem::path> files_of(const std::vector<std::string>& names) {
  std::vector<std::filesystem::path> files;
  for (const std::string& name : names) {
    if (!std::filesystem::is_directory(name)) {
      files.emplace_back(name);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(name)) {
      const std::string extension = entry.path().extension();
      if (extension == ".ply" || extension == ".obj" || extension == ".off" || extension == ".stl")
        files.push_back(entry.path());
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

int run(const Arguments& arguments) {
  const std::map<std::string, double> reference = read_reference(arguments.reference);
  const Methods methods = arguments.methods == "all"    ? Methods::all
                          : arguments.methods == "auto" ? Methods::default_alone
                                                        : Methods::mirror;
  std::vector<Hole> holes;
  for (const std::filesystem::path& file : files_of(arguments.models)) {
    const std::string model = file.stem();
    if (arguments.half != "both" && is_tuning(model) != (arguments.half == "tuning")) continue;
    const TriangleSoup whole = load(file);
    const std::vector<int> centers = centers_of(whole, arguments.at);
    for (int k = 0; k < arguments.count; ++k) {
      const std::optional<Cut> cut = make_cut(whole, centers, model, arguments.seed, k, methods);
      if (!cut) {
        std::printf("%s %d: no clean cut was found\n", model.c_str(), k);
        continue;
      }
      holes.push_back(run_hole(*cut, model, methods));
      const auto known = reference.find(holes.back().name);
      if (known != reference.end()) holes.back().d[reference_name] = known->second;
      print(holes.back());
    }
  }
  const std::string text =
      "Score: rms distance from what was cut away, divided by the smallest of all methods on the same hole.\n\n" +
      summary_table(holes).markdown() + '\n' + model_table(holes).markdown() +
      (methods == Methods::mirror ? '\n' + mirror_table(holes).markdown() : std::string());
  std::printf("\n%s", text.c_str());
  write_text(arguments.markdown, text);
  write_text(arguments.csv, csv(holes));
  return 0;
}

}  // namespace

int main(int argc, char** argv) try {
  Arguments arguments;
  CLI::App app("Holes cut into many models: which method comes closest to what was there?", "loopmend_cut_models");
  app.add_option("models", arguments.models, "Meshes, or folders of meshes")->required();
  app.add_option("--count", arguments.count, "Holes of each model (10)");
  app.add_option("--seed", arguments.seed, "Seed of all cuts (1)");
  app.add_option("--at", arguments.at, "Centres of the holes: anywhere (default), or at sharp edges")
      ->check(CLI::IsMember({"anywhere", "edges"}));
  app.add_option("--half", arguments.half, "tuning (default), test or both: models parted by their names")
      ->check(CLI::IsMember({"tuning", "test", "both"}));
  app.add_option("--methods", arguments.methods,
                 "all (default); auto: the engine's default alone; auto,mirror: the default, and the mirror image "
                 "where it fits")
      ->check(CLI::IsMember({"all", "auto", "auto,mirror"}));
  app.add_option("--reference", arguments.reference, "CSV of a former run, whose `auto` is compared, too");
  app.add_option("--markdown", arguments.markdown, "Write the tables to this file");
  app.add_option("--csv", arguments.csv, "Write every hole to this file");
  CLI11_PARSE(app, argc, argv);
  return run(arguments);
} catch (const std::exception& error) {
  std::fprintf(stderr, "loopmend_cut_models: %s\n", error.what());
  return 1;
}
