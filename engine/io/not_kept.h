// SPDX-License-Identifier: GPL-3.0-or-later
// What a file holds that is not in a file that Loopmend writes.
#pragma once

#include "core/message.h"

#include <cstddef>
#include <string>
#include <vector>

namespace loopmend {

/// One kind of thing that a reader counts and leaves out, or that a format has no room for.
struct NotKept {
  Message what;  ///< in the plural: "normals", "face property \"quality\""
  std::size_t count = 0;
};

/// Adds to the entry of that name, or a new one; nothing for a count of 0 or an empty name.
void count_not_kept(std::vector<NotKept>& list, const Message& what, std::size_t count = 1);

/// "normals (9992), materials (3)"; empty for an empty list.
std::string to_string(const std::vector<NotKept>& list);

}  // namespace loopmend
