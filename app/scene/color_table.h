// SPDX-License-Identifier: GPL-3.0-or-later
// A colour map as VTK takes it.
#pragma once

#include "scene/color_map.h"

#include <vtkSmartPointer.h>

class vtkLookupTable;

namespace loopmend {

/// What the ends of a colour table stand for.
enum class TableEnds {
  both_signs,  ///< [−half_width, half_width], all of the map
  from_zero,   ///< [0, half_width], from the middle of the map to its upper end
};

/// 256 entries over [−1, 1].
vtkSmartPointer<vtkLookupTable> make_diverging_table();
/// Other colours and another range in the same table. @param half_width  above 0
void paint_table(vtkLookupTable* table, ColorMap map, TableEnds ends, double half_width);

}  // namespace loopmend
