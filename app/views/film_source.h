// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded states of patches as pictures of the view, for a film.
#pragma once

#include "dialogs/film_dialog.h"
#include "document/patch_state.h"
#include "scene/shading.h"

#include <set>

namespace loopmend {

class Document;
class MeshView;

/// "mean curvature"
QString shown_by(Shading shading);

/// "MMCVF, step 4 of 7: mean curvature". No flow is named where the step was not one of a flow.
/// @param steps  of the whole film.
QString film_caption(const PatchState& state, int steps, Shading shading);

/// Whether a flow has moved one of these patches.
bool has_film(const Document& document, const std::set<int>& patches);

/// The patches go through their states together; one whose flow was shorter waits at its end. Everything else is as
/// the view shows it.
FilmSource film_of(MeshView& view, const Document& document, const std::set<int>& patches);

}  // namespace loopmend
