// SPDX-License-Identifier: GPL-3.0-or-later
#include "interrupt.h"

#include "exit_notice.h"
#include "io/atomic_file.h"

#include <windows.h>

#include <atomic>
#include <csignal>

namespace loopmend {

namespace {

constexpr int interrupted = 130;  // 128 + SIGINT, as elsewhere

// A handler can reach what it acts on, and what it leaves, only by globals.
CancelToken* to_cancel = nullptr;  ///< set once, before the handler asks for it
const char* last_words = "";       ///< likewise
std::atomic<bool> may_finish{false}, was_cancelled{false};
std::atomic_flag leaving = ATOMIC_FLAG_INIT;

/// Called on a thread of its own.
BOOL WINAPI stop(DWORD event) {
  // Whatever else it is, such as a closed console, leaves no time to finish.
  const bool is_key = event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT;
  if (is_key && may_finish.exchange(false)) {
    was_cancelled = true;
    to_cancel->cancel();
    say_at_exit("\nloopmend: stopping; what is finished will be written (Ctrl-C again: nothing will)\n");
    return TRUE;
  }
  if (leaving.test_and_set()) return TRUE;
  remove_unfinished_files();
  say_at_exit("\nloopmend: cancelled");
  say_what_was_written(last_words);
  ::TerminateProcess(::GetCurrentProcess(), interrupted);
  return TRUE;
}

void tell_crash() {
  if (leaving.test_and_set()) return;
  remove_unfinished_files();
  say_at_exit("\nloopmend: crashed, a fault of this program; unfinished files were removed");
  say_what_was_written(last_words);
}

LONG WINAPI on_exception(EXCEPTION_POINTERS*) {
  tell_crash();
  return EXCEPTION_CONTINUE_SEARCH;
}

/// The default action comes next.
void on_abort(int signal) {
  tell_crash();
  std::signal(signal, SIG_DFL);
}

}  // namespace

void cancel_on_interrupt(const CancelToken& token) {
  static CancelToken shared;
  shared = token;
  to_cancel = &shared;
  may_finish = true;
}

int interrupt_exit_code() { return was_cancelled ? interrupted : 0; }

bool reader_has_gone() { return false; }

void handle_signals(const char* at_the_end) {
  last_words = at_the_end;
  ::SetConsoleOutputCP(CP_UTF8);
  ::SetConsoleCtrlHandler(stop, TRUE);
  ::SetUnhandledExceptionFilter(on_exception);
  std::signal(SIGABRT, on_abort);
}

}  // namespace loopmend
