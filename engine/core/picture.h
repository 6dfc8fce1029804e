// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/types.h"

#include <cstddef>
#include <vector>

namespace loopmend {

/// Pixels row by row, the uppermost row first.
struct Picture {
  int width = 0, height = 0;
  std::vector<Color> pixels;

  Picture() = default;
  Picture(int w, int h, Color color = {0, 0, 0, 255})
      : width(w),
        height(h),
        pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), color) {}

  Color& at(int x, int y) { return pixels[place(x, y)]; }
  const Color& at(int x, int y) const { return pixels[place(x, y)]; }
  bool empty() const { return pixels.empty(); }

 private:
  std::size_t place(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

}  // namespace loopmend
