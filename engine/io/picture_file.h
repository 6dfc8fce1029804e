// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of textures: PNG and JPEG are read, PNG is written.
#pragma once

#include "core/picture.h"
#include "io/file_content.h"

#include <filesystem>
#include <ostream>

namespace loopmend {

/// @throws ReadError for a file that is missing, damaged, no PNG or JPEG, or of more than 16384 pixels a side.
Picture read_picture(const std::filesystem::path& path);

/// The same of what has been loaded. @param file  its path is for messages
Picture read_picture(const FileContent& file);

/// As PNG: without alpha where every pixel is opaque. @throws std::runtime_error if libpng fails
void write_png(std::ostream& stream, const Picture& picture);

}  // namespace loopmend
