// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/text_cursor.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <locale>
#include <sstream>
#include <system_error>
#include <utility>

namespace loopmend {

namespace {

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\v' || c == '\f'; }

/// Of a decimal number, in the C locale: its nearest double, infinity or zero where there is none.
double value_by_stream(std::string_view token) {
  std::istringstream stream{std::string(token)};
  stream.imbue(std::locale::classic());
  double value = 0;
  stream >> value;  // where the number is too large, standard libraries leave the largest double or infinity
  return std::abs(value) < std::numeric_limits<double>::max()
             ? value
             : std::copysign(std::numeric_limits<double>::infinity(), value);
}

/// What old Visual C++ prints after "1." for what is no finite number, as in "-1.#IND" and "1.#INF00".
constexpr std::array<std::pair<std::string_view, double>, 4> not_finite_words = {
    {{"#QNAN", std::numeric_limits<double>::quiet_NaN()},
     {"#SNAN", std::numeric_limits<double>::quiet_NaN()},
     {"#IND", std::numeric_limits<double>::quiet_NaN()},
     {"#INF", std::numeric_limits<double>::infinity()}}};

std::optional<double> not_finite_value(std::string_view token) {
  const bool is_negative = token.substr(0, 1) == "-";
  if (is_negative) token.remove_prefix(1);
  if (token.substr(0, 2) != "1.") return std::nullopt;
  for (const auto& [word, value] : not_finite_words)
    if (token.substr(2, word.size()) == word &&
        token.find_first_not_of("0123456789", 2 + word.size()) == std::string_view::npos)
      return is_negative ? -value : value;
  return std::nullopt;
}

/// Where the comment of a line begins; the mark in "1.#QNAN" is none.
std::size_t comment_in(std::string_view line, char mark) {
  std::size_t at = line.find(mark);
  const auto is_in_number = [&] {
    return at >= 2 && line.substr(at - 2, 2) == "1." &&
           std::any_of(not_finite_words.begin(), not_finite_words.end(),
                       [&](const auto& entry) { return line.substr(at, entry.first.size()) == entry.first; });
  };
  while (at != std::string_view::npos && is_in_number()) at = line.find(mark, at + 1);
  return at;
}

#ifndef __cpp_lib_to_chars
/// [-]digits[.digits][e[+-]digits], with a digit before or after the point.
bool is_decimal(std::string_view token) {
  const auto digits = [&token] {
    const std::size_t count = std::min(token.find_first_not_of("0123456789"), token.size());
    token.remove_prefix(count);
    return count;
  };
  const auto take = [&token](std::string_view any) {
    if (token.empty() || any.find(token.front()) == std::string_view::npos) return false;
    token.remove_prefix(1);
    return true;
  };
  take("-");
  std::size_t count = digits();
  if (take(".")) count += digits();
  if (count == 0) return false;
  if (!take("eE")) return token.empty();
  take("+-");
  return digits() > 0 && token.empty();
}
#endif

}  // namespace

char ascii_lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool equals_ignoring_case(std::string_view a, std::string_view b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    if (ascii_lower(a[i]) != ascii_lower(b[i])) return false;
  }
  return true;
}

std::optional<double> parse_double(std::string_view token) {
  if (!token.empty() && token.front() == '+') {
    token.remove_prefix(1);
    if (!token.empty() && token.front() == '-') return std::nullopt;
  }
#ifdef __cpp_lib_to_chars
  double value = 0.0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (token.empty() || end != token.data() + token.size()) return not_finite_value(token);
  if (error == std::errc::result_out_of_range) return value_by_stream(token);
  if (error != std::errc()) return std::nullopt;
  return value;
#else  // such as libc++ before LLVM 20
  return is_decimal(token) ? value_by_stream(token) : not_finite_value(token);
#endif
}

std::optional<std::int64_t> parse_integer(std::string_view token) {
  if (!token.empty() && token.front() == '+') {
    token.remove_prefix(1);
    if (!token.empty() && token.front() == '-') return std::nullopt;
  }
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(token.data(), token.data() + token.size(), value);
  if (token.empty() || error != std::errc() || end != token.data() + token.size()) return std::nullopt;
  return value;
}

std::string upper_off_keyword(std::string_view token) {
  std::string upper(token);
  const std::size_t at = token.find("off");
  if (at == std::string_view::npos || at > 4) return upper;
  for (std::size_t k = 0; k < at + 3; ++k)
    if (upper[k] >= 'a' && upper[k] <= 'z') upper[k] = static_cast<char>(upper[k] - 'a' + 'A');
  return upper;
}

std::string in_quotes(std::string_view token) {
  constexpr std::size_t longest = 40;
  std::string text = "\"";
  for (const char c : token.substr(0, longest)) text += (c >= ' ' && c <= '~') ? c : '?';
  if (token.size() > longest) text += "...";
  return text + "\"";
}

std::string_view without_end_mark(std::string_view text) {
  if (!text.empty() && text.back() == '\0') text.remove_suffix(1);
  while (!text.empty() && text.back() == '\x1A') text.remove_suffix(1);
  return text;
}

TextCursor::TextCursor(std::string_view text, char comment_mark)
    : text_(without_end_mark(text)),
      comment_mark_(comment_mark) {}

bool TextCursor::next_line() {
  if (next_ >= text_.size()) {
    at_ = line_end_ = next_ = text_.size();
    return false;
  }
  at_ = next_;
  std::size_t end = at_;
  while (end < text_.size() && text_[end] != '\n' && text_[end] != '\r') ++end;
  next_ = end;
  if (next_ < text_.size()) next_ += (text_[end] == '\r' && end + 1 < text_.size() && text_[end + 1] == '\n') ? 2 : 1;
  line_end_ = end;
  if (comment_mark_ != '\0') {
    const std::size_t comment = comment_in(text_.substr(at_, end - at_), comment_mark_);
    if (comment != std::string_view::npos) line_end_ = at_ + comment;
  }
  ++line_number_;
  return true;
}

std::string_view TextCursor::next_token() {
  while (at_ < line_end_ && is_blank(text_[at_])) ++at_;
  const std::size_t begin = at_;
  while (at_ < line_end_ && !is_blank(text_[at_])) ++at_;
  return text_.substr(begin, at_ - begin);
}

std::string_view TextCursor::next_token_across_lines() {
  for (;;) {
    const std::string_view token = next_token();
    if (!token.empty() || !next_line()) return token;
  }
}

}  // namespace loopmend
