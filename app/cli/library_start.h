// SPDX-License-Identifier: GPL-3.0-or-later
// Signals while the libraries begin, before main().
#pragma once

namespace loopmend {

/// Until this is called, SIGINT waits: OpenBLAS starts a thread for each core when it is loaded, and raises SIGINT where the
/// system allows no more (`ulimit -u`), though it works with one, and one is all that the engine lets it use. That SIGINT is
/// dropped; one from another process is delivered now. Call it once, with the handlers in their places.
void deliver_interrupts();

}  // namespace loopmend
