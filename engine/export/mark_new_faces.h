// SPDX-License-Identifier: GPL-3.0-or-later
// A label on the triangles that the scan did not have.
#pragma once

#include "mesh/triangle_soup.h"

#include <filesystem>

namespace loopmend {

/// Labels the triangles without a row of the file, as the format of the output has room for it: PLY by the face property `patch`,
/// 1 for them and 0 for others; OBJ by the group, glTF and 3MF by the object `loopmend_patch`. To be called last, after
/// continue_attributes(). @returns whether the format has such a label; STL and OFF have none.
/// @throws WriteError for an unknown extension.
bool mark_new_faces(const std::filesystem::path& path, TriangleSoup& soup);

}  // namespace loopmend
