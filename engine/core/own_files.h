// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the program in files of their own: they bring a large library along, or may crash, and are used when they are needed.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace loopmend {

/// A file that was built or installed with the one that holds this code: beside it, or in the folder of such parts.
/// @throws Error where it is missing, naming it.
std::filesystem::path own_file(const std::string& name);

struct ChildRun {
  int exit_code = 0;      ///< 128 + the signal where one ended it
  std::string output;     ///< what it wrote to its standard output
  std::string complaint;  ///< to its standard error
};

/// Runs a program to its end. Thread-safe. @param input  what it reads. @throws Error where it cannot be started.
ChildRun run_child(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                   const std::string& input);

}  // namespace loopmend
