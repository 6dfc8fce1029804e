#include "open_model.h"

#include "core/error.h"

namespace loopmend {

OpenedModel open_model(const std::filesystem::path& path) {
  ImportedMesh imported = read_mesh(path);
  try {
    return {make_surface_model(std::move(imported.soup)), std::move(imported.report)};
  } catch (const InvalidArgument& error) {
    throw ReadError(path, error.what(), "", "Check the mesh in the program that made it.");
  }
}

}  // namespace loopmend
