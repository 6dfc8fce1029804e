// SPDX-License-Identifier: GPL-3.0-or-later
// From a path to a surface: reading, and the view in which loops can be walked.
#pragma once

#include "io/read_mesh.h"
#include "mesh/surface_model.h"

#include <filesystem>
#include <optional>

namespace loopmend {

struct OpenedModel {
  SurfaceModel model;
  ImportReport import;
};

/// How much of the surface the view holds.
enum class View {
  whole,
  loops,   ///< what finding the loops needs
  filling  ///< and what filling them needs (pipeline/filling_view.h)
};

/// The view of a soup that was read from this file. @param survey  of this soup, where it is known. @throws ReadError where it holds no usable face.
SurfaceModel model_of(const std::filesystem::path& path, TriangleSoup soup, View view = View::whole,
                      std::optional<VertexSurvey> survey = std::nullopt);

/// @throws ReadError, also where the file is sound but holds no usable face.
OpenedModel open_model(const std::filesystem::path& path, CoincidentVertices coincident = CoincidentVertices::keep,
                       View view = View::whole, FloatText float_text = FloatText::nearest_float);

}  // namespace loopmend
