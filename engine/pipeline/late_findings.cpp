// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/late_findings.h"

#include "pipeline/flat_cut.h"
#include "pipeline/judge.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <memory>
#include <utility>

namespace loopmend {

namespace {

constexpr double bulges = 0.04;       ///< of a patch beyond the heights of its loop, in diameters
constexpr double long_outline = 0.5;  ///< 4 area / (perimeter diameter): 1 for a circle, 0.3 for horseshoes

bool is_long(const BoundaryLoop& loop) { return 4 * loop.area < long_outline * loop.perimeter * loop.diameter; }

/// How far the part of the patch that a loop bounds lies beyond the loop, square to its plane, in diameters.
double reach_beyond(const Patch& patch, std::size_t loop) {
  const std::vector<int>& vertices = patch.loops[loop];
  Vec3 center = Vec3::Zero(), axis = Vec3::Zero();
  for (const int v : vertices) center += patch.positions[v] / static_cast<double>(vertices.size());
  for (std::size_t k = 0; k < vertices.size(); ++k)
    axis +=
        (patch.positions[vertices[k]] - center).cross(patch.positions[vertices[(k + 1) % vertices.size()]] - center);
  if (!(axis.norm() > 0)) return 0;
  axis.normalize();
  double low = 0, high = 0, reach = 0;
  const auto height = [&](int v) { return axis.dot(patch.positions[v] - center); };
  for (const int v : vertices) {
    low = std::min(low, height(v));
    high = std::max(high, height(v));
  }
  const std::vector<int> loop_of = loop_of_free_vertices(patch);
  for (int v = 0; v < static_cast<int>(loop_of.size()); ++v)
    if (loop_of[v] == static_cast<int>(loop)) reach = std::max({reach, low - height(v), height(v) - high});
  return reach / loop_diameter(patch, loop);
}

}  // namespace

void add_to_look(std::vector<HoleResult>& results, std::size_t hole, Notice finding) {
  const std::shared_ptr<const PatchResult> judged = results[hole].patch;
  const auto place = static_cast<std::size_t>(results[hole].place);
  if (!is_filled(results[hole].status) || !judged || place >= judged->verdicts.size()) return;
  const auto patch = std::make_shared<PatchResult>(*judged);
  add_finding(patch->verdicts[place], Grade::look, std::move(finding));
  for (HoleResult& result : results)
    if (result.patch == judged) result.patch = patch;
}

void name_rim_groups(const std::vector<RimGroup>& groups, const std::vector<LoopChoice>& choices,
                     std::vector<HoleResult>& results) {
  const auto joined_with = [&](const HoleResult& first, int k) {  // holes that are solved together share a patch, too
    const HoleResult& hole = results[static_cast<std::size_t>(k)];
    return is_filled(hole.status) && hole.patch == first.patch &&
           (hole.place == 0 || hole.message.code == "joined_wall" || hole.message.code == "joined_island");
  };
  std::vector<RimGroup> apart = groups;
  std::erase_if(apart, [&](const RimGroup& group) {
    const HoleResult& first = results[static_cast<std::size_t>(group.loops[0])];
    return std::ranges::all_of(group.loops, [&](int k) { return joined_with(first, k); });
  });
  const auto is_gap = [](const RimGroup& group) { return group.kind == RimGroup::Kind::gap; };
  const bool several = static_cast<std::ptrdiff_t>(apart.size()) - std::ranges::count_if(apart, is_gap) > 1;
  for (const RimGroup& group : apart)
    for (const int own : group.loops) {
      const auto k = static_cast<std::size_t>(own);
      if (choices[k].left == LoopChoice::Left::wide_crack) continue;
      Message& message = results[k].message;
      message = joined(std::move(message), "; ", advice(group, own));
      if (several && !is_gap(group))
        message = joined(std::move(message), "; ", say("for several patches, repeat --loops in one command"));
      if (group.kind == RimGroup::Kind::ring) add_to_look(results, k, {NoticeCode::wall_ends, {}});
    }
}

void judge_outlines(std::vector<HoleResult>& results) {
  for (std::size_t k = 0; k < results.size(); ++k) {
    const BoundaryLoop& loop = results[k].loop;
    const auto place = static_cast<std::size_t>(results[k].place);
    const bool may_end = loop.kind == LoopKind::outer_rim && loop.planarity <= flat_planarity && is_long(loop);
    if (!may_end || !is_filled(results[k].status) || place >= results[k].outcome().patch.loops.size()) continue;
    const double reach = reach_beyond(results[k].outcome().patch, place);
    if (reach > bulges) add_to_look(results, k, {NoticeCode::dome_over_flat_loop, {reach}});
  }
}

}  // namespace loopmend
