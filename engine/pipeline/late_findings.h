// SPDX-License-Identifier: GPL-3.0-or-later
// Findings on patches that depend on more than the patch: on what kind of loop it closes, and on other loops.
#pragma once

#include "pipeline/choose_loops.h"
#include "pipeline/rim_groups.h"
#include "pipeline/solve_group.h"

#include <cstddef>
#include <vector>

namespace loopmend {

/// Makes the hole's verdict look at best, with this finding. Holes that share the patch share the new one.
void add_to_look(std::vector<HoleResult>& results, std::size_t hole, Notice finding);

/// Names what joins the loops of each group that no patch joins. A patch over one loop alone leaves a wall hollow, or goes through it.
void name_rim_groups(const std::vector<RimGroup>& groups, const std::vector<LoopChoice>& choices,
                     std::vector<HoleResult>& results);

/// Outlines that are nearly plane and much longer than wide, as of a jaw or a horseshoe, end in a plane: a patch that bulges below them is
/// to be looked at.
void judge_outlines(std::vector<HoleResult>& results);

}  // namespace loopmend
