// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/timeline.h"

#include <algorithm>
#include <numeric>

namespace loopmend {
namespace {

template <class T>
std::size_t bytes(const std::vector<T>& values) {
  return values.capacity() * sizeof(T);
}

std::size_t size_of(const Timeline& timeline) {
  return std::accumulate(timeline.begin(), timeline.end(), std::size_t{0},
                         [](std::size_t sum, const PatchStatePtr& state) { return sum + size_of(*state); });
}

}  // namespace

Timeline thinned(const Timeline& timeline, const PatchStatePtr& kept) {
  Timeline fewer;
  for (std::size_t i = 0; i < timeline.size(); ++i)
    if (i % 2 == 0 || i + 1 == timeline.size() || timeline[i] == kept) fewer.push_back(timeline[i]);
  return fewer;
}

std::size_t size_of(const PatchState& state) {
  std::size_t sum = sizeof(PatchState) + bytes(state.patch.positions) + bytes(state.patch.triangles) +
                    bytes(state.patch.ring) + bytes(state.patch.view_vertex);
  if (state.shape)
    sum += bytes(state.shape->points) + bytes(state.shape->normals) + state.shape->triangles.size() * sizeof(int) +
           bytes(state.shape->H) + bytes(state.shape->K);
  return sum;
}

TimelinePtr start_timeline(PatchStatePtr first) { return std::make_shared<Timeline>(Timeline{std::move(first)}); }

std::size_t place_in(const Timeline& timeline, const PatchStatePtr& state) {
  const auto found = std::find(timeline.begin(), timeline.end(), state);
  return found == timeline.end() ? timeline.size() - 1 : static_cast<std::size_t>(found - timeline.begin());
}

Timeline within(Timeline timeline, const PatchStatePtr& kept, std::size_t budget) {
  while (timeline.size() > 2 && size_of(timeline) > budget) {
    Timeline fewer = thinned(timeline, kept);
    if (fewer.size() == timeline.size()) break;
    timeline = std::move(fewer);
  }
  return timeline;
}

TimelinePtr extended(const Timeline& timeline, const PatchStatePtr& now, const std::vector<PatchStatePtr>& more,
                     std::size_t budget) {
  Timeline next(timeline.begin(), timeline.begin() + static_cast<std::ptrdiff_t>(place_in(timeline, now)) + 1);
  next.insert(next.end(), more.begin(), more.end());
  return std::make_shared<Timeline>(within(std::move(next), nullptr, budget));
}

}  // namespace loopmend
