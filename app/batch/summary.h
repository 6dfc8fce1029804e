// SPDX-License-Identifier: GPL-3.0-or-later
// What a batch has come to: one row for each scan, as a table for programs and as a page for people.
#pragma once

#include "scan_runs.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace loopmend {

/// The report of a scan, in short.
struct ScanFigures {
  std::size_t vertices = 0, faces = 0;  ///< of the input
  int loops = 0, filled = 0;
  int bad = 0, look = 0;  ///< of those filled: bad ones, those that a person should look at
  int failed = 0;
  int left = 0;  ///< as asked, no holes, or not finished
  long new_vertices = 0;
  std::optional<double> angle_rms, angle_max;  ///< largest at a seam, degrees
  double seconds = 0;                          ///< of the work, without the start of the process
  double memory = 0;                           ///< at most, MB
  std::optional<double> likely_off;            ///< of the patch that is likely farthest from what was there; mesh units
  std::vector<Message> remarks;                ///< on loops that are open or not good, each once

  /// The worst of the patches: "good", "look", "bad"; empty where there is none.
  const char* verdict() const { return bad > 0 ? "bad" : look > 0 ? "look" : filled > 0 ? "good" : ""; }
};

struct SummaryRow {
  Scan scan;
  ScanEnd end;
  std::optional<ScanFigures> figures;  ///< nothing where there is no report
  std::string picture;                 ///< as the page names it; empty: there is none

  /// "filled", "nothing" (no loop was filled, and none should have been), "open", "error" or "waiting".
  const char* status() const;
  std::vector<Message> remarks() const;
};

struct SummaryCounts {
  int filled = 0;   ///< some loop, and everything as asked
  int nothing = 0;  ///< there was nothing to fill
  int open = 0;     ///< a loop failed or has a bad patch, or none is a hole
  int look = 0;     ///< of those filled: with a patch that a person should look at
  int error = 0, waiting = 0;
  int as_before = 0;  ///< of the first three, those that an earlier run did
};

/// Reads the report of the scan.
SummaryRow summary_row(const std::filesystem::path& folder, const Scan& scan, const ScanEnd& end);
SummaryCounts counts_of(const std::vector<SummaryRow>& rows);

std::vector<std::string> english(const std::vector<Message>& remarks);

std::string summary_csv(const std::vector<SummaryRow>& rows);

/// A page that needs no other file: the pictures are within.
/// @param folder  of the results, where the pictures are
std::string summary_page(const std::filesystem::path& folder, const std::vector<SummaryRow>& rows,
                         const std::string& command_line);

}  // namespace loopmend
