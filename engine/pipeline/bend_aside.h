// SPDX-License-Identifier: GPL-3.0-or-later
// Moves a patch out of the way of fragments: small pieces of other surface, as they float in the openings of scans.
#pragma once

#include "core/cancel.h"
#include "core/message.h"
#include "mesh/patch.h"
#include "pipeline/validate.h"

#include <optional>

namespace loopmend {

struct BentPatch {
  Patch patch;        ///< cuts nothing
  Validity validity;  ///< of it
  int fragments = 0;  ///< that it was moved past
};

Message bent_message();

/// Bends the patch around each fragment that it cuts, to the side where the way is shorter. Only free vertices move, those near a
/// fragment. @returns nothing where the patch cuts anything else than fragments, itself above all, or is still in their way after some
/// rounds, or has more folds than before.
/// @param validity  of the patch
std::optional<BentPatch> bent_aside(const ScanIndex& scan, const Patch& patch, const Validity& validity,
                                    const CancelToken& cancel);

}  // namespace loopmend
