// SPDX-License-Identifier: GPL-3.0-or-later
// What the lengths of a scan are measured in, by the words of 3MF; empty: not known. Loopmend never converts: it is read, shown
// and written.
#pragma once

#include <array>
#include <string>

namespace loopmend {

inline constexpr std::array<const char*, 6> length_units{"micron", "millimeter", "centimeter", "meter", "inch", "foot"};

inline bool is_length_unit(const std::string& unit) {
  for (const char* known : length_units)
    if (unit == known) return true;
  return false;
}

}  // namespace loopmend
