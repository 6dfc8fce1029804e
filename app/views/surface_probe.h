// SPDX-License-Identifier: GPL-3.0-or-later
// Which vertex lies under a point of the picture, and what is known there.
#pragma once

#include "document/document.h"

#include <QStringList>

#include <optional>

namespace loopmend {

struct Probe {
  Vec3 at = Vec3::Zero();  ///< of the nearest vertex, in the scene's frame
  QStringList lines;       ///< what is known there, in words
};

/// @param at  a point on a surface, in the scene's frame.
/// @returns nothing when nothing is open.
std::optional<Probe> probe(const Document& document, const Vec3& at);

}  // namespace loopmend
