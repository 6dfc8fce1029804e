// SPDX-License-Identifier: GPL-3.0-or-later
// One clock for all: ours and the peers' times must be comparable.
#pragma once

namespace loopmend::bench {

enum class TimeSource {
  wall,       ///< what a user waits
  processor,  ///< summed over the threads of this process: what other programs on the machine do not disturb
};

/// For all stopwatches from now on; wall by default. Not while other threads measure.
void measure_by(TimeSource source);

class Stopwatch {
 public:
  Stopwatch();
  double seconds() const;  ///< since it was made

 private:
  double start_;
};

}  // namespace loopmend::bench
