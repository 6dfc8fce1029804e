// The JSON report of `loopmend info` and `loopmend fill`.
#pragma once

#include "evolution/evolve_patch.h"
#include "evolution/fill_loops.h"
#include "io/read_mesh.h"
#include "mesh/surface_model.h"

#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace loopmend {

/// "input": path, vertices, faces, import {counts by kind}.
nlohmann::ordered_json input_json(const std::filesystem::path& path, const ImportReport& import,
                                  const ModelRepairs& repairs);

/// The figures of a seam; null where there is none.
nlohmann::ordered_json seam_json(const SeamReport& seam);

/// Number, edges, lengths and kind of a loop.
nlohmann::ordered_json loop_json(const BoundaryLoop& loop);

/// The same with status, times, energies and seam figures.
nlohmann::ordered_json loop_json(const LoopResult& result);

/// Status, steps, energies, times and quality of a patch that was evolved by itself.
nlohmann::ordered_json evolved_json(const EvolvedPatch& evolved);

/// Before long work: can the mesh be written, can the report, and does the report land on none of the meshes?
/// @throws WriteError, UsageError
void check_outputs(const std::vector<std::filesystem::path>& inputs, const std::filesystem::path& output,
                   const std::string& report);

/// True if both names mean one file, be it there already or not.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// Writes to the file, or to standard output for "-". @throws WriteError
void write_report(const std::string& target, const nlohmann::ordered_json& report);

}  // namespace loopmend
