// SPDX-License-Identifier: GPL-3.0-or-later
#include "library_start.h"

#ifdef __linux__

#include <unistd.h>

#include <csignal>

namespace loopmend {

namespace {

sigset_t mask_at_start;

sigset_t only_interrupt() {
  sigset_t set;
  sigemptyset(&set);
  sigaddset(&set, SIGINT);
  return set;
}

void block_interrupt(int, char**, char**) {
  const sigset_t set = only_interrupt();
  sigprocmask(SIG_BLOCK, &set, &mask_at_start);
}

/// What stands in this section is called before the functions by which libraries begin.
[[gnu::section(".preinit_array"), gnu::used]] void (*const before_libraries)(int, char**, char**) = block_interrupt;

}  // namespace

void deliver_interrupts() {
  const sigset_t set = only_interrupt();
  const timespec now{};
  siginfo_t from{};
  bool interrupted = false;
  while (sigtimedwait(&set, &from, &now) == SIGINT) interrupted = interrupted || from.si_pid != getpid();
  sigprocmask(SIG_SETMASK, &mask_at_start, nullptr);
  if (interrupted) raise(SIGINT);
}

}  // namespace loopmend

#else

namespace loopmend {
void deliver_interrupts() {}
}  // namespace loopmend

#endif
