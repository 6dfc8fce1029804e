// SPDX-License-Identifier: GPL-3.0-or-later
// Rings missing from tubes whose every point is known: ours, others on the same mesh, and the exact surface.
#pragma once

#include "table.h"

namespace loopmend::bench {

/// A cylinder and an unduloid with 24 to 96 vertices around, on three kinds of mesh.
Table run_ring_gaps();

}  // namespace loopmend::bench
