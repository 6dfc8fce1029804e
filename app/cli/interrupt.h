// SPDX-License-Identifier: GPL-3.0-or-later
// Signals: end the process at once with nothing half-written, or ask it to finish early. In interrupt_posix.cpp and
// interrupt_windows.cpp.
#pragma once

#include "core/cancel.h"

namespace loopmend {

/// Call it first in main(). From then on
/// - SIGINT, SIGTERM, SIGHUP and SIGXCPU, on whatever thread they arrive, make the process say why it ends and what was
///   written by then, remove unfinished files and exit with 128 + the signal, even in the middle of a factorisation.
///   SIGHUP stays ignored where it was, as under nohup;
/// - a crash (SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT) removes unfinished files, says so, and goes on as it would have;
/// - SIGXFSZ and SIGPIPE do nothing: the write fails, and the writer reports why;
/// - standard streams that were closed lead to /dev/null, so that no output file takes their numbers.
/// Windows has Ctrl-C, Ctrl-Break and the closed window of a console in place of the first group; they end the process with 130.
/// @param at_the_end  said last, a line of its own; lives as long as the process.
void handle_signals(const char* at_the_end = "");

/// From then on the first of the signals that end the process cancels the token, and only the second ends it. Call it once.
void cancel_on_interrupt(const CancelToken& token);

/// 128 + the signal that has cancelled the token, as in a shell; 0: none has.
int interrupt_exit_code();

/// True where standard output leads to a closed pipe, as behind `| head`: no fault. Not known on
/// Windows: false.
bool reader_has_gone();

}  // namespace loopmend
