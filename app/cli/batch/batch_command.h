// SPDX-License-Identifier: GPL-3.0-or-later
// `loopmend batch`: fills many scans, several at once, each in a process of its own, and writes one summary.
#pragma once

#include "cli/progress_line.h"

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace loopmend {

struct BatchCommand {
  std::vector<std::filesystem::path> inputs;  ///< scans, folders of scans, manifests (.jsonl)
  std::filesystem::path output;               ///< folder
  int jobs = 0;                               ///< scans worked on at once; 0: one for each core
  std::string format;                         ///< extension of the outputs without its point; empty: that of each input
  enum class Pictures { none, open, all } pictures = Pictures::all;   ///< before and after, of which scans
  enum class FailOn { never, error, open } fail_on = FailOn::error;   ///< what makes the exit code 1
  enum class Again { none, open, all } again = Again::none;           ///< which complete scans are filled once more
  enum class Existing { keep, overwrite } existing = Existing::keep;  ///< files in the folder that batch did not write
  enum class Prepare { as_asked, where_needed } prepare = Prepare::where_needed;  ///< --auto for every scan, or not
  Verbosity verbosity = Verbosity::normal;
  std::vector<std::string> fill_options;  ///< for every scan
  std::string command_line;               ///< as typed, for the summary
};

void add_batch(CLI::App& app, BatchCommand& command);

/// Throws UsageError unless `loopmend fill` takes these options.
using CheckFillOptions = std::function<void(const std::vector<std::string>&)>;

/// @returns an ExitCode. @throws UsageError, WriteError, Error.
int run_batch(const BatchCommand& command, const CheckFillOptions& check);

}  // namespace loopmend
