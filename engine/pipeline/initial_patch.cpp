// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/initial_patch.h"

#include "core/error.h"
#include "core/seconds_since.h"
#include "core/threads.h"
#include "edges/sharp_patch.h"
#include "mesh/by_position.h"
#include "pipeline/edge_preview.h"
#include "pipeline/flat_cut.h"
#include "split/split_estimate.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <map>
#include <new>
#include <numeric>
#include <unordered_map>

namespace loopmend {

namespace {

/// What goes wrong in one loop leaves the others alone.
LoopPatchOutcome guarded_fill(const SurfaceModel& model, const BoundaryLoop& loop, const InitialPatchOptions& options,
                              const CancelToken& cancel) {
  LoopPatchOutcome outcome;
  if (cancel.cancelled()) return outcome;
  try {
    return fill_loop(model, loop, options, cancel);
  } catch (const std::bad_alloc&) {
    outcome.message = no_memory_message();
  } catch (const std::exception& error) {
    outcome.message = message_of(error);
  }
  return outcome;
}

/// The patch of those loops of a group that have an initial patch; empty if none has.
std::optional<Patch> joined_patch(const SurfaceModel& model, const std::vector<BoundaryLoop>& group,
                                  const std::vector<LoopPatchOutcome>& outcomes, double density) {
  std::vector<BoundaryLoop> loops;
  std::vector<LoopPatch> loop_patches;
  for (std::size_t k = 0; k < group.size(); ++k) {
    if (!outcomes[k].patch) continue;
    loops.push_back(group[k]);
    loop_patches.push_back(*outcomes[k].patch);
  }
  if (loops.empty()) return std::nullopt;
  Patch patch = make_patch(model, loops, loop_patches);
  patch.grading.density = density;
  return patch;
}

/// The loops and what is around them, with nothing in them.
Patch without_patches(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::vector<LoopPatch> empty(loops.size());
  for (std::size_t k = 0; k < loops.size(); ++k) empty[k].points.resize(loops[k].vertices.size());
  return make_patch(model, loops, empty);
}

/// What a loop asks for. `apart`: a split of its own, or sharp edges that run on.
enum class Treatment { apart, exact, flat_cut };

template <class T>
std::vector<T> picked(const std::vector<T>& all, const std::vector<int>& which) {
  std::vector<T> result;
  for (int k : which) result.push_back(all[k]);
  return result;
}

}  // namespace

namespace {

/// Loops of which one lies within so many edges of the other, directly or by way of others. @param members  indices into `loops`.
std::vector<std::vector<int>> loops_within(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                           const std::vector<int>& members, int rings) {
  std::unordered_map<int, std::vector<int>> loops_at;  // by place in `members`
  for (std::size_t k = 0; k < members.size(); ++k)
    for (int v : loops[members[k]].vertices) loops_at[v].push_back(static_cast<int>(k));
  std::vector<int> parent(members.size());
  std::iota(parent.begin(), parent.end(), 0);
  const auto root = [&](int k) {
    while (parent[k] != k) k = parent[k] = parent[parent[k]];
    return k;
  };
  for (std::size_t k = 0; k < members.size(); ++k) {
    std::unordered_map<int, int> distance;
    std::vector<int> queue = loops[members[k]].vertices;
    for (int v : queue) distance[v] = 0;
    for (std::size_t q = 0; q < queue.size(); ++q) {
      const int v = queue[q];
      if (const auto met = loops_at.find(v); met != loops_at.end())
        for (int other : met->second) {
          const int a = root(static_cast<int>(k)), b = root(other);
          parent[std::max(a, b)] = std::min(a, b);
        }
      if (distance[v] >= rings) continue;
      for (const auto w : model.mesh.vv_range(TriMesh::VertexHandle(v)))
        if (distance.emplace(w.idx(), distance[v] + 1).second) queue.push_back(w.idx());
    }
  }
  std::vector<std::vector<int>> groups;
  std::unordered_map<int, std::size_t> group_of;
  for (std::size_t k = 0; k < members.size(); ++k) {
    const auto [entry, added] = group_of.emplace(root(static_cast<int>(k)), groups.size());
    if (added) groups.emplace_back();
    groups[entry->second].push_back(members[k]);
  }
  return groups;
}

/// By falling perimeter, of equals by their positions: a joint patch depends on the order of its loops, which must not depend on
/// how the file numbers them. @param members  indices into `loops`
void sort_by_position(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, std::vector<int>& members) {
  const auto precede = [&](int v, int w) {
    return precedes(model.mesh.point(TriMesh::VertexHandle(v)), model.mesh.point(TriMesh::VertexHandle(w)));
  };
  std::stable_sort(members.begin(), members.end(), [&](int k, int l) {
    const BoundaryLoop &a = loops[k], &b = loops[l];
    if (a.perimeter != b.perimeter) return a.perimeter > b.perimeter;
    return std::lexicographical_compare(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(),
                                        precede);
  });
}

/// On a scan full of holes each lies near some other, and all would be one problem.
constexpr std::size_t most_jointly = 24;

double total_edges(const std::vector<BoundaryLoop>& loops) {
  return std::accumulate(loops.begin(), loops.end(), 0.0,
                         [](double sum, const BoundaryLoop& l) { return sum + l.edges(); });
}

}  // namespace

std::vector<std::vector<int>> group_loops(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::vector<int> all(loops.size());
  std::iota(all.begin(), all.end(), 0);
  std::vector<std::vector<int>> groups{all};
  for (const int rings : {patch_rings - 1, 2, 0}) {
    std::vector<std::vector<int>> finer;
    for (const std::vector<int>& group : groups) {
      const bool whole = rings < patch_rings - 1 && group.size() <= most_jointly;
      const auto parts = whole ? std::vector<std::vector<int>>{group} : loops_within(model, loops, group, rings);
      finer.insert(finer.end(), parts.begin(), parts.end());
    }
    groups = std::move(finer);
  }
  std::vector<std::vector<int>> result;
  for (const std::vector<int>& group : groups) {
    if (group.size() <= most_jointly) {
      result.push_back(group);
      continue;
    }
    for (int k : group) result.push_back({k});
  }
  std::sort(result.begin(), result.end());
  for (std::vector<int>& group : result) sort_by_position(model, loops, group);
  return result;
}

Message no_memory_message() {
  return say("not enough memory for this hole: left open; a smaller density needs less").with_code("no_memory");
}

Message InitialPatch::message() const {
  Message all;
  for (const LoopPatchOutcome& outcome : outcomes)
    if (outcome.patch) all = joined(std::move(all), "; ", outcome.message);
  return all;
}

InitialPatch make_initial_patch(const SurfaceModel& model, const std::vector<BoundaryLoop>& group,
                                const InitialPatchOptions& options, const CancelToken& cancel) {
  check(options);
  const auto start = std::chrono::steady_clock::now();
  InitialPatch initial;
  initial.loops = group;
  for (const BoundaryLoop& loop : group) initial.outcomes.push_back(guarded_fill(model, loop, options, cancel));
  initial.patch = joined_patch(model, group, initial.outcomes, options.density);
  initial.seconds = seconds_since(start);
  return initial;
}

InitialPatch make_surveyed_patch(const SurfaceModel& model, const std::vector<BoundaryLoop>& group,
                                 const InitialPatchOptions& options, const CancelToken& cancel) {
  InitialPatch initial;
  BoundarySurvey survey;
  const bool surveyable = group.size() == 1 && group.front().diameter > 0;
  const auto make = [&] { initial = make_initial_patch(model, group, options, cancel); };
  if (!surveyable) {
    make();
    return initial;
  }
  const auto start = std::chrono::steady_clock::now();
  parallel_invoke(make, [&] { survey = survey_boundary(without_patches(model, group), cancel); });
  initial.survey_seconds = std::max(0.0, seconds_since(start) - initial.seconds);
  if (initial.patch) initial.survey = std::move(survey);
  return initial;
}

InitialPatch part_of(const SurfaceModel& model, const InitialPatch& group, const std::vector<int>& members,
                     const InitialPatchOptions& options) {
  InitialPatch part;
  part.loops = picked(group.loops, members);
  part.outcomes = picked(group.outcomes, members);
  part.patch = joined_patch(model, part.loops, part.outcomes, options.density);
  part.seconds = group.seconds * total_edges(part.loops) / total_edges(group.loops);
  return part;
}

std::vector<LoopsAlike> groups_alike(const SurfaceModel& model, const InitialPatch& group,
                                     const EvolutionOptions& options) {
  const auto treatment = [&](LoopsAlike& alike) {
    const std::vector<int>& members = alike.members;
    const std::vector<BoundaryLoop> loops = picked(group.loops, members);
    if (continues_edges(options) && !edits_at(model, loops, options.edge_edits).empty()) return Treatment::apart;
    std::vector<LoopEnd> ends;
    for (const BoundaryLoop& loop : loops) ends.push_back(loop_end(model, loop));
    if (std::ranges::count(ends, LoopEnd::toothed) > 0) return Treatment::apart;
    if (std::ranges::count(ends, LoopEnd::runs_on) == 0) return Treatment::flat_cut;
    const std::optional<Patch> patch = joined_patch(model, loops, picked(group.outcomes, members), 1);
    if (!patch) return Treatment::apart;
    if (options.edges == SharpEdges::continued && ends_at_sharp_edges(*patch)) return Treatment::apart;
    alike.split = estimate_split(*patch);
    return alike.split->is_exact() ? Treatment::exact : Treatment::apart;
  };
  std::vector<LoopsAlike> alone;
  std::map<Treatment, std::vector<int>> of_treatment;
  std::vector<int> without_vertices;
  for (int k = 0; k < static_cast<int>(group.loops.size()); ++k) {
    alone.push_back({{k}, std::nullopt});
    const std::optional<LoopPatch>& patch = group.outcomes[k].patch;
    if (patch && patch->points.size() == group.loops[k].vertices.size())
      without_vertices.push_back(k);
    else
      of_treatment[treatment(alone.back())].push_back(k);
  }
  // A patch without free vertices matters as the neighborhood of others alone: else there is nothing to estimate for it.
  const bool any_together = of_treatment.contains(Treatment::exact) || of_treatment.contains(Treatment::flat_cut);
  for (int k : without_vertices) of_treatment[any_together ? treatment(alone[k]) : Treatment::apart].push_back(k);
  std::vector<LoopsAlike> result;
  for (const auto& [asked, loops] : of_treatment)
    for (const std::vector<int>& members : group_loops(model, picked(group.loops, loops))) {
      LoopsAlike together{picked(loops, members), std::nullopt};
      if (together.members.size() > 1 && asked != Treatment::apart && treatment(together) == asked)
        result.push_back(std::move(together));
      else
        for (int k : together.members) result.push_back(alone[k]);
    }
  std::sort(result.begin(), result.end(), [](const auto& a, const auto& b) { return a.members < b.members; });
  return result;
}

}  // namespace loopmend
