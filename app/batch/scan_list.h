// SPDX-License-Identifier: GPL-3.0-or-later
// Which scans a batch fills, and how their outputs are named.
#pragma once

#include "batch_job.h"

#include "core/message.h"

#include <filesystem>
#include <string>
#include <vector>

namespace loopmend {

struct Scan {
  std::filesystem::path input;
  std::string name;                  ///< of the output, with the folders above it; no two scans have the same
  std::vector<std::string> options;  ///< of fill: those of the batch, then its own
  Message fault;                     ///< why it cannot be tried; mostly empty
};

/// Files as they are named, the meshes of folders and of the folders in them, and the lines of manifests, without the folder of
/// the results. Outputs have the places of their inputs below the deepest folder that holds all of them, unless a manifest names
/// them.
/// @throws UsageError for a manifest that is none, an input among the results, two scans with one output, and where there is no
/// scan at all.
std::vector<Scan> list_scans(const BatchJob& job);

}  // namespace loopmend
