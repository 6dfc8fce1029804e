// SPDX-License-Identifier: GPL-3.0-or-later
// Surroundings under white noise: a problem without the noise, and its answer carried back to the surroundings as they are.
#pragma once

#include "mesh/patch.h"

#include <limits>

namespace loopmend {

/// The patch with every fixed vertex moved towards a robust cubic fit of its surroundings, and the free ones carried along:
/// the sixth order then meets the shape instead of the noise. The fits reach over 4 rings, and on over 6, 8 and 10 as far as
/// they leave over no more than the noise; one width passes into the next without a jump.
/// @param model  the patch was made of; fits look farther than the patch's own rings.
/// @param share  0..1: how far the vertices go; 1 is onto the fits.
Patch without_noise(const Patch& patch, const SurfaceModel& model, double share);

/// The free vertices of `solved`, carried along from its loops to those of `original`: their offset runs harmonically into
/// the patch. Fixed vertices are those of `original`, bit for bit.
/// @param solved  from without_noise(original), whatever became of its free vertices and triangles.
/// @param reach  > 0, patch frame: the way on which the offset fades to 1/e, on top of what it does harmonically.
Patch with_noise_again(const Patch& solved, const Patch& original,
                       double reach = std::numeric_limits<double>::infinity());

}  // namespace loopmend
