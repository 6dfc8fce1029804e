// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices named in a file, or by a condition on a number that each of them has.
#pragma once

#include "mesh/surface_model.h"

#include <filesystem>
#include <string>
#include <vector>

namespace loopmend {

/// Numbers (0-based) parted by blanks, commas or line ends; the rest of a line after # is a comment.
/// @throws ReadError for anything else, and for a file without a number.
std::vector<int> read_vertex_numbers(const std::filesystem::path& path);

/// @param condition  "NAME OP NUMBER" with NAME x, y, z, H or K and OP <, >, <=, >=; several joined by commas must all
/// hold: "z>0.725", "x>0,H<-0.5". H and K are fitted curvatures in 1/length and 1/length².
/// @returns soup points. @throws UsageError.
std::vector<int> vertices_where(const SurfaceModel& model, const std::string& condition);

}  // namespace loopmend
