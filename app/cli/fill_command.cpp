// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "exit_codes.h"
#include "fill_summary.h"
#include "interrupt.h"
#include "open_model.h"
#include "outputs.h"
#include "report.h"
#include "verdict.h"

#include "core/path_text.h"
#include "core/seconds_since.h"
#include "core/single_precision.h"
#include "core/system_memory.h"
#include "core/version.h"
#include "io/atomic_file.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <utility>

namespace loopmend {

namespace {

/// What was done, and how often; empty: nothing.
std::string words_of(const RepairCounts& counts) {
  std::string words;
  const auto add = [&words](std::size_t count, const char* one, const char* many) {
    if (count > 0) words += (words.empty() ? "" : ", ") + counted(count, one, many);
  };
  add(counts.degenerate_faces, "degenerate face removed", "degenerate faces removed");
  add(counts.duplicate_faces, "duplicate face removed", "duplicate faces removed");
  add(counts.intersecting_faces, "intersecting face removed", "intersecting faces removed");
  add(counts.separated_edges, "edge separated", "edges separated");
  add(counts.separated_vertices, "vertex separated", "vertices separated");
  add(counts.turned_faces, "face turned", "faces turned");
  if (counts.turned_shells > 0)
    words += " (" + counted(counts.turned_shells, "body", "bodies or cavities") + " inside out)";
  if (counts.united.bodies > 0) {
    add(counts.united.bodies, "body united", "bodies united");
    words += " into " + std::to_string(counts.united.made) + " (" +
             counted(counts.united.removed_faces, "face", "faces") + " removed or divided, " +
             counted(counts.united.new_faces, "part", "parts") + " of them made)";
  }
  add(counts.cut_handles, "tiny handle cut open", "tiny handles cut open");
  if (counts.cut_handles > 0) words += " (" + counted(counts.handle_faces, "face", "faces") + ")";
  add(counts.removed_pieces, "fragment removed", "fragments removed");
  if (counts.removed_pieces > 0) words += " (" + counted(counts.removed_faces, "face", "faces") + ")";
  return words;
}

/// Bodies that overlap still, and the next thing to do.
void print_left_bodies(std::FILE* out, const RepairCounts& counts) {
  if (counts.overlapping_bodies > 0)
    std::fprintf(out, "%s others and stay whole: --union makes one of those that are closed.\n",
                 counted(counts.overlapping_bodies, "body overlaps", "bodies overlap").c_str());
  if (counts.united.open_pieces > 0)
    std::fprintf(out, "%s left as they are: fill their holes, then use --union on what was written.\n",
                 counted(counts.united.open_pieces,
                         "open piece of surface crosses others, holds a body or lies in one; such pieces are",
                         "open pieces of surface cross others, hold a body or lie in one and are")
                     .c_str());
  if (counts.united.crossing > 0)
    std::fprintf(out, "%s left as they are: use --cut-intersections, then --union on what was written.\n",
                 counted(counts.united.crossing,
                         "closed body crosses itself, and crosses others, holds one or lies in one; such bodies are",
                         "closed bodies cross themselves, and cross others, hold one or lie in one; they are")
                     .c_str());
  if (counts.united.touching > 0)
    std::fprintf(out,
                 "%s at single points or edges alone and stay apart: around both there is no manifold. Move one "
                 "into the other, then use --union again.\n",
                 counted(counts.united.touching, "pair of bodies touches", "pairs of bodies touch").c_str());
  if (counts.united.refused > 0)
    std::fprintf(
        out,
        "%s left as they are: they touch themselves, or each other within rounding, have faces without area, or no "
        "manifold is around both. Move or part them, then use --union again.\n",
        counted(counts.united.refused, "pair of bodies overlaps; both are", "pairs of bodies overlap; all are")
            .c_str());
  if (counts.united.crossing_parts > 0)
    std::fprintf(
        out, "%s by the rounding of their corners; the body is closed.\n",
        counted(counts.united.crossing_parts, "pair of new faces crosses", "pairs of new faces cross").c_str());
}

void print_cut(std::FILE* out, const PlaneCutCounts& cut) {
  std::fprintf(out, "Cut by the plane: %s removed, %s divided",
               counted(cut.removed_faces, "face was", "faces were").c_str(),
               counted(cut.divided_faces, "face was", "faces were").c_str());
  if (cut.closed > 0)
    std::fprintf(out, "; %s closed by %s",
                 counted(cut.closed, "curve of the section was", "curves of the section were").c_str(),
                 counted(cut.new_faces, "plane face", "plane faces").c_str());
  if (cut.left_open > 0)
    std::fprintf(out, "; %s left open, as part of a boundary",
                 counted(cut.left_open, "curve is", "curves are").c_str());
  std::fprintf(out, "; the output is compared with the mesh after that.\n");
}

void print_preparation(std::FILE* out, const Preparation& done) {
  if (done.no_data_faces == 0U)
    std::fprintf(out, "No vertex marks missing data: --cut-no-data removed nothing.\n");
  else if (done.no_data_faces)
    std::fprintf(out, "%s removed at %s of missing data (%g); the output is compared with the mesh without them.\n",
                 counted(*done.no_data_faces, "face was", "faces were").c_str(),
                 counted(done.no_data.vertices.size(), "vertex", "vertices").c_str(), done.no_data.value);
  else
    print_no_data(out, done.no_data);
  if (done.sides_turned > 0) std::fprintf(out, "All %zu faces were turned round.\n", done.sides_turned);
  if (done.tiles.removed_faces > 0)
    std::fprintf(out,
                 "Tiles that overlap: %s removed where a larger part lies, and %s laid across the gaps; the output is "
                 "compared with the mesh after that.\n",
                 counted(done.tiles.removed_faces, "face was", "faces were").c_str(),
                 counted(done.tiles.bridges, "strip was", "strips were").c_str());
  if (done.tiles.open_gaps > 0)
    std::fprintf(out, "%s without a strip: each would cut the surface; --bridge A,B lays one between two vertices.\n",
                 counted(done.tiles.open_gaps, "gap is", "gaps are").c_str());
  if (done.tiles.removed_parts > 0)
    std::fprintf(out, "%s removed that lay wholly on a larger one: right for tiles, wrong for layers.\n",
                 counted(done.tiles.removed_parts, "part was", "parts were").c_str());
  if (done.stitched)
    std::fprintf(out, "Stitched: %s joined to others, %s split; the output is compared with the stitched mesh.\n",
                 counted(done.stitched->joined_vertices, "vertex", "vertices").c_str(),
                 counted(done.stitched->split_faces, "face", "faces").c_str());
  if (done.bridges > 0)
    std::fprintf(out, "%zu %s laid across holes; the output is compared with the mesh that has them.\n", done.bridges,
                 done.bridges == 1 ? "strip was" : "strips were");
  if (done.cut) print_cut(out, *done.cut);
  if (done.base_loop > 0)
    std::fprintf(out, "A base closes loop %d; the output is compared with the mesh that has it.\n", done.base_loop);
  if (!done.repaired) return;
  const std::string repaired = words_of(*done.repaired);
  if (repaired.empty())
    std::fprintf(out, "Repair: nothing to do.\n");
  else
    std::fprintf(out, "Repaired: %s; the output is compared with the repaired mesh.\n", repaired.c_str());
  print_left_bodies(out, *done.repaired);
  if (done.joined_again > 0)
    std::fprintf(out, "Stitched again: %s that the repair had parted.\n",
                 counted(done.joined_again, "vertex was joined", "vertices were joined").c_str());
}

nlohmann::ordered_json preparation_json(const Preparation& done) {
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (done.sides_turned > 0) json["sides_turned"] = done.sides_turned;
  if (done.stitched)
    json["stitched"] = {{"joined_vertices", done.stitched->joined_vertices},
                        {"split_faces", done.stitched->split_faces},
                        {"removed_faces", done.stitched->removed_faces}};
  if (done.tiles.removed_faces > 0)
    json["joined_tiles"] = {{"removed_faces", done.tiles.removed_faces},
                            {"removed_parts", done.tiles.removed_parts},
                            {"strips", done.tiles.bridges},
                            {"open_gaps", done.tiles.open_gaps}};
  if (done.repaired)
    json["repaired"] = {
        {"separated_edges", done.repaired->separated_edges}, {"separated_vertices", done.repaired->separated_vertices},
        {"turned_faces", done.repaired->turned_faces},       {"degenerate_faces", done.repaired->degenerate_faces},
        {"duplicate_faces", done.repaired->duplicate_faces}, {"intersecting_faces", done.repaired->intersecting_faces},
        {"cut_handles", done.repaired->cut_handles},         {"handle_faces", done.repaired->handle_faces},
        {"removed_pieces", done.repaired->removed_pieces},   {"removed_faces", done.repaired->removed_faces}};
  if (done.repaired) {
    json["repaired"]["turned_shells"] = done.repaired->turned_shells;
    json["repaired"]["overlapping_bodies"] = done.repaired->overlapping_bodies;
    const UnionCounts& united = done.repaired->united;
    json["repaired"]["union"] = {{"bodies", united.bodies},
                                 {"made", united.made},
                                 {"removed_faces", united.removed_faces},
                                 {"new_faces", united.new_faces},
                                 {"open_pieces", united.open_pieces},
                                 {"crossing_bodies", united.crossing},
                                 {"touching_pairs", united.touching},
                                 {"refused_pairs", united.refused},
                                 {"crossing_parts", united.crossing_parts}};
  }
  if (done.no_data_faces) json["no_data_faces"] = *done.no_data_faces;
  if (done.joined_again > 0) json["joined_again"] = done.joined_again;
  if (done.bridges > 0) json["bridges"] = done.bridges;
  if (done.cut)
    json["plane_cut"] = {{"removed_faces", done.cut->removed_faces},
                         {"divided_faces", done.cut->divided_faces},
                         {"closed_curves", done.cut->closed},
                         {"open_curves", done.cut->left_open},
                         {"new_faces", done.cut->new_faces}};
  if (done.base_loop > 0) json["base_loop"] = done.base_loop;
  return json;
}

/// Fills the chosen loops, and shows how far it has come.
std::vector<HoleResult> fill_and_show(ScanPlan& scan, const FillCommand& command, const Deadline& deadline,
                                      const CancelToken& cancel) {
  ProgressLine progress(command.verbosity);
  if (const std::size_t count = scan.chosen().size(); count > 0)
    progress.say("filling " + counted(count, "loop", "loops"));
  const auto show = [&](const FillProgress& p) {
    progress.show(p.loops_done, p.loops_total, p.loops_total == 1 ? "loop" : "loops");
  };
  return fill_chosen(scan, command.job, deadline, show, cancel);
}

nlohmann::ordered_json faces_json(const std::vector<BadBoundaryFace>& faces) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const BadBoundaryFace& bad : faces)
    json.push_back({{"face", bad.face}, {"fault", to_string(bad.fault)}, {"ring", bad.ring}});
  return json;
}

/// Empty where every patch is good, and where trimming cures nothing.
std::string trim_suggestion(const FillCommand& command, const ScanPlan& scan, const Outcome& outcome) {
  if (scan.trimmable.empty() || command.job.prepare.trim_rounds > 0) return {};
  if (outcome.look + outcome.bad + outcome.failed == 0) return {};
  if (scan.trimming_helps == ScanPlan::TrimmingHelps::no) return {};
  return counted(scan.trimmable.size(), "bad triangle", "bad triangles") +
         " at the boundaries; --trim-boundary 3 would remove these" +
         (scan.trimming_helps == ScanPlan::TrimmingHelps::yes ? "." : " (not tried).");
}

nlohmann::ordered_json fill_report(const FillCommand& command, const ImportReport& import, const ScanPlan& scan,
                                   const std::vector<HoleResult>& results) {
  nlohmann::ordered_json json;
  json["schema_version"] = report_schema_version;
  json["version"] = version();
  json["command_line"] = command.command_line;
  json["input"] = input_json(command.input, import, scan.done.before);
  json["prepared"] = preparation_json(scan.done);
  json["trimmed_faces"] = faces_json(scan.trimmed);
  json["bad_boundary_faces"] = faces_json(scan.bad_faces);
  json["loops"] = nlohmann::ordered_json::array();
  const std::size_t in_full = command.detail == Detail::all ? results.size() : most_loops_in_report;
  for (std::size_t k = 0; k < results.size(); ++k)
    json["loops"].push_back(k < in_full ? loop_json(results[k]) : brief_loop_json(results[k]));
  return json;
}

nlohmann::ordered_json output_json(const FillCommand& command, const WrittenScan& written, const OutputLosses& losses) {
  nlohmann::ordered_json json = losses_json(losses);
  json["content"] = command.content == FillCommand::Content::patches ? "patches" : "surface";
  json["beside"] = nlohmann::ordered_json::array();
  for (const std::filesystem::path& file : written.beside) json["beside"].push_back(path_text(file));
  json["painted_triangles"] = written.painted;
  json["remarks"] = nlohmann::ordered_json::array();
  for (const Message& remark : written.remarks) json["remarks"].push_back(remark.english());
  return json;
}

void print_beside(std::FILE* out, const WrittenScan& written) {
  if (written.painted > 0)
    std::fprintf(out, "A picture was painted for %s of the patches.\n",
                 counted(written.painted, "triangle", "triangles").c_str());
  std::string names;
  for (const std::filesystem::path& file : written.beside)
    names += (names.empty() ? "" : ", ") + path_text(file.filename());
  if (!names.empty()) std::fprintf(out, "Beside it: %s.\n", names.c_str());
  for (const Message& remark : written.remarks) std::fprintf(out, "%s\n", remark.english().c_str());
}

/// What was done to the scan before it was filled.
void print_changes(std::FILE* out, const FillCommand& command, const ImportReport& import, const ScanPlan& scan) {
  if (command.coincident == CoincidentVertices::weld)
    std::fprintf(out, "%s welded; the output is compared with the welded mesh.\n",
                 counted(import.vertices_welded, "vertex was", "vertices were").c_str());
  if (import.near_vertices_joined > 0)
    std::fprintf(out, "%s joined to others up to %.2g away along cracks no wider than rounding.\n",
                 counted(import.near_vertices_joined, "vertex was", "vertices were").c_str(), import.largest_join);
  if (import.vertices_joined > 0)
    std::fprintf(out, "%s joined to others in the same place, where only these touch.\n",
                 counted(import.vertices_joined, "boundary vertex was", "boundary vertices were").c_str());
  print_preparation(out, scan.done);
  print_inverted(out, scan.inverted, "");
  print_tiles(out, scan.tiles, "");
  if (const std::size_t turned = scan.turned_faces(); turned > 0)
    std::fprintf(out, "%s turned round to agree with the neighbours.\n",
                 counted(turned, "face was", "faces were").c_str());
  if (scan.spared_pieces > 0)
    std::fprintf(out, "%s not trimmed: more than a fifth of the triangles or a tenth of the area would have gone.\n",
                 counted(scan.spared_pieces, "piece of surface was", "pieces of surface were").c_str());
  if (!scan.trimmed.empty() && command.job.prepare.trim_rounds == 0)
    std::fprintf(out, "%s removed where a boundary ran through the surface.\n",
                 counted(scan.trimmed.size(), "triangle was", "triangles were").c_str());
  else if (!scan.trimmed.empty())
    std::fprintf(out, "%s removed at the boundaries.\n",
                 counted(scan.trimmed.size(), "bad triangle was", "bad triangles were").c_str());
}

/// The first reason, where there is one.
std::string why_open(const std::vector<HoleResult>& results) {
  for (const HoleResult& result : results)
    if (!result.message.empty())
      return " (loop " + std::to_string(result.loop.number) + ": " + result.message.english() + ")";
  return "";
}

}  // namespace

int run_fill(const FillCommand& command) {
  const auto start = std::chrono::steady_clock::now();
  CommandFiles()
      .reads("the input", command.input)
      .writes(NamedFile::Kind::mesh, "-o", command.output)
      .writes_report("--report", command.report)
      .check();
  ImportedMesh opened = read_mesh(command.input, command.coincident, command.float_text);
  SoupRecord as_read = record_of(opened.soup);
  SurfaceModel model = model_of(command.input, std::move(opened.soup),
                                needs_whole_view(command.job) ? View::whole : View::filling, std::move(opened.survey));
  const double read_at = seconds_since(start);
  const CancelToken cancel;
  if (command.when_stopped == FillCommand::WhenStopped::keep_finished) cancel_on_interrupt(cancel);
  const Deadline deadline(start, command.max_seconds, cancel);
  ScanPlan scan = plan_scan(std::move(as_read), std::move(model), command.job, cancel);
  TriangleSoup& soup = scan.model.soup;
  const double planned_at = seconds_since(start);
  const std::vector<HoleResult> results = fill_and_show(scan, command, deadline, cancel);
  const double filled_at = seconds_since(start);
  const bool stopped = cancel.cancelled();
  Outcome outcome = outcome_of(results, scan.choices);
  if (scan.done.repaired) outcome.apart = scan.done.repaired->united.left();
  WriteScanOptions options = command.write;
  if (command.deviations == FillCommand::Deviations::written) options.expected_deviation = expected_deviations(results);
  std::size_t exterior = scan.given.points;
  if (command.content == FillCommand::Content::patches) {
    if (outcome.filled == 0) {
      std::fprintf(stderr, "loopmend: no loop was filled, so there are no patches and %s was not written%s.\n",
                   path_text(command.output).c_str(), why_open(results).c_str());
      return interrupt_exit_code() != 0 ? interrupt_exit_code() : exit_loops_failed;
    }
    options.written.assign(scan.given.triangles, 0);
    options.written.resize(soup.triangles.size(), 1);
    exterior = 0;
  }
  OutputTransaction outputs;
  const WrittenScan written = write_scan(outputs, command.output, soup, options);
  const OutputLosses losses = losses_of(command.output, soup, command.write.encoding, opened.report.not_kept, exterior);
  std::optional<Watertightness> verdict;
  if (command.check == Check::printable) {
    TriangleSoup as_written = soup;
    if (holds_floats(command.output, soup, command.write.encoding)) round_to_floats(as_written.points);
    verdict = watertightness(as_written);
  }

  const double seconds = seconds_since(start);
  const std::string suggestion = trim_suggestion(command, scan, outcome);
  nlohmann::ordered_json json;
  if (!command.report.empty()) {
    json = fill_report(command, opened.report, scan, results);
    if (!suggestion.empty()) json["suggestion"] = suggestion;
    json["exterior_unchanged"] = losses.largest_exterior_rounding == 0;  // the model's is: that was compared above
    json["output"] = output_json(command, written, losses);
    if (verdict) json["check"] = verdict_json(*verdict);
    json["stopped"] = stopped;
    json["peak_memory_mb"] = peak_memory_of_process() / (1 << 20);
    json["stage_seconds"] = {{"reading", read_at},
                             {"planning", planned_at - read_at},
                             {"filling", filled_at - planned_at},
                             {"writing", seconds - filled_at}};
    json["total_seconds"] = seconds;
  }
  commit_with_report(outputs, command.report, json);
  if (command.verbosity == Verbosity::normal) {
    std::FILE* out = command.report == "-" ? stderr : stdout;
    print_changes(out, command, opened.report, scan);
    if (scan.loops.empty())
      std::fprintf(out, "The surface is closed: there is nothing to fill. %s was written.\n",
                   path_text(command.output).c_str());
    else
      print_summary(out, results, outcome, command, seconds);
    if (!suggestion.empty()) std::fprintf(out, "%s\n", suggestion.c_str());
    if (verdict) print_verdict(out, *verdict);
    print_losses(out, command.output, losses);
    print_beside(out, written);
    print_import_losses(out, opened.report);
    if (const std::size_t degenerate = scan.model.repairs.degenerate_faces; degenerate > 0)
      std::fprintf(
          out, "%s; fill --repair removes such faces.\n",
          counted(degenerate, "face has a vertex twice and stays", "faces have a vertex twice and stay").c_str());
    if (!scan.coincident.closing.empty()) print_coincident(out, opened.report, scan.loops);
    if (outcome.open_cuts > 0 && !outcome.in_vain() && command.job.prepare.extent == PrepareOptions::Extent::as_asked)
      std::fprintf(
          out, "%s left open: fill again with --auto.\n",
          counted(outcome.open_cuts, "loop that looks like a hole runs along edges of more than two faces and is",
                  "loops that look like holes run along edges of more than two faces and are")
              .c_str());
    if (outcome.in_vain()) print_cure(out, scan, outcome.wide_cracks);
  }
  if (const int stopped_with = interrupt_exit_code(); stopped && stopped_with != 0) return stopped_with;
  return outcome.exit_code();
}

}  // namespace loopmend
