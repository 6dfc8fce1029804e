// SPDX-License-Identifier: GPL-3.0-or-later
// The embedded sample: a scan-like relief that our own code makes, so that a first run needs no download.
#pragma once

#include "mesh/triangle_soup.h"

namespace loopmend {

/// A smooth organic relief (a sleeping mask, about 120 × 150 × 55) in millimetres with measured noise, five holes of
/// different shape, and an outer rim. Normals point towards the viewer, +z. The same bits on every call.
TriangleSoup make_sample_scan();

/// The same scan before the holes were cut: the truth that a filling can be compared with.
TriangleSoup make_complete_sample_scan();

/// Height of the noiseless relief over (x, y), millimetres. Smooth on the whole plane.
double sample_relief_height(double x, double y);

}  // namespace loopmend
