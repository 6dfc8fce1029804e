// SPDX-License-Identifier: GPL-3.0-or-later
#include "summary.h"

#include "core/version.h"
#include "io/base64.h"
#include "io/xml_text.h"

#include <cstdio>
#include <fstream>
#include <iterator>

namespace loopmend {

namespace {

namespace fs = std::filesystem;

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
  return "<a href='" + address(path) + "'>" + xml_text(words) + "</a>";
}

std::string cell(const std::string& content) { return "<td>" + content + "</td>"; }
std::string cell(long count) { return "<td class='n'>" + std::to_string(count) + "</td>"; }
std::string cell(const char* format, const std::optional<double>& value) {
  char text[64] = "";
  if (value) std::snprintf(text, sizeof text, format, *value);
  return "<td class='n'>" + std::string(text) + "</td>";
}

/// Nothing, one remark, or a list of them.
std::string listed(const std::vector<std::string>& remarks) {
  std::string html;
  for (const std::string& remark : remarks) html += "<li>" + xml_text(remark) + "</li>";
  return html.empty() ? html : "<ul>" + html + "</ul>";
}

std::string row_html(const fs::path& folder, const SummaryRow& row, std::size_t number) {
  const std::string& name = row.scan.name;
  std::string html =
      "<tr id='s" + std::to_string(number) + "' data-status='" + row.status() + "'>" + cell(static_cast<long>(number));
  std::string files;
  if (row.end.has_mesh())
    files = "<br>" + link("filled/" + name, "mesh") + " " + link("reports/" + name + ".json", "report");
  html += cell("<b>" + xml_text(name) + "</b>" + files) + "<td class='status'>" + row.status() + "</td>";
  if (row.figures) {
    const ScanFigures& f = *row.figures;
    html += "<td class='" + std::string(f.verdict()) + "'>" + f.verdict() + "</td>" + cell("%.2g", f.likely_off);
    for (const long count :
         {static_cast<long>(f.faces), static_cast<long>(f.loops), static_cast<long>(f.filled), static_cast<long>(f.bad),
          static_cast<long>(f.failed), static_cast<long>(f.left), f.new_vertices})
      html += cell(count);
    html +=
        cell("%.1f", f.angle_rms) + cell("%.1f", f.angle_max) + cell("%.1f", row.end.seconds) + cell("%.0f", f.memory);
  } else {
    for (int k = 0; k < 13; ++k) html += "<td></td>";  // so that a click on a header sorts by it
  }
  html += cell(listed(english(row.remarks())));
  const std::string png = row.picture.empty() ? std::string() : bytes_of(folder / row.picture);
  html += png.empty()
              ? cell("")
              : cell("<img alt='before and after' title='click: larger' loading='lazy' src='data:image/png;base64," +
                     to_base64(png) + "'>");
  return html + "</tr>\n";
}

const char* page_head = R"(<!doctype html>
<html lang='en'><head><meta charset='utf-8'><title>Filled scans</title>
<style>
body{font:15px/1.4 sans-serif;margin:1.5rem;color:#222;background:#fff}
table{border-collapse:collapse}
th,td{border:1px solid #ccc;padding:.25rem .5rem;text-align:left;vertical-align:top}
th{position:sticky;top:0;background:#eee}
th button{font:inherit;border:0;background:none;padding:0;cursor:pointer}
th[aria-sort=ascending] button::after{content:' \25B2'}th[aria-sort=descending] button::after{content:' \25BC'}
td.n{text-align:right}td ul{margin:0;padding-left:1.1rem;min-width:18rem;max-width:34rem}
td.look,[data-status=open] .status{background:#ffe9c2}td.bad,[data-status=error] .status{background:#ffd0d0}
[data-status=waiting] .status,[data-status=nothing] .status{background:#e6e6e6}
img{width:420px;cursor:zoom-in}img.large{width:1200px;cursor:zoom-out}
code{white-space:pre-wrap}form{margin:.5rem 0}[hidden]{display:none}
</style></head><body>
)";

/// Sorts by a click on a header, shows rows that have a word or a status, and enlarges a picture. Without it the page is whole.
const char* page_script = R"(<script>
const body = document.querySelector('tbody'), heads = [...document.querySelectorAll('th')];
const value = (row, k) => row.cells[k].textContent.trim();
heads.forEach((head, k) => head.querySelector('button')?.addEventListener('click', () => {
  const up = head.getAttribute('aria-sort') !== 'ascending';
  heads.forEach(other => other.removeAttribute('aria-sort'));
  head.setAttribute('aria-sort', up ? 'ascending' : 'descending');
  const rows = [...body.rows], numbers = rows.every(row => value(row, k) === '' || !isNaN(value(row, k)));
  const order = (a, b) => numbers ? a - b : a.localeCompare(b);
  rows.sort((one, other) => {
    const a = value(one, k), b = value(other, k);
    return a === '' || b === '' ? (a === '') - (b === '') : up ? order(a, b) : order(b, a);
  });
  body.append(...rows);
}));
const form = document.querySelector('form');
form.hidden = false;
form.addEventListener('submit', event => event.preventDefault());
form.addEventListener('input', () => {
  const word = form.word.value.toLowerCase(), status = form.status.value;
  for (const row of body.rows)
    row.hidden = (status && row.dataset.status !== status) || !row.textContent.toLowerCase().includes(word);
});
body.addEventListener('click', event => event.target.tagName === 'IMG' && event.target.classList.toggle('large'));
</script>
)";

/// The scans that a person should look at, before the long table.
std::string to_look_at(const std::vector<SummaryRow>& rows) {
  constexpr int most = 100;
  std::string list;
  int count = 0;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    const std::string status = rows[k].status();
    const bool has_look = status == "filled" && rows[k].figures->look > 0;
    if ((status != "open" && status != "error" && !has_look) || ++count > most) continue;
    list += "<li><a href='#s" + std::to_string(k + 1) + "'>" + xml_text(rows[k].scan.name) + "</a> (" +
            (has_look ? "look" : status) + ") " + listed(english(rows[k].remarks())) + "</li>\n";
  }
  if (count > most) list += "<li>" + std::to_string(count - most) + " more</li>\n";
  return count == 0 ? std::string() : "<h2>To look at</h2>\n<ul>\n" + list + "</ul>\n";
}

}  // namespace

std::string summary_page(const fs::path& folder, const std::vector<SummaryRow>& rows, const std::string& command_line) {
  const SummaryCounts counts = counts_of(rows);
  std::string html = page_head;
  html += "<h1>" + std::to_string(rows.size()) + " scans</h1>\n<p>" + std::to_string(counts.filled) + " filled, " +
          std::to_string(counts.look) + " of them to look at, " + std::to_string(counts.nothing) +
          " with nothing to fill, " + std::to_string(counts.open) + " left open, " + std::to_string(counts.error) +
          (counts.error == 1 ? " error, " : " errors, ") + std::to_string(counts.waiting) + " waiting; " +
          std::to_string(counts.as_before) +
          " of them were complete before this run. <a href='summary.csv'>summary.csv</a></p>\n<p>Loopmend " +
          xml_text(version()) + ": <code>" + xml_text(command_line) + "</code></p>\n" + to_look_at(rows);
  html +=
      "<h2>All scans</h2>\n<form hidden><input name='word' type='search' placeholder='name or remark'> <select "
      "name='status'>"
      "<option value=''>every status</option>";
  for (const char* status : {"filled", "nothing", "open", "error", "waiting"})
    html += "<option>" + std::string(status) + "</option>";
  html += "</select></form>\n<table>\n<thead><tr>";
  for (const char* name :
       {"#", "scan", "status", "verdict", "likely off", "faces", "loops", "filled", "bad", "failed", "left",
        "new vertices", "seam angle rms, &deg;", "seam angle max, &deg;", "seconds", "memory, MB", "remark"})
    html += "<th><button>" + std::string(name) + "</button></th>";
  html += "<th>before and after</th></tr></thead>\n<tbody>\n";
  for (std::size_t k = 0; k < rows.size(); ++k) html += row_html(folder, rows[k], k + 1);
  return html + "</tbody></table>\n" + page_script + "</body></html>\n";
}

}  // namespace loopmend
