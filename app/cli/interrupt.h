// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C: ends the process at once with nothing half-written, or asks it to finish early.
#pragma once

#include "core/cancel.h"

namespace loopmend {

/// From then on SIGINT and SIGTERM, on whatever thread they arrive, make the process say
/// "cancelled" and what was written by then, remove unfinished files and exit with 130, even in the middle of a factorisation.
void exit_on_interrupt();

/// From then on the first SIGINT or SIGTERM cancels the token, and only the second ends the process so. Call it once.
void cancel_on_interrupt(const CancelToken& token);

}  // namespace loopmend
