#include "interrupt.h"

#include "exit_codes.h"
#include "io/atomic_file.h"

#include <unistd.h>
#include <csignal>
#include <string_view>

namespace loopmend {

namespace {

/// Only what POSIX allows in a handler: lock-free atomics, unlink, write, _exit.
void leave(int) {
  remove_unfinished_files();
  constexpr std::string_view words = "\nloopmend: cancelled\n";
  static_cast<void>(!write(STDERR_FILENO, words.data(), words.size()));
  _exit(exit_cancelled);
}

}  // namespace

void exit_on_interrupt() {
  struct sigaction action {};
  action.sa_handler = leave;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

}  // namespace loopmend
