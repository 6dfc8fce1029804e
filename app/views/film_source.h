// SPDX-License-Identifier: GPL-3.0-or-later
// The recorded states of patches as pictures of the view, for a film.
#pragma once

#include "dialogs/film_dialog.h"

#include <set>

namespace loopmend {

class Document;
class MeshView;

/// Whether a flow has moved one of these patches.
bool has_film(const Document& document, const std::set<int>& patches);

/// The patches go through their states together; one whose flow was shorter waits at its end. Everything else is as
/// the view shows it.
FilmSource film_of(MeshView& view, const Document& document, const std::set<int>& patches);

}  // namespace loopmend
