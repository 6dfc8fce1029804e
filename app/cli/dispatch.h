// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the command line: which command they are, and what becomes of its errors.
#pragma once

namespace loopmend {

/// Parses the words, runs one command, and turns what it throws into one line on standard error.
/// @returns an ExitCode
int dispatch(int argc, char** argv);

}  // namespace loopmend
