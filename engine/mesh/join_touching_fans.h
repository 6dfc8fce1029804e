// SPDX-License-Identifier: GPL-3.0-or-later
// Boundary vertices that programs double where two holes touch, made one again.
#pragma once

#include "mesh/triangle_soup.h"
#include "mesh/vertex_survey.h"

#include <vector>

namespace loopmend {

/// Boundary vertices in exactly the same place, of the same colour, whose fans of faces lie side by side around it and share no
/// edge there: their faces name the first of them, so that each gap between the fans is a boundary of its own. Vertices along
/// cracks, whose edges lie on each other, are left alone. Points and the order of faces stay.
/// @param survey  of the soup as it is before
/// @returns for each point the one that its faces name now, itself if nothing changed; empty where no vertex was joined.
std::vector<int> join_touching_fans(TriangleSoup& soup, const VertexSurvey& survey);

}  // namespace loopmend
