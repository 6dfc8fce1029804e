// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/color_map.h"

#include <algorithm>

namespace loopmend {
namespace {

using Stops = std::array<Rgb, 9>;

constexpr Stops blue_orange{{{0.129, 0.294, 0.545},
                             {0.231, 0.447, 0.702},
                             {0.431, 0.624, 0.816},
                             {0.694, 0.804, 0.898},
                             {0.945, 0.941, 0.925},
                             {0.957, 0.804, 0.655},
                             {0.914, 0.616, 0.373},
                             {0.800, 0.412, 0.149},
                             {0.592, 0.243, 0.055}}};
constexpr Stops purple_green{{{0.365, 0.157, 0.475},
                              {0.525, 0.353, 0.624},
                              {0.663, 0.549, 0.757},
                              {0.812, 0.753, 0.867},
                              {0.945, 0.945, 0.945},
                              {0.780, 0.890, 0.745},
                              {0.545, 0.769, 0.522},
                              {0.282, 0.600, 0.314},
                              {0.063, 0.404, 0.176}}};
constexpr Stops brown_teal{{{0.435, 0.259, 0.047},
                            {0.612, 0.408, 0.137},
                            {0.784, 0.608, 0.357},
                            {0.902, 0.804, 0.620},
                            {0.950, 0.950, 0.940},
                            {0.718, 0.871, 0.847},
                            {0.455, 0.741, 0.706},
                            {0.180, 0.549, 0.522},
                            {0.027, 0.365, 0.341}}};
constexpr Stops grey{{{0.16, 0.16, 0.17},
                      {0.25, 0.25, 0.26},
                      {0.34, 0.34, 0.35},
                      {0.43, 0.43, 0.44},
                      {0.53, 0.53, 0.53},
                      {0.64, 0.64, 0.63},
                      {0.75, 0.75, 0.74},
                      {0.86, 0.86, 0.85},
                      {0.97, 0.97, 0.96}}};

const Stops& stops_of(ColorMap map) {
  switch (map) {
    case ColorMap::blue_orange: return blue_orange;
    case ColorMap::purple_green: return purple_green;
    case ColorMap::brown_teal: return brown_teal;
    case ColorMap::grey: return grey;
  }
  return blue_orange;
}

}  // namespace

const char* to_string(ColorMap map) {
  switch (map) {
    case ColorMap::blue_orange: return "blue-orange";
    case ColorMap::purple_green: return "purple-green";
    case ColorMap::brown_teal: return "brown-teal";
    case ColorMap::grey: return "grey";
  }
  return "";
}

ColorMap color_map_named(const std::string& word) {
  const auto found =
      std::find_if(all_color_maps.begin(), all_color_maps.end(), [&](ColorMap map) { return word == to_string(map); });
  return found == all_color_maps.end() ? ColorMap::blue_orange : *found;
}

Rgb color_at(ColorMap map, double t) {
  const Stops& stops = stops_of(map);
  const double at = std::clamp(t, 0.0, 1.0) * (stops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double f = at - static_cast<double>(i);
  Rgb out{};
  for (std::size_t k = 0; k < 3; ++k) out[k] = (1 - f) * stops[i][k] + f * stops[i + 1][k];
  return out;
}

}  // namespace loopmend
