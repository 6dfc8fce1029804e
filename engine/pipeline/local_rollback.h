// SPDX-License-Identifier: GPL-3.0-or-later
// Where an evolved patch folds or cuts the surface at a few places, it goes back to its start there alone.
#pragma once

#include "core/cancel.h"
#include "mesh/patch.h"
#include "pipeline/validate.h"

#include <optional>

namespace loopmend {

struct LocalRollback {
  Patch patch;
  Validity validity;  ///< on the patch
  int rings = 0;      ///< over which it goes back around each spoilt place; 0 where there is none
  int moved = 0;      ///< free vertices that are not where they were in the evolved patch
};

/// Vertices of spoilt triangles go back to the start, and those around them less and less, over 1, 2, 4, ... edges, until
/// the patch may be kept; places that are spoilt on the way go back, too. The other vertices keep the bits of `evolved`.
/// The triangles are those of `evolved`, in which the start may be folded at its creases.
/// @param start  with the same vertices. @param limit  the patch may be kept if it is no worse than that.
/// @returns empty if that takes the whole patch back, if the two patches have not the same number of vertices, or when cancelled.
std::optional<LocalRollback> roll_back_locally(const ScanIndex& scan, const Patch& start, const Patch& evolved,
                                               const Validity& limit, const CancelToken& cancel);

}  // namespace loopmend
