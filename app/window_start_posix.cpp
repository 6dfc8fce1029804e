// SPDX-License-Identifier: GPL-3.0-or-later
#include "window_start.h"

#include <cstdlib>

namespace loopmend {

bool has_display() {
  const auto is_set = [](const char* name) {
    const char* value = std::getenv(name);
    return value && *value;
  };
  return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY") || is_set("QT_QPA_PLATFORM");
}

void find_console() {}

}  // namespace loopmend
