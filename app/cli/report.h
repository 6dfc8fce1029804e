// SPDX-License-Identifier: GPL-3.0-or-later
// The JSON report of `loopmend info` and `loopmend fill`.
#pragma once

#include "io/read_mesh.h"
#include "mesh/surface_model.h"
#include "pipeline/evolve_patch.h"
#include "pipeline/fill_holes.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>

namespace loopmend {

/// Grows when a field of the reports goes, or means something else. See docs/user/report.schema.json and info.schema.json.
constexpr int report_schema_version = 5;

/// "input": path, vertices, faces, import {counts by kind}.
nlohmann::ordered_json input_json(const std::filesystem::path& path, const ImportReport& import,
                                  const ModelRepairs& repairs);

/// The figures of a seam; null where there is none.
nlohmann::ordered_json seam_json(const SeamReport& seam);

/// Number, edges, lengths and kind of a loop.
nlohmann::ordered_json loop_json(const BoundaryLoop& loop);

/// The same with status, times, energies and seam figures.
nlohmann::ordered_json loop_json(const HoleResult& result);

/// What counts of a loop that is one of thousands.
nlohmann::ordered_json brief_loop_json(const HoleResult& result);

/// Status, steps, energies, times and quality of a patch that was evolved by itself.
nlohmann::ordered_json patch_json(const PatchResult& result);

/// One line on why something else than the flow was done; nothing where there is no reason.
void print_reason(std::FILE* out, const Message& reason);

}  // namespace loopmend
