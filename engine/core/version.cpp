// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/version.h"

namespace loopmend {
const char* version() { return LOOPMEND_VERSION; }
}  // namespace loopmend
