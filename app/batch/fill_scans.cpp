// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill_scans.h"

#include "core/path_text.h"
#include "io/atomic_file.h"
#include "usage_error.h"

#include <ostream>

namespace loopmend {

namespace {

void write_summary(const BatchJob& job, const std::vector<SummaryRow>& rows, Ledger& ledger) {
  const ResultFiles files = result_files(job.output);
  ledger.begin_summary();
  OutputTransaction outputs;
  outputs.add(files.table, [&](std::ostream& out) { out << summary_csv(rows); });
  outputs.add(files.page, [&](std::ostream& out) { out << summary_page(job.output, rows, job.command_line); });
  outputs.commit();
}

}  // namespace

std::vector<std::string> BatchJob::options_of_all() const {
  std::vector<std::string> options;
  if (prepare == Prepare::where_needed) options.emplace_back("--auto");
  options.insert(options.end(), fill_options.begin(), fill_options.end());
  return options;
}

std::vector<SummaryRow> fill_scans(const BatchJob& job, const BatchEvents& events, const CancelToken& cancel) {
  const std::vector<Scan> scans = list_scans(job);
  if (events.listed) events.listed(scans);
  Ledger ledger(job.output);
  const auto foreign = ledger.foreign_summary();
  if (foreign && job.existing == BatchJob::Existing::keep)
    throw UsageError(say("%1 is there, and no batch wrote it: move it away, or give --overwrite", path_text(*foreign)));
  const std::vector<ScanEnd> ends = run_scans(scans, job, ledger, events, cancel);
  std::vector<SummaryRow> rows;
  for (std::size_t k = 0; k < scans.size(); ++k) rows.push_back(summary_row(job.output, scans[k], ends[k]));
  write_summary(job, rows, ledger);
  return rows;
}

}  // namespace loopmend
