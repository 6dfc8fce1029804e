// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/edge_preview.h"

#include "core/error.h"
#include "filling/loop_patch.h"
#include "pipeline/flat_cut.h"
#include "pipeline/initial_patch.h"

#include <algorithm>
#include <map>
#include <set>

namespace loopmend {

namespace {

int soup_point(const SurfaceModel& model, const Patch& patch, int vertex) {
  return model.soup_vertex[patch.view_vertex[vertex]];
}

}  // namespace

EdgeEdits edits_at(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, const EdgeEdits& edits) {
  if (edits.empty()) return {};
  std::set<int> points;
  for (const BoundaryLoop& loop : loops)
    for (int v : loop.vertices) points.insert(model.soup_vertex[v]);
  EdgeEdits own = edits;
  std::erase_if(own.drawn,
                [&](const auto& ends) { return !points.contains(ends.first) || !points.contains(ends.second); });
  std::erase_if(own.stopped, [&](int point) { return !points.contains(point); });
  return own;
}

LoopEdits edits_of(const SurfaceModel& model, const Patch& patch, const EdgeEdits& edits) {
  LoopEdits own;
  if (edits.empty() || patch.loops.size() != 1) return own;
  std::map<int, int> place_of;
  for (int place = 0; place < static_cast<int>(patch.loops[0].size()); ++place)
    place_of.emplace(soup_point(model, patch, patch.loops[0][place]), place);
  for (const auto& [a, b] : edits.drawn)
    if (place_of.contains(a) && place_of.contains(b)) own.drawn.emplace_back(place_of[a], place_of[b]);
  for (int point : edits.stopped)
    if (place_of.contains(point)) own.stopped.push_back(place_of[point]);
  return own;
}

std::vector<ContinuedEdge> continued_edges(const SurfaceModel& model, const BoundaryLoop& loop, const EdgeEdits& edits,
                                           double density, const CancelToken& cancel) {
  const std::optional<Patch> initial = make_initial_patch(model, {loop}, {density}, cancel).patch;
  if (!initial || initial->free_count == 0 || cancel.cancelled()) return {};
  const LoopEdits own = edits_of(model, *initial, edits);
  if (own.drawn.empty() && loop_end(model, loop) != LoopEnd::runs_on) return {};
  const std::optional<SharpPatch> sharp = continue_sharp_edges(*initial, own, cancel).patch;
  std::vector<ContinuedEdge> edges;
  if (!sharp) return edges;
  const auto loop_size = static_cast<int>(initial->loops[0].size());
  const auto boundary_point = [&](int v) {
    return v < loop_size ? soup_point(model, *initial, initial->loops[0][v]) : -1;
  };
  for (const std::vector<int>& seam : sharp->edges) {
    ContinuedEdge& edge = edges.emplace_back();
    for (int v : seam) edge.line.push_back(sharp->patch.points[v]);
    edge.begin = boundary_point(seam.front());
    edge.end = boundary_point(seam.back());
  }
  return edges;
}

void check(const EdgeEdits& edits, const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::map<int, std::vector<std::pair<std::size_t, int>>> places;  // loop and place on it, by soup point
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (int place = 0; place < loops[l].edges(); ++place)
      places[model.soup_vertex[loops[l].vertices[place]]].emplace_back(l, place);
  const auto on_boundary = [&](int point) {
    if (!places.contains(point)) throw InvalidArgument(say("vertex %1 lies on no boundary loop", point));
    return places[point];
  };
  for (int point : edits.stopped) on_boundary(point);
  for (const auto& [a, b] : edits.drawn) {
    const auto &first = on_boundary(a), &second = on_boundary(b);
    const bool fits = std::any_of(first.begin(), first.end(), [&](const auto& from) {
      return std::any_of(second.begin(), second.end(), [&](const auto& to) {
        const int edges = loops[from.first].edges(), apart = std::abs(from.second - to.second);
        return from.first == to.first && apart > 1 && apart < edges - 1;
      });
    });
    if (!fits)
      throw InvalidArgument(
          say("no edge can be drawn from vertex %1 to %2: they are not on one hole, or beside each other", a, b));
  }
}

}  // namespace loopmend
