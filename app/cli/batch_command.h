// SPDX-License-Identifier: GPL-3.0-or-later
// `loopmend batch`: fills many scans, several at once, each in a process of its own, and writes one summary.
#pragma once

#include "batch/batch_job.h"
#include "cli/progress_line.h"

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace loopmend {

struct BatchCommand {
  BatchJob job;
  enum class FailOn { never, error, open } fail_on = FailOn::error;  ///< what makes the exit code 1
  Verbosity verbosity = Verbosity::normal;
};

void add_batch(CLI::App& app, BatchCommand& command);

/// Throws UsageError unless `loopmend fill` takes these options.
using CheckFillOptions = std::function<void(const std::vector<std::string>&)>;

/// @returns an ExitCode. @throws UsageError, WriteError, Error.
int run_batch(const BatchCommand& command, const CheckFillOptions& check);

}  // namespace loopmend
