// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill_summary.h"

#include "exit_codes.h"
#include "outputs.h"

#include "core/path_text.h"
#include "pipeline/flat_cut.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <regex>
#include <set>
#include <string>
#include <utility>
#include <vector>

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

/// A text with its numbers apart: reasons that differ by a figure are one.
struct Reason {
  std::string plain;                 ///< "\x1f" for each number
  std::vector<std::string> numbers;  ///< as they are written
};

Reason split(const std::string& text) {
  if (text.find("'loopmend blend ") != std::string::npos) return {text, {}};  // a command is that of its own loops
  static const std::regex number(R"(\d+(\.\d+)?(e[-+]?\d+)?)");
  Reason reason{std::regex_replace(text, number, "\x1f"), {}};
  for (std::sregex_iterator found(text.begin(), text.end(), number), end; found != end; ++found)
    reason.numbers.push_back(found->str());
  return reason;
}

double value(const std::string& number) {
  double value = 0;
  std::from_chars(number.data(), number.data() + number.size(), value);
  return value;
}

/// Reasons of one plain text.
struct Alike {
  std::vector<std::vector<std::string>> numbers;  ///< of each
  std::vector<int> loops;

  /// Each number as it is in all of them, or from the lowest to the highest.
  std::string text(const std::string& plain) const {
    std::string text;
    std::size_t k = 0;
    for (const char c : plain) {
      if (c != '\x1f') {
        text += c;
        continue;
      }
      const auto [low, high] =
          std::ranges::minmax_element(numbers, {}, [k](const auto& of_one) { return value(of_one[k]); });
      text += (*low)[k];
      if (value((*low)[k]) < value((*high)[k])) text += " to " + (*high)[k];
      ++k;
    }
    return text;
  }
};

/// Each text once, with its loops. @param text_of  of one result; empty: there is none
void print_once(std::FILE* out, const std::vector<HoleResult>& results, Detail detail,
                std::string (*text_of)(const HoleResult&)) {
  constexpr std::size_t most_numbers = 12;
  std::map<std::string, Alike> alike;
  for (const HoleResult& r : results) {
    const std::string text = text_of(r);
    if (text.empty()) continue;
    Reason reason = detail == Detail::all ? Reason{text, {}} : split(text);
    Alike& same = alike[reason.plain];
    same.numbers.push_back(std::move(reason.numbers));
    same.loops.push_back(r.loop.number);
  }
  for (const auto& [plain, same] : alike) {
    std::string list;
    for (std::size_t k = 0; k < std::min(same.loops.size(), most_numbers); ++k)
      list += (k ? ", " : "") + std::to_string(same.loops[k]);
    if (same.loops.size() > most_numbers) list += " and " + std::to_string(same.loops.size() - most_numbers) + " more";
    std::fprintf(out, "loop%s %s: %s.\n", same.loops.size() == 1 ? "" : "s", list.c_str(), same.text(plain).c_str());
  }
}

/// Why a loop is open, or what else there is to know of it.
std::string message_text(const HoleResult& r) { return r.message.english(); }

/// Why the flow was not run as asked.
std::string reason_text(const HoleResult& r) {
  return r.reason().empty() ? std::string() : r.method() + ": " + r.reason().english();
}

/// What became of very many loops: how many there are for each outcome, and each thing that is said of them.
void print_counts(std::FILE* out, const std::vector<HoleResult>& results) {
  std::map<std::pair<std::string, std::string>, Alike> alike;  // by status and reason
  for (const HoleResult& result : results) {
    Reason reason = split(result.message.english());
    Alike& same = alike[{to_string(result.status), reason.plain}];
    same.numbers.push_back(std::move(reason.numbers));
    same.loops.push_back(result.loop.number);
  }
  for (const auto& [outcome, same] : alike)
    std::fprintf(out, "%s %s%s%s\n", counted(same.loops.size(), "loop", "loops").c_str(), outcome.first.c_str(),
                 outcome.second.empty() ? "" : ": ", same.text(outcome.second).c_str());
}

/// A finding on the shape over a loop that a person has to look at.
bool is_high(const HoleResult& r) {
  constexpr double rises = 0.05;  // diameters
  const Verdict verdict = r.verdict();
  return is_filled(r.status) && verdict.grade == Grade::look &&
         std::ranges::any_of(verdict.findings, [&](const Notice& finding) {
           const bool is_high = verdict.height > rises &&
                                (finding.code == NoticeCode::high_over_loop || finding.code == NoticeCode::likely_far);
           return is_high || finding.code == NoticeCode::dome_over_flat_loop;
         });
}

/// "loop 3", "loops 3, 5"
std::string loops_text(const std::vector<int>& numbers) {
  std::string text = numbers.size() == 1 ? "loop " : "loops ";
  for (std::size_t k = 0; k < numbers.size(); ++k) text += (k > 0 ? ", " : "") + std::to_string(numbers[k]);
  return text;
}

/// For patches that rise so high: --islands cover where islands are joined to them, and where the loop is nearly plane, so that the
/// surface may end there, the --loops that closes it flat and fills the others as they were.
void print_other_shapes(std::FILE* out, const std::vector<HoleResult>& results) {
  constexpr int most_in_an_option = 20;
  std::set<const PatchResult*> with_islands;
  for (const HoleResult& r : results)
    if (r.message.code == "joined_island") with_islands.insert(r.patch.get());
  std::vector<int> flat, islands;
  std::string option;
  int filled = 0;
  for (const HoleResult& r : results) {
    if (!is_filled(r.status)) continue;
    const bool has_islands = with_islands.contains(r.patch.get());
    const bool ends_flat = is_high(r) && !has_islands && r.loop.planarity <= flat_planarity;
    if (is_high(r) && has_islands) islands.push_back(r.loop.number);
    if (ends_flat) flat.push_back(r.loop.number);
    option += (filled++ == 0 ? "" : ",") + std::to_string(r.loop.number) + (ends_flat ? ":flat" : "");
  }
  if (!islands.empty())
    std::fprintf(out, "If the islands in %s are debris, --islands cover makes patches without them.\n",
                 loops_text(islands).c_str());
  if (!flat.empty() && filled <= most_in_an_option)
    std::fprintf(out, "If the surface ends at %s, --loops %s closes %s flat.\n", loops_text(flat).c_str(),
                 option.c_str(), flat.size() == 1 ? "it" : "them");
}

}  // namespace

int Outcome::exit_code() const {
  return failed + bad + unfinished + wide_cracks + open_cuts > 0 || apart > 0 || in_vain() ? exit_loops_failed
                                                                                           : exit_done;
}

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
  if (cut > 0) std::fprintf(out, " Along edges of more than two faces: %td; fill again with --auto.", cut);
  std::fprintf(out, "\n");
}

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
  print_other_shapes(out, results);
  std::fprintf(out, "%d filled, ", outcome.filled);
  if (outcome.look > 0) std::fprintf(out, "%d of them to look at, ", outcome.look);
  if (outcome.bad > 0) std::fprintf(out, "%d of them bad, ", outcome.bad);
  std::fprintf(out, "%d failed, %d left as asked", outcome.failed, outcome.left);
  if (outcome.unfinished > 0) std::fprintf(out, ", %d not finished", outcome.unfinished);
  if (outcome.no_hole > 0) std::fprintf(out, ", %d left because they are no holes", outcome.no_hole);
  std::fprintf(out, "; %s written in %.2f s\n", path_text(command.output).c_str(), seconds);
}

}  // namespace loopmend
