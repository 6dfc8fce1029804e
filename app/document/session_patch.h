// SPDX-License-Identifier: GPL-3.0-or-later
// The patches of a session file.
#pragma once

#include "document/patch_state.h"
#include "document/session_stream.h"

namespace loopmend {

/// Without its shape, which is made again.
void put(SessionWriter& out, const PatchState& state);
/// @throws ReadError where the file is damaged.
PatchStatePtr read_state(SessionReader& in);

/// Another state of the same patch. Where it has the same mesh, only the free vertices are stored.
void put_beside(SessionWriter& out, const PatchState& state, const PatchState& present);
/// @throws ReadError where the file is damaged.
PatchStatePtr read_state_beside(SessionReader& in, const PatchState& present);
/// About how many bytes it takes.
std::size_t size_beside(const PatchState& state, const PatchState& present);

}  // namespace loopmend
