// SPDX-License-Identifier: GPL-3.0-or-later
// Runs `loopmend` as a person or a script would.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace loopmend::test {

struct Outcome {
  int code = -1;  ///< exit code; 128 + signal when killed
  std::string out, err;
};

/// @param command  as typed in a shell.
Outcome run_in_shell(const std::string& command);

/// @param arguments  as typed in a shell.
Outcome loopmend_program(const std::string& arguments);

std::string text_of(const std::filesystem::path& path);

/// A folder of its own for each test, removed at its end.
class Workspace {
 public:
  Workspace();
  ~Workspace();
  Workspace(const Workspace&) = delete;
  Workspace& operator=(const Workspace&) = delete;
  std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

/// Tests of commands that write work / "out.ply".
class ProgramTest : public testing::Test {
 protected:
  /// A file in the test's folder, quoted for the shell, with a blank behind.
  std::string path(const std::string& name) const;
  /// A sentence with these words, and nothing written.
  void expect_refused(const Outcome& run, int code, const std::string& words) const;
  Workspace work;
};

}  // namespace loopmend::test
