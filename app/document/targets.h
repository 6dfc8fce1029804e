// SPDX-License-Identifier: GPL-3.0-or-later
// What a button would act on: the selection, or everything when nothing is selected.
#pragma once

#include "document/document.h"
#include "document/hole_selection.h"

#include <set>
#include <vector>

namespace loopmend {

/// Loops that Fill would close: the selected ones, or all that are fillable. None that has a patch.
std::set<int> loops_to_fill(const Document& document, const HoleSelection& selection);

/// The largest ones of these loops, the largest first.
std::vector<int> largest(const Document& document, const std::set<int>& loops, std::size_t at_most);

/// Patches of the selected loops, or all when nothing is selected.
std::set<int> chosen_patches(const Document& document, const HoleSelection& selection);

/// Of these, the ones that a flow may move: not accepted yet.
std::set<int> patches_to_move(const Document& document, const HoleSelection& selection);

std::set<int> loops_of(const Document& document, const std::set<int>& patches);

/// Cracks that nothing has closed: what Stitch is for.
int cracks_left(const Document& document);
/// A loop that is no hole, and has no patch.
bool is_left_out(const Document& document, int loop);
int loops_left_out(const Document& document);

/// Boundary loops but cracks and cuts that stay open in what is exported: a patch that cuts the surface is left out of it.
int open_loops(const Document& document);

/// The scan of a selected loop, else the first one; -1 where there is none.
int scan_of_selection(const Document& document, const HoleSelection& selection);

enum class SizeMeasure { edges, diameter };
/// Fillable loops without a patch that are no larger than `limit`; diameter in the scan's unit.
std::set<int> loops_up_to(const Document& document, SizeMeasure measure, double limit);

}  // namespace loopmend
