// SPDX-License-Identifier: GPL-3.0-or-later
#include "stopwatch.h"

#include <ctime>

namespace loopmend::bench {

namespace {

clockid_t clock_id = CLOCK_MONOTONIC;

double now() {
  timespec time{};
  clock_gettime(clock_id, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

void measure_by(TimeSource source) {
  clock_id = source == TimeSource::wall ? CLOCK_MONOTONIC : CLOCK_PROCESS_CPUTIME_ID;
}

Stopwatch::Stopwatch() : start_(now()) {}

double Stopwatch::seconds() const { return now() - start_; }

}  // namespace loopmend::bench
