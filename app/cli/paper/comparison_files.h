// SPDX-License-Identifier: GPL-3.0-or-later
// What a comparison of flows leaves in a folder: meshes, one picture, the profile as CSV and plot, tables.
#pragma once

#include "io/atomic_file.h"
#include "pipeline/compare.h"
#include "pipeline/problem.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace loopmend {

/// What write_comparison leaves in this folder.
std::vector<std::filesystem::path> comparison_files(const std::filesystem::path& folder);

/// Adds start.ply, one mesh for each flow, compare.png, profile.csv, profile.svg, table.csv, table.md to
/// what a command writes; the folder must be there.
/// @param title  of the plot.
/// @param eye    as in RenderOptions. @throws WriteError
void write_comparison(OutputTransaction& outputs, const Problem& problem, const FlowComparison& comparison,
                      const std::string& title, const std::filesystem::path& folder,
                      const std::optional<Vec3>& eye = std::nullopt);

}  // namespace loopmend
