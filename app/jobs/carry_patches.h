// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of the patches of a scan when another one, changed elsewhere, comes in its place.
#pragma once

#include "document/opened_scan.h"
#include "document/patch_state.h"

#include <vector>

namespace loopmend {

/// Where the points of a scan's soup are in another; −1: gone. Empty: where they were.
using NewPoints = std::vector<int>;

/// Those patches whose holes and fixed vertices are in the new scan as they were, as patches of it. Their loops are counted
/// within the scan, ids and scan are not set, and of their timelines the first state and the present one stay.
std::vector<OpenPatch> carried_patches(const std::vector<OpenPatch>& patches, int first_loop, const OpenedScan& from,
                                       const OpenedScan& to, const NewPoints& new_points);

}  // namespace loopmend
