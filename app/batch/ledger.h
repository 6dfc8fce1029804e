// SPDX-License-Identifier: GPL-3.0-or-later
// What batches have written into a folder, and from what: a later run skips what is complete, and replaces nothing of a person's.
#pragma once

#include "journal_file.h"
#include "scan_list.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>

namespace loopmend {

/// The files of a scan in the folder of the results.
struct ScanFiles {
  std::filesystem::path mesh, report, picture;
};
ScanFiles files_of(const std::filesystem::path& folder, const std::string& name);

/// The summary of all scans, in the same folder.
struct ResultFiles {
  std::filesystem::path table, page;
};
ResultFiles result_files(const std::filesystem::path& folder);

/// Shows whether a file has changed.
struct FileState {
  std::uintmax_t size = 0;
  std::int64_t modified = 0;  ///< nanoseconds, by the file system's clock
  bool operator==(const FileState&) const = default;
};
/// Nothing where there is no file.
std::optional<FileState> state_of(const std::filesystem::path& path);

/// A scan that was filled.
struct LedgerEntry {
  std::string input;  ///< its path, seen from the folder of the results
  std::optional<FileState> input_file, mesh, report;
  std::vector<std::string> options;
  std::string version;  ///< of this program
  int code = 0;         ///< of fill: 0 or 1
  double seconds = 0;   ///< of its process
};

/// The file batch.jsonl: one line when a scan is begun, one when it is filled, each on the disk before anything else happens.
/// No other process can open it meanwhile.
class Ledger {
 public:
  /// Makes the folder and the file where they are not there. A line that was cut off, as by kill -9, is dropped.
  /// @throws UsageError where another batch is at work there, or the file is of another kind; WriteError.
  explicit Ledger(const std::filesystem::path& folder);

  /// The entry, where its files stand as they were written, and were made from this input with these options by this version.
  std::optional<LedgerEntry> complete(const Scan& scan) const;

  /// The first of the scan's files, or of the summary's, that stands there but was not written by a batch, or has changed since.
  std::optional<std::filesystem::path> foreign_file(const std::string& name) const;
  std::optional<std::filesystem::path> foreign_summary() const;

  /// From now on its files are ours. @throws WriteError
  void begin(const std::string& name);
  void begin_summary();
  /// @param input_file  as it was before the work. @throws WriteError
  LedgerEntry finish(const Scan& scan, const std::optional<FileState>& input_file, int code, double seconds);

 private:
  void read();
  void append(const nlohmann::ordered_json& line);

  std::filesystem::path folder_, path_;
  JournalFile file_;
  std::map<std::string, std::optional<LedgerEntry>> entries_;  ///< by name; empty while a scan is under way
  bool summary_is_ours_ = false;
};

}  // namespace loopmend
