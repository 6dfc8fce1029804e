// SPDX-License-Identifier: GPL-3.0-or-later
// What a batch has come to: one row for each scan, as a table for programs and as a page for people.
#pragma once

#include "scan_runs.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace loopmend {

/// What the report of a scan tells, in short.
struct ScanFigures {
  std::size_t vertices = 0, faces = 0;  ///< of the input
  int loops = 0, filled = 0;
  int bad = 0;  ///< of those filled
  int failed = 0;
  int left = 0;  ///< as asked, no holes, or not finished
  long new_vertices = 0;
  std::optional<double> angle_rms, angle_max;  ///< largest at a seam, degrees
  double seconds = 0;                          ///< of the work, without the start of the process
  double memory = 0;                           ///< at most, MB
  std::string remarks;                         ///< what is said of loops that are open or bad, each once
};

struct SummaryRow {
  const Scan* scan = nullptr;
  const ScanEnd* end = nullptr;
  std::optional<ScanFigures> figures;  ///< nothing where there is no report
  std::string picture;                 ///< as the page names it; empty: there is none

  /// "filled", "look", "error" or "waiting".
  const char* status() const;
  std::string remark() const;
};

struct SummaryCounts {
  int filled = 0;  ///< everything as asked
  int look = 0;    ///< a loop failed or has a bad patch, or none is a hole
  int error = 0, waiting = 0;
  int as_before = 0;  ///< of the first two, those that an earlier run filled
};

std::vector<SummaryRow> summary_rows(const std::filesystem::path& folder, const std::vector<Scan>& scans,
                                     const std::vector<ScanEnd>& ends);
SummaryCounts counts_of(const std::vector<SummaryRow>& rows);

std::string summary_csv(const std::vector<SummaryRow>& rows);

/// A page that needs no other file: the pictures are within.
/// @param folder  of the results, where the pictures are
std::string summary_page(const std::filesystem::path& folder, const std::vector<SummaryRow>& rows,
                         const std::string& command_line);

}  // namespace loopmend
