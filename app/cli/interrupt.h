// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C: ends the process at once, with nothing half-written.
#pragma once

namespace loopmend {

/// From then on SIGINT and SIGTERM, on whatever thread they arrive, make the process say
/// "cancelled" and what was written by then, remove unfinished files and exit with 130, even in the middle of a factorisation.
void exit_on_interrupt();

}  // namespace loopmend
