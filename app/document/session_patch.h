// SPDX-License-Identifier: GPL-3.0-or-later
// The patches of a session file.
#pragma once

#include "document/patch_state.h"
#include "document/session_stream.h"

namespace loopmend {

/// Without its shape and what its neighborhood knows, which are made again.
void put(SessionWriter& out, const PatchState& state);
/// @throws ReadError where the file is damaged.
PatchStatePtr read_state(SessionReader& in);

}  // namespace loopmend
