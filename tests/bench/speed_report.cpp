// SPDX-License-Identifier: GPL-3.0-or-later
#include "speed_report.h"

#include "table.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace loopmend::bench {

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

double counter(const benchmark::BenchmarkReporter::Run& run, const char* name) {
  const auto found = run.counters.find(name);
  return found == run.counters.end() ? nan : found->second.value;
}

}  // namespace

const std::vector<int>& table_sizes() {
  static const std::vector<int> sizes{1160, 3720, 1074, 1470, 800, 432, 840};
  return sizes;
}

void SpeedReporter::ReportRuns(const std::vector<Run>& runs) {
  ConsoleReporter::ReportRuns(runs);
  for (const Run& run : runs) {
    if (run.error_occurred || run.run_type != Run::RT_Iteration || run.run_name.args.empty()) continue;
    Measured measured;
    measured.seconds = run.real_accumulated_time / static_cast<double>(run.iterations);
    measured.bytes = counter(run, "bytes");
    measured.steps = counter(run, "steps");
    measured.added = counter(run, "new");
    measured.label = run.report_label;
    runs_[std::stoi(run.run_name.args)][run.run_name.function_name] = measured;
  }
}

double SpeedReporter::seconds(const std::string& name, int free) const {
  const auto size = runs_.find(free);
  if (size == runs_.end()) return nan;
  const auto found = size->second.find(name);
  return found == size->second.end() ? nan : found->second.seconds;
}

std::vector<std::string> SpeedReporter::row(int free) const {
  std::vector<std::string> cells{number(free)};
  for (const char* name : {"form", "factor", "solve", "step", "flow_step", "flow_steps", "steady"})
    cells.push_back(number(seconds(name, free)));
  const auto& runs = runs_.at(free);
  const auto steady = runs.find("steady");
  cells.push_back(steady == runs.end() ? "-"
                                       : number(static_cast<int>(steady->second.steps)) + " " + steady->second.label);
  cells.push_back(number(seconds("fill", free)));
  const auto memory = runs.find(runs.contains("fill") ? "fill" : "step");
  // Less than that is lost in what the process holds anyway.
  const bool known = memory != runs.end() && memory->second.bytes > 4e6;
  cells.push_back(known ? number(memory->second.bytes / 1e6) : "-");
  cells.push_back(known ? number(memory->second.bytes / 1e3 / free) : "-");
  for (int k : {1, 2})
    cells.push_back(number(seconds("steady", free) / seconds("cgal_c" + std::to_string(k) + "_fair", free)));
  for (int k : {1, 2})
    cells.push_back(number(seconds("fill", free) / seconds("cgal_c" + std::to_string(k) + "_fill", free)));
  return cells;
}

/// d log t / d log n between neighbouring sizes from 10k on.
std::string SpeedReporter::growth() const {
  Table table({"from", "to", "form", "factor", "solve", "step", "steady", "fill"});
  int previous = 0;
  for (const auto& [free, runs] : runs_) {
    if (free < 10000) continue;
    if (previous > 0) {
      std::vector<std::string> cells{number(previous), number(free)};
      for (const char* name : {"form", "factor", "solve", "step", "steady", "fill"})
        cells.push_back(number(std::log(seconds(name, free) / seconds(name, previous)) /
                               std::log(static_cast<double>(free) / previous)));
      table.add(cells);
    }
    previous = free;
  }
  return table.empty() ? "" : "\nGrowth exponents:\n\n" + table.markdown();
}

void SpeedReporter::write(const std::filesystem::path& path, const std::string& unit) const {
  Table table({"free vertices", "form", "factor", "solve", "step", "flow step", "of ten", "steady", "steps", "fill",
               "fill MB", "kB a vertex", "steady / CGAL C1 fairing", "steady / CGAL C2 fairing", "fill / CGAL C1 call",
               "fill / CGAL C2 call"});
  const std::vector<int>& of_the_paper = table_sizes();
  for (int free : of_the_paper)
    if (runs_.contains(free)) table.add(row(free));
  for (const auto& [free, runs] : runs_)
    if (std::find(of_the_paper.begin(), of_the_paper.end(), free) == of_the_paper.end()) table.add(row(free));
  write_text(path, unit +
                       ". form: fits, operators and the matrix; factor: symbolic and numeric Cholesky; step: one whole "
                       "Gauss-Newton step with checks and mesh improvement; flow step: one semi-implicit step of the "
                       "paper, the first; of ten: the "
                       "mean of the first ten; "
                       "steady: to the steady state from a bump; fill: one call on the open surface.\n\n" +
                       table.markdown() + growth());
}

}  // namespace loopmend::bench
