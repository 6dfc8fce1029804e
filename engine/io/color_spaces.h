// SPDX-License-Identifier: GPL-3.0-or-later
// Colours are sRGB everywhere in Loopmend; numbers in glTF are linear.
#pragma once

#include <algorithm>
#include <cmath>

namespace loopmend {

/// 0..1 in and out (IEC 61966-2-1); what is beyond is clamped.
inline double srgb_from_linear(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}
inline double linear_from_srgb(double x) {
  x = std::clamp(x, 0.0, 1.0);
  return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
}

}  // namespace loopmend
