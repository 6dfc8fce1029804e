// SPDX-License-Identifier: GPL-3.0-or-later
// Recorded states of a patch: appending, going back, staying within a memory budget.
#pragma once

#include "document/patch_state.h"

namespace loopmend {

/// A timeline that holds one state.
TimelinePtr start_timeline(PatchStatePtr first);

/// Where `state` stands; the last place if it is not recorded.
std::size_t place_in(const Timeline& timeline, const PatchStatePtr& state);

/// Without every second one of its inner states; the first, the last and `kept` stay.
Timeline thinned(const Timeline& timeline, const PatchStatePtr& kept);

/// Thinned as often as needed to take at most `budget` bytes of memory.
Timeline within(Timeline timeline, const PatchStatePtr& kept, std::size_t budget);

/// The timeline up to `now`, then `more`. Above `budget` bytes every second one of the inner states is forgotten, as
/// often as needed; the first and the last stay.
TimelinePtr extended(const Timeline& timeline, const PatchStatePtr& now, const std::vector<PatchStatePtr>& more,
                     std::size_t budget);

}  // namespace loopmend
