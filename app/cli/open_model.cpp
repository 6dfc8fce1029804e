// SPDX-License-Identifier: GPL-3.0-or-later
#include "open_model.h"

#include "core/error.h"
#include "pipeline/filling_view.h"

#include <utility>

namespace loopmend {

SurfaceModel model_of(const std::filesystem::path& path, TriangleSoup soup, View view,
                      std::optional<VertexSurvey> survey) {
  try {
    switch (view) {
      case View::whole: break;
      case View::loops: return make_view_around_loops(std::move(soup), {}, std::move(survey));
      case View::filling: return make_filling_view(std::move(soup), std::move(survey));
    }
    return make_surface_model(std::move(soup), std::move(survey));
  } catch (const InvalidArgument& error) {
    throw ReadError(path, error.message(), {}, say("Check the mesh in the program that made it."));
  }
}

OpenedModel open_model(const std::filesystem::path& path, CoincidentVertices coincident, View view,
                       FloatText float_text) {
  ImportedMesh imported = read_mesh(path, coincident, float_text);
  SurfaceModel model = model_of(path, std::move(imported.soup), view, std::move(imported.survey));
  return {std::move(model), std::move(imported.report)};
}

}  // namespace loopmend
