// SPDX-License-Identifier: GPL-3.0-or-later
// Reading PLY, STL, OBJ, OFF, glTF, 3MF and polydata into a validated triangle soup. All of a file, or an error.
#pragma once

#include "core/single_precision.h"
#include "io/not_kept.h"
#include "mesh/triangle_soup.h"
#include "mesh/vertex_survey.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace loopmend {

/// What was in the file and what was done to it, in numbers.
struct ImportReport {
  std::string format;                     ///< "PLY", "STL", "OBJ", "OFF", "glTF", "3MF" or "VTK"
  std::size_t vertices = 0;               ///< after welding (STL)
  std::size_t faces = 0;                  ///< polygons as in the file
  std::size_t triangles = 0;              ///< after triangulation
  std::size_t polygons_triangulated = 0;  ///< faces with more than three vertices
  std::size_t vertices_welded = 0;  ///< merged with an earlier one at the same place: corners of STL, or on request
  std::size_t vertices_joined = 0;  ///< whose faces name another one in the same place, where only these two touch
  std::size_t near_vertices_joined = 0;   ///< of STL: that lay within rounding of another along a crack
  double largest_join = 0;                ///< from the farthest of these to the one that it became; mesh units
  std::size_t unreferenced_vertices = 0;  ///< as in the file
  std::size_t degenerate_faces = 0;       ///< triangles with a vertex twice, or with zero area; kept
  std::size_t duplicate_faces = 0;        ///< triangles over the same three different vertices as an earlier one; kept
  std::size_t coincident_vertices = 0;    ///< further vertices at exactly the place of another; kept apart
  std::size_t missing_colors = 0;         ///< vertices without a (finite) colour in a file with colours; made white
  std::size_t skipped_elements = 0;       ///< OBJ lines, points and curves; left out
  bool has_colors = false;
  std::vector<NotKept> not_kept;  ///< what is in no file that is written, by name
  std::vector<NotKept> oddities;  ///< deviations from the format that were still read, by name
};

struct ImportedMesh {
  TriangleSoup soup;
  ImportReport report;
  std::optional<VertexSurvey> survey = std::nullopt;  ///< of the soup as it is here: spares make_surface_model its own
};

/// What becomes of vertices at exactly the same place. STL has no other way to say that faces share a vertex: there they
/// are always welded, and joined along cracks that are no wider than rounding (mesh/rounding_cracks.h). `keep` joins boundary
/// vertices whose fans touch there and nowhere else (mesh/join_touching_fans.h): points stay, faces name the first.
enum class CoincidentVertices { keep, weld };

/// Whether files of this name are read: .ply .stl .obj .off .glb .gltf .3mf .vtp .vtk, any case, with or without .gz.
bool is_mesh_name(const std::filesystem::path& path);

/// Reads a mesh. The format follows from the content, else from the extension.
/// @throws ReadError for anything that is not wholly a mesh with at least one face: a missing file, a directory, no
///         permission, an unknown format, a syntax error, a count that does not match, a non-finite coordinate, an
///         index out of range. Never returns a part of a file.
ImportedMesh read_mesh(const std::filesystem::path& path, CoincidentVertices coincident = CoincidentVertices::keep,
                       FloatText float_text = FloatText::nearest_float);

}  // namespace loopmend
