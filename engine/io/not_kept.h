// SPDX-License-Identifier: GPL-3.0-or-later
// What a file holds beside points, faces and vertex colours, and what of it is not in a file that Loopmend writes.
#pragma once

#include "mesh/triangle_soup.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace loopmend {

/// One kind of thing that a reader counts and leaves out, or that a format has no room for.
struct NotKept {
  std::string what;  ///< in the plural: "normals", "face property \"quality\""
  std::size_t count = 0;
};

/// Adds to the entry of that name, or a new one; nothing for a count of 0 or an empty name.
void count_not_kept(std::vector<NotKept>& list, const std::string& what, std::size_t count = 1);

/// What of the soup the format of this name has no room for: colours and lone points in STL, alpha in OBJ.
/// @throws WriteError for an unknown extension.
std::vector<NotKept> not_kept_by_format(const std::filesystem::path& path, const TriangleSoup& soup);

/// "normals (9992), materials (3)"; empty for an empty list.
std::string to_string(const std::vector<NotKept>& list);

}  // namespace loopmend
