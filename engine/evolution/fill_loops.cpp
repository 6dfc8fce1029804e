#include "evolution/fill_loops.h"

#include "core/error.h"
#include "mesh/quality.h"
#include "mesh/self_intersections.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <mutex>
#include <numeric>
#include <thread>
#include <unordered_map>

namespace loopmend {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

Triangles view_triangles(const TriMesh& mesh) {
  Triangles triangles;
  triangles.reserve(mesh.n_faces());
  for (const auto f : mesh.faces()) {
    const auto h = mesh.halfedge_handle(f);
    triangles.push_back({mesh.from_vertex_handle(h).idx(), mesh.to_vertex_handle(h).idx(),
                         mesh.to_vertex_handle(mesh.next_halfedge_handle(h)).idx()});
  }
  return triangles;
}

/// What all workers read: the model as it was, and an index of its triangles.
struct Site {
  explicit Site(const SurfaceModel& surface) : model(surface), triangles(view_triangles(surface.mesh)) {
    points.reserve(surface.mesh.n_vertices());
    for (const auto v : surface.mesh.vertices()) points.push_back(surface.mesh.point(v));
    index = std::make_unique<TriangleIndex>(points, triangles);
  }
  const SurfaceModel& model;
  Points points;
  Triangles triangles;
  std::unique_ptr<TriangleIndex> index;
};

/// Pairs of a patch triangle with another patch triangle or with any triangle of the model.
int intersections_of(const Site& site, const PatchGeometry& patch) {
  const int rim = static_cast<int>(patch.rim.size());
  Points points;
  Eigen::AlignedBox3d box;
  for (int v : patch.rim) points.push_back(site.points[v]);
  points.insert(points.end(), patch.points.begin(), patch.points.end());
  for (const Vec3& p : points) box.extend(p);
  Triangles triangles = patch.triangles;
  std::unordered_map<int, int> local;
  for (int i = 0; i < rim; ++i) local.emplace(patch.rim[i], i);
  for (int f : site.index->near(box.min(), box.max())) {
    Triangle t = site.triangles[f];
    for (int& v : t) {
      const auto [entry, added] = local.emplace(v, static_cast<int>(points.size()));
      if (added) points.push_back(site.points[v]);
      v = entry->second;
    }
    triangles.push_back(t);
  }
  return static_cast<int>(self_intersections(points, triangles, static_cast<int>(patch.triangles.size())).size());
}

struct Verdict {
  int folds = 0;
  int intersections = 0;
};

Verdict judge(const Site& site, const Patch& patch) {
  return {count_folds(patch.positions, patch.triangles, patch.patch_triangles),
          intersections_of(site, patch_geometry(patch))};
}

bool no_worse(const Verdict& a, const Verdict& b) { return a.folds <= b.folds && a.intersections <= b.intersections; }

/// One group of loops solved: what is to be pasted, and what is to be told of each loop.
struct GroupOutcome {
  std::optional<PatchGeometry> geometry;
  std::vector<LoopResult> results;  ///< in the order of the group
};

LoopStatus status_after(EvolutionStatus status) {
  return status == EvolutionStatus::step_limit ? LoopStatus::step_limit : LoopStatus::converged;
}

/// Free vertices of each of the patch's loops: those that its part of the patch is made of.
std::vector<int> free_vertices_per_loop(const Patch& patch) {
  std::vector<int> part(patch.vertex_count());
  std::iota(part.begin(), part.end(), 0);
  const auto root = [&](int v) {
    while (part[v] != v) v = part[v] = part[part[v]];
    return v;
  };
  for (int f = 0; f < patch.patch_triangles; ++f)
    for (int k = 1; k < 3; ++k) part[root(patch.triangles[f][k])] = root(patch.triangles[f][0]);
  std::unordered_map<int, int> count;
  for (int i = 0; i < patch.free_count; ++i) ++count[root(i)];
  std::vector<int> result;
  for (const auto& loop : patch.loops) {
    const auto found = count.find(root(loop.front()));
    result.push_back(found == count.end() ? 0 : found->second);
  }
  return result;
}

struct Evolved {
  Patch patch;
  LoopStatus status = LoopStatus::filled;
  std::string message;
  int steps = 0;
  double bending = 0;
  double assemble = 0, solve = 0, initial_energy = 0, final_energy = 0;
};

void take_figures(const Evolution& evolution, Evolved& result) {
  result.steps = static_cast<int>(evolution.history().size());
  for (const StepRecord& step : evolution.history()) {
    result.assemble += step.assemble_seconds;
    result.solve += step.solve_seconds;
  }
  result.initial_energy = evolution.initial_energy();
  result.final_energy = evolution.energy();
}

/// One run of the flow from the filler. @returns true if its result may be kept.
bool evolve_once(const Site& site, const Patch& filler, const EvolutionOptions& options, const CancelToken& cancel,
                 Evolved& result) {
  Evolution evolution(filler, options);
  const EvolutionStatus status = evolution.run(nullptr, cancel);
  take_figures(evolution, result);
  if (status == EvolutionStatus::cancelled) return false;
  if (status == EvolutionStatus::failed && evolution.history().empty()) {
    result.message = "the flow could not start (" + evolution.message() + "): the filler was kept";
    return false;
  }
  if (!no_worse(judge(site, evolution.patch()), judge(site, filler))) {
    result.message = "the flow would have folded the patch or cut the surface: the filler was kept";
    return false;
  }
  result.patch = evolution.patch();
  result.status = status_after(status);
  result.message = evolution.message();
  result.bending = evolution.bending();
  return true;
}

/// The flow from the filler. Where the sixth order would spoil the patch, bending energy is blended in; where that does
/// not help either, the filler stays and the message says so.
Evolved evolve(const Site& site, const Patch& filler, const EvolutionOptions& options, const CancelToken& cancel) {
  Evolved result;
  result.patch = filler;
  if (filler.free_count == 0) {
    result.message = "too small to hold a free vertex: closed by triangles between its own vertices";
    return result;
  }
  if (evolve_once(site, filler, options, cancel, result) || cancel.cancelled()) return result;
  if (options.flow == FlowKind::mmcvf && options.mode == EvolutionMode::steady && !options.bending) {
    for (double bending : {60.0, 300.0}) {
      EvolutionOptions gentler = options;
      gentler.bending = bending;
      if (evolve_once(site, filler, gentler, cancel, result) || cancel.cancelled()) return result;
    }
  }
  result.final_energy = result.initial_energy;
  result.steps = 0;
  return result;
}

GroupOutcome solve_group(const Site& site, const std::vector<BoundaryLoop>& group, const FillOptions& options,
                         const CancelToken& cancel) {
  const auto start = std::chrono::steady_clock::now();
  GroupOutcome outcome;
  const PatchStart first = start_patch(site.model, group, options.filler, cancel);
  const double filler_seconds = seconds_since(start);
  for (std::size_t k = 0; k < group.size(); ++k) {
    LoopResult result;
    result.loop = group[k];
    result.status = LoopStatus::failed;
    result.message = first.fillers[k].message;
    result.seconds.filler = filler_seconds;
    outcome.results.push_back(std::move(result));
  }
  if (!first.patch || cancel.cancelled()) return outcome;
  Evolved evolved;
  evolved.patch = *first.patch;
  if (options.evolution) evolved = evolve(site, *first.patch, *options.evolution, cancel);
  if (cancel.cancelled()) return outcome;
  const Verdict verdict = judge(site, evolved.patch);
  const std::vector<int> free = free_vertices_per_loop(evolved.patch);
  for (std::size_t p = 0; p < evolved.patch.loops.size(); ++p) {
    LoopResult& result = *std::find_if(outcome.results.begin(), outcome.results.end(), [&](const LoopResult& r) {
      return r.loop.number == evolved.patch.loop_numbers[p];
    });
    if (verdict.intersections > 0) {
      result.message = "every patch that was found would cut the surface or itself (" +
                       std::to_string(verdict.intersections) + " intersections): left open";
      continue;
    }
    result.status = evolved.status;
    // What the filler lacked is past once the flow has mended it.
    if (evolved.status != LoopStatus::filled || !evolved.message.empty()) result.message = evolved.message;
    result.free_vertices = free[p];
    result.steps = evolved.steps;
    result.bending = evolved.bending;
    result.energy = {evolved.initial_energy, evolved.final_energy};
    result.seam_before = seam_report(*first.patch, static_cast<int>(p));
    result.seam_after = seam_report(evolved.patch, static_cast<int>(p));
    result.seconds.assemble = evolved.assemble;
    result.seconds.solve = evolved.solve;
  }
  if (verdict.intersections == 0) outcome.geometry = patch_geometry(evolved.patch);
  for (LoopResult& result : outcome.results) result.seconds.total = seconds_since(start);
  return outcome;
}

GroupOutcome failed_group(const std::vector<BoundaryLoop>& group, const std::string& why) {
  GroupOutcome outcome;
  for (const BoundaryLoop& loop : group) {
    LoopResult result;
    result.loop = loop;
    result.status = LoopStatus::failed;
    result.message = why;
    outcome.results.push_back(std::move(result));
  }
  return outcome;
}

/// Runs job(k) for k = 0..count−1 on several threads, in order of k. The job must not throw.
void run_parallel(int count, int threads, const std::function<void(int)>& job) {
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int k = next++; k < count; k = next++) job(k);
  };
  std::vector<std::jthread> workers;
  for (int t = 1; t < std::min(threads, count); ++t) workers.emplace_back(work);
  work();
}

}  // namespace

const char* to_string(LoopStatus status) {
  switch (status) {
    case LoopStatus::converged: return "converged";
    case LoopStatus::step_limit: return "step_limit";
    case LoopStatus::filled: return "filled";
    case LoopStatus::failed: return "failed";
    case LoopStatus::skipped: return "skipped";
  }
  return "";
}

std::vector<std::vector<int>> group_loops(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::unordered_map<int, int> loop_at;
  for (std::size_t k = 0; k < loops.size(); ++k)
    for (int v : loops[k].vertices) loop_at[v] = static_cast<int>(k);
  std::vector<int> parent(loops.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  for (std::size_t k = 0; k < loops.size(); ++k) {
    std::unordered_map<int, int> ring;
    std::vector<int> queue = loops[k].vertices;
    for (int v : queue) ring[v] = 1;
    for (std::size_t q = 0; q < queue.size(); ++q) {
      const int v = queue[q];
      const auto met = loop_at.find(v);
      if (met != loop_at.end()) {
        const int a = root(static_cast<int>(k)), b = root(met->second);
        parent[std::max(a, b)] = std::min(a, b);
      }
      if (ring[v] >= patch_rings) continue;
      for (const auto w : model.mesh.vv_range(TriMesh::VertexHandle(v)))
        if (ring.emplace(w.idx(), ring[v] + 1).second) queue.push_back(w.idx());
    }
  }
  std::vector<std::vector<int>> groups;
  std::unordered_map<int, std::size_t> group_of;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const auto [entry, added] = group_of.emplace(root(static_cast<int>(k)), groups.size());
    if (added) groups.emplace_back();
    groups[entry->second].push_back(static_cast<int>(k));
  }
  return groups;
}

PatchStart start_patch(const SurfaceModel& model, const std::vector<BoundaryLoop>& group, const FillerOptions& options,
                       const CancelToken& cancel) {
  PatchStart start;
  std::vector<BoundaryLoop> loops;
  std::vector<LoopFiller> fillers;
  for (const BoundaryLoop& loop : group) {
    start.fillers.push_back(cancel.cancelled() ? FillerOutcome{} : fill_loop(model, loop, options, cancel));
    if (!start.fillers.back().filler) continue;
    loops.push_back(loop);
    fillers.push_back(*start.fillers.back().filler);
  }
  if (!loops.empty()) start.patch = make_patch(model, loops, fillers);
  return start;
}

std::vector<LoopResult> fill_loops(SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                   const FillOptions& options, const OnFillProgress& progress,
                                   const CancelToken& cancel) {
  std::vector<std::vector<int>> groups = group_loops(model, loops);
  const auto size = [&](const std::vector<int>& group) {
    return std::accumulate(group.begin(), group.end(), 0, [&](int sum, int k) { return sum + loops[k].edges(); });
  };
  std::stable_sort(groups.begin(), groups.end(),
                   [&](const auto& a, const auto& b) { return size(a) > size(b); });
  const Site site(model);
  std::vector<GroupOutcome> outcomes(groups.size());
  std::mutex progress_mutex;
  FillProgress state;
  state.loops_total = static_cast<int>(loops.size());
  const int threads = options.threads > 0 ? options.threads : static_cast<int>(std::thread::hardware_concurrency());
  run_parallel(static_cast<int>(groups.size()), threads, [&](int g) {
    if (cancel.cancelled()) return;
    std::vector<BoundaryLoop> group;
    for (int k : groups[g]) group.push_back(loops[k]);
    try {
      outcomes[g] = solve_group(site, group, options, cancel);
    } catch (const std::exception& error) {
      outcomes[g] = failed_group(group, error.what());
    }
    const std::lock_guard lock(progress_mutex);
    state.loops_done += static_cast<int>(group.size());
    state.loop_number = group.front().number;
    state.stage = state.loops_done == state.loops_total ? "done" : "evolving";
    if (progress) progress(state);
  });
  if (cancel.cancelled()) return {};

  std::vector<LoopResult> results(loops.size());
  std::vector<std::size_t> by_first_loop(groups.size());
  std::iota(by_first_loop.begin(), by_first_loop.end(), std::size_t{0});
  std::sort(by_first_loop.begin(), by_first_loop.end(),
            [&](std::size_t a, std::size_t b) { return groups[a].front() < groups[b].front(); });
  for (std::size_t g : by_first_loop) {
    try {
      if (outcomes[g].geometry) append_patch(model, *outcomes[g].geometry);
    } catch (const InvalidArgument& error) {
      for (LoopResult& result : outcomes[g].results) {
        result.status = LoopStatus::failed;
        result.message = error.what();
      }
    }
    for (std::size_t k = 0; k < groups[g].size(); ++k) results[groups[g][k]] = std::move(outcomes[g].results[k]);
  }
  return results;
}

}  // namespace loopmend
