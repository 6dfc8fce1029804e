// SPDX-License-Identifier: GPL-3.0-or-later
// Single vertices that stand off an otherwise smooth surface: a spike of the scanner, not its shape.
#pragma once

#include "mesh/patch.h"

namespace loopmend {

/// The neighborhood without its outliers, and how many there were.
struct CleanNeighborhood {
  Patch patch;       ///< outliers moved towards the surface round about; all else as it was, bit for bit
  int outliers = 0;  ///< 0: the patch is as it was
};

/// A fixed vertex of rings 1 to 4 is an outlier as far as its distance from a robust cubic fit of its neighbours, itself left
/// out, exceeds both 0.03 mean edges and ten times the median of these distances; from twice that on it is moved onto the
/// fit. The largest are taken first, since they lead the fits beside them astray. More than two within two edges of one
/// another are a feature, and stay. Where the median itself exceeds 0.03 mean edges, the neighborhood is rough: it has no outliers.
CleanNeighborhood remove_outliers(const Patch& patch);

/// The free vertices of `solved`, carried along from its fixed vertices to those of `original`, which are met bit for bit: their
/// offset fades from the loops into the patch, to 1/e within `reach` and faster.
/// @param reach  > 0, patch frame.
Patch carried_to(const Patch& original, const Patch& solved, double reach);

}  // namespace loopmend
