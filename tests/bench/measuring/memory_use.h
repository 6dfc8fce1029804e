// SPDX-License-Identifier: GPL-3.0-or-later
// Memory of this process, from /proc. 0 where that cannot be read.
#pragma once

namespace loopmend::bench {

/// Bytes in use now.
double memory_now();
/// Largest use since start_memory_peak(), bytes.
double memory_peak();
void start_memory_peak();

}  // namespace loopmend::bench
