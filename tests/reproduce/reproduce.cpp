// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the experiments of the paper and writes a report: index.html and report.md with every claim, picture and number,
// Table 5.1 beside ours, and the meshes.
#include "analysis/curvature_field.h"
#include "cli/outputs.h"
#include "cli/paper/comparison_files.h"
#include "cli/progress_line.h"
#include "core/path_text.h"
#include "core/seconds_since.h"
#include "core/version.h"
#include "exit_codes.h"
#include "io/write_mesh.h"
#include "paper_figures.h"
#include "scene/offscreen_render.h"
#include "scene/surface_shape.h"
#include "usage_error.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <chrono>
#include <cstdio>

namespace loopmend {

namespace {

struct ReproduceCommand {
  std::vector<std::string> figures;  ///< "all", "fig5.1a", ...
  std::filesystem::path output;      ///< folder
  bool quiet = false;
};

/// What stays of a run once its files are written.
struct Entry {
  FigureRun run;  ///< without its surfaces
  double seconds = 0;
};

double color_range(const SurfaceModel& model) {
  const auto field = curvature_field(model.mesh).H;
  const std::vector<float> H(field.begin(), field.end());
  return symmetric_range(H);
}

void write_figure(OutputTransaction& outputs, FigureRun& run, const std::filesystem::path& folder) {
  write_mesh(outputs, folder / (run.id + "-input.ply"), run.before.soup);
  write_mesh(outputs, folder / (run.id + "-initial.ply"), run.initial.soup);
  write_mesh(outputs, folder / (run.id + "-result.ply"), run.after.soup);
  RenderOptions options;
  options.height = 620;
  options.h_range = color_range(run.after);
  options.eye = run.eye;
  Panel input{&run.before, "Input"};
  if (run.look == FigureRun::Look::polyhedron) {
    input.shading = Shading::plain;
    input.edges = Edges::shown;
  }
  std::vector<Panel> panels{input, {&run.initial, run.initial_caption}};
  if (run.between) {
    write_mesh(outputs, folder / (run.id + "-between.ply"), run.between->soup);
    panels.push_back({&*run.between, run.between_caption});
  }
  panels.push_back({&run.after, "Result"});
  options.width = static_cast<int>(600 * panels.size());
  add_text(outputs, folder / (run.id + ".png"), render_panels(panels, static_cast<int>(panels.size()), options));
  if (run.comparison) {
    outputs.add_folder(folder / run.id);
    write_comparison(outputs, {run.start, run.surface}, *run.comparison, run.id + ": " + run.title, folder / run.id,
                     run.eye);
  }
  run.before = run.initial = run.after = {};
  run.between.reset();
}

std::string table_html(const std::vector<Entry>& entries) {
  std::string html =
      "<table><tr><th rowspan='2'>example</th><th colspan='2'>unknowns</th><th colspan='2'>time step &tau;</th><th "
      "rowspan='2'>our &sigma;</th><th colspan='2'>form, s</th><th colspan='2'>steps</th><th colspan='2'>solve, "
      "s</th></tr><tr>";
  for (int k = 0; k < 5; ++k) html += "<th>paper</th><th>ours</th>";
  html += "</tr>\n";
  for (const Entry& entry : entries) {
    if (!entry.run.paper || !entry.run.ours) continue;
    const TableRow &paper = *entry.run.paper, &ours = *entry.run.ours;
    html += "<tr><td>" + entry.run.id + "</td><td>" + std::to_string(paper.unknowns) + "</td><td>" +
            std::to_string(ours.unknowns) + "</td><td>" + number_text("%g", paper.tau) + "</td><td>" +
            number_text("%.2g", ours.tau) + "</td><td>" + number_text("%g", entry.run.sigma) + "</td><td>" +
            number_text("%.2f", paper.form) + "</td><td>" + number_text("%.3f", ours.form) + "</td><td>" +
            std::to_string(paper.steps) + "</td><td>" + std::to_string(ours.steps) + "</td><td>" +
            number_text("%.2f", paper.solve) + "</td><td>" + number_text("%.3f", ours.solve) + "</td></tr>\n";
  }
  return html + "</table>\n";
}

const std::string profile_note =
    "Jumps in the pictures are those of wide fits. In the section, the steep parts of MCF, SDF and WF behind the seam "
    "are "
    "one or two triangles wide, whatever their size: the discrete curvatures reach across the seam, and smear a jump "
    "over "
    "them. What is left of MMCVF's own jump shrinks with the edges.";

std::string figure_html(const Entry& entry) {
  const FigureRun& run = entry.run;
  const char* mark = run.verdict == Reproduction::reproduced ? "yes"
                     : run.verdict == Reproduction::partly   ? "partly"
                                                             : "no";
  std::string html = "<h2 id='" + run.id + "'>" + run.id + ": " + run.title + "</h2>\n<p>The paper: <q>" + run.claim +
                     "</q></p>\n<p><b class='" + mark + "'>" + to_string(run.verdict) + "</b>. " + run.why +
                     "</p>\n<img src='" + run.id + ".png' alt='" + run.title + ": input, start, result'>\n";
  if (run.comparison)
    html += "<img src='" + run.id + "/compare.png' alt='Four flows'>\n<img src='" + run.id +
            "/profile.svg' alt='H across the seam'>\n<p>" + profile_note +
            "</p>\n<p>Energies and seam figures: <a href='" + run.id + "/table.md'>table.md</a>, <a href='" + run.id +
            "/table.csv'>table.csv</a>, <a href='" + run.id + "/profile.csv'>profile.csv</a></p>\n";
  html += "<table>\n";
  for (const auto& [name, value] : run.numbers) html += "<tr><td>" + name + "</td><td>" + value + "</td></tr>\n";
  return html + "<tr><td>seconds for all of this figure</td><td>" + number_text("%.1f", entry.seconds) +
         "</td></tr>\n</table>\n";
}

std::string overview_html(const std::vector<Entry>& entries) {
  std::string html = "<table><tr><th>figure</th><th>the paper's claim</th><th>verdict</th></tr>\n";
  for (const Entry& entry : entries) {
    const FigureRun& run = entry.run;
    html += "<tr><td><a href='#" + run.id + "'>" + run.id + "</a></td><td>" + run.claim + "</td><td>" +
            to_string(run.verdict) + "</td></tr>\n";
  }
  return html + "</table>\n";
}

const char* table_note =
    "The paper's time step has no stated unit; ours is &tau; = &sigma;/&lambda;<sub>1</sub> with &lambda;<sub>1</sub> "
    "the "
    "slowest decay rate of the patch, printed in units of our meshes (length<sup>6</sup>). Times are those of one "
    "step, "
    "ours on this machine, with the operators' fits counted as forming.";

std::string page(const std::vector<Entry>& entries) {
  std::string html =
      "<!doctype html>\n<html lang='en'><head><meta charset='utf-8'><title>The paper reproduced</title>\n<style>body{"
      "font:16px/1.5 sans-serif;max-width:62rem;margin:2rem auto;padding:0 1rem;color:#222}img{max-width:100%}"
      "table{border-collapse:collapse;margin:1rem 0}td,th{border:1px solid #ccc;padding:.25rem .6rem;text-align:left}"
      ".yes{color:#006b4f}.partly{color:#9a5b00}.no{color:#b00020}</style></head><body>\n"
      "<h1>Minimal mean-curvature-variation surfaces, reproduced</h1>\n<p>Xu and Zhang, section 5, run by loopmend ";
  html += std::string(version()) + ". Inputs, pictures and numbers are made by one command.</p>\n";
  html += overview_html(entries);
  html += "<h2>Table 5.1</h2>\n<p>" + std::string(table_note) + "</p>\n" + table_html(entries);
  for (const Entry& entry : entries) html += figure_html(entry);
  return html + "</body></html>\n";
}

/// Entities that the texts use, as characters: Markdown readers show both, plain eyes only these.
std::string plain(std::string words) {
  static const std::vector<std::pair<std::string, std::string>> entities{
      {"&int;", "∫"},   {"&nabla;", "∇"},  {"&sup2;", "²"},       {"&rarr;", "→"},      {"&deg;", "°"},
      {"&times;", "×"}, {"&minus;", "−"},  {"&frac12;", "½"},     {"&gt;", ">"},        {"&tau;", "τ"},
      {"&sigma;", "σ"}, {"&lambda;", "λ"}, {"<sub>1</sub>", "₁"}, {"<sup>6</sup>", "⁶"}};
  for (const auto& [entity, character] : entities)
    for (std::size_t at = 0; (at = words.find(entity, at)) != std::string::npos;)
      words.replace(at, entity.size(), character);
  return words;
}

std::string markdown(const std::vector<Entry>& entries) {
  std::string md =
      "# Minimal mean-curvature-variation surfaces, reproduced\n\n| figure | claim | verdict |\n|---|---|---|\n";
  for (const Entry& e : entries)
    md += "| " + e.run.id + " | " + e.run.claim + " | " + to_string(e.run.verdict) + " |\n";
  md += "\n## Table 5.1 (paper / ours)\n\n" + std::string(table_note) +
        "\n\n| example | unknowns | tau | our sigma | form, s | steps | solve, s |\n|---|---|---|---|---|---|---|\n";
  for (const Entry& e : entries) {
    if (!e.run.paper || !e.run.ours) continue;
    const TableRow &p = *e.run.paper, &o = *e.run.ours;
    md += "| " + e.run.id + " | " + std::to_string(p.unknowns) + " / " + std::to_string(o.unknowns) + " | " +
          number_text("%g", p.tau) + " / " + number_text("%.2g", o.tau) + " | " + number_text("%g", e.run.sigma) +
          " | " + number_text("%.2f", p.form) + " / " + number_text("%.3f", o.form) + " | " + std::to_string(p.steps) +
          " / " + std::to_string(o.steps) + " | " + number_text("%.2f", p.solve) + " / " +
          number_text("%.3f", o.solve) + " |\n";
  }
  for (const Entry& e : entries) {
    md += "\n## " + e.run.id + ": " + e.run.title + "\n\n> " + e.run.claim + "\n\n**" + to_string(e.run.verdict) +
          "**. " + e.run.why + "\n\n![" + e.run.title + "](" + e.run.id + ".png)\n\n";
    if (e.run.comparison)
      md += "![Four flows](" + e.run.id + "/compare.png)\n\n![H across the seam](" + e.run.id + "/profile.svg)\n\n" +
            profile_note + "\n\nEnergies and seam figures: [table.md](" + e.run.id + "/table.md)\n\n";
    for (const auto& [name, value] : e.run.numbers) md += "- " + name + ": " + value + "\n";
  }
  return plain(md);
}

std::vector<std::string> chosen_figures(const std::vector<std::string>& words) {
  const std::vector<std::string> all = paper_figure_ids();
  std::vector<std::string> chosen;
  for (const std::string& word : words) {
    if (word == "all") return all;
    if (std::find(all.begin(), all.end(), word) == all.end()) {
      std::string list;
      for (const std::string& id : all) list += ", " + id;
      throw UsageError("there is no figure '" + word + "': name all" + list);
    }
    chosen.push_back(word);
  }
  return chosen;
}

int run_reproduce(const ReproduceCommand& command) {
  const auto begin = std::chrono::steady_clock::now();
  const std::vector<std::string> figures = chosen_figures(command.figures);
  OutputTransaction outputs;
  outputs.add_folder(command.output);
  CommandFiles()
      .writes(NamedFile::Kind::other, "the file", command.output / "index.html")
      .writes(NamedFile::Kind::other, "the file", command.output / "report.md")
      .check();
  ProgressLine progress(command.quiet ? Verbosity::quiet : Verbosity::normal);
  std::vector<Entry> entries;
  for (const std::string& id : figures) {
    const auto start = std::chrono::steady_clock::now();
    progress.say(id);
    Entry entry{run_paper_figure(id), 0};
    write_figure(outputs, entry.run, command.output);
    entry.seconds = seconds_since(start);
    entries.push_back(std::move(entry));
  }
  add_text(outputs, command.output / "index.html", page(entries));
  add_text(outputs, command.output / "report.md", markdown(entries));
  outputs.commit();
  const double seconds = seconds_since(begin);
  if (!command.quiet) {
    for (const Entry& entry : entries)
      std::printf("%-8s  %-18s  %s\n", entry.run.id.c_str(), to_string(entry.run.verdict), entry.run.title.c_str());
    std::printf("%s written in %.1f s\n", path_text(command.output / "index.html").c_str(), seconds);
  }
  return exit_done;
}

}  // namespace
}  // namespace loopmend

int main(int argc, char** argv) {
  loopmend::ReproduceCommand command;
  CLI::App app("Run the experiments of the paper and write a report");
  app.add_option("FIGURE", command.figures,
                 "all, or fig5.1a fig5.1d fig5.2a fig5.2d fig5.2g fig5.3 fig5.4 fig5.5 fig5.6 table5.1")
      ->required();
  app.add_option("-o,--output", command.output, "Folder to write to; made if need be")->type_name("DIR")->required();
  app.add_flag("--quiet", command.quiet, "No progress and no summary");
  CLI11_PARSE(app, argc, argv);
  try {
    return loopmend::run_reproduce(command);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "loopmend_reproduce: %s\n", error.what());
    return dynamic_cast<const loopmend::UsageError*>(&error) ? loopmend::exit_usage : loopmend::exit_internal;
  }
}
