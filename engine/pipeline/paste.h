// SPDX-License-Identifier: GPL-3.0-or-later
// Finished patches into the surface, with the two checks that no result leaves without.
#pragma once

#include "core/message.h"
#include "mesh/patch.h"
#include "mesh/surface_model.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace loopmend {

/// What became of a patch.
struct PastedPatch {
  Message fault;            ///< why it was left out; empty: it was pasted
  int first_point = -1;     ///< of its own in the surface, which follow one another; -1: left out
  int first_triangle = -1;  ///< the same for its triangles
};

/// Pastes the patches in the order of their smallest loop numbers, whatever order they come in. Patches that were solved
/// without knowing of each other are tested against each other first: one that would intersect an earlier one is left out, and one
/// that would make an edge with more than two faces of surface and patches together (mesh/chord_faces.h).
/// @returns one entry for each patch, in the order in which they came.
/// A patch for which there is no memory left is left out, too. @throws std::bad_alloc, with the model unchanged;
/// std::logic_error if a point or triangle of the model was changed, which would be a fault of this program.
std::vector<PastedPatch> paste_patches(SurfaceModel& model, const std::vector<const Patch*>& patches);

/// What a soup was, to tell later whether it is still so, without a copy of it: counts, and a checksum (CRC-32) of each
/// stretch of its points and triangles.
struct SoupRecord {
  std::size_t points = 0, triangles = 0;
  std::vector<std::uint32_t> sums{};
};

/// @param turned  triangles that are recorded as if they were turned round, ascending
SoupRecord record_of(const TriangleSoup& soup, const std::vector<int>& turned = {});

/// @throws std::logic_error unless `now` begins with the recorded points, bit for bit, and the recorded triangles in their order,
/// of which those in `turned` were turned round.
void check_exterior(const SoupRecord& before, const TriangleSoup& now, const std::vector<int>& turned = {});

/// @throws std::logic_error unless `now` begins with the points of `before`, bit for bit, and its triangles in their order,
/// of which `turned` may have been turned round.
void check_exterior(const TriangleSoup& before, const TriangleSoup& now, std::size_t turned);

}  // namespace loopmend
