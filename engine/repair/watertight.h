// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a surface encloses a volume, as a 3D printer needs it.
#pragma once

#include "core/cancel.h"
#include "mesh/triangle_soup.h"

#include <cstddef>
#include <string>
#include <vector>

namespace loopmend {

/// Loose triangles may have as many as their number squared.
inline constexpr std::size_t most_intersections = 1'000'000;

/// Counts over the triangles that have three different corners; points in exactly the same place are one, as a printer sees
/// them.
struct Watertightness {
  std::size_t pieces = 0;           ///< parts of the surface that share no vertex
  std::size_t open_boundaries = 0;  ///< loops of open edges; two that touch at a vertex are two
  std::size_t open_edges = 0;       ///< of one triangle
  std::size_t touching_edges = 0;   ///< of more than two, in pairs that agree: where a body touches another, or itself
  std::size_t non_manifold_edges = 0;  ///< of more than two that are not in such pairs
  std::size_t reversed_edges = 0;      ///< whose two triangles do not agree which side is outside
  std::size_t intersections = 0;       ///< pairs of triangles that cut each other, counted up to most_intersections
  std::size_t inverted_shells = 0;     ///< bodies and cavities that are inside out among several: see InvertedShells
  double volume = 0;  ///< cubic mesh units; negative: inside out. Tells nothing where the surface is open

  /// Whether inside and outside are distinct everywhere: a body that touches itself along an edge is still a body.
  bool encloses() const { return open_edges + non_manifold_edges + reversed_edges == 0; }
  bool printable() const { return encloses() && intersections == 0 && inverted_shells == 0 && volume > 0; }
};

/// @returns what was counted; cancelled, nothing of use.
Watertightness watertightness(const TriangleSoup& soup, const CancelToken& cancel = {});

/// What stands against printing it, one phrase each, such as "2 open boundaries"; empty where it is printable.
std::vector<std::string> faults(const Watertightness& surface);

}  // namespace loopmend
