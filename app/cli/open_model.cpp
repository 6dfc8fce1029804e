// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_model.h"

#include "core/error.h"

namespace loopmend {

SurfaceModel model_of(const std::filesystem::path& path, const TriangleSoup& soup) {
  try {
    return make_surface_model(soup);
  } catch (const InvalidArgument& error) {
    throw ReadError(path, error.what(), "", "Check the mesh in the program that made it.");
  }
}

OpenedModel open_model(const std::filesystem::path& path, CoincidentVertices coincident) {
  ImportedMesh imported = read_mesh(path, coincident);
  SurfaceModel model = model_of(path, imported.soup);
  return {std::move(imported.soup), std::move(model), std::move(imported.report)};
}

}  // namespace loopmend
