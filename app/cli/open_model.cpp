// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_model.h"

#include "core/error.h"

namespace loopmend {

OpenedModel open_model(const std::filesystem::path& path, CoincidentVertices coincident) {
  ImportedMesh imported = read_mesh(path, coincident);
  try {
    SurfaceModel model = make_surface_model(imported.soup);
    return {std::move(imported.soup), std::move(model), std::move(imported.report)};
  } catch (const InvalidArgument& error) {
    throw ReadError(path, error.what(), "", "Check the mesh in the program that made it.");
  }
}

}  // namespace loopmend
