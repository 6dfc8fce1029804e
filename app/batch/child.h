// SPDX-License-Identifier: GPL-3.0-or-later
// `loopmend` as a child process: what goes wrong there takes one scan only. In child_posix.cpp and child_windows.cpp.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace loopmend {

struct ChildEnd {
  int code = 0;      ///< its exit code; 128 + signal where one has killed it, as in a shell
  std::string said;  ///< the end of what it wrote to standard error
};

/// Runs from its construction on. Its standard output goes nowhere. It ends when this process dies, of whatever,
/// where the system lets that be asked for: on Linux by SIGTERM, also at the end of the thread that made it; on Windows
/// at once.
class Child {
 public:
  /// @param program    its file; empty: this program once more
  /// @param arguments  behind the name of the program. @throws Error where the system starts no process.
  Child(const std::filesystem::path& program, const std::vector<std::string>& arguments);
  /// Kills it where it still runs.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// Nothing while it runs.
  std::optional<ChildEnd> end();
  /// Asks it to remove unfinished files and to end. On Windows, where a process without a console cannot be asked, as kill().
  void stop() const;
  void kill() const;

 private:
  struct Process;
  std::unique_ptr<Process> process_;
};

}  // namespace loopmend
