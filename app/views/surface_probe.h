// SPDX-License-Identifier: GPL-3.0-or-later
// Which vertex lies under a point of the picture, and what is known there.
#pragma once

#include "document/scene_visibility.h"

#include <QStringList>

#include <optional>

namespace loopmend {

/// A vertex that is shown.
struct SurfacePlace {
  int scan = 0;            ///< or that of the patch
  int patch = -1;          ///< id; −1: it is the scan's own
  int vertex = 0;          ///< of the scan's view, or a free one of the patch
  Vec3 at = Vec3::Zero();  ///< in the scene's frame
};

/// The nearest to a point on a surface, in the scene's frame; none where nothing is shown.
std::optional<SurfacePlace> place_near(const Document& document, const SceneVisibility& visibility, const Vec3& at);

/// The piece that it belongs to; of a patch, that of its first hole.
PieceId piece_at(const Document& document, const SceneVisibility& visibility, const SurfacePlace& place);

struct Probe {
  Vec3 at = Vec3::Zero();  ///< of the nearest vertex, in the scene's frame
  QStringList lines;       ///< what is known there, in words
};

Probe probe(const Document& document, const SurfacePlace& place);

}  // namespace loopmend
