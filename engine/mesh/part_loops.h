// SPDX-License-Identifier: GPL-3.0-or-later
// Which loops of several parts are to be joined.
#pragma once

#include "mesh/join_parts.h"

#include <string>
#include <vector>

namespace loopmend {

/// A loop with the name that a person gave it, or could have given it: "2:1", part and loop from 1.
struct NamedLoop {
  std::string name;
  BoundaryLoop loop;
};

/// @param words  "1:2,2:1"; empty: of each part the loop that faces the others most, or the two loops of one part.
/// @throws InvalidArgument for words that name no loop, or where the choice is not clear.
std::vector<NamedLoop> choose_part_loops(const JoinedParts& parts, const std::string& words);

}  // namespace loopmend
