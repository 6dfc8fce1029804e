// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of results, as Markdown for people and as CSV for programs.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace loopmend::bench {

class Table {
 public:
  explicit Table(std::vector<std::string> columns) : columns_(std::move(columns)) {}
  /// One cell for each column.
  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  bool empty() const { return rows_.empty(); }

  std::string markdown() const;
  std::string csv() const;

 private:
  std::vector<std::string> columns_;
  std::vector<std::vector<std::string>> rows_;
};

/// Three significant digits; "-" for NaN.
std::string number(double value);
std::string number(int value);

/// Writes atomically enough for a report: a temporary file, renamed. Does nothing for an empty path.
/// @throws std::runtime_error if the file cannot be written.
void write_text(const std::filesystem::path& path, const std::string& text);

}  // namespace loopmend::bench
