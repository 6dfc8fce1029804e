// SPDX-License-Identifier: GPL-3.0-or-later
#include "child.h"

#include "core/error.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/mman.h>
#include <sys/prctl.h>
#endif
#ifdef __APPLE__
#include <mach-o/dyld.h>
#endif

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdio>
#include <cstring>

namespace loopmend {

namespace {

constexpr off_t most_said = 4096;  ///< bytes that are kept of what a child says

/// In the child, before the program: only what POSIX allows there.
/// @param otherwise  a second try; may be null
[[noreturn]] void become(const char* program, const char* otherwise, char* const* arguments, pid_t parent, int said,
                         const sigset_t& signals) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
    struct sigaction before {};
    if (sigaction(signal, nullptr, &before) == 0 && before.sa_handler != SIG_IGN) std::signal(signal, SIG_DFL);
  }
#ifdef __linux__
  prctl(PR_SET_PDEATHSIG, SIGTERM);  // stays over exec
#endif
  if (getppid() != parent) _exit(127);
  const int nothing = open("/dev/null", O_RDWR);
  dup2(nothing, STDIN_FILENO);
  dup2(nothing, STDOUT_FILENO);
  dup2(said, STDERR_FILENO);
  if (nothing > STDERR_FILENO) close(nothing);
  sigprocmask(SIG_SETMASK, &signals, nullptr);
  execv(program, arguments);
  if (otherwise != nullptr) execv(otherwise, arguments);
  _exit(127);
}

/// The file of this program, whose name `ps` shows.
std::string own_file() {
  std::array<char, 4096> path{};
#ifdef __APPLE__
  auto size = static_cast<std::uint32_t>(path.size());
  if (_NSGetExecutablePath(path.data(), &size) != 0) return {};
#else
  static_cast<void>(!readlink("/proc/self/exe", path.data(), path.size() - 1));
#endif
  return path.data();
}

/// A file without a name, which goes to no child by itself. @returns −1, with the reason in errno.
int nameless_file() {
#ifdef __linux__
  return memfd_create("loopmend", MFD_CLOEXEC);
#else
  std::FILE* file = std::tmpfile();
  if (file == nullptr) return -1;
  const int result = fcntl(fileno(file), F_DUPFD_CLOEXEC, 0);
  std::fclose(file);
  return result;
#endif
}

std::string end_of(int file) {
  const off_t size = lseek(file, 0, SEEK_END);
  std::string text(static_cast<std::size_t>(std::clamp(size, off_t{0}, most_said)), '\0');
  const ssize_t read = pread(file, text.data(), text.size(), std::max(off_t{0}, size - most_said));
  text.resize(static_cast<std::size_t>(std::max(ssize_t{0}, read)));
  return text;
}

}  // namespace

struct Child::Process {
  pid_t id = -1;               ///< -1: it has ended, and the system knows it no more
  int said = nameless_file();  ///< takes its standard error
  ~Process() {
    if (said >= 0) close(said);
  }
};

Child::Child(const std::filesystem::path& program, const std::vector<std::string>& arguments)
    : process_(std::make_unique<Process>()) {
  struct sigaction of_children {};
  // Ignored, as some callers leave it, the children's ends would not be reported. A handler, as Qt has one, stays.
  if (sigaction(SIGCHLD, nullptr, &of_children) == 0 && of_children.sa_handler == SIG_IGN)
    std::signal(SIGCHLD, SIG_DFL);
  std::vector<char*> words{const_cast<char*>("loopmend")};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  const std::string file = program.empty() ? own_file() : program.string();
  // The same program where its file was replaced meanwhile.
  const char* otherwise = program.empty() ? "/proc/self/exe" : nullptr;
  // A signal to the child between fork and exec must not meet our handlers there: it would be lost.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_SETMASK, &all, &before);
  const pid_t parent = getpid();
  process_->id = process_->said < 0 ? -1 : fork();
  const int error = errno;
  if (process_->id == 0) become(file.c_str(), otherwise, words.data(), parent, process_->said, before);
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  if (process_->id > 0) return;
  throw Error(say("the system starts no further process: %1. A smaller --jobs needs fewer.", std::strerror(error)));
}

Child::~Child() {
  if (process_->id <= 0) return;
  kill();
  while (waitpid(process_->id, nullptr, 0) < 0 && errno == EINTR) continue;
}

std::optional<ChildEnd> Child::end() {
  int status = 0;
  if (process_->id < 0 || waitpid(process_->id, &status, WNOHANG) != process_->id) return {};
  process_->id = -1;
  return ChildEnd{WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), end_of(process_->said)};
}

void Child::stop() const {
  if (process_->id > 0) ::kill(process_->id, SIGTERM);
}

void Child::kill() const {
  if (process_->id > 0) ::kill(process_->id, SIGKILL);
}

}  // namespace loopmend
