// SPDX-License-Identifier: GPL-3.0-or-later
// How many triangles cut each other, where it does not matter which.
#pragma once

#include "core/cancel.h"
#include "core/types.h"

#include <cstddef>

namespace loopmend {

/// The number of pairs that self_intersections() would return for all triangles, or `most` where there are more: loose triangles may
/// have as many as their number squared.
std::size_t count_self_intersections(const Points& points, const Triangles& triangles, std::size_t most,
                                     const CancelToken& cancel = {});

}  // namespace loopmend
