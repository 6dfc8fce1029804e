// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "core/path_text.h"
#include "exit_codes.h"
#include "open_model.h"
#include "outputs.h"
#include "report.h"
#include "verdict.h"

#include "repair/inverted_shells.h"
#include "repair/stitch_boundaries.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstdio>
#include <limits>
#include <optional>
#include <string>

namespace loopmend {

namespace {

void print_count(std::size_t count, const char* one, const char* many) {
  if (count > 0) std::printf("  %s\n", counted(count, one, many).c_str());
}

void print_import(const ImportReport& import, const ModelRepairs& repairs) {
  print_count(import.polygons_triangulated, "polygon was triangulated", "polygons were triangulated");
  print_count(import.vertices_welded, "vertex was welded", "vertices were welded");
  if (import.near_vertices_joined > 0)
    std::printf("  %s joined to others up to %.2g away along cracks no wider than rounding\n",
                counted(import.near_vertices_joined, "vertex was", "vertices were").c_str(), import.largest_join);
  print_count(import.vertices_joined, "boundary vertex touches another in the same place; its faces name that one now",
              "boundary vertices touch others in the same place; their faces name these now");
  print_count(import.unreferenced_vertices, "vertex belongs to no face; it is kept",
              "vertices belong to no face; they are kept");
  print_count(import.coincident_vertices, "vertex lies exactly on another; it is kept apart",
              "vertices lie exactly on another; they are kept apart");
  print_count(import.degenerate_faces, "face has no area; it is kept", "faces have no area; they are kept");
  print_count(import.duplicate_faces, "face is there twice; it is kept", "faces are there twice; they are kept");
  for (const NotKept& oddity : import.oddities)
    print_count(oddity.count, oddity.what.english().c_str(), oddity.what.english().c_str());
  print_count(import.missing_colors, "vertex has no colour in a file with colours; it is white",
              "vertices have no colour in a file with colours; they are white");
  print_count(repairs.non_manifold_edges, "edge has more than two faces", "edges have more than two faces");
  print_count(repairs.non_manifold_vertices, "vertex joins several fans of faces",
              "vertices join several fans of faces");
  print_count(repairs.reoriented_faces, "face was turned round to agree with its neighbours",
              "faces were turned round to agree with their neighbours");
}

/// What no output will hold, and what only some formats have room for.
void print_not_kept(const OpenedModel& opened) {
  if (const std::vector<NotKept> carried = carried_attributes(opened.model.soup); !carried.empty())
    std::printf("  also holds: %s\n", to_string(carried).c_str());
  if (!opened.import.not_kept.empty())
    std::printf("  in no file that Loopmend writes: %s\n", to_string(opened.import.not_kept).c_str());
  for (const char* format : {"PLY", "STL", "OBJ", "OFF", "GLB", "3MF", "VTP"}) {
    const std::vector<NotKept> list = not_kept_by_format(std::string("x.") + format, opened.model.soup);
    if (!list.empty()) std::printf("  not in %s: %s\n", format, to_string(list).c_str());
  }
  Eigen::AlignedBox3d box;
  for (const Vec3& point : opened.model.soup.points) box.extend(point);
  const double rounding = largest_rounding("x.stl", opened.model.soup, Encoding::binary);
  // That of coordinates of the mesh's own size is no news; a scan far from the origin is.
  if (rounding > 1e-6 * box.diagonal().norm())
    std::printf("  binary STL would move vertices by up to %.3g\n", rounding);
}

/// What stands against a fill before any hole is looked at, and what cures it.
struct Findings {
  NearBoundaries boundaries;
  InvertedShells inverted;
  NoDataVertices no_data;
  OverlappingOutlines overlapping;
};

Findings findings_of(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  return {loops.empty() ? NearBoundaries() : near_boundaries(model), find_inverted_shells(model, loops),
          find_no_data(model.soup.points), find_overlapping_outlines(model, loops)};
}

void print_findings(const Findings& found) {
  print_inverted(stdout, found.inverted, "  ");
  print_tiles(stdout, {0, found.overlapping}, "  ");
  std::string beside;
  if (found.boundaries.vertices > 0)
    beside = counted(found.boundaries.vertices, "boundary vertex lies", "boundary vertices lie") +
             " within a tenth of the edges there of another";
  if (found.boundaries.faces > 0)
    beside += (beside.empty() ? "" : ", ") + counted(found.boundaries.faces,
                                                     "face has a boundary vertex of others on an edge",
                                                     "faces have boundary vertices of others on an edge");
  if (!beside.empty()) std::printf("  %s: fill --stitch joins them\n", beside.c_str());
}

/// Of the file as it is: faces that disagree count.
Watertightness verdict_before_turning(const SurfaceModel& model) {
  if (model.turned_faces.empty()) return watertightness(model.soup);
  return watertightness(as_read(model));
}

/// How many loops there are of each kind.
void print_kinds(const std::vector<BoundaryLoop>& loops) {
  std::string words;
  for (const LoopKind kind : {LoopKind::hole, LoopKind::outer_rim, LoopKind::crack, LoopKind::cut}) {
    const auto count =
        std::count_if(loops.begin(), loops.end(), [kind](const auto& loop) { return loop.kind == kind; });
    if (count == 0) continue;
    words += (words.empty() ? "" : ", ") + std::to_string(count) + " " + to_string(kind);
    if (count > 1) words += "s";
  }
  std::printf("  %s\n", words.c_str());
}

/// Of the input, on the loop.
int lowest_vertex(const SurfaceModel& model, const BoundaryLoop& loop) {
  int lowest = std::numeric_limits<int>::max();
  for (int v : loop.vertices) lowest = std::min(lowest, model.soup_vertex[v]);
  return lowest;
}

void print_loops(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, Detail detail) {
  const bool all = detail == Detail::all || loops.size() <= most_loops_in_full;
  const std::size_t most_rows = all ? loops.size() : largest_loops;
  if (!all) print_kinds(loops);
  std::printf("\n%6s  %-9s  %6s  %12s  %12s  %9s  %9s\n", "number", "kind", "edges", "perimeter", "diameter",
              "planarity", "vertex");
  for (std::size_t k = 0; k < loops.size() && k < most_rows; ++k)
    std::printf("%6d  %-9s  %6d  %12.6g  %12.6g  %9.4f  %9d\n", loops[k].number, to_string(loops[k].kind),
                loops[k].edges(), loops[k].perimeter, loops[k].diameter, loops[k].planarity,
                lowest_vertex(model, loops[k]));
  if (loops.size() > most_rows)
    std::printf("... and %zu smaller ones (all of them with --verbose or --json)\n", loops.size() - most_rows);
}

}  // namespace

int run_info(const InfoCommand& command) {
  CommandFiles().reads("the input", command.input).writes_report("--json", command.json).check();
  const OpenedModel opened = open_model(command.input, command.coincident, View::loops, command.float_text);
  const SurfaceModel& model = opened.model;
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  const Findings found = findings_of(model, loops);
  std::optional<Watertightness> verdict;
  if (command.check == Check::printable) verdict = verdict_before_turning(model);
  if (!command.json.empty()) {
    nlohmann::ordered_json json;
    json["schema_version"] = report_schema_version;
    json["input"] = input_json(command.input, opened.import, model.repairs);
    json["near_boundaries"] = {{"vertices", found.boundaries.vertices}, {"faces", found.boundaries.faces}};
    json["no_data"] = {{"vertices", found.no_data.vertices.size()}, {"value", found.no_data.value}};
    json["inside_out"] = {{"closed", found.inverted.closed}, {"open", found.inverted.open}};
    json["loops"] = nlohmann::ordered_json::array();
    for (const BoundaryLoop& loop : loops) {
      json["loops"].push_back(loop_json(loop));
      nlohmann::ordered_json& vertices = json["loops"].back()["vertices"] = nlohmann::ordered_json::array();
      for (int v : loop.vertices) vertices.push_back(model.soup_vertex[v]);
    }
    if (verdict) json["check"] = verdict_json(*verdict);
    OutputTransaction outputs;
    commit_with_report(outputs, command.json, json);
    return exit_done;
  }
  std::printf("%s: %s, %zu vertices, %zu faces\n", path_text(command.input).c_str(), opened.import.format.c_str(),
              opened.import.vertices, opened.import.faces);
  print_import(opened.import, model.repairs);
  print_findings(found);
  print_no_data(stdout, found.no_data);
  print_not_kept(opened);
  if (verdict) print_verdict(stdout, *verdict);
  if (loops.empty()) {
    std::printf("The surface is closed: it has no boundary loops.\n");
    return exit_done;
  }
  std::printf("%zu boundary %s\n", loops.size(), loops.size() == 1 ? "loop" : "loops");
  print_coincident(stdout, opened.import, loops);
  print_loops(model, loops, command.detail);
  return exit_done;
}

}  // namespace loopmend
