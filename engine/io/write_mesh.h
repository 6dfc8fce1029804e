// Writing PLY, STL, OBJ and OFF, each atomically: the whole file under its name, or nothing new.
#pragma once

#include "mesh/triangle_soup.h"

#include <filesystem>

namespace loopmend {

enum class Encoding { binary, ascii };

/// The format follows the extension (.ply .stl .obj .off, any case). PLY holds doubles and colours; binary is the
/// default; OBJ and OFF are always text with 17 digits; binary STL holds floats.
/// @throws WriteError for an unknown extension, a missing folder, no permission, a full disk. The old file stays.
void write_mesh(const std::filesystem::path& path, const TriangleSoup& soup, Encoding encoding = Encoding::binary);

}  // namespace loopmend
