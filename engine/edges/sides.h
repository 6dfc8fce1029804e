// SPDX-License-Identifier: GPL-3.0-or-later
// The neighborhood of a hole in sides, parted at sharp edges (docs/math/sharp_edges.md, "Sides").
#pragma once

#include "edges/side_surface.h"
#include "mesh/patch.h"

#include <optional>
#include <utility>
#include <vector>

namespace loopmend {

/// Edges that bend by more are sharp, whatever the noise.
inline constexpr double sharp_edge_deg = 25;

/// What a neighborhood without sharp edges is: one side, and nothing else.
struct Sides {
  std::vector<SideSurface> surfaces;  ///< of each side that bounds the hole
  std::vector<int> of_edge;           ///< of each loop edge (from place i to i + 1): its side
  double seam_deg = sharp_edge_deg;   ///< seams that bend by less are no edges
  double loop_price = 1;              ///< of a change of sides on the loop, beside the same within the patch
  int groups = 0;                     ///< of faces between sharp edges, also of those away from the hole
  double rms = 0;                     ///< of the vertices from the surfaces of their sides, patch frame
  double rms_of_one = 0;              ///< of all vertices from one polynomial
  bool are_noisy = false;             ///< parted by filtered normals
};

/// What parts or joins sides beside the surface itself.
struct SideEdits {
  std::vector<std::pair<int, int>>
      drawn;  ///< places on the loop: what lies on either hand of this line are different sides
  std::vector<std::pair<int, int>> joined;  ///< loop edges whose sides are one
};

/// Faces within six rings and `reach` diameters of the loop are grouped across edges below max(25°, 4 medians) of bend, under
/// noise of filtered normals; small groups join the most similar
/// neighbor. Sides that continue one another are one.
/// @param loop  which of patch.loops
/// @returns nothing where no edge is sharp or drawn, or where the sides do not say how they go on.
std::optional<Sides> find_sides(const Patch& patch, std::size_t loop, double reach, const SideEdits& edits = {});

}  // namespace loopmend
