// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "exit_codes.h"
#include "interrupt.h"
#include "open_model.h"
#include "outputs.h"
#include "report.h"
#include "verdict.h"

#include "core/path_text.h"
#include "core/system_memory.h"
#include "core/version.h"
#include "io/atomic_file.h"
#include "pipeline/flat_cut.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <utility>

namespace loopmend {

namespace {

/// For people: three digits, none beyond two decimal places. "28.7", "0.05", "1230".
std::string short_number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.*f", std::abs(value) < 10 ? 2 : std::abs(value) < 100 ? 1 : 0, value);
  return text;
}

/// "28.7 -> 17.2", or a dash where the surface has too few vertices to measure it.
std::string before_and_after(double before, double after) {
  if (!std::isfinite(before) || !std::isfinite(after)) return "-";
  return short_number(before) + " -> " + short_number(after);
}

/// Mesh units; "-" without an estimate.
std::string likely_off(const ExpectedDeviation& deviation) {
  if (!deviation.is_known()) return "-";
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", deviation.likely);
  return text;
}

/// The text with … for each number: reasons that differ by a figure are one.
std::string without_numbers(const std::string& text) {
  std::string plain;
  bool in_number = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto is_digit = [&](std::size_t i) { return i < text.size() && text[i] >= '0' && text[i] <= '9'; };
    const bool number =
        is_digit(k) || (in_number && (text[k] == '.' || text[k] == 'e' || text[k] == '-') && is_digit(k + 1));
    if (!number) plain += text[k];
    if (number && !in_number) plain += "…";
    in_number = number;
  }
  return plain;
}

/// Each text once, with its loops. @param text_of  of one result; empty: there is none
void print_once(std::FILE* out, const std::vector<HoleResult>& results, Detail detail,
                std::string (*text_of)(const HoleResult&)) {
  constexpr std::size_t most_numbers = 12;
  std::map<std::string, std::vector<int>> loops_of;
  for (const HoleResult& r : results)
    if (const std::string text = text_of(r); !text.empty())
      loops_of[detail == Detail::all ? text : without_numbers(text)].push_back(r.loop.number);
  for (const auto& [text, numbers] : loops_of) {
    std::string list;
    for (std::size_t k = 0; k < std::min(numbers.size(), most_numbers); ++k)
      list += (k ? ", " : "") + std::to_string(numbers[k]);
    if (numbers.size() > most_numbers) list += " and " + std::to_string(numbers.size() - most_numbers) + " more";
    std::fprintf(out, "loop%s %s: %s.\n", numbers.size() == 1 ? "" : "s", list.c_str(), text.c_str());
  }
}

/// Why a loop is open, or what else there is to know of it.
std::string message_text(const HoleResult& r) { return r.message.english(); }

/// Why the flow was not run as asked.
std::string reason_text(const HoleResult& r) {
  return r.reason().empty() ? std::string() : r.method() + ": " + r.reason().english();
}

/// What became of the loops, in numbers.
struct Outcome {
  int filled = 0, failed = 0;
  int look = 0, bad = 0;    ///< verdicts of those filled
  int left = 0;             ///< as asked
  int unfinished = 0;       ///< when the command was stopped, or its time was over
  int wide_cracks = 0;      ///< left for --stitch
  int open_cuts = 0;        ///< loops along which the surface had to be cut, but which look like holes
  std::size_t apart = 0;    ///< bodies and pieces that --union left
  int no_hole = 0;          ///< cracks, and loops where the surface had to be cut: left without being asked for
  bool holes_left = false;  ///< some loop that could be filled was left as asked

  /// No loop could be filled.
  bool in_vain() const { return filled == 0 && failed == 0 && no_hole > 0 && !holes_left; }
  int exit_code() const {
    return failed + bad + unfinished + wide_cracks + open_cuts > 0 || apart > 0 || in_vain() ? exit_loops_failed
                                                                                             : exit_done;
  }
};

Outcome outcome_of(const std::vector<HoleResult>& results, const std::vector<LoopChoice>& choices) {
  Outcome outcome;
  for (std::size_t k = 0; k < results.size(); ++k) {
    outcome.filled += is_filled(results[k].status);
    outcome.failed += results[k].status == PatchStatus::failed;
    outcome.look += results[k].verdict().grade == Grade::look;
    outcome.bad += results[k].verdict().grade == Grade::bad;
    if (results[k].status != PatchStatus::skipped) continue;
    if (choices[k].fill) {
      ++outcome.unfinished;
      continue;
    }
    outcome.wide_cracks += choices[k].left == LoopChoice::Left::wide_crack;
    const BoundaryLoop& loop = results[k].loop;
    outcome.open_cuts += choices[k].left == LoopChoice::Left::no_hole && loop.kind == LoopKind::cut &&
                         is_shaped_like_a_hole(loop) && 2 * loop.coincident < loop.edges();
    const bool no_hole = choices[k].left != LoopChoice::Left::as_asked;
    ++(no_hole ? outcome.no_hole : outcome.left);
    outcome.holes_left = outcome.holes_left || (!no_hole && !choices[k].is_outer_rim);
  }
  return outcome;
}

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
    std::fprintf(out,
                 "%s left as they are: they touch themselves, have faces without area, or no manifold is around both. "
                 "Move or part them, then use --union again.\n",
                 counted(counts.united.refused, "pair of bodies overlaps; both are", "pairs of bodies overlap; all are")
                     .c_str());
  if (counts.united.crossing_parts > 0)
    std::fprintf(
        out, "%s by the rounding of their corners; the body is closed.\n",
        counted(counts.united.crossing_parts, "pair of new faces crosses", "pairs of new faces cross").c_str());
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
  if (done.stitched)
    std::fprintf(out, "Stitched: %s joined to others, %s split; the output is compared with the stitched mesh.\n",
                 counted(done.stitched->joined_vertices, "vertex", "vertices").c_str(),
                 counted(done.stitched->split_faces, "face", "faces").c_str());
  if (done.bridges > 0)
    std::fprintf(out, "%zu %s laid across holes; the output is compared with the mesh that has them.\n", done.bridges,
                 done.bridges == 1 ? "strip was" : "strips were");
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
  if (done.base_loop > 0) json["base_loop"] = done.base_loop;
  return json;
}

/// What would help where no loop is a hole.
void print_cure(std::FILE* out, const ScanPlan& scan, int wide_cracks) {
  const auto count = [&](LoopChoice::Cure cure) {
    return std::count_if(scan.choices.begin(), scan.choices.end(),
                         [&](const LoopChoice& choice) { return choice.cure == cure; });
  };
  const auto cut = count(LoopChoice::Cure::repair), split = count(LoopChoice::Cure::stitch);
  std::fprintf(out, "Nothing was filled: none of these loops is a hole as the mesh stands.");
  if (wide_cracks > 0)
    std::fprintf(out, " Gaps between sides that belong together: %d; fill again with the option named above.",
                 wide_cracks);
  if (split > 0) std::fprintf(out, " On another loop, or on themselves: %td; fill again with --stitch.", split);
  if (cut > 0)
    std::fprintf(out,
                 " Along edges of more than two faces, or where the surface is one-sided: %td; fill again with --auto.",
                 cut);
  std::fprintf(out, "\n");
}

/// What became of very many loops: how many there are for each outcome, and each thing that is said of them.
void print_counts(std::FILE* out, const std::vector<HoleResult>& results) {
  std::map<std::pair<std::string, std::string>, int> count;
  for (const HoleResult& result : results)
    ++count[{to_string(result.status), without_numbers(result.message.english())}];
  for (const auto& [what, loops] : count)
    std::fprintf(out, "%s %s%s%s\n", counted(loops, "loop", "loops").c_str(), what.first.c_str(),
                 what.second.empty() ? "" : ": ", what.second.c_str());
}

/// Whether the loop is nearly plane and its patch rises over it so that a person has to look: the surface may end there.
bool may_end_flat(const HoleResult& r) {
  constexpr double rises = 0.05;  // diameters
  const Verdict verdict = r.verdict();
  return is_filled(r.status) && verdict.grade == Grade::look && r.loop.planarity <= flat_planarity &&
         verdict.height > rises && std::ranges::any_of(verdict.findings, [](const Notice& finding) {
           return finding.code == NoticeCode::high_over_loop || finding.code == NoticeCode::likely_far;
         });
}

/// The option that closes such loops flat, and fills the others as they were.
void print_flat_caps(std::FILE* out, const std::vector<HoleResult>& results) {
  constexpr int most_in_an_option = 20;
  std::string ends, loops;
  int filled = 0, flat = 0;
  for (const HoleResult& r : results) {
    if (!is_filled(r.status)) continue;
    const std::string number = std::to_string(r.loop.number);
    const bool ends_flat = may_end_flat(r);
    if (ends_flat) ends += (flat++ == 0 ? "" : ", ") + number;
    loops += (filled++ == 0 ? "" : ",") + number + (ends_flat ? ":flat" : "");
  }
  if (flat > 0 && filled <= most_in_an_option)
    std::fprintf(out, "If the surface ends at %s %s, --loops %s closes %s flat.\n", flat == 1 ? "loop" : "loops",
                 ends.c_str(), loops.c_str(), flat == 1 ? "it" : "them");
}

/// One line for each loop when there are few, else for the largest; long texts below, once for each kind.
void print_summary(std::FILE* out, const std::vector<HoleResult>& results, const Outcome& outcome,
                   const FillCommand& command, double seconds) {
  const bool all = command.detail == Detail::all || results.size() <= most_loops_in_full;
  std::fprintf(out, "%5s  %6s  %6s  %-7s  %-10s  %-10s  %-16s  %18s  %20s\n", "loop", "edges", "new", "verdict",
               "likely off", "status", "method", "angle at seam, deg", "jump of H x diameter");
  for (std::size_t k = 0; k < (all ? results.size() : largest_loops); ++k) {
    const HoleResult& r = results[k];
    const Verdict verdict = r.verdict();
    const bool filled = is_filled(r.status);
    std::fprintf(out, filled ? "%5d  %6d  %6d  %-7s  %10s  %-10s" : "%5d  %6d  %6d  %-7s  %10s  %s", r.loop.number,
                 r.loop.edges(), r.free_vertices, filled ? to_string(verdict.grade) : "-",
                 likely_off(r.deviation()).c_str(), to_string(r.status));
    if (filled)
      std::fprintf(out, "  %-16s  %18s  %20s", r.method().c_str(),
                   before_and_after(r.seam_before().g1_rms_deg, r.seam_after().g1_rms_deg).c_str(),
                   before_and_after(r.seam_before().h_jump_rms_times_diameter, r.seam_after().h_jump_rms_times_diameter)
                       .c_str());
    const std::string remark = verdict.message().english();
    std::fprintf(out, "%s%s\n", remark.empty() ? "" : "  ", remark.c_str());
  }
  if (!all) {
    std::fprintf(out, "... and %zu smaller ones (all of them with --verbose or --report). In all:\n",
                 results.size() - largest_loops);
    print_counts(out, results);
  } else {
    print_once(out, results, Detail::all, message_text);
  }
  print_once(out, results, all ? Detail::all : Detail::summary, reason_text);
  print_flat_caps(out, results);
  std::fprintf(out, "%d filled, ", outcome.filled);
  if (outcome.look > 0) std::fprintf(out, "%d of them to look at, ", outcome.look);
  if (outcome.bad > 0) std::fprintf(out, "%d of them bad, ", outcome.bad);
  std::fprintf(out, "%d failed, %d left as asked", outcome.failed, outcome.left);
  if (outcome.unfinished > 0) std::fprintf(out, ", %d not finished", outcome.unfinished);
  if (outcome.no_hole > 0) std::fprintf(out, ", %d left because they are no holes", outcome.no_hole);
  std::fprintf(out, "; %s written in %.2f s\n", path_text(command.output).c_str(), seconds);
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

/// @param bad  triangles that are left at the boundaries of the loops that are filled
nlohmann::ordered_json fill_report(const FillCommand& command, const ImportReport& import, const ScanPlan& scan,
                                   const std::vector<BadBoundaryFace>& bad, const std::vector<HoleResult>& results) {
  nlohmann::ordered_json json;
  json["schema_version"] = report_schema_version;
  json["version"] = version();
  json["command_line"] = command.command_line;
  json["input"] = input_json(command.input, import, scan.done.before);
  json["prepared"] = preparation_json(scan.done);
  json["trimmed_faces"] = faces_json(scan.trimmed);
  json["bad_rim_faces"] = faces_json(bad);
  if (!scan.trimmable.empty() && command.job.prepare.trim_rounds == 0)
    json["suggestion"] = counted(scan.trimmable.size(), "bad triangle", "bad triangles") +
                         " at the boundaries; --trim-boundary 3 would remove what is bad.";
  json["loops"] = nlohmann::ordered_json::array();
  const std::size_t in_full = command.detail == Detail::all ? results.size() : most_loops_in_report;
  for (std::size_t k = 0; k < results.size(); ++k)
    json["loops"].push_back(k < in_full ? loop_json(results[k]) : brief_loop_json(results[k]));
  return json;
}

}  // namespace

namespace {

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
    std::fprintf(out, "%s not trimmed: more than a fifth of the triangles would have gone.\n",
                 counted(scan.spared_pieces, "piece of surface was", "pieces of surface were").c_str());
  if (!scan.trimmed.empty() && command.job.prepare.trim_rounds == 0)
    std::fprintf(out, "%s removed where a boundary ran through the surface.\n",
                 counted(scan.trimmed.size(), "triangle was", "triangles were").c_str());
  else if (!scan.trimmed.empty())
    std::fprintf(out, "%s removed at the boundaries.\n",
                 counted(scan.trimmed.size(), "bad triangle was", "bad triangles were").c_str());
  else if (!scan.trimmable.empty())
    std::fprintf(out, "%s at the boundaries; --trim-boundary 3 would remove what is bad.\n",
                 counted(scan.trimmable.size(), "bad triangle", "bad triangles").c_str());
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
  const CancelToken cancel;
  if (command.when_stopped == FillCommand::WhenStopped::keep_finished) cancel_on_interrupt(cancel);
  const Deadline deadline(start, command.max_seconds, cancel);
  ScanPlan scan = plan_scan(std::move(as_read), std::move(model), command.job, cancel);
  const std::vector<BadBoundaryFace> bad = bad_boundary_faces(scan.model, scan.to_trim);
  TriangleSoup& soup = scan.model.soup;
  const std::vector<HoleResult> results = fill_and_show(scan, command, deadline, cancel);
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
  if (command.check == Check::printable) verdict = watertightness(soup);

  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  nlohmann::ordered_json json = fill_report(command, opened.report, scan, bad, results);
  json["exterior_unchanged"] = losses.largest_exterior_rounding == 0;  // the model's is: that was compared above
  json["output"] = losses_json(losses);
  json["output"]["content"] = command.content == FillCommand::Content::patches ? "patches" : "surface";
  json["output"]["beside"] = nlohmann::ordered_json::array();
  for (const std::filesystem::path& file : written.beside) json["output"]["beside"].push_back(path_text(file));
  json["output"]["painted_triangles"] = written.painted;
  json["output"]["remarks"] = nlohmann::ordered_json::array();
  for (const Message& remark : written.remarks) json["output"]["remarks"].push_back(remark.english());
  if (verdict) json["check"] = verdict_json(*verdict);
  json["stopped"] = stopped;
  json["peak_memory_mb"] = peak_memory_of_process() / (1 << 20);
  json["total_seconds"] = seconds;
  commit_with_report(outputs, command.report, json);
  if (command.verbosity == Verbosity::normal) {
    std::FILE* out = command.report == "-" ? stderr : stdout;
    print_changes(out, command, opened.report, scan);
    if (scan.loops.empty())
      std::fprintf(out, "The surface is closed: there is nothing to fill. %s was written.\n",
                   path_text(command.output).c_str());
    else
      print_summary(out, results, outcome, command, seconds);
    if (verdict) print_verdict(out, *verdict);
    print_losses(out, command.output, losses);
    print_beside(out, written);
    print_import_losses(out, opened.report);
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
