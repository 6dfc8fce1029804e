// SPDX-License-Identifier: GPL-3.0-or-later
// What a batch is asked to do.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace loopmend {

struct BatchJob {
  std::vector<std::filesystem::path> inputs;  ///< scans, folders of scans, manifests (.jsonl)
  std::filesystem::path output;               ///< folder
  std::filesystem::path program;              ///< `loopmend`, which does the work; empty: this program
  int jobs = 0;                               ///< scans worked on at once; 0: one for each core
  std::string format;                         ///< extension of the outputs without its point; empty: that of each input
  enum class Pictures { none, open, all } pictures = Pictures::all;   ///< before and after, of which scans
  enum class Again { none, open, all } again = Again::none;           ///< which complete scans are filled once more
  enum class Existing { keep, overwrite } existing = Existing::keep;  ///< files in the folder that batch did not write
  enum class Prepare { as_asked, where_needed } prepare = Prepare::where_needed;  ///< --auto for every scan, or not
  std::vector<std::string> fill_options;  ///< for every scan, after what `prepare` gives
  std::string command_line;               ///< as typed, for the summary

  /// What every scan is filled with.
  std::vector<std::string> options_of_all() const;
};

}  // namespace loopmend
