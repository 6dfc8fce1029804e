// SPDX-License-Identifier: GPL-3.0-or-later
// Diverging colour maps, distinct for every kind of colour vision: lightness falls evenly on both sides of the middle.
#pragma once

#include <array>
#include <string>

namespace loopmend {

using Rgb = std::array<double, 3>;

inline constexpr Rgb unknown_color{0.60, 0.60, 0.58};  ///< where the curvature is not known

enum class ColorMap { blue_orange, purple_green, brown_teal, grey };

inline constexpr std::array<ColorMap, 4> all_color_maps{ColorMap::blue_orange, ColorMap::purple_green,
                                                        ColorMap::brown_teal, ColorMap::grey};

/// One word, for files: "blue-orange".
const char* to_string(ColorMap map);
/// The default for a word that is not known.
ColorMap color_map_named(const std::string& word);

/// @param t  0..1
Rgb color_at(ColorMap map, double t);

}  // namespace loopmend
