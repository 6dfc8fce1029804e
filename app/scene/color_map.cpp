#include "scene/color_map.h"

#include <vtkLookupTable.h>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

// Lightness falls evenly on both sides of the middle, so that the map also reads in grey and under any lighting.
constexpr std::array<Rgb, 9> stops{{{0.129, 0.294, 0.545},
                                    {0.231, 0.447, 0.702},
                                    {0.431, 0.624, 0.816},
                                    {0.694, 0.804, 0.898},
                                    {0.945, 0.941, 0.925},
                                    {0.957, 0.804, 0.655},
                                    {0.914, 0.616, 0.373},
                                    {0.800, 0.412, 0.149},
                                    {0.592, 0.243, 0.055}}};

Rgb diverging(double t) {
  const double at = std::clamp(t, 0.0, 1.0) * (stops.size() - 1);
  const auto i = std::min(static_cast<std::size_t>(at), stops.size() - 2);
  const double f = at - static_cast<double>(i);
  Rgb out{};
  for (std::size_t k = 0; k < 3; ++k) out[k] = (1 - f) * stops[i][k] + f * stops[i + 1][k];
  return out;
}

}  // namespace

vtkSmartPointer<vtkLookupTable> make_diverging_table() {
  constexpr int entries = 256;
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(entries);
  table->SetRange(-1, 1);
  table->Build();
  for (int i = 0; i < entries; ++i) {
    const Rgb c = diverging(static_cast<double>(i) / (entries - 1));
    table->SetTableValue(i, c[0], c[1], c[2], 1);
  }
  table->SetNanColor(unknown_color[0], unknown_color[1], unknown_color[2], 1);
  return table;
}

}  // namespace loopmend
