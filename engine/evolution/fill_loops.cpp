// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/fill_loops.h"

#include "core/error.h"
#include "core/threads.h"
#include "evolution/solve_group.h"
#include "mesh/self_intersections.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <mutex>
#include <numeric>
#include <unordered_map>

namespace loopmend {

namespace {

/// Wrong options are the caller's fault, not the loops'.
void check(const FillOptions& options) {
  check(options.filler);
  if (options.evolution) check(*options.evolution);
}

/// Patches of different groups were solved without knowing of each other: each is tested against those before it.
class PastedPatches {
 public:
  /// @returns why the patch was not pasted; empty when it was.
  std::string paste(SurfaceModel& model, const PatchGeometry& patch) {
    Part part;
    for (int v : patch.rim) part.points.push_back(model.mesh.point(TriMesh::VertexHandle(v)));
    part.points.insert(part.points.end(), patch.points.begin(), patch.points.end());
    part.triangles = patch.triangles;
    for (const Vec3& p : part.points) part.box.extend(p);
    for (const Part& other : parts_)
      if (other.box.intersects(part.box) && cut(part, other))
        return "its patch would cut that of another loop: left open";
    try {
      append_patch(model, patch);
    } catch (const InvalidArgument& error) {
      return error.what();
    }
    parts_.push_back(std::move(part));
    return "";
  }

 private:
  struct Part {
    Points points;
    Triangles triangles;
    Eigen::AlignedBox3d box;
  };

  static bool cut(const Part& a, const Part& b) {
    Points points = a.points;
    points.insert(points.end(), b.points.begin(), b.points.end());
    Triangles triangles = a.triangles;
    const int shift = static_cast<int>(a.points.size());
    for (Triangle t : b.triangles) {
      for (int& v : t) v += shift;
      triangles.push_back(t);
    }
    return !self_intersections(points, triangles, static_cast<int>(a.triangles.size())).empty();
  }

  std::vector<Part> parts_;
};

}  // namespace

const char* to_string(LoopStatus status) {
  switch (status) {
    case LoopStatus::converged: return "converged";
    case LoopStatus::faired: return "faired";
    case LoopStatus::step_limit: return "step_limit";
    case LoopStatus::doubtful: return "doubtful";
    case LoopStatus::filled: return "filled";
    case LoopStatus::failed: return "failed";
    case LoopStatus::skipped: return "skipped";
  }
  return "";
}

bool is_filled(LoopStatus status) { return status != LoopStatus::failed && status != LoopStatus::skipped; }

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

std::optional<Patch> joined_patch(const SurfaceModel& model, const std::vector<BoundaryLoop>& group,
                                  const std::vector<FillerOutcome>& outcomes, double density) {
  std::vector<BoundaryLoop> loops;
  std::vector<LoopFiller> fillers;
  for (std::size_t k = 0; k < group.size(); ++k) {
    if (!outcomes[k].filler) continue;
    loops.push_back(group[k]);
    fillers.push_back(*outcomes[k].filler);
  }
  if (loops.empty()) return std::nullopt;
  Patch patch = make_patch(model, loops, fillers);
  patch.grading.density = density;
  return patch;
}

PatchStart start_patch(const SurfaceModel& model, const std::vector<BoundaryLoop>& group, const FillerOptions& options,
                       const CancelToken& cancel) {
  PatchStart start;
  for (const BoundaryLoop& loop : group)
    start.fillers.push_back(cancel.cancelled() ? FillerOutcome{} : fill_loop(model, loop, options, cancel));
  start.patch = joined_patch(model, group, start.fillers, options.density);
  return start;
}

namespace {

/// What a loop asks for where that is all or nothing: 0 the flow itself, 1 the flow without the noise, 2 robust fairing. −1
/// where it is something between, which is different for every loop.
int treatment_of(const RimRoughness& boundary) {
  if (boundary.rough_share >= 1) return 2;
  if (boundary.rough_share > 0 || boundary.bending > 0) return -1;
  return boundary.noise_share == 0 ? 0 : boundary.noise_share >= 1 ? 1 : -1;
}

template <class T>
std::vector<T> picked(const std::vector<T>& all, const std::vector<int>& which) {
  std::vector<T> result;
  for (int k : which) result.push_back(all[k]);
  return result;
}

}  // namespace

std::vector<std::vector<int>> groups_alike(const SurfaceModel& model, const std::vector<BoundaryLoop>& group,
                                           const std::vector<FillerOutcome>& fillers) {
  const auto treatment = [&](const std::vector<int>& members) {
    const std::optional<Patch> patch = joined_patch(model, picked(group, members), picked(fillers, members), 1);
    return patch ? treatment_of(rim_roughness(*patch)) : -1;
  };
  std::map<int, std::vector<int>> of_treatment;
  for (int k = 0; k < static_cast<int>(group.size()); ++k) of_treatment[treatment({k})].push_back(k);
  std::vector<std::vector<int>> result;
  for (const auto& [asked, loops] : of_treatment)
    for (const std::vector<int>& members : group_loops(model, picked(group, loops))) {
      const std::vector<int> together = picked(loops, members);
      if (together.size() == 1 || (asked >= 0 && treatment(together) == asked))
        result.push_back(together);
      else
        for (int k : together) result.push_back({k});
    }
  std::sort(result.begin(), result.end());
  return result;
}

std::vector<LoopResult> fill_loops(SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                   const FillOptions& options, const OnFillProgress& progress,
                                   const CancelToken& cancel) {
  check(options);
  std::vector<std::vector<int>> groups = group_loops(model, loops);
  const auto size = [&](const std::vector<int>& group) {
    return std::accumulate(group.begin(), group.end(), 0, [&](int sum, int k) { return sum + loops[k].edges(); });
  };
  std::stable_sort(groups.begin(), groups.end(), [&](const auto& a, const auto& b) { return size(a) > size(b); });
  const FillSite site(model);
  std::vector<GroupOutcome> outcomes(groups.size());
  std::mutex progress_mutex;
  FillProgress state;
  state.loops_total = static_cast<int>(loops.size());
  const auto solve = [&](int g) {
    if (cancel.cancelled()) return;
    std::vector<BoundaryLoop> group;
    for (int k : groups[g]) group.push_back(loops[k]);
    outcomes[g] = solve_group(site, group, options, cancel);
    const std::lock_guard lock(progress_mutex);
    state.loops_done += static_cast<int>(group.size());
    state.loop_number = group.front().number;
    if (progress) progress(state);
  };
  with_thread_budget(options.threads, [&] { parallel_for(0, static_cast<int>(groups.size()), 1, solve); });
  if (cancel.cancelled()) return {};

  std::vector<LoopResult> results(loops.size());
  std::vector<std::size_t> by_first_loop(groups.size());
  std::iota(by_first_loop.begin(), by_first_loop.end(), std::size_t{0});
  std::sort(by_first_loop.begin(), by_first_loop.end(),
            [&](std::size_t a, std::size_t b) { return groups[a].front() < groups[b].front(); });
  PastedPatches pasted;
  for (std::size_t g : by_first_loop) {
    for (const FinishedPatch& patch : outcomes[g].patches) {
      const std::string trouble = pasted.paste(model, patch.geometry);
      for (int k : patch.loops)
        if (!trouble.empty()) {
          outcomes[g].results[k].status = LoopStatus::failed;
          outcomes[g].results[k].message = trouble;
          outcomes[g].results[k].method.clear();
          outcomes[g].results[k].reason.clear();
        }
    }
    for (std::size_t k = 0; k < groups[g].size(); ++k) results[groups[g][k]] = std::move(outcomes[g].results[k]);
  }
  return results;
}

}  // namespace loopmend
