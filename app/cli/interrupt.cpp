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

}  // namespace

void exit_on_interrupt() {
  struct sigaction action {};
  action.sa_handler = leave;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // A file that grows beyond `ulimit -f` then fails with an error that can be told, in place of a signal.
  std::signal(SIGXFSZ, SIG_IGN);
}

}  // namespace loopmend
