// SPDX-License-Identifier: GPL-3.0-or-later
// What programs have worked, as a bound for what must not take for ever: time on the clock depends on what else a machine does.
#pragma once

#include <ctime>

namespace loopmend::test {

/// Of all threads of this process since it began, s.
inline double processor_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

}  // namespace loopmend::test
