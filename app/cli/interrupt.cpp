// SPDX-License-Identifier: GPL-3.0-or-later
#include "interrupt.h"

#include "exit_codes.h"
#include "io/atomic_file.h"

#include <unistd.h>
#include <csignal>
#include <cstring>

namespace loopmend {

namespace {

void say(const char* words) { static_cast<void>(!write(STDERR_FILENO, words, std::strlen(words))); }

/// Only what POSIX allows in a handler: lock-free atomics, unlink, rmdir, write, _exit.
void leave(int) {
  remove_unfinished_files();
  say("\nloopmend: cancelled");
  if (file_in_place(0) == nullptr) {
    say("; nothing was written\n");
  } else {
    say(" after ");
    for (std::size_t k = 0; const char* name = file_in_place(k); ++k) {
      if (k > 0) say(file_in_place(k + 1) != nullptr ? ", " : " and ");
      say(name);
    }
    say(file_in_place(1) != nullptr ? " were written\n" : " was written\n");
  }
  _exit(exit_cancelled);
}

void handle(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

/// A handler has no other way to what it acts on. Set once, before the handler is.
CancelToken* to_cancel = nullptr;

void finish_early(int) {
  to_cancel->cancel();  // a lock-free store
  handle(leave);
  say("\nloopmend: stopping; what is finished will be written (Ctrl-C again: nothing will)\n");
}

}  // namespace

void cancel_on_interrupt(const CancelToken& token) {
  static CancelToken shared;
  shared = token;
  to_cancel = &shared;
  handle(finish_early);
}

void exit_on_interrupt() {
  handle(leave);
  // A file that grows beyond `ulimit -f` then fails with an error that can be told, in place of a signal.
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace loopmend
