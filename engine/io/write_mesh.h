// SPDX-License-Identifier: GPL-3.0-or-later
// Writing PLY, STL, OBJ and OFF, each atomically: the whole file under its name, or nothing new.
#pragma once

#include "io/atomic_file.h"
#include "mesh/triangle_soup.h"

#include <filesystem>
#include <span>

namespace loopmend {

enum class Encoding { binary, ascii };

/// The format follows the extension (.ply .stl .obj .off, any case). PLY holds doubles and colours; binary is the
/// default; OBJ and OFF are always text with 17 digits; binary STL holds floats.
/// What the format cannot hold is not written: colours and lone points in STL, alpha in OBJ.
/// @throws WriteError for an unknown extension, a missing folder, no permission, a full disk. The old file stays.
/// @throws InvalidArgument for a soup that could not be read again: an index out of range, a coordinate that is not
///         finite, colours but not one per point.
void write_mesh(const std::filesystem::path& path, const TriangleSoup& soup, Encoding encoding = Encoding::binary);

/// The same as one of several files that appear together: with outputs.commit().
void write_mesh(OutputTransaction& outputs, const std::filesystem::path& path, const TriangleSoup& soup,
                Encoding encoding = Encoding::binary);

/// How far the farthest of these points moves when it is written under this name; mesh units. Binary STL rounds to
/// single precision; the other formats, and text STL, keep every bit: 0.
/// @throws WriteError for an unknown extension.
double largest_rounding(const std::filesystem::path& path, std::span<const Vec3> points, Encoding encoding);

/// Tells before long work whether write_mesh could begin: known extension, folder that takes a file. Writes nothing.
/// @throws WriteError as write_mesh.
void check_mesh_writable(const std::filesystem::path& path);

}  // namespace loopmend
