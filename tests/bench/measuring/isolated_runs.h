// SPDX-License-Identifier: GPL-3.0-or-later
// Runs jobs in processes of their own, so that a crash or an endless loop costs one job and no more.
#pragma once

#include <functional>
#include <string>

namespace loopmend::bench {

struct IsolatedResult {
  std::string text;   ///< what the job said, all of it even if it did not come to its end
  std::string fault;  ///< empty at a good end; else "time limit", "crashed (signal 11)", "exception: ..."
  double seconds = 0;
};

struct IsolationOptions {
  int jobs = 1;             ///< at once
  double time_limit = 300;  ///< seconds for each
};

/// What a job wants to be known of it; may be called several times.
using Say = std::function<void(const std::string&)>;
using IsolatedJob = std::function<void(int, const Say&)>;

/// job(k, say) for k = 0..count−1, each in a forked process; done(k, result) in this one, in the order in which they end.
void run_isolated(int count, const IsolationOptions& options, const IsolatedJob& job,
                  const std::function<void(int, const IsolatedResult&)>& done);

}  // namespace loopmend::bench
