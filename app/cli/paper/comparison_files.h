// What a comparison of flows leaves in a folder: meshes, one picture, the profile as CSV and plot, tables.
#pragma once

#include "evolution/compare_flows.h"
#include "mesh/surface_model.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <functional>
#include <string>

namespace loopmend {

/// Where all flows begin, and how a patch becomes the whole surface again.
struct ComparisonStart {
  Patch patch;
  std::function<TriangleSoup(const Patch&)> surface;
};

/// "MCF", "SDF", "WF", "MMCVF".
std::string upper_name(FlowKind flow);

/// start.ply, one mesh for each flow, compare.png, profile.csv, profile.svg, table.csv, table.md.
/// @param title  of picture and plot. @throws WriteError
void write_comparison(const ComparisonStart& start, const FlowComparison& comparison, const std::string& title,
                      const std::filesystem::path& folder);

/// The table for people: energies and seam figures by flow.
std::string comparison_table(const FlowComparison& comparison);
nlohmann::ordered_json comparison_json(const FlowComparison& comparison);

/// Writes text atomically. @throws WriteError
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace loopmend
