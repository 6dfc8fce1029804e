// SPDX-License-Identifier: GPL-3.0-or-later
#include "isolated_runs.h"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <vector>

namespace loopmend::bench {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

void write_all(int file, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t written = write(file, text.data() + done, text.size() - done);
    if (written <= 0) return;
    done += static_cast<std::size_t>(written);
  }
}

constexpr char end_mark = '\x04', error_mark = '\x15';

/// The forked process: never returns.
[[noreturn]] void work(int k, int out, const IsolatedJob& job) {
  try {
    job(k, [out](const std::string& text) { write_all(out, text); });
    write_all(out, std::string(1, end_mark));
  } catch (const std::exception& error) {
    write_all(out, std::string(1, error_mark) + error.what());
  } catch (...) {
    write_all(out, std::string(1, error_mark) + "an unknown one");
  }
  _exit(0);
}

/// One process, and what it has said so far.
class Child {
 public:
  Child(int number, const IsolatedJob& job) : number_(number), start_(Clock::now()) {
    int ends[2];
    if (pipe(ends) != 0) throw std::runtime_error("no pipe could be opened");
    std::fflush(nullptr);
    pid_ = fork();
    if (pid_ < 0) throw std::runtime_error("no process could be started");
    if (pid_ == 0) {
      close(ends[0]);
      work(number, ends[1], job);
    }
    close(ends[1]);
    file_ = ends[0];
  }
  int number() const { return number_; }
  double seconds() const { return seconds_since(start_); }

  /// Reads what is there. @returns true once the process has closed its end.
  bool read_some() {
    pollfd wait{file_, POLLIN, 0};
    if (poll(&wait, 1, 0) <= 0) return false;
    char buffer[4096];
    const ssize_t size = read(file_, buffer, sizeof buffer);
    if (size <= 0) return true;
    text_.append(buffer, static_cast<std::size_t>(size));
    return false;
  }

  IsolatedResult end(bool out_of_time) {
    if (out_of_time) kill(pid_, SIGKILL);
    int status = 0;
    waitpid(pid_, &status, 0);
    close(file_);
    IsolatedResult result;
    result.seconds = seconds();
    if (out_of_time)
      result.fault = "time limit";
    else if (WIFSIGNALED(status))
      result.fault = "crashed (signal " + std::to_string(WTERMSIG(status)) + ")";
    const std::size_t end = text_.find_first_of(std::string{end_mark, error_mark});
    result.text = text_.substr(0, end);
    if (result.fault.empty() && end == std::string::npos)
      result.fault = "ended without a word";
    else if (result.fault.empty() && text_[end] == error_mark)
      result.fault = "exception: " + text_.substr(end + 1);
    return result;
  }

 private:
  int number_;
  Clock::time_point start_;
  pid_t pid_ = 0;
  int file_ = -1;
  std::string text_;
};

}  // namespace

void run_isolated(int count, const IsolationOptions& options, const IsolatedJob& job,
                  const std::function<void(int, const IsolatedResult&)>& done) {
  std::vector<Child> running;
  for (int next = 0; next < count || !running.empty();) {
    while (next < count && static_cast<int>(running.size()) < std::max(1, options.jobs))
      running.emplace_back(next++, job);
    for (auto child = running.begin(); child != running.end();) {
      const bool closed = child->read_some();
      const bool late = !closed && child->seconds() > options.time_limit;
      if (closed || late) {
        done(child->number(), child->end(late));
        child = running.erase(child);
      } else {
        ++child;
      }
    }
    usleep(2000);
  }
}

}  // namespace loopmend::bench
