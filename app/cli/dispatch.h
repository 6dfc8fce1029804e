// SPDX-License-Identifier: GPL-3.0-or-later
// Parses the command line: which command it is, and how its errors are reported.
#pragma once

namespace loopmend {

/// Parses the words, runs one command, and turns what it throws into one line on standard error.
/// @returns an ExitCode
int dispatch(int argc, char** argv);

}  // namespace loopmend
