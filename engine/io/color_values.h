// Colour channels from the number ranges that files use.
#pragma once

#include "core/types.h"

#include <cmath>

namespace loopmend {

inline constexpr Color opaque_white = {255, 255, 255, 255};

/// @param scale  what full intensity is in the file: 1, 255 or 65535. `value` must be finite; it is clamped.
inline unsigned char color_channel(double value, double scale) {
  const double scaled = std::round(value / scale * 255.0);
  return static_cast<unsigned char>(scaled < 0.0 ? 0.0 : (scaled > 255.0 ? 255.0 : scaled));
}

}  // namespace loopmend
