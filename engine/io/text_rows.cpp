// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/text_rows.h"

#include "core/threads.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <type_traits>
#include <vector>

namespace loopmend {

namespace {

constexpr std::size_t block_bytes = 1 << 18;
constexpr std::size_t most_numbers = 16;

/// A stretch of whole lines.
struct Block {
  std::string_view text;
  std::size_t first_row = 0, rows = 0;
};

/// Blocks of whole lines, until they have as many as are asked for.
std::vector<Block> blocks_of(std::string_view text, std::size_t rows) {
  std::vector<Block> blocks;
  std::size_t at = 0, found = 0;
  // By a few at a time: what follows the rows may be much longer than they are.
  constexpr int at_once = 256;
  while (at < text.size() && found < rows) {
    const std::size_t begin = blocks.size();
    for (int k = 0; k < at_once && at < text.size(); ++k) {
      std::size_t end = std::min(at + block_bytes, text.size());
      end = std::min(text.find('\n', end - 1), text.size() - 1) + 1;
      blocks.push_back({text.substr(at, end - at), 0, 0});
      at = end;
    }
    parallel_for(static_cast<int>(begin), static_cast<int>(blocks.size()), 1, [&](int k) {
      Block& block = blocks[k];
      block.rows = static_cast<std::size_t>(std::count(block.text.begin(), block.text.end(), '\n'));
      if (block.text.back() != '\n') ++block.rows;  // the last line of the text
    });
    for (std::size_t k = begin; k < blocks.size(); ++k) {
      blocks[k].first_row = found;
      found += blocks[k].rows;
    }
  }
  while (!blocks.empty() && blocks.back().first_row >= rows) blocks.pop_back();
  if (found < rows) return {};
  return blocks;
}

template <class T>
std::optional<T> parsed(std::string_view token) {
  if constexpr (std::is_same_v<T, double>)
    return parse_double(token);
  else
    return parse_integer(token);
}

/// Up to the given row. @returns the bytes read; nothing where a line will not do.
template <class T, class Keep>
std::optional<std::size_t> read_block(const Block& block, std::size_t end_row, std::size_t numbers, const Keep& keep,
                                      std::string_view keyword) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  const std::string_view text = block.text;
  std::array<T, most_numbers> row{};
  std::size_t at = 0;
  for (std::size_t r = block.first_row; r < std::min(block.first_row + block.rows, end_row); ++r) {
    const std::size_t line_break = std::min(text.find('\n', at), text.size());
    std::size_t line_end = line_break;
    if (line_end > at && text[line_end - 1] == '\r') --line_end;
    if (text.substr(at, keyword.size()) != keyword) return std::nullopt;
    at += keyword.size();
    for (std::size_t n = 0; n < numbers; ++n) {
      while (at < line_end && is_blank(text[at])) ++at;
      const std::size_t begin = at;
      while (at < line_end && !is_blank(text[at])) ++at;
      const std::optional<T> value = parsed<T>(text.substr(begin, at - begin));
      if (!value) return std::nullopt;
      row[n] = *value;
    }
    while (at < line_end && is_blank(text[at])) ++at;
    if (at != line_end || !keep(r, row.data())) return std::nullopt;
    at = std::min(line_break + 1, text.size());
  }
  return at;
}

template <class T, class Keep>
std::optional<std::size_t> read(std::string_view text, std::size_t rows, int numbers, const Keep& keep,
                                std::string_view keyword) {
  if (numbers < 1 || static_cast<std::size_t>(numbers) > most_numbers || rows == 0) return std::nullopt;
  const std::vector<Block> blocks = blocks_of(text, rows);
  if (blocks.empty()) return std::nullopt;
  std::atomic<bool> all_do{true};
  std::size_t last_bytes = 0;
  parallel_for(0, static_cast<int>(blocks.size()), 1, [&](int k) {
    if (!all_do) return;
    const Block& block = blocks[k];
    const auto bytes = read_block<T>(block, rows, static_cast<std::size_t>(numbers), keep, keyword);
    if (!bytes) all_do = false;
    if (bytes && &block == &blocks.back()) last_bytes = *bytes;
  });
  if (!all_do) return std::nullopt;
  return static_cast<std::size_t>(blocks.back().text.data() - text.data()) + last_bytes;
}

}  // namespace

std::optional<std::size_t> read_rows(std::string_view text, std::size_t rows, int numbers, const KeepRow& keep,
                                     std::string_view keyword) {
  return read<double>(text, rows, numbers, keep, keyword);
}

std::optional<std::size_t> read_rows(std::string_view text, std::size_t rows, int numbers, const KeepIntegers& keep,
                                     std::string_view keyword) {
  return read<std::int64_t>(text, rows, numbers, keep, keyword);
}

std::size_t count_rows(std::string_view text, std::string_view keyword) {
  std::size_t rows = 0;
  for (std::size_t at = 0; at < text.size() && text.substr(at, keyword.size()) == keyword; ++rows)
    at = std::min(text.find('\n', at), text.size() - 1) + 1;
  return rows;
}

}  // namespace loopmend
