// SPDX-License-Identifier: GPL-3.0-or-later
// --stitch, with or without a tolerance behind it, and --base.
#pragma once

#include "commands.h"

#include "repair/stitch_boundaries.h"

#include <string>
#include <vector>

namespace loopmend {

/// "0.5": a length in mesh units; "5%": of the boundary edges there. @throws UsageError for anything else.
StitchTolerance stitch_tolerance_of(const std::string& text);

/// The words of a command line with the tolerance that follows --stitch, or the default, joined to it ("--stitch=10%"), so
/// that it takes no file for one.
std::vector<std::string> with_stitch_tolerances(std::vector<std::string> words);

/// "5", or "2:5" for loop 2. @throws UsageError for anything else.
FillCommand::Base base_of(const std::string& text);

}  // namespace loopmend
