// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling_result.h"

#include "analysis/seam_report.h"
#include "mesh/mesh_arrays.h"
#include "mesh/quality.h"
#include "mesh/self_intersections.h"
#include "stopwatch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <unordered_map>

namespace loopmend::bench {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool starts_with(const TriangleSoup& longer, const TriangleSoup& shorter) {
  return longer.points.size() >= shorter.points.size() && longer.triangles.size() >= shorter.triangles.size() &&
         std::memcmp(longer.points.data(), shorter.points.data(), shorter.points.size() * sizeof(Vec3)) == 0 &&
         std::equal(shorter.triangles.begin(), shorter.triangles.end(), longer.triangles.begin());
}

std::string last_attempt(const HoleResult& result) {
  return is_filled(result.status) && !result.outcome().made_by.empty() ? result.outcome().made_by : "none";
}

int severity(PatchStatus status) {
  switch (status) {
    case PatchStatus::converged: return 0;
    case PatchStatus::early_stop:
    case PatchStatus::faired: return 1;
    case PatchStatus::step_limit:
    case PatchStatus::stalled: return 2;
    case PatchStatus::filled: return 4;
    default: return 5;
  }
}

/// Of the flow alone: fairings do not lower it, and the split flow lowers J instead, by construction.
void add_lowered_energy(const PatchResult& result, Filling& filling) {
  if (result.method != Method::flow) return;
  filling.energy_before += result.energy.initial;
  filling.energy_after += result.energy.final;
}

/// The worst of the loops' ends stands for the whole.
void take_results(const std::vector<HoleResult>& results, Filling& filling) {
  filling.complete = !results.empty();
  filling.status = results.empty() ? "cancelled" : to_string(PatchStatus::converged);
  PatchStatus worst = PatchStatus::converged;
  if (!results.empty()) filling.attempt = last_attempt(results.front());
  if (!results.empty()) filling.mirror = results.front().mirror;
  for (const HoleResult& result : results) {
    filling.steps = std::max(filling.steps, result.steps());
    filling.bending = std::max(filling.bending, result.outcome().bending);
    add_lowered_energy(result.outcome(), filling);
    if (const DeviationPredictors& predictors = result.deviation().predictors;
        predictors.second_order > filling.predictors.second_order)
      filling.predictors = predictors;
    if (result.status == PatchStatus::failed || result.status == PatchStatus::skipped) filling.complete = false;
    if (severity(result.status) <= severity(worst)) continue;
    worst = result.status;
    filling.status = to_string(result.status);
    filling.attempt = last_attempt(result);
    filling.message = result.message.english();
  }
}

/// The whole surface with the filling, the filling's triangles first.
struct Pasted {
  Points points;
  Triangles triangles;
  int own = 0;
};

Pasted paste(const HoleProblem& problem, const Filling& filling) {
  Pasted pasted{points_of(problem.model.mesh), filling.triangles, static_cast<int>(filling.triangles.size())};
  pasted.points.insert(pasted.points.end(), filling.points.begin(), filling.points.end());
  const Triangles old = triangles_of(problem.model.mesh);
  pasted.triangles.insert(pasted.triangles.end(), old.begin(), old.end());
  return pasted;
}

/// Triangles of the filling that belong to each loop: those joined to it by common vertices.
std::vector<Triangles> triangles_per_loop(const HoleProblem& problem, const Filling& filling) {
  std::unordered_map<int, int> parent;
  const auto root = [&](int v) {
    parent.try_emplace(v, v);
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (const Triangle& t : filling.triangles)
    for (int k : {1, 2}) parent[root(t[k])] = root(t[0]);
  std::unordered_map<int, std::size_t> loop_of_root;
  for (std::size_t l = 0; l < problem.loops.size(); ++l) loop_of_root[root(problem.loops[l].vertices.front())] = l;
  std::vector<Triangles> result(problem.loops.size());
  for (const Triangle& t : filling.triangles) {
    const auto loop = loop_of_root.find(root(t[0]));
    if (loop != loop_of_root.end()) result[loop->second].push_back(t);
  }
  return result;
}

/// Empty when the triangles use other vertices than the loop's and new ones.
LoopPatch patch_of_loop(const HoleProblem& problem, const Filling& filling, const BoundaryLoop& loop,
                        const Triangles& triangles) {
  const int old = static_cast<int>(problem.model.mesh.n_vertices());
  LoopPatch loop_patch;
  std::unordered_map<int, int> index;
  for (int v : loop.vertices) {
    index[v] = static_cast<int>(loop_patch.points.size());
    loop_patch.points.push_back(problem.model.mesh.point(TriMesh::VertexHandle(v)));
  }
  for (Triangle t : triangles) {
    for (int& v : t) {
      const auto [entry, added] = index.try_emplace(v, static_cast<int>(loop_patch.points.size()));
      if (added && v < old) return {};
      if (added) loop_patch.points.push_back(filling.points[v - old]);
      v = entry->second;
    }
    loop_patch.triangles.push_back(t);
  }
  return loop_patch;
}

/// rms over the loops, each weighted by its number of vertices.
void measure_seams(const HoleProblem& problem, const Filling& filling, PatchFigures& figures) {
  const std::vector<Triangles> parts = triangles_per_loop(problem, filling);
  double angle2 = 0, jump2 = 0, weight = 0;
  for (std::size_t l = 0; l < problem.loops.size(); ++l) {
    const LoopPatch loop_patch = patch_of_loop(problem, filling, problem.loops[l], parts[l]);
    if (loop_patch.triangles.empty()) continue;
    const SeamReport seam = seam_report(make_patch(problem.model, {problem.loops[l]}, {loop_patch}), 0);
    if (!std::isfinite(seam.g1_rms_deg)) continue;
    const double edges = problem.loops[l].edges();
    angle2 += edges * seam.g1_rms_deg * seam.g1_rms_deg;
    jump2 += edges * seam.h_jump_rms_times_diameter * seam.h_jump_rms_times_diameter;
    weight += edges;
  }
  figures.g1 = std::sqrt(angle2 / weight);
  figures.g2 = std::sqrt(jump2 / weight);
}

void measure_vertices(const HoleProblem& problem, const Filling& filling, const Pasted& pasted, PatchFigures& figures) {
  const std::size_t old = problem.model.mesh.n_vertices();
  std::vector<double> area(filling.points.size(), 0);
  for (const Triangle& t : filling.triangles) {
    const Vec3 a = pasted.points[t[0]];
    const double third = (pasted.points[t[1]] - a).cross(pasted.points[t[2]] - a).norm() / 6;
    for (int v : t)
      if (static_cast<std::size_t>(v) >= old) area[v - old] += third;
  }
  double sum = 0, weight = 0;
  for (std::size_t i = 0; i < filling.points.size(); ++i) {
    const double d = problem.distance(filling.points[i]);
    sum += area[i] * d * d;
    weight += area[i];
    figures.d_max = std::max(figures.d_max, d);
    double reach = std::numeric_limits<double>::max();
    for (const BoundaryLoop& loop : problem.loops)
      reach = std::min(reach, (filling.points[i] - loop.center).norm() / loop.diameter);
    figures.reach = std::max(figures.reach, std::isfinite(reach) ? reach : std::numeric_limits<double>::infinity());
  }
  const double unit = 1000 / problem.diameter();
  figures.d_rms = unit * std::sqrt(sum / weight);
  figures.d_max *= unit;
}

/// Four points a face: its middle and the middles of the three corners' thirds.
void measure_faces(const HoleProblem& problem, const Filling& filling, const Pasted& pasted, PatchFigures& figures) {
  double sum = 0, weight = 0;
  for (const Triangle& t : filling.triangles) {
    const Vec3 &a = pasted.points[t[0]], &b = pasted.points[t[1]], &c = pasted.points[t[2]];
    const double area = (b - a).cross(c - a).norm();
    for (const Vec3& p :
         {Vec3((a + b + c) / 3), Vec3((4 * a + b + c) / 6), Vec3((a + 4 * b + c) / 6), Vec3((a + b + 4 * c) / 6)}) {
      const double d = problem.distance(p);
      sum += area * d * d;
      weight += area;
    }
  }
  figures.d_faces = 1000 / problem.diameter() * std::sqrt(sum / weight);
}

bool all_finite(const Points& points) {
  return std::all_of(points.begin(), points.end(), [](const Vec3& p) { return p.allFinite(); });
}

}  // namespace

Filling fill_by_engine(const HoleProblem& problem, const FillOptions& options, const CancelToken& cancel) {
  SurfaceModel model = problem.model;
  Filling filling;
  const Stopwatch watch;
  const std::vector<HoleResult> results = fill_holes(model, problem.loops, options, nullptr, cancel);
  filling.seconds = watch.seconds();
  take_results(results, filling);
  filling.exterior_unchanged = starts_with(model.soup, problem.model.soup);
  const Points points = points_of(model.mesh);
  const Triangles triangles = triangles_of(model.mesh);
  filling.points.assign(points.begin() + static_cast<long>(problem.model.mesh.n_vertices()), points.end());
  filling.triangles.assign(triangles.begin() + static_cast<long>(problem.model.mesh.n_faces()), triangles.end());
  return filling;
}

PatchFigures measure(const HoleProblem& problem, const Filling& filling) {
  PatchFigures figures;
  if (filling.triangles.empty() || filling.points.empty() || !all_finite(filling.points)) {
    figures.d_rms = figures.d_max = figures.d_faces = figures.g1 = figures.g2 = figures.min_angle = nan;
    figures.reach = all_finite(filling.points) ? 0 : std::numeric_limits<double>::infinity();
    return figures;
  }
  const Pasted pasted = paste(problem, filling);
  measure_vertices(problem, filling, pasted, figures);
  measure_faces(problem, filling, pasted, figures);
  measure_seams(problem, filling, figures);
  figures.min_angle = min_angle_deg(pasted.points, pasted.triangles, pasted.own);
  figures.folds = count_folds(pasted.points, pasted.triangles, pasted.own);
  figures.cuts = static_cast<int>(self_intersections(pasted.points, pasted.triangles, pasted.own).size());
  return figures;
}

}  // namespace loopmend::bench
