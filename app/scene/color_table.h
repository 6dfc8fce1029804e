// SPDX-License-Identifier: GPL-3.0-or-later
// A colour map as VTK takes it.
#pragma once

#include "scene/color_map.h"

#include <vtkSmartPointer.h>

class vtkLookupTable;

namespace loopmend {

/// 256 entries over [−1, 1]; set the range with SetRange.
vtkSmartPointer<vtkLookupTable> make_diverging_table();
/// Other colours in the same table.
void paint_table(vtkLookupTable* table, ColorMap map);

}  // namespace loopmend
