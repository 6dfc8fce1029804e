// SPDX-License-Identifier: GPL-3.0-or-later
// Light, dark, or as the system has it.
#pragma once

#include "document/preferences.h"

class QPalette;

namespace loopmend {

void apply_theme(Theme theme);
QPalette dark_palette();
QPalette light_palette();

}  // namespace loopmend
