// SPDX-License-Identifier: GPL-3.0-or-later
// The command line that repeats what was done by hand.
#pragma once

#include "document/document.h"

#include <QStringList>

namespace loopmend {

struct CommandLine {
  QString text;         ///< one command per line, for a POSIX shell; empty when there is nothing to repeat
  QStringList remarks;  ///< what it does not repeat exactly, in words
};

/// Fills from the scans' files what the patches by these ids fill, with the same initial patches and flows.
CommandLine command_line(const Document& document, const std::set<int>& patch_ids);

}  // namespace loopmend
