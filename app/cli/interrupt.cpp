#include "interrupt.h"

#include "exit_codes.h"
#include "io/atomic_file.h"

#include <csignal>
#include <string_view>
#include <thread>
#include <unistd.h>

namespace loopmend {

void exit_on_interrupt() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals] {
    int signal = 0;
    if (sigwait(&signals, &signal) != 0) return;
    remove_unfinished_files();
    constexpr std::string_view words = "\ncancelled: nothing was written\n";
    static_cast<void>(!write(STDERR_FILENO, words.data(), words.size()));
    _exit(exit_cancelled);
  }).detach();
}

}  // namespace loopmend
