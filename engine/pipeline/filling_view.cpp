// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/filling_view.h"

#include "mesh/patch.h"
#include "mesh/pieces.h"
#include "pipeline/flat_cut.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <set>
#include <utility>

namespace loopmend {

namespace {

/// All that grows out of the loops ring by ring looks at no more than this (mesh/patch.h, group_loops).
constexpr int rings = patch_rings;

/// Where more than the rings is looked at: each box that the view does not hold.
std::vector<Eigen::AlignedBox3d> boxes_to_hold(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const BoundaryLoop& loop : loops) {
    const double reach = reach_of_loop_end(model, loop);
    if (reach <= 0) continue;
    Eigen::AlignedBox3d box;
    for (int v : loop.vertices) box.extend(model.mesh.point(TriMesh::VertexHandle(v)));
    boxes.emplace_back(box.min() - Vec3::Constant(reach), box.max() + Vec3::Constant(reach));
  }
  std::vector<char> is_short(boxes.size(), 0);
  for (const auto v : model.mesh.vertices())
    if (is_cut_off(model, v.idx()))
      for (std::size_t k = 0; k < boxes.size(); ++k)
        if (!is_short[k] && boxes[k].contains(model.mesh.point(v))) is_short[k] = 1;
  if (std::find(is_short.begin(), is_short.end(), 1) == is_short.end()) return {};
  return boxes;
}

/// A hole is filled together with the islands in it.
std::vector<BoundaryLoop> with_islands(const SurfaceModel& model, const std::vector<BoundaryLoop>& all,
                                       const std::vector<BoundaryLoop>& loops) {
  std::set<int> numbers;
  for (const BoundaryLoop& loop : loops) numbers.insert(loop.number);
  std::vector<BoundaryLoop> result = loops;
  for (const HoleWithIslands& found : find_islands(model, all))
    if (numbers.contains(all[found.hole].number))
      for (int island : found.islands) result.push_back(all[island]);
  return result;
}

}  // namespace

SurfaceModel make_filling_view(TriangleSoup soup, std::optional<VertexSurvey> survey) {
  return make_view_around_loops(std::move(soup), {rings, {}}, std::move(survey));
}

bool widen_filling_view(SurfaceModel& model, const std::vector<BoundaryLoop>& all,
                        const std::vector<BoundaryLoop>& loops) {
  if (!model.beyond) return false;
  const std::vector<Eigen::AlignedBox3d> boxes = boxes_to_hold(model, with_islands(model, all, loops));
  if (boxes.empty()) return false;
  model = with_view_around(std::move(model), {rings, boxes});
  return true;
}

bool holds_neighborhood(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  return !model.beyond || (model.beyond->rings >= rings && boxes_to_hold(model, loops).empty());
}

}  // namespace loopmend
