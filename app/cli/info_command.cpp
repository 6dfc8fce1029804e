// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "exit_codes.h"
#include "open_model.h"
#include "outputs.h"
#include "report.h"

#include <Eigen/Geometry>

#include <cstdio>

namespace loopmend {

namespace {

void print_count(std::size_t count, const char* words) {
  if (count > 0) std::printf("  %zu %s\n", count, words);
}

void print_import(const ImportReport& import, const ModelRepairs& repairs) {
  print_count(import.polygons_triangulated, "polygons were triangulated");
  print_count(import.vertices_welded, "vertices were welded");
  print_count(import.unreferenced_vertices, "vertices belong to no face; they are kept");
  print_count(import.coincident_vertices, "vertices lie exactly on another; they are kept apart");
  print_count(import.degenerate_faces, "faces have no area; they are kept");
  print_count(import.duplicate_faces, "faces are there twice; they are kept");
  for (const NotKept& oddity : import.oddities) print_count(oddity.count, oddity.what.c_str());
  print_count(import.missing_colors, "vertices have no colour in a file with colours; they are white");
  print_count(repairs.non_manifold_edges, "edges have more than two faces");
  print_count(repairs.non_manifold_vertices, "vertices join several fans of faces");
  print_count(repairs.reoriented_faces, "faces were turned round to agree with their neighbours");
}

/// What no output will hold, and what only some formats have room for.
void print_not_kept(const OpenedModel& opened) {
  if (const std::vector<NotKept> carried = carried_attributes(opened.as_read); !carried.empty())
    std::printf("  also holds: %s\n", to_string(carried).c_str());
  if (!opened.import.not_kept.empty())
    std::printf("  in no file that Loopmend writes: %s\n", to_string(opened.import.not_kept).c_str());
  for (const char* format : {"PLY", "STL", "OBJ", "OFF"}) {
    const std::vector<NotKept> list = not_kept_by_format(std::string("x.") + format, opened.as_read);
    if (!list.empty()) std::printf("  not in %s: %s\n", format, to_string(list).c_str());
  }
  Eigen::AlignedBox3d box;
  for (const Vec3& point : opened.as_read.points) box.extend(point);
  const double rounding = largest_rounding("x.stl", opened.as_read, Encoding::binary);
  // That of coordinates of the mesh's own size is no news; a scan far from the origin is.
  if (rounding > 1e-6 * box.diagonal().norm())
    std::printf("  binary STL would move vertices by up to %.3g\n", rounding);
}

void print_loops(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  constexpr std::size_t most_rows = 60;
  std::printf("\n%6s  %-9s  %6s  %12s  %12s  %9s  %9s\n", "number", "kind", "edges", "perimeter", "diameter",
              "planarity", "vertex");
  for (std::size_t k = 0; k < loops.size() && k < most_rows; ++k)
    std::printf("%6d  %-9s  %6d  %12.6g  %12.6g  %9.4f  %9d\n", loops[k].number, to_string(loops[k].kind),
                loops[k].edges(), loops[k].perimeter, loops[k].diameter, loops[k].planarity,
                model.soup_vertex[static_cast<std::size_t>(loops[k].vertices.front())]);
  if (loops.size() > most_rows)
    std::printf("... and %zu smaller ones (all of them with --json)\n", loops.size() - most_rows);
}

}  // namespace

int run_info(const InfoCommand& command) {
  CommandFiles().reads("the input", command.input).writes_report("--json", command.json).check();
  const OpenedModel opened = open_model(command.input, command.coincident);
  const SurfaceModel& model = opened.model;
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  if (!command.json.empty()) {
    nlohmann::ordered_json json;
    json["schema_version"] = report_schema_version;
    json["input"] = input_json(command.input, opened.import, model.repairs);
    json["loops"] = nlohmann::ordered_json::array();
    for (const BoundaryLoop& loop : loops) {
      json["loops"].push_back(loop_json(loop));
      nlohmann::ordered_json& vertices = json["loops"].back()["vertices"] = nlohmann::ordered_json::array();
      for (int v : loop.vertices) vertices.push_back(model.soup_vertex[static_cast<std::size_t>(v)]);
    }
    OutputTransaction outputs;
    commit_with_report(outputs, command.json, json);
    return exit_done;
  }
  std::printf("%s: %s, %zu vertices, %zu faces\n", command.input.c_str(), opened.import.format.c_str(),
              opened.import.vertices, opened.import.faces);
  print_import(opened.import, model.repairs);
  print_not_kept(opened);
  if (loops.empty()) {
    std::printf("The surface is closed: it has no boundary loops.\n");
    return exit_done;
  }
  std::printf("%zu boundary %s\n", loops.size(), loops.size() == 1 ? "loop" : "loops");
  print_coincident(stdout, opened.import, loops);
  print_loops(model, loops);
  return exit_done;
}

}  // namespace loopmend
