// SPDX-License-Identifier: GPL-3.0-or-later
// VTK's polydata, .vtp and .vtk. VTK reads and writes them in a program of its own (app/polydata/), since it crashes on some damaged
// files. That program turns them into PLY and back.
#pragma once

#include "io/format_writers.h"
#include "io/polygon_soup.h"

#include <filesystem>

namespace loopmend {

/// @throws ReadError, also where the program is missing.
PolygonSoup parse_polydata(const FileContent& file);

/// @throws WriteError where the program is missing.
void require_polydata_program(const std::filesystem::path& path);

/// @throws WriteError
void write_polydata(Output& out, const std::filesystem::path& path, const TriangleSoup& soup, Encoding encoding);

}  // namespace loopmend
