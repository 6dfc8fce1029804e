// SPDX-License-Identifier: GPL-3.0-or-later
#include "child.h"

#include "core/error.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>

namespace loopmend {

namespace {

constexpr off_t most_said = 4096;  ///< bytes that are kept of what a child says

/// In the child, before the program: only what POSIX allows there.
[[noreturn]] void become(char* const* arguments, pid_t parent, int said, const sigset_t& signals) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) std::signal(signal, SIG_DFL);
  }
  prctl(PR_SET_PDEATHSIG, SIGTERM);  // stays over exec
  if (getppid() != parent) _exit(127);
  const int nothing = open("/dev/null", O_RDWR);
  dup2(nothing, STDIN_FILENO);
  dup2(nothing, STDOUT_FILENO);
  dup2(said, STDERR_FILENO);
  if (nothing > STDERR_FILENO) close(nothing);
  sigprocmask(SIG_SETMASK, &signals, nullptr);
  char program[4096];
  const ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
  program[std::max(ssize_t{0}, length)] = '\0';
  execv(program, arguments);           // by its name, which `ps` shows
  execv("/proc/self/exe", arguments);  // the same program where its file was replaced meanwhile
  _exit(127);
}

std::string end_of(int file) {
  const off_t size = lseek(file, 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::clamp(size, off_t{0}, most_said)), '\0');
  const ssize_t read = pread(file, text.data(), text.size(), std::max(off_t{0}, size - most_said));
  text.resize(static_cast<std::size_t>(std::max(ssize_t{0}, read)));
  return text;
}

}  // namespace

Child::Child(const std::vector<std::string>& arguments) {
  std::vector<char*> words{const_cast<char*>("loopmend")};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  said_ = memfd_create("loopmend", MFD_CLOEXEC);
  // A signal to the child between fork and exec must not meet our handlers there: it would be lost.
  sigset_t all, before;
  sigfillset(&all);
  sigprocmask(SIG_SETMASK, &all, &before);
  const pid_t parent = getpid();
  process_ = said_ < 0 ? -1 : fork();
  const int error = errno;
  if (process_ == 0) become(words.data(), parent, said_, before);
  sigprocmask(SIG_SETMASK, &before, nullptr);
  if (process_ > 0) return;
  if (said_ >= 0) close(said_);
  throw Error(std::string("the system starts no further process: ") + std::strerror(error) +
              ". A smaller --jobs needs fewer.");
}

Child::~Child() {
  if (process_ > 0) {
    kill();
    while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) continue;
  }
  close(said_);
}

std::optional<ChildEnd> Child::end() {
  int status = 0;
  if (process_ < 0 || waitpid(process_, &status, WNOHANG) != process_) return {};
  process_ = -1;
  return ChildEnd{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), end_of(said_)};
}

void Child::stop() const {
  if (process_ > 0) ::kill(process_, SIGTERM);
}

void Child::kill() const {
  if (process_ > 0) ::kill(process_, SIGKILL);
}

}  // namespace loopmend
