// SPDX-License-Identifier: GPL-3.0-or-later
#include "interrupt.h"

#include "exit_notice.h"
#include "io/atomic_file.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <csignal>
#include <memory>

namespace loopmend {

namespace {

struct StopSignal {
  int number;
  const char* words;  ///< why the process ends
};
constexpr std::array<StopSignal, 4> stop_signals{{{SIGINT, "cancelled"},
                                                  {SIGTERM, "cancelled by SIGTERM"},
                                                  {SIGHUP, "cancelled, since the terminal is gone (SIGHUP)"},
                                                  {SIGXCPU, "cancelled at the limit of processor time (SIGXCPU)"}}};
constexpr std::array<int, 5> crash_signals{SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT};

// A handler can reach what it acts on, and what it leaves, only by globals.
CancelToken* to_cancel = nullptr;  ///< set once, before the handler is
const char* last_words = "";       ///< likewise
std::atomic<int> stopped_by{0};
std::atomic_flag leaving = ATOMIC_FLAG_INIT;
static_assert(std::atomic<int>::is_always_lock_free);

/// Only what POSIX allows in a handler: lock-free atomics, unlink, rmdir, write, _exit.
void leave(int signal) {
  if (leaving.test_and_set()) return;  // another thread is on its way out
  remove_unfinished_files();
  say_at_exit("\nloopmend: ");
  for (const StopSignal& stop : stop_signals)
    if (stop.number == signal) say_at_exit(stop.words);
  say_what_was_written(last_words);
  _exit(128 + signal);
}

/// The default action comes next: the shell names the signal, and there is a core file where one is wanted.
void tell_crash(int signal) {
  const bool first = !leaving.test_and_set();
  if (first) {
    remove_unfinished_files();
    say_at_exit("\nloopmend: crashed, a fault of this program; unfinished files were removed");
    say_what_was_written(last_words);
  }
  std::signal(signal, SIG_DFL);
  raise(signal);  // blocked until this returns; a fault would happen again by itself
}

void handle_stops(void (*handler)(int)) {
  struct sigaction action {};
  action.sa_handler = handler;
  sigemptyset(&action.sa_mask);
  for (const StopSignal& stop : stop_signals) sigaddset(&action.sa_mask, stop.number);
  for (const StopSignal& stop : stop_signals) {
    struct sigaction before {};
    const bool ignored = sigaction(stop.number, nullptr, &before) == 0 && before.sa_handler == SIG_IGN;
    if (stop.number == SIGHUP && ignored) continue;  // nohup
    sigaction(stop.number, &action, nullptr);
  }
}

void finish_early(int signal) {
  int none = 0;
  stopped_by.compare_exchange_strong(none, signal);
  to_cancel->cancel();  // a lock-free store
  handle_stops(leave);
  say_at_exit("\nloopmend: stopping; what is finished will be written (Ctrl-C again: nothing will)\n");
}

/// On a stack of its own: the process's may be what has run out.
void handle_crashes() {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // sanitizers tell more than we could
  constexpr std::size_t stack_size = 1 << 16;
  static const std::unique_ptr<char[]> stack(new char[stack_size]);
  const stack_t alternative{stack.get(), 0, stack_size};
  sigaltstack(&alternative, nullptr);
  struct sigaction action {};
  action.sa_handler = tell_crash;
  action.sa_flags = SA_ONSTACK;
  sigemptyset(&action.sa_mask);
  for (const int signal : crash_signals) sigaction(signal, &action, nullptr);
#else
  static_cast<void>(tell_crash);
  static_cast<void>(crash_signals);
#endif
}

void open_closed_streams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0) static_cast<void>(open("/dev/null", O_RDWR));  // takes the lowest free number
}

}  // namespace

void cancel_on_interrupt(const CancelToken& token) {
  static CancelToken shared;
  shared = token;
  to_cancel = &shared;
  handle_stops(finish_early);
}

int interrupt_exit_code() {
  const int signal = stopped_by.load();
  return signal == 0 ? 0 : 128 + signal;
}

bool reader_has_gone() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return poll(&output, 1, 0) == 1 && (output.revents & POLLERR) != 0;
}

void handle_signals(const char* at_the_end) {
  last_words = at_the_end;
  open_closed_streams();
  handle_stops(leave);
  handle_crashes();
  // A file that grows beyond `ulimit -f` then fails with an error that can be reported, in place of a signal.
  std::signal(SIGXFSZ, SIG_IGN);
  // If the reader of our messages stops, the files are written nevertheless.
  std::signal(SIGPIPE, SIG_IGN);
}

}  // namespace loopmend
