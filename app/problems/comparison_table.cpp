// SPDX-License-Identifier: GPL-3.0-or-later
#include "problems/comparison_table.h"

#include "flows/flow_terms.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

namespace loopmend {

namespace {

/// Empty for what is not known.
std::string format(const char* pattern, double value) {
  if (!std::isfinite(value)) return {};
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

std::string joined_row(const std::vector<std::string>& cells, const char* before, const char* between,
                       const char* after) {
  std::string row = before;
  for (std::size_t k = 0; k < cells.size(); ++k) row += (k ? between : "") + cells[k];
  return row + after;
}

}  // namespace

std::string upper_name(FlowKind flow) {
  std::string name = to_string(flow);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  return name;
}

SeamFigures seam_figures(const std::vector<SeamReport>& seams) {
  SeamFigures figures;
  double count = 0;
  for (const SeamReport& seam : seams) {
    if (!std::isfinite(seam.h_jump_rms)) continue;
    figures.jump += seam.h_jump_rms * seam.h_jump_rms;
    figures.jump_times_diameter += seam.h_jump_rms_times_diameter * seam.h_jump_rms_times_diameter;
    figures.angle += seam.g1_rms_deg * seam.g1_rms_deg;
    ++count;
  }
  for (double* x : {&figures.jump, &figures.jump_times_diameter, &figures.angle})
    *x = count > 0 ? std::sqrt(*x / count) : std::nan("");
  return figures;
}

const std::vector<std::string>& comparison_heads() {
  static const std::vector<std::string> heads{
      "surface",        "status",    "steps",           "int |grad H|^2",   "int H^2", "area",
      "wide jump of H", "jump of H", "jump x diameter", "angle in degrees", "folds",   "self-intersections"};
  return heads;
}

std::vector<std::string> comparison_row(const std::string& name, const std::string& status, int steps,
                                        const PatchEnergies& energies, const std::vector<SeamReport>& seams,
                                        double wide_jump, const Validity& quality) {
  const SeamFigures seam = seam_figures(seams);
  return {name,
          status,
          std::to_string(steps),
          format("%.5g", energies.variation),
          format("%.5g", energies.bending),
          format("%.5g", energies.area),
          format("%.4g", wide_jump),
          format("%.4g", seam.jump),
          format("%.4g", seam.jump_times_diameter),
          format("%.4g", seam.angle),
          std::to_string(quality.folds),
          std::to_string(quality.intersections)};
}

namespace {

/// The flow, and what took its place where something did.
std::string run_name(const ComparedFlow& run) {
  if (run.outcome.method == Method::flow) return upper_name(run.outcome.flow);
  return upper_name(run.outcome.flow) + " as " + method_name(run.outcome.method, run.outcome.flow);
}

}  // namespace

std::vector<std::vector<std::string>> comparison_rows(const FlowComparison& comparison) {
  std::vector<std::vector<std::string>> rows;
  rows.push_back(comparison_row("start", "", 0, comparison.start, comparison.start_seams, comparison.start_wide_jump,
                                comparison.start_validity));
  for (const ComparedFlow& run : comparison.runs)
    rows.push_back(comparison_row(run_name(run), to_string(run.outcome.status), run.outcome.steps, run.energies,
                                  run.outcome.seams, run.wide_jump, run.outcome.validity));
  return rows;
}

std::string comparison_csv(const FlowComparison& comparison) { return csv_of(comparison_rows(comparison)); }

std::string csv_of(const std::vector<std::vector<std::string>>& rows) {
  std::string text = joined_row(comparison_heads(), "", ",", "\n");
  for (const auto& row : rows) text += joined_row(row, "", ",", "\n");
  return text;
}

std::string comparison_table(const FlowComparison& comparison) {
  std::vector<std::string> heads = comparison_heads();
  for (std::string& head : heads)  // a bar would begin another column
    for (std::size_t at = head.find('|'); at != std::string::npos; at = head.find('|', at + 2))
      head.insert(at, 1, '\\');
  std::string text = joined_row(heads, "| ", " | ", " |\n");
  text += joined_row(std::vector<std::string>(heads.size(), "---"), "| ", " | ", " |\n");
  for (const auto& row : comparison_rows(comparison)) text += joined_row(row, "| ", " | ", " |\n");
  for (const ComparedFlow& run : comparison.runs)
    if (!run.outcome.message.empty())
      text.append("\n")
          .append(upper_name(run.outcome.flow))
          .append(": ")
          .append(run.outcome.message.english())
          .append(".\n");
  return text;
}

std::string profile_csv(const FlowComparison& comparison) {
  std::string text = "flow,distance,H,H_sigma\n";
  for (std::size_t k = 0; k < comparison.profiles.size(); ++k)
    for (const ProfilePoint& p : comparison.profiles[k])
      text += joined_row({upper_name(comparison.runs[k].outcome.flow), format("%.17g", p.distance),
                          format("%.17g", p.H), p.H_sigma >= 0 ? format("%.17g", p.H_sigma) : ""},
                         "", ",", "\n");
  return text;
}

}  // namespace loopmend
