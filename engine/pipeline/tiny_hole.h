// SPDX-License-Identifier: GPL-3.0-or-later
// Holes of three to eight edges, of which a scan may have thousands: closed by a few triangles, without a flow.
#pragma once

#include "pipeline/solve_group.h"

#include <optional>

namespace loopmend {

/// Closes the hole by triangles between its own vertices or, where the loop is compact, around one new vertex on a quadric fitted to
/// the neighborhood (docs/dev/filling.md, "Tiny holes").
/// @param rings  of fixed vertices that the patch carries, 2..patch_rings: two are enough to paste it. The geometry does not depend on it.
/// @returns nothing where the loop is larger, touches others, or the options ask for a certain treatment, and where a Judge would have
/// a finding: such a hole is for solve_group().
std::optional<GroupResult> close_tiny_hole(const ScanIndex& scan, const BoundaryLoop& loop, const GroupOptions& options,
                                           int rings);

}  // namespace loopmend
