// SPDX-License-Identifier: GPL-3.0-or-later
// How the surfaces are shown and from where, as a person has chosen it. Plain values: the panel edits them, the view
// follows them, a session keeps them.
#pragma once

#include "core/types.h"
#include "scene/color_map.h"
#include "scene/shading.h"

namespace loopmend {

/// Which curvatures the ends of the colour map stand for. The range is symmetric about 0, taken from the scans alone, and
/// so the same before, while and after a flow runs.
struct ColorRange {
  enum class Rule {
    percentile,       ///< the range of `percent` of a scan's values on either side; of several scans the widest
    own,              ///< `half_width`
    percentile_each,  ///< each scan, and what fills it, by its own values: scans of different sizes show their shapes
  } rule = Rule::percentile;
  double percent = 98;    ///< 50..100
  double half_width = 1;  ///< above 0; 1/length for H, 1/length² for K

  bool operator==(const ColorRange&) const = default;
};

/// Which way is up: for the named sides, for the first picture, and for what turns about it.
enum class UpAxis { by_shape, x, minus_x, y, minus_y, z, minus_z };

struct Look {
  Shading shading = Shading::curvature;
  Edges edges = Edges::hidden;
  Seams seams = Seams::shown;
  Tint tint = Tint::none;
  ColorMap map = ColorMap::blue_orange;
  ColorRange H, K;
  int stripes = 9;  ///< 3..40, of zebra and isophotes
  UpAxis up = UpAxis::by_shape;

  const ColorRange& range() const { return shading == Shading::gaussian ? K : H; }
  ColorRange& range() { return shading == Shading::gaussian ? K : H; }
  bool operator==(const Look&) const = default;
};

/// From where the scene is looked at; mesh units.
struct Viewpoint {
  Vec3 focus = Vec3::Zero();
  Vec3 eye = Vec3::UnitZ();
  Vec3 up = Vec3::UnitY();  ///< unit

  bool operator==(const Viewpoint&) const = default;
};

}  // namespace loopmend
