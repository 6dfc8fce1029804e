// The diverging colour map for H: blue, near-white, orange; told apart by every kind of colour vision.
#pragma once

#include <array>

#include <vtkSmartPointer.h>

class vtkLookupTable;

namespace loopmend {

using Rgb = std::array<double, 3>;

inline constexpr Rgb unknown_color{0.60, 0.60, 0.58};  ///< where H is not known

/// 256 entries over [−1, 1]; set the range with SetRange.
vtkSmartPointer<vtkLookupTable> make_diverging_table();

}  // namespace loopmend
