// SPDX-License-Identifier: GPL-3.0-or-later
// The tables of the speed bench: times by size, ratios to CGAL, growth exponents.
#pragma once

#include <benchmark/benchmark.h>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace loopmend::bench {

/// Free vertices of the seven rows of the paper's Table 5.1 (its unknowns divided by three).
const std::vector<int>& table_sizes();

/// Shows runs as they end, like Google Benchmark, and keeps them.
class SpeedReporter : public benchmark::ConsoleReporter {
 public:
  void ReportRuns(const std::vector<Run>& runs) override;
  /// The tables as Markdown. Does nothing for an empty path. @param unit  of the times, in words.
  void write(const std::filesystem::path& path, const std::string& unit) const;

 private:
  struct Measured {
    double seconds = 0, bytes = 0, steps = 0, added = 0;
    std::string label;
  };
  /// NaN where there was no such run.
  double seconds(const std::string& name, int free) const;
  std::vector<std::string> row(int free) const;
  std::string growth() const;

  std::map<int, std::map<std::string, Measured>> runs_;  ///< by size, then by name
};

}  // namespace loopmend::bench
