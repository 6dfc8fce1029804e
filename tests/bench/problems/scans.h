// SPDX-License-Identifier: GPL-3.0-or-later
// The shared scans, made fit to be cut: one component, oriented, boundaries trimmed.
#pragma once

#include "mesh/triangle_soup.h"

#include <string>
#include <vector>

namespace loopmend::bench {

/// bunny, dragon, head, lps_head, demosthenes, doll.
const std::vector<std::string>& scan_names();

/// Read once and kept. Not thread-safe.
/// @throws ReadError if the file is not there: the folder is LOOPMEND_SHARED_DIR/data.
const TriangleSoup& scan(const std::string& name);

/// Largest side of the bounding box, mesh units: the size of an object.
double extent(const TriangleSoup& soup);

}  // namespace loopmend::bench
