// SPDX-License-Identifier: GPL-3.0-or-later
// This program once more, as a child process: what goes wrong there takes one scan only.
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>
#include <vector>

namespace loopmend {

struct ChildEnd {
  int code = 0;      ///< its exit code; 128 + signal where one has killed it, as a shell tells it
  std::string said;  ///< the end of what it wrote to standard error
};

/// Runs from its construction on. Its standard output goes nowhere. It gets SIGTERM when this process dies, of whatever.
class Child {
 public:
  /// @param arguments  behind the name of the program. @throws Error where the system starts no process.
  explicit Child(const std::vector<std::string>& arguments);
  /// Kills it where it still runs.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Nothing while it runs.
  std::optional<ChildEnd> end();
  /// Asks it to remove unfinished files and to end.
  void stop() const;
  void kill() const;

 private:
  pid_t process_ = -1;  ///< -1: it has ended, and the system knows it no more
  int said_ = -1;       ///< a file in memory that takes its standard error
};

}  // namespace loopmend
