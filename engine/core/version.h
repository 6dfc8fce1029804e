// SPDX-License-Identifier: GPL-3.0-or-later
// The version of the engine, "major.minor.patch".
#pragma once

namespace loopmend {
const char* version();
}  // namespace loopmend
