// SPDX-License-Identifier: GPL-3.0-or-later
// Folds of a patch, opened by moving single vertices.
#pragma once

#include "core/cancel.h"
#include "mesh/patch.h"

namespace loopmend {

/// Turns triangles at edges that are bent by more than `limit_deg` about these edges, where their third vertex is free, until
/// no such edge is left or turning helps no more. @returns whether anything was moved. The caller judges the result.
bool unfold(Patch& patch, double limit_deg, const CancelToken& cancel);

}  // namespace loopmend
