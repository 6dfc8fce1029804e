// SPDX-License-Identifier: GPL-3.0-or-later
// Walking through the text of a mesh file: lines, tokens, numbers. Independent of the locale; cannot run past the end.
#pragma once

#include "core/message.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace loopmend {

/// 'A'..'Z' to lower case; every other byte as it is.
char ascii_lower(char c);
bool equals_ignoring_case(std::string_view a, std::string_view b);

/// The double that is nearest to the decimal text, as strtod in the C locale finds it; a leading '+' is allowed, "nan"
/// and "inf" are numbers, as is what old Visual C++ writes for them, "1.#QNAN". Nothing if the token is not wholly a number.
std::optional<double> parse_double(std::string_view token);

/// Nothing if the token is not wholly a decimal integer that fits.
std::optional<std::int64_t> parse_integer(std::string_view token);

/// "off", "coff" and so on in the capitals that the format has; every other token as it is.
std::string upper_off_keyword(std::string_view token);

/// For error messages: the token in quotes, shortened, with unprintable bytes as '?'.
std::string in_quotes(std::string_view token);

/// The text without what some programs write after its end: the zero of a string of C, the ends of file of DOS. Several
/// zeros are what a crash leaves of a file that was not wholly written: they stay.
std::string_view without_end_mark(std::string_view text);

/// Lines end with \n, \r\n or \r; tokens are separated by blanks and tabs; without_end_mark() reports the end.
class TextCursor {
 public:
  /// @param comment_mark  everything from this character to the end of a line is left out; '\0' for none.
  explicit TextCursor(std::string_view text, char comment_mark = '\0');

  /// Steps to the next line; false at the end of the text.
  bool next_line();
  /// The next token of this line; empty at its end.
  std::string_view next_token();
  /// The next token, on this line or a later one; empty at the end of the text.
  std::string_view next_token_across_lines();
  /// What is left of this line, its blanks as they are.
  std::string_view rest_of_line() const { return text_.substr(at_, line_end_ - at_); }
  /// The same with what would be a comment: for names, which may hold the mark.
  std::string_view rest_with_comment() const {
    const std::string_view rest = text_.substr(at_, next_ - at_);
    return rest.substr(0, rest.find_last_not_of("\r\n") + 1);
  }
  /// Leaves out the rest of this line.
  void skip_line() { at_ = line_end_; }

  /// Whether the last token was followed by nothing at all, not even a blank.
  bool at_line_end() const { return at_ == line_end_; }
  std::size_t line_number() const { return line_number_; }
  /// "line 12", for error messages.
  Message place() const { return say("line %1", line_number_); }
  /// How many bytes of text there are from the next token on.
  std::size_t bytes_left() const { return text_.size() - at_; }
  /// Where in the text the next line begins.
  std::size_t next_line_offset() const { return next_; }
  /// The text from the next line on, and how to leave out lines of it that were read elsewhere.
  std::string_view next_lines() const { return text_.substr(next_); }
  void skip_lines(std::size_t bytes, std::size_t lines) {
    at_ = line_end_ = next_ += bytes;
    line_number_ += lines;
  }

 private:
  std::string_view text_;
  char comment_mark_;
  std::size_t at_ = 0;        // next byte to look at
  std::size_t line_end_ = 0;  // one past the last byte of this line, without a comment
  std::size_t next_ = 0;      // first byte of the next line
  std::size_t line_number_ = 0;
};

}  // namespace loopmend
