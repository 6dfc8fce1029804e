// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/color_table.h"

#include <vtkLookupTable.h>

namespace loopmend {

vtkSmartPointer<vtkLookupTable> make_diverging_table() {
  constexpr int entries = 256;
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(entries);
  table->Build();
  table->SetNanColor(unknown_color[0], unknown_color[1], unknown_color[2], 1);
  paint_table(table, ColorMap::blue_orange, TableEnds::both_signs, 1);
  return table;
}

void paint_table(vtkLookupTable* table, ColorMap map, TableEnds ends, double half_width) {
  const double first = ends == TableEnds::from_zero ? 0.5 : 0;
  const vtkIdType entries = table->GetNumberOfTableValues();
  for (vtkIdType i = 0; i < entries; ++i) {
    const Rgb c = color_at(map, first + (1 - first) * static_cast<double>(i) / static_cast<double>(entries - 1));
    table->SetTableValue(i, c[0], c[1], c[2], 1);
  }
  table->SetRange(ends == TableEnds::from_zero ? 0 : -half_width, half_width);
}

}  // namespace loopmend
