// SPDX-License-Identifier: GPL-3.0-or-later
// Finished patches into the surface, with the two checks that no result leaves without.
#pragma once

#include "mesh/patch.h"
#include "mesh/surface_model.h"

#include <string>
#include <vector>

namespace loopmend {

/// Pastes the patches in the order of their smallest loop numbers, whatever order they come in. Patches that were solved
/// without knowing of each other are tested against each other first: one that would intersect an earlier one is left out.
/// @returns one entry for each patch: why it was left out; empty where it was pasted.
/// A patch for which there is no memory left is left out, too. @throws std::bad_alloc, with the model unchanged;
/// std::logic_error if a point or triangle of the model was changed, which would be a fault of this program.
std::vector<std::string> paste_patches(SurfaceModel& model, const std::vector<const Patch*>& patches);

/// @throws std::logic_error unless `now` begins with the points of `before`, bit for bit, and its triangles in their order,
/// of which `turned` may have been turned round.
void check_exterior(const TriangleSoup& before, const TriangleSoup& now, std::size_t turned);

}  // namespace loopmend
