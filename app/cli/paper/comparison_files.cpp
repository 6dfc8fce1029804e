// SPDX-License-Identifier: GPL-3.0-or-later
#include "comparison_files.h"

#include "cli/outputs.h"
#include "line_plot.h"
#include "problems/comparison_table.h"

#include "analysis/curvature_field.h"
#include "flows/flow_terms.h"
#include "io/atomic_file.h"
#include "io/write_mesh.h"
#include "pipeline/continue_attributes.h"
#include "scene/offscreen_render.h"
#include "scene/surface_shape.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace loopmend {

namespace {

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

LinePlot profile_plot(const FlowComparison& comparison, const std::string& title) {
  LinePlot plot{
      title, "distance from the seam (neighborhood left, patch right)", "mean curvature H, one-sided", {}, {}};
  double low = 1e300, high = -1e300;
  for (std::size_t k = 0; k < comparison.profiles.size(); ++k) {
    PlotLine line{upper_name(comparison.runs[k].outcome.flow), {}};
    for (const ProfilePoint& p : comparison.profiles[k]) {
      line.points.emplace_back(p.distance, p.H);
      if (comparison.runs[k].outcome.flow == FlowKind::mcf || !std::isfinite(p.H)) continue;
      low = std::min(low, p.H);
      high = std::max(high, p.H);
    }
    plot.lines.push_back(std::move(line));
  }
  if (low < high) plot.y_limits = {low - 0.25 * (high - low), high + 0.25 * (high - low)};
  return plot;
}

}  // namespace

std::vector<std::filesystem::path> comparison_files(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const char* name : {"start.ply", "mcf.ply", "sdf.ply", "wf.ply", "mmcvf.ply", "compare.png", "profile.csv",
                           "profile.svg", "table.csv", "table.md"})
    files.push_back(folder / name);
  return files;
}

void write_comparison(OutputTransaction& outputs, const Problem& problem, const FlowComparison& comparison,
                      const std::string& title, const std::filesystem::path& folder, const std::optional<Vec3>& eye) {
  TriangleSoup start = problem.surface(problem.start);
  continue_attributes(start);
  write_mesh(outputs, folder / "start.ply", start);
  std::vector<SurfaceModel> models;
  for (const ComparedFlow& run : comparison.runs) {
    TriangleSoup soup = problem.surface(run.outcome.patch);
    continue_attributes(soup);
    write_mesh(outputs, folder / (std::string(to_string(run.outcome.flow)) + ".ply"), soup);
    models.push_back(make_surface_model(std::move(soup)));
  }
  std::vector<Panel> panels;
  for (std::size_t k = 0; k < models.size(); ++k) {
    const ComparedFlow& run = comparison.runs[k];
    panels.push_back({&models[k], upper_name(run.outcome.flow) + format(": jump of H %.2g", run.wide_jump)});
  }
  RenderOptions options;
  options.eye = eye;
  // The colours are those that suit MMCVF: MCF's extremes would leave the others pale.
  const auto field = curvature_field(models.back().mesh).H;
  std::vector<float> H(field.begin(), field.end());
  options.h_range = symmetric_range(H);
  add_text(outputs, folder / "compare.png", render_panels(panels, 2, options));
  add_text(outputs, folder / "profile.csv", profile_csv(comparison));
  add_text(outputs, folder / "profile.svg", to_svg(profile_plot(comparison, title)));
  add_text(outputs, folder / "table.csv", comparison_csv(comparison));
  add_text(outputs, folder / "table.md", comparison_table(comparison));
}

}  // namespace loopmend
