// SPDX-License-Identifier: GPL-3.0-or-later
#include "summary.h"

#include "core/path_text.h"
#include "exit_codes.h"
#include "pipeline/judge.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

namespace loopmend {

namespace {

namespace fs = std::filesystem;

constexpr std::size_t most_remarks = 6;  ///< of a scan, in its row; the report has all

std::string number(const char* format, double value) {
  char text[64];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

std::string number(const std::optional<double>& value) { return value ? number("%.4g", *value) : std::string(); }

void take_larger(std::optional<double>& largest, const nlohmann::json& value) {
  if (value.is_number()) largest = std::max(largest.value_or(0), value.get<double>());
}

std::string list_of(const std::vector<std::string>& parts, const char* between) {
  std::string text;
  for (std::size_t k = 0; k < parts.size(); ++k) text.append(k > 0 ? between : "").append(parts[k]);
  return text;
}

/// "loops 2, 5: " and what is said of them.
Message with_loops(const Message& message, const std::vector<int>& loops) {
  constexpr std::size_t most_numbers = 8;
  std::vector<std::string> numbers;
  for (std::size_t k = 0; k < std::min(loops.size(), most_numbers); ++k) numbers.push_back(std::to_string(loops[k]));
  const std::string list = list_of(numbers, ", ");
  if (loops.size() == 1) return say("loop %1: %2", list, message);
  if (loops.size() <= most_numbers) return say("loops %1: %2", list, message);
  return say("loops %1 and %2 more: %3", list, loops.size() - most_numbers, message);
}

/// Of a loop's entry, in full or brief.
std::string grade_of(const nlohmann::json& loop) {
  return loop.contains("verdict") ? loop["verdict"].at("grade").get<std::string>()
                                  : loop.at("grade").get<std::string>();
}

/// "bad", "failed": the grade of a loop that was filled, the status of another one.
Message word_of(const std::string& grade_or_status) {
  for (const char* known : {text_to_say("failed"), text_to_say("skipped"), text_to_say("bad"), text_to_say("look")})
    if (known == grade_or_status) return say(known);
  return verbatim(grade_or_status);
}

std::optional<NoticeCode> notice_code_of(const std::string& word) {
  for (int k = 0; k <= static_cast<int>(NoticeCode::mirror_faulty); ++k)
    if (word == to_string(static_cast<NoticeCode>(k))) return static_cast<NoticeCode>(k);
  return {};
}

/// As a value that other languages have words for, where the findings give the sentence of the report.
Message sentence_of(const nlohmann::json& verdict) {
  const std::string sentence = verdict.at("sentence").get<std::string>();
  Verdict found;
  for (const nlohmann::json& finding : verdict.at("findings")) {
    const auto code = notice_code_of(finding.at("code").get<std::string>());
    if (!code) continue;
    Notice& notice = found.findings.emplace_back(Notice{*code, {}});
    for (const nlohmann::json& argument : finding.at("arguments"))  // JSON has null in place of NaN and infinity
      notice.arguments.push_back(argument.is_number() ? argument.get<double>() : std::nan(""));
  }
  Message message = found.message();
  return message.english() == sentence ? message : Message{sentence, {}, {}, false};
}

/// What is said of a loop that is open or not good.
Message why_not_good(const nlohmann::json& loop, const std::string& word) {
  const std::string text = loop.at("message").get<std::string>();
  const Message why = word != loop.at("status").get<std::string>() && loop.contains("verdict")
                          ? sentence_of(loop["verdict"])
                          : Message{text, {}, loop.value("message_code", ""), false};
  return why.empty() ? word_of(word) : say("%1, %2", word_of(word), why);
}

/// @throws nlohmann::json::exception where it is no report of fill.
ScanFigures figures_of(const nlohmann::json& report) {
  ScanFigures figures;
  figures.vertices = report.at("input").at("vertices").get<std::size_t>();
  figures.faces = report.at("input").at("faces").get<std::size_t>();
  figures.seconds = report.at("total_seconds").get<double>();
  figures.memory = report.at("peak_memory_mb").get<double>();
  std::vector<std::pair<Message, std::vector<int>>> said;
  for (const nlohmann::json& loop : report.at("loops")) {
    const std::string status = loop.at("status").get<std::string>();
    ++figures.loops;
    const bool is_open = status == "failed" || status == "skipped";
    std::string grade;
    if (is_open) {
      ++(status == "failed" ? figures.failed : figures.left);
    } else {
      ++figures.filled;
      grade = grade_of(loop);
      figures.bad += grade == "bad";
      figures.look += grade == "look";
      if (loop.at("expected_deviation").is_object())
        take_larger(figures.likely_off, loop["expected_deviation"].at("likely"));
      figures.new_vertices += loop.at("free_vertices").get<long>();
      take_larger(figures.angle_rms, loop.at("seam_after").at("g1_rms_deg"));
      take_larger(figures.angle_max, loop.at("seam_after").at("g1_max_deg"));
    }
    if (grade == "good") continue;
    const Message words = why_not_good(loop, is_open ? status : grade);
    auto known = std::find_if(said.begin(), said.end(), [&](const auto& one) { return one.first == words; });
    if (known == said.end()) known = said.insert(said.end(), {words, {}});
    known->second.push_back(loop.at("number").get<int>());
  }
  for (std::size_t k = 0; k < std::min(said.size(), most_remarks); ++k)
    figures.remarks.push_back(with_loops(said[k].first, said[k].second));
  if (said.size() > most_remarks) figures.remarks.push_back(say("and more, see the report"));
  return figures;
}

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"\r\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
  return quoted + "\"";
}

}  // namespace

const char* SummaryRow::status() const {
  if (end.state == ScanEnd::State::error) return "error";
  if (end.state == ScanEnd::State::waiting) return "waiting";
  if (end.code != exit_done || !figures) return "open";
  return figures->filled > 0 ? "filled" : "nothing";
}

std::vector<Message> SummaryRow::remarks() const {
  std::vector<Message> parts;
  if (!end.why.empty()) parts.push_back(end.why);
  if (end.state == ScanEnd::State::waiting) parts.push_back(say("the batch was stopped before this scan was done"));
  if (end.has_mesh() && !figures) parts.push_back(say("the report cannot be read"));
  if (figures && end.code != exit_done && figures->failed == 0 && figures->bad == 0)
    parts.push_back(figures->filled > 0 ? say("not everything was finished") : say("nothing was filled"));
  if (figures && figures->loops == 0) parts.push_back(say("the surface is closed"));
  if (figures) parts.insert(parts.end(), figures->remarks.begin(), figures->remarks.end());
  if (!end.picture_fault.empty()) parts.push_back(say("no picture: %1", end.picture_fault));
  return parts;
}

SummaryRow summary_row(const fs::path& folder, const Scan& scan, const ScanEnd& end) {
  SummaryRow row{scan, end, {}, {}};
  if (!end.has_mesh()) return row;
  const ScanFiles files = files_of(folder, scan.name);
  try {
    std::ifstream report(files.report);
    row.figures = figures_of(nlohmann::json::parse(report));
  } catch (const nlohmann::json::exception&) {  // the row says so
  }
  if (state_of(files.picture)) row.picture = "pictures/" + scan.name + ".png";
  return row;
}

SummaryCounts counts_of(const std::vector<SummaryRow>& rows) {
  SummaryCounts counts;
  for (const SummaryRow& row : rows) {
    const std::string status = row.status();
    ++(status == "filled"    ? counts.filled
       : status == "nothing" ? counts.nothing
       : status == "open"    ? counts.open
       : status == "error"   ? counts.error
                             : counts.waiting);
    counts.look += status == "filled" && row.figures->look > 0;
    counts.as_before += row.end.state == ScanEnd::State::as_before;
  }
  return counts;
}

std::vector<std::string> english(const std::vector<Message>& remarks) {
  std::vector<std::string> texts;
  for (const Message& remark : remarks) texts.push_back(remark.english());
  return texts;
}

std::string summary_csv(const std::vector<SummaryRow>& rows) {
  std::string csv =
      "scan,input,status,exit_code,this_run,vertices,faces,loops,filled,bad,failed,left,new_vertices,seam_angle_"
      "rms_deg,"
      "seam_angle_max_deg,seconds,fill_seconds,peak_memory_mb,verdict,likely_off,mesh,report,picture,remark\n";
  for (const SummaryRow& row : rows) {
    const std::string& name = row.scan.name;
    std::vector<std::string> fields{name, generic_path_text(row.scan.input), row.status(),
                                    row.end.state == ScanEnd::State::waiting ? "" : std::to_string(row.end.code),
                                    row.end.state == ScanEnd::State::as_before ? "no" : "yes"};
    if (row.figures) {
      const ScanFigures& f = *row.figures;
      for (const long count : {static_cast<long>(f.vertices), static_cast<long>(f.faces), static_cast<long>(f.loops),
                               static_cast<long>(f.filled), static_cast<long>(f.bad), static_cast<long>(f.failed),
                               static_cast<long>(f.left), f.new_vertices})
        fields.push_back(std::to_string(count));
      fields.insert(fields.end(),
                    {number(f.angle_rms), number(f.angle_max), number("%.3f", row.end.seconds),
                     number("%.3f", f.seconds), number("%.0f", f.memory), f.verdict(), number(f.likely_off)});
    } else {
      fields.resize(fields.size() + 15);
    }
    const bool has_mesh = row.end.has_mesh();
    fields.insert(fields.end(), {has_mesh ? "filled/" + name : "", has_mesh ? "reports/" + name + ".json" : "",
                                 row.picture, list_of(english(row.remarks()), "; ")});
    for (std::string& field : fields) field = csv_field(field);
    csv += list_of(fields, ",") + "\n";
  }
  return csv;
}

}  // namespace loopmend
