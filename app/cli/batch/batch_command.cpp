// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch_command.h"

#include "cli/commands.h"
#include "cli/exit_codes.h"
#include "cli/interrupt.h"
#include "cli/outputs.h"
#include "core/path_text.h"
#include "summary.h"

#include <chrono>
#include <cstdio>

namespace loopmend {

namespace {

void write_summary(const BatchCommand& command, const std::vector<SummaryRow>& rows, Ledger& ledger) {
  ledger.begin_summary();
  OutputTransaction outputs;
  add_text(outputs, command.output / "summary.csv", summary_csv(rows));
  add_text(outputs, command.output / "summary.html", summary_page(command.output, rows, command.command_line));
  outputs.commit();
}

int exit_code_of(const SummaryCounts& counts, BatchCommand::FailOn policy) {
  const bool failed = (policy != BatchCommand::FailOn::never && counts.error > 0) ||
                      (policy == BatchCommand::FailOn::open && counts.look > 0);
  return failed ? exit_loops_failed : exit_done;
}

}  // namespace

int run_batch(const BatchCommand& command, const CheckFillOptions& check) {
  const auto start = std::chrono::steady_clock::now();
  check(command.fill_options);
  const std::vector<Scan> scans = list_scans(command);
  for (const Scan& scan : scans)
    if (scan.options != command.fill_options) check(scan.options);
  Ledger ledger(command.output);
  const auto foreign = ledger.foreign_summary();
  if (foreign && command.existing == BatchCommand::Existing::keep)
    throw UsageError(path_text(*foreign) + " is there, and no batch wrote it: move it away, or give --overwrite");
  const CancelToken cancel;
  cancel_on_interrupt(cancel);
  const std::vector<ScanEnd> ends = fill_scans(scans, command, ledger, cancel);
  const std::vector<SummaryRow> rows = summary_rows(command.output, scans, ends);
  write_summary(command, rows, ledger);
  const SummaryCounts counts = counts_of(rows);
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  if (command.verbosity == Verbosity::normal) {
    std::printf("%s: %d filled, %d to look at, %d errors", counted(scans.size(), "scan", "scans").c_str(),
                counts.filled, counts.look, counts.error);
    if (counts.nothing > 0) std::printf(", %d with nothing to fill", counts.nothing);
    if (counts.waiting > 0) std::printf(", %d waiting for the next run", counts.waiting);
    if (counts.as_before > 0) std::printf("; %d were complete before", counts.as_before);
    std::printf("; %s written in %.1f s\n", path_text(command.output / "summary.html").c_str(), seconds);
  }
  if (const int stopped_with = interrupt_exit_code(); cancel.cancelled() && stopped_with != 0) return stopped_with;
  return exit_code_of(counts, command.fail_on);
}

}  // namespace loopmend
