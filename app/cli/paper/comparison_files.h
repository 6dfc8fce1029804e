// What a comparison of flows leaves in a folder: meshes, one picture, the profile as CSV and plot, tables.
#pragma once

#include "evolution/compare_flows.h"
#include "problems/problem.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <string>

namespace loopmend {

/// start.ply, one mesh for each flow, compare.png, profile.csv, profile.svg, table.csv, table.md.
/// @param title  of the plot.
/// @param eye    as in RenderOptions. @throws WriteError
void write_comparison(const Problem& problem, const FlowComparison& comparison, const std::string& title,
                      const std::filesystem::path& folder, const std::optional<Vec3>& eye = std::nullopt);

nlohmann::ordered_json comparison_json(const FlowComparison& comparison);

/// Writes text atomically. @throws WriteError
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace loopmend
