// SPDX-License-Identifier: GPL-3.0-or-later
// A picture for textures whose colour says where it is.
#pragma once

#include "core/picture.h"

namespace loopmend {

/// 200 x 200; red grows to the right, green to the top.
inline Picture ramp() {
  Picture picture(200, 200);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x)
      picture.at(x, y) = {static_cast<unsigned char>(x), static_cast<unsigned char>(199 - y), 40, 255};
  return picture;
}

}  // namespace loopmend
