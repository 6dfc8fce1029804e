#include "comparison_files.h"

#include "cli/report.h"
#include "line_plot.h"

#include "analysis/curvature_field.h"
#include "flows/flow_terms.h"
#include "io/atomic_file.h"
#include "io/write_mesh.h"
#include "scene/offscreen_render.h"
#include "scene/surface_shape.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>

namespace loopmend {

namespace {

struct SeamFigures {
  double jump = 0, jump_times_diameter = 0, angle = 0;
};

/// Root mean square over the loops.
SeamFigures overall(const std::vector<SeamReport>& seams) {
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

std::string format(const char* pattern, double value) {
  char text[64];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

/// Name, status, steps, ∫‖∇H‖², ∫H², area, jump of H, times diameter, angle, folds, cuts.
std::vector<std::vector<std::string>> rows_of(const FlowComparison& comparison) {
  std::vector<std::vector<std::string>> rows;
  const auto add = [&](const std::string& name, const std::string& status, int steps, const PatchEnergies& energies,
                       const std::vector<SeamReport>& seams, double wide_jump, const FillerQuality& quality) {
    const SeamFigures seam = overall(seams);
    rows.push_back({name, status, std::to_string(steps), format("%.5g", energies.variation),
                    format("%.5g", energies.bending), format("%.5g", energies.area), format("%.4g", wide_jump),
                    format("%.4g", seam.jump), format("%.4g", seam.jump_times_diameter), format("%.4g", seam.angle),
                    std::to_string(quality.folds), std::to_string(quality.self_intersections)});
  };
  add("start", "", 0, comparison.start, comparison.start_seams, std::nan(""), {});
  for (const FlowRun& run : comparison.runs)
    add(upper_name(run.flow), to_string(run.evolved.status), run.evolved.steps, run.energies, run.seams, run.wide_jump,
        run.evolved.quality);
  return rows;
}

const std::vector<std::string> heads{"surface",         "status",     "steps",           "int |grad H|^2",
                                     "int H^2",         "area",       "jump of H, wide", "jump of H",
                                     "jump x diameter", "angle, deg", "folds",           "self-intersections"};

std::string joined_row(const std::vector<std::string>& cells, const char* before, const char* between,
                       const char* after) {
  std::string row = before;
  for (std::size_t k = 0; k < cells.size(); ++k) row += (k ? between : "") + cells[k];
  return row + after;
}

std::string csv_table(const FlowComparison& comparison) {
  std::string text = joined_row(heads, "", ",", "\n");
  for (const auto& row : rows_of(comparison)) text += joined_row(row, "", ",", "\n");
  return text;
}

std::string profile_csv(const FlowComparison& comparison) {
  std::string text = "flow,distance,H\n";
  for (std::size_t k = 0; k < comparison.profiles.size(); ++k)
    for (const ProfilePoint& p : comparison.profiles[k])
      text += upper_name(comparison.runs[k].flow) + format(",%.17g", p.distance) + format(",%.17g", p.H) + "\n";
  return text;
}

LinePlot profile_plot(const FlowComparison& comparison, const std::string& title) {
  LinePlot plot{
      title, "distance from the seam (surroundings left, patch right)", "mean curvature H, one-sided", {}, {}};
  double low = 1e300, high = -1e300;
  for (std::size_t k = 0; k < comparison.profiles.size(); ++k) {
    PlotLine line{upper_name(comparison.runs[k].flow), {}};
    for (const ProfilePoint& p : comparison.profiles[k]) {
      line.points.emplace_back(p.distance, p.H);
      if (comparison.runs[k].flow == FlowKind::mcf || !std::isfinite(p.H)) continue;
      low = std::min(low, p.H);
      high = std::max(high, p.H);
    }
    plot.lines.push_back(std::move(line));
  }
  if (low < high) plot.y_limits = {low - 0.25 * (high - low), high + 0.25 * (high - low)};
  return plot;
}

}  // namespace

std::string upper_name(FlowKind flow) {
  std::string name = to_string(flow);
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return std::toupper(c); });
  return name;
}

void write_text(const std::filesystem::path& path, const std::string& text) {
  write_file_atomically(path, [&](std::ostream& out) { out << text; });
}

std::string comparison_table(const FlowComparison& comparison) {
  std::string text = joined_row(heads, "| ", " | ", " |\n");
  text += joined_row(std::vector<std::string>(heads.size(), "---"), "| ", " | ", " |\n");
  for (const auto& row : rows_of(comparison)) text += joined_row(row, "| ", " | ", " |\n");
  return text;
}

nlohmann::ordered_json comparison_json(const FlowComparison& comparison) {
  nlohmann::ordered_json json;
  for (const FlowRun& run : comparison.runs) {
    nlohmann::ordered_json one = evolved_json(run.evolved);
    one["flow"] = to_string(run.flow);
    one["area"] = run.energies.area;
    one["bending_energy"] = run.energies.bending;
    one["variation_energy"] = run.energies.variation;
    const SeamFigures seam = overall(run.seams);
    one["h_jump_wide"] = run.wide_jump;
    one["h_jump_rms"] = std::isfinite(seam.jump) ? nlohmann::ordered_json(seam.jump) : nlohmann::ordered_json(nullptr);
    for (const SeamReport& report : run.seams) one["seams"].push_back(seam_json(report));
    json.push_back(std::move(one));
  }
  return json;
}

void write_comparison(const ComparisonStart& start, const FlowComparison& comparison, const std::string& title,
                      const std::filesystem::path& folder) {
  write_mesh(folder / "start.ply", start.surface(start.patch));
  std::vector<SurfaceModel> models;
  for (const FlowRun& run : comparison.runs) {
    TriangleSoup soup = start.surface(run.evolved.patch);
    write_mesh(folder / (std::string(to_string(run.flow)) + ".ply"), soup);
    models.push_back(make_surface_model(std::move(soup)));
  }
  std::vector<Panel> panels;
  for (std::size_t k = 0; k < models.size(); ++k) {
    const FlowRun& run = comparison.runs[k];
    panels.push_back({&models[k], upper_name(run.flow) + format(": jump of H %.3g", overall(run.seams).jump) +
                                      format(" (wide fits %.3g)", run.wide_jump)});
  }
  RenderOptions options;
  // The colours are those that suit MMCVF: MCF's extremes would leave the others pale.
  const auto field = curvature_field(models.back().mesh).H;
  std::vector<float> H(field.begin(), field.end());
  options.h_range = symmetric_range(H);
  render_panels(panels, 2, options, folder / "compare.png");
  write_text(folder / "profile.csv", profile_csv(comparison));
  write_text(folder / "profile.svg", to_svg(profile_plot(comparison, title)));
  write_text(folder / "table.csv", csv_table(comparison));
  write_text(folder / "table.md", comparison_table(comparison));
}

}  // namespace loopmend
