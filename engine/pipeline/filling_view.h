// SPDX-License-Identifier: GPL-3.0-or-later
// A view of a large scan that holds as much around its boundary loops as filling them looks at.
#pragma once

#include "mesh/boundary_loops.h"
#include "mesh/surface_model.h"

#include <optional>
#include <vector>

namespace loopmend {

/// The view in which most loops can be filled. @throws as make_surface_model
SurfaceModel make_filling_view(TriangleSoup soup, std::optional<VertexSurvey> survey = std::nullopt);

/// Makes the view wider where the filling of some loops looks further than it reaches; view vertices may take other numbers
/// then. @param all  loops of the model. @param loops  to be filled. @returns whether it was made again: find the loops again.
bool widen_filling_view(SurfaceModel& model, const std::vector<BoundaryLoop>& all,
                        const std::vector<BoundaryLoop>& loops);

/// Whether the view holds all that filling the loops looks at; a whole view does.
bool holds_neighborhood(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops);

}  // namespace loopmend
