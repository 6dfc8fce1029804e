// SPDX-License-Identifier: GPL-3.0-or-later
// Which loops of which files a command means.
#pragma once

#include "cli/open_model.h"

#include "mesh/join_parts.h"

#include <filesystem>
#include <string>
#include <vector>

namespace loopmend {

struct OpenedParts {
  std::vector<std::filesystem::path> paths;
  std::vector<ImportReport> imports;
  std::vector<ModelRepairs> repairs;
  JoinedParts joined;
};

/// @throws ReadError; InvalidArgument where parts overlap.
OpenedParts open_parts(const std::vector<std::filesystem::path>& paths);

/// A loop with the name that a person gave it, or could have given it: "2:1".
struct NamedLoop {
  std::string name;
  BoundaryLoop loop;
};

/// @param words  "1:2,2:1"; empty: of each file the loop that faces the others most, or the two loops of one file.
/// @throws UsageError for words that name no loop, or where the choice is not clear.
std::vector<NamedLoop> choose_part_loops(const JoinedParts& parts, const std::string& words);

}  // namespace loopmend
