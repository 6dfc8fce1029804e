// SPDX-License-Identifier: GPL-3.0-or-later
#include "table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <stdexcept>

namespace loopmend::bench {

namespace {

/// Width on paper: UTF-8 sequences count as one.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(
      std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string result = "\"";
  for (char c : cell) result += c == '"' ? std::string("\"\"") : std::string(1, c);
  return result + '"';
}

std::string padded_row(const std::vector<std::string>& row, const std::vector<std::size_t>& widths) {
  std::string line = "|";
  for (std::size_t k = 0; k < row.size(); ++k) {
    const std::string space(widths[k] - width(row[k]), ' ');
    line += k == 0 ? ' ' + row[k] + space : ' ' + space + row[k];
    line += " |";
  }
  return line + '\n';
}

std::string csv_row(const std::vector<std::string>& row) {
  std::string line;
  for (const std::string& cell : row) {
    if (&cell != &row.front()) line += ',';
    line += quoted(cell);
  }
  return line + '\n';
}

}  // namespace

std::string Table::markdown() const {
  std::vector<std::size_t> widths;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    widths.push_back(std::max<std::size_t>(3, width(columns_[k])));
    for (const auto& row : rows_) widths[k] = std::max(widths[k], width(row[k]));
  }
  std::string text = padded_row(columns_, widths) + '|';
  for (std::size_t k = 0; k < widths.size(); ++k)
    text += k == 0 ? ' ' + std::string(widths[k], '-') + " |" : ' ' + std::string(widths[k] - 1, '-') + ": |";
  text += '\n';
  for (const auto& row : rows_) text += padded_row(row, widths);
  return text;
}

std::string Table::csv() const {
  std::string text = csv_row(columns_);
  for (const auto& row : rows_) text += csv_row(row);
  return text;
}

std::string number(double value) {
  if (std::isnan(value)) return "-";
  char text[32];
  const double size = std::abs(value);
  if (size != 0 && (size < 1e-3 || size >= 1e5))
    std::snprintf(text, sizeof text, "%.2e", value);
  else
    std::snprintf(text, sizeof text, "%.*f",
                  size >= 100   ? 0
                  : size >= 10  ? 1
                  : size >= 1   ? 2
                  : size >= 0.1 ? 3
                                : 4,
                  value);
  return text;
}

std::string number(int value) { return std::to_string(value); }

void write_text(const std::filesystem::path& path, const std::string& text) {
  if (path.empty()) return;
  std::filesystem::path temporary = path;
  temporary += ".part";
  std::ofstream(temporary, std::ios::binary) << text << std::flush;
  std::error_code error;
  std::filesystem::rename(temporary, path, error);
  if (error) throw std::runtime_error(path.string() + ": cannot be written (" + error.message() + ")");
}

}  // namespace loopmend::bench
