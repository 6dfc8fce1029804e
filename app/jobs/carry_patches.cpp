// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/carry_patches.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace loopmend {
namespace {

class Carrier {
 public:
  Carrier(const OpenedScan& from, const OpenedScan& to, const NewPoints& new_points)
      : from_(from),
        to_(to),
        new_points_(new_points),
        view_(to.model->soup.points.size(), none) {
    for (std::size_t v = 0; v < to.model->soup_vertex.size(); ++v) {
      int& view = view_[to.model->soup_vertex[v]];
      view = view == none ? static_cast<int>(v) : several;
    }
  }

  /// Of the new scan's view; negative where there is none, or more than one.
  int vertex(int old_vertex) const {
    const auto old_point = static_cast<std::size_t>(from_.model->soup_vertex[old_vertex]);
    const int point = new_points_.empty() ? static_cast<int>(old_point) : new_points_[old_point];
    return point < 0 ? none : view_[point];
  }

  /// The loop that runs through the same vertices; it may begin at another. −1: there is none.
  int loop(const BoundaryLoop& old) const {
    std::vector<int> wanted;
    for (int v : old.vertices) wanted.push_back(vertex(v));
    const auto from_lowest = [](std::vector<int> vertices) {
      std::rotate(vertices.begin(), std::min_element(vertices.begin(), vertices.end()), vertices.end());
      return vertices;
    };
    wanted = from_lowest(std::move(wanted));
    const auto found = std::find_if(to_.loops.begin(), to_.loops.end(),
                                    [&](const BoundaryLoop& l) { return from_lowest(l.vertices) == wanted; });
    return found == to_.loops.end() ? none : static_cast<int>(found - to_.loops.begin());
  }

  std::optional<OpenPatch> patch(const OpenPatch& old, int first_loop) const {
    OpenPatch made = old;
    std::vector<int> numbers;
    for (int& l : made.loops) {
      l = loop(from_.loops[l - first_loop]);
      if (l < 0) return std::nullopt;
      numbers.push_back(to_.loops[l].number);
    }
    const auto state = [&](const PatchStatePtr& before) -> PatchStatePtr {
      auto after = std::make_shared<PatchState>(*before);
      after->patch.loop_numbers = numbers;
      for (int& v : after->patch.view_vertex) {
        if (v < 0) continue;
        v = vertex(v);
        if (v < 0) return nullptr;
      }
      return after;
    };
    made.state = state(old.state);
    if (!made.state) return std::nullopt;
    auto timeline = std::make_shared<Timeline>();
    if (old.timeline->front() != old.state) timeline->push_back(state(old.timeline->front()));
    timeline->push_back(made.state);
    if (!timeline->front()) return std::nullopt;
    made.timeline = std::move(timeline);
    return made;
  }

 private:
  static constexpr int none = -1, several = -2;
  const OpenedScan &from_, &to_;
  const NewPoints& new_points_;
  std::vector<int> view_;  ///< per point of the new soup
};

}  // namespace

std::vector<OpenPatch> carried_patches(const std::vector<OpenPatch>& patches, int first_loop, const OpenedScan& from,
                                       const OpenedScan& to, const NewPoints& new_points) {
  std::vector<OpenPatch> carried;
  if (patches.empty()) return carried;
  const Carrier carrier(from, to, new_points);
  for (const OpenPatch& patch : patches)
    if (auto made = carrier.patch(patch, first_loop)) carried.push_back(std::move(*made));
  return carried;
}

}  // namespace loopmend
