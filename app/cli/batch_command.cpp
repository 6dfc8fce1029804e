// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch_command.h"

#include "batch/fill_scans.h"
#include "core/path_text.h"
#include "core/seconds_since.h"
#include "exit_codes.h"
#include "interrupt.h"
#include "outputs.h"

#include <chrono>
#include <cstdio>

namespace loopmend {

namespace {

int exit_code_of(const SummaryCounts& counts, BatchCommand::FailOn policy) {
  const bool failed = (policy != BatchCommand::FailOn::never && counts.error > 0) ||
                      (policy == BatchCommand::FailOn::open && counts.open > 0);
  return failed ? exit_loops_failed : exit_done;
}

}  // namespace

int run_batch(const BatchCommand& command, const CheckFillOptions& check) {
  const auto start = std::chrono::steady_clock::now();
  const BatchJob& job = command.job;
  check(job.options_of_all());
  const CancelToken cancel;
  ProgressLine progress(command.verbosity);
  int scans = 0, done = 0;
  BatchEvents events;
  events.listed = [&](const std::vector<Scan>& found) {
    for (const Scan& scan : found)
      if (scan.options != job.options_of_all()) check(scan.options);
    scans = static_cast<int>(found.size());
    cancel_on_interrupt(cancel);
  };
  events.ended = [&](std::size_t, const ScanEnd&) { progress.show(++done, scans, "scans"); };
  events.said = [&](const Message& words) { progress.say(words.english()); };
  const std::vector<SummaryRow> rows = fill_scans(job, events, cancel);
  const SummaryCounts counts = counts_of(rows);
  const double seconds = seconds_since(start);
  if (command.verbosity == Verbosity::normal) {
    std::printf("%s: %d filled, %d of them to look at, %d left open, %s", counted(rows.size(), "scan", "scans").c_str(),
                counts.filled, counts.look, counts.open,
                counted(static_cast<std::size_t>(counts.error), "error", "errors").c_str());
    if (counts.nothing > 0) std::printf(", %d with nothing to fill", counts.nothing);
    if (counts.waiting > 0) std::printf(", %d waiting for the next run", counts.waiting);
    if (counts.as_before > 0) std::printf("; %d were complete before", counts.as_before);
    std::printf("; %s written in %.1f s\n", path_text(result_files(job.output).page).c_str(), seconds);
  }
  if (const int stopped_with = interrupt_exit_code(); cancel.cancelled() && stopped_with != 0) return stopped_with;
  return exit_code_of(counts, command.fail_on);
}

}  // namespace loopmend
