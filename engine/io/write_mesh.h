// SPDX-License-Identifier: GPL-3.0-or-later
// Writing PLY, STL, OBJ, OFF, glTF, 3MF and polydata, each atomically: the whole file under its name, or nothing new.
#pragma once

#include "io/atomic_file.h"
#include "io/not_kept.h"
#include "mesh/triangle_soup.h"

#include <filesystem>
#include <limits>

namespace loopmend {

enum class Encoding { binary, ascii };

/// What of the soup a file of this name has no room for: colours in STL, alpha in OBJ, groups in PLY.
/// @throws WriteError for an unknown extension.
std::vector<NotKept> not_kept_by_format(const std::filesystem::path& path, const TriangleSoup& soup,
                                        Encoding encoding = Encoding::binary);

/// All that the soup has beside points, faces and vertex colours: what joining it with another one loses.
std::vector<NotKept> carried_attributes(const TriangleSoup& soup);

/// The format follows the extension (.ply .stl .obj .off .glb .gltf .3mf .vtp .vtk, any case), compressed with gzip where .gz comes after it. PLY holds doubles, or floats where the scan was read from
/// a PLY file of floats; binary is the default; OBJ and OFF are always text with 17 digits; binary STL holds floats.
/// With the points and faces go the soup's attributes that the format holds: those of the file for what was read,
/// those of `continued` for what is new. Polygons of which no triangle was changed are polygons again (not in STL).
/// What the format cannot hold is not written: not_kept_by_format() names it. Of a soup with attributes and without `continued`
/// new points and triangles have zeros: export/write_scan.h makes the rows first.
/// @throws WriteError for an unknown extension, a missing folder, no permission, a full disk. The old file stays.
/// @throws InvalidArgument for a soup that could not be read again: an index out of range, a coordinate that is not
///         finite, colours but not one per point.
void write_mesh(const std::filesystem::path& path, const TriangleSoup& soup, Encoding encoding = Encoding::binary);

/// The same as one of several files that appear together: with outputs.commit().
void write_mesh(OutputTransaction& outputs, const std::filesystem::path& path, const TriangleSoup& soup,
                Encoding encoding = Encoding::binary);

/// Whether coordinates are written in single precision: binary STL, and PLY where the scan was such a file.
bool holds_floats(const std::filesystem::path& path, const TriangleSoup& soup, Encoding encoding);

/// How far the farthest of the first points moves when the soup is written under this name; mesh units. 0 where every bit
/// is kept.
/// @throws WriteError for an unknown extension.
double largest_rounding(const std::filesystem::path& path, const TriangleSoup& soup, Encoding encoding,
                        std::size_t points = std::numeric_limits<std::size_t>::max());

/// Checks before long work whether write_mesh could begin: known extension, folder that takes a file. Writes nothing.
/// @throws WriteError as write_mesh.
void check_mesh_writable(const std::filesystem::path& path);

}  // namespace loopmend
