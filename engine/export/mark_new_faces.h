// SPDX-License-Identifier: GPL-3.0-or-later
// Labels on what the scan did not have: its triangles, and how far its vertices are likely from what was there.
#pragma once

#include "mesh/triangle_soup.h"

#include <filesystem>
#include <vector>

namespace loopmend {

/// Labels the triangles without a row of the file, as the format of the output has room for it: PLY and polydata by the face property `patch`,
/// 1 for them and 0 for others; OBJ by the group, glTF and 3MF by the object `loopmend_patch`. To be called last, after
/// continue_attributes(). @returns whether the format has such a label; STL and OFF have none.
/// @throws WriteError for an unknown extension.
bool mark_new_faces(const std::filesystem::path& path, TriangleSoup& soup);

/// PLY and polydata: vertex property `expected_deviation`, mesh units, 0 for the vertices of the scan.
/// @param values  of the last vertices of the soup. @returns whether the format has room for it: these two.
bool label_expected_deviation(const std::filesystem::path& path, TriangleSoup& soup, const std::vector<double>& values);

}  // namespace loopmend
