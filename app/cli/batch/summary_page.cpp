// SPDX-License-Identifier: GPL-3.0-or-later
#include "summary.h"

#include "core/version.h"
#include "io/base64.h"

#include <cstdio>
#include <fstream>
#include <iterator>

namespace loopmend {

namespace {

namespace fs = std::filesystem;

std::string escaped(const std::string& text) {
  std::string html;
  for (const char c : text) {
    if (c == '&')
      html += "&amp;";
    else if (c == '<')
      html += "&lt;";
    else if (c == '>')
      html += "&gt;";
    else if (c == '"')
      html += "&quot;";
    else
      html += c;
  }
  return html;
}

/// A path as an address within the page's folder.
std::string address(const std::string& path) {
  const std::string plain = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-._~/";
  std::string text;
  for (const char c : path) {
    char code[4];
    std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned char>(c));
    text += plain.find(c) != std::string::npos ? std::string(1, c) : std::string(code);
  }
  return text;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::string link(const std::string& path, const std::string& words) {
  return "<a href='" + address(path) + "'>" + escaped(words) + "</a>";
}

std::string cell(const std::string& content) { return "<td>" + content + "</td>"; }
std::string cell(long count) { return "<td class='n'>" + std::to_string(count) + "</td>"; }
std::string cell(const char* format, const std::optional<double>& value) {
  char text[64] = "";
  if (value) std::snprintf(text, sizeof text, format, *value);
  return "<td class='n'>" + std::string(text) + "</td>";
}

std::string row_html(const fs::path& folder, const SummaryRow& row, std::size_t number) {
  const std::string& name = row.scan->name;
  std::string html =
      "<tr id='s" + std::to_string(number) + "' class='" + row.status() + "'>" + cell(static_cast<long>(number));
  std::string files;
  if (row.end->has_mesh())
    files = "<br>" + link("filled/" + name, "mesh") + " " + link("reports/" + name + ".json", "report");
  html += cell("<b>" + escaped(name) + "</b>" + files) + cell(row.status());
  if (row.figures) {
    const ScanFigures& f = *row.figures;
    for (const long count :
         {static_cast<long>(f.faces), static_cast<long>(f.loops), static_cast<long>(f.filled), static_cast<long>(f.bad),
          static_cast<long>(f.failed), static_cast<long>(f.left), f.new_vertices})
      html += cell(count);
    html +=
        cell("%.1f", f.angle_rms) + cell("%.1f", f.angle_max) + cell("%.1f", row.end->seconds) + cell("%.0f", f.memory);
  } else {
    html += "<td colspan='11'></td>";
  }
  html += cell(escaped(row.remark()));
  const std::string png = row.picture.empty() ? std::string() : bytes_of(folder / row.picture);
  html += png.empty() ? cell("")
                      : cell("<img alt='before and after' width='360' loading='lazy' src='data:image/png;base64," +
                             to_base64(png) + "'>");
  return html + "</tr>\n";
}

const char* page_head =
    "<!doctype html>\n<html lang='en'><head><meta charset='utf-8'><title>Filled scans</title>\n<style>\n"
    "body{font:15px/1.4 sans-serif;margin:1.5rem;color:#222;background:#fff}\n"
    "table{border-collapse:collapse}th,td{border:1px solid #ccc;padding:.25rem "
    ".5rem;text-align:left;vertical-align:top}\n"
    "th{position:sticky;top:0;background:#eee}td.n{text-align:right}td:nth-last-child(2){max-width:26rem}\n"
    ".look td:nth-child(3){background:#ffe9c2}.error td:nth-child(3){background:#ffd0d0}"
    ".waiting td:nth-child(3){background:#e6e6e6}\ncode{white-space:pre-wrap}\n</style></head><body>\n";

/// The scans that a person should look at, before the long table.
std::string to_look_at(const std::vector<SummaryRow>& rows) {
  constexpr int most = 100;
  std::string list;
  int count = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::string status = rows[k].status();
    if ((status != "look" && status != "error") || ++count > most) continue;
    list += "<li><a href='#s" + std::to_string(k + 1) + "'>" + escaped(rows[k].scan->name) + "</a> (" + status +
            "): " + escaped(rows[k].remark()) + "</li>\n";
  }
  if (count > most) list += "<li>" + std::to_string(count - most) + " more</li>\n";
  return count == 0 ? std::string() : "<h2>To look at</h2>\n<ul>\n" + list + "</ul>\n";
}

}  // namespace

std::string summary_page(const fs::path& folder, const std::vector<SummaryRow>& rows, const std::string& command_line) {
  const SummaryCounts counts = counts_of(rows);
  std::string html = page_head;
  html += "<h1>" + std::to_string(rows.size()) + " scans</h1>\n<p>" + std::to_string(counts.filled) + " filled, " +
          std::to_string(counts.look) + " to look at, " + std::to_string(counts.error) + " errors, " +
          std::to_string(counts.waiting) + " waiting; " + std::to_string(counts.as_before) +
          " of them were complete before this run. <a href='summary.csv'>summary.csv</a></p>\n<p>Loopmend " +
          escaped(version()) + ": <code>" + escaped(command_line) + "</code></p>\n" + to_look_at(rows);
  html +=
      "<h2>All "
      "scans</h2>\n<table>\n<thead><tr><th>#</th><th>scan</th><th>status</th><th>faces</th><th>loops</th><th>filled</"
      "th>"
      "<th>bad</th><th>failed</th><th>left</th><th>new vertices</th><th>seam angle rms, &deg;</th>"
      "<th>seam angle max, &deg;</th><th>seconds</th><th>memory, MB</th><th>remark</th><th>before and "
      "after</th></tr></thead>\n"
      "<tbody>\n";
  for (std::size_t k = 0; k < rows.size(); ++k) html += row_html(folder, rows[k], k + 1);
  return html + "</tbody></table>\n</body></html>\n";
}

}  // namespace loopmend
