// SPDX-License-Identifier: GPL-3.0-or-later
// Several files as the parts of one problem.
#pragma once

#include "cli/open_model.h"

#include "mesh/part_loops.h"

#include <filesystem>
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

}  // namespace loopmend
