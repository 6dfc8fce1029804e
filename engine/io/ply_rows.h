// SPDX-License-Identifier: GPL-3.0-or-later
// The body of a PLY file, value by value: one source for text and one for both binaries, with the same functions.
#pragma once

#include "core/message.h"
#include "io/parse_errors.h"
#include "io/ply_header.h"
#include "io/text_cursor.h"

#include <bit>
#include <cstring>
#include <limits>
#include <optional>
#include <string_view>
#include <utility>

namespace loopmend {

/// The value whose bytes begin there, in the order of this machine.
template <class T>
T loaded(const char* from) {
  T value;
  std::memcpy(&value, from, sizeof value);
  return value;
}

/// Values as text. A row begins on a line of its own and may go on over several.
class PlyTextRows {
 public:
  PlyTextRows(const FileContent& file, const PlyHeader& header)
      : errors_(file),
        cursor_(mesh_text(file).substr(header.body_offset)),
        header_lines_(header.lines) {}

  void begin_row(const PlyElement& element, std::uint64_t row) {
    element_ = &element;
    row_ = row;
  }

  double number(PlyType) {
    const std::string_view token = next();
    const std::optional<double> value = parse_double(token);
    if (!value) errors_.not_a_number(token, say("a number"), place());
    return *value;
  }

  /// Of a property that is only passed on: "1.#QNAN" and the like of old compilers are no numbers there, and no fault.
  double carried(PlyType) {
    const std::string_view token = next();
    if (const std::optional<double> value = parse_double(token)) return *value;
    if (token.find('#') == std::string_view::npos && token.find("nan") == std::string_view::npos)
      errors_.not_a_number(token, say("a number"), place());
    return std::numeric_limits<double>::quiet_NaN();
  }

  std::int64_t integer(PlyType) {
    const std::string_view token = next();
    const std::optional<std::int64_t> value = parse_integer(token);
    if (!value) errors_.not_a_number(token, say("a whole number"), place());
    return *value;
  }

  std::uint64_t list_length(const PlyProperty& list) {
    const std::int64_t length = integer(list.count_type);
    const auto most =
        (std::uint64_t{1} << (8 * size_in_bytes(list.count_type) - (is_signed(list.count_type) ? 1 : 0))) - 1;
    if (length < 0 || static_cast<std::uint64_t>(length) > most)
      errors_.fail(say("a list of %1 items", length), place());
    if (static_cast<std::uint64_t>(length) > cursor_.bytes_left()) {
      errors_.truncated(say("a list of %1 items", length), place());
    }
    return static_cast<std::uint64_t>(length);
  }

  void end_row() {
    const std::string_view token = cursor_.next_token();
    if (!token.empty()) {
      errors_.fail(say("this row holds more values than the header says, from %1 on", in_quotes(token)), place(),
                   say("The header and the data do not belong together; export the mesh again."));
    }
  }

  void end_body(std::uint64_t) {
    const std::string_view token = cursor_.next_token_across_lines();
    if (!token.empty()) {
      errors_.fail(say("there is more data than the header announces"), place(),
                   say("The header and the data do not belong together; export the mesh again."));
    }
  }

  static constexpr bool is_text = true;
  std::string_view next_lines() const { return cursor_.next_lines(); }
  void skip_lines(std::size_t bytes, std::size_t lines) { cursor_.skip_lines(bytes, lines); }

  Message place() const { return say("line %1", header_lines_ + cursor_.line_number()); }

 private:
  std::string_view next() {
    const std::string_view token = cursor_.next_token_across_lines();
    if (token.empty()) {
      errors_.truncated(say("%1 %2 of %3", element_->name, row_, element_->count), place());
    }
    return token;
  }

  ParseErrors errors_;
  TextCursor cursor_;
  std::size_t header_lines_;
  const PlyElement* element_ = nullptr;
  std::uint64_t row_ = 0;
};

/// Values in the byte order that the header names.
class PlyBinaryRows {
 public:
  PlyBinaryRows(const FileContent& file, const PlyHeader& header)
      : errors_(file),
        bytes_(mesh_text(file)),
        at_(header.body_offset),
        offset_(file.bytes.size() - bytes_.size()),
        swap_((header.encoding == PlyEncoding::big_endian) != (std::endian::native == std::endian::big)) {}

  void begin_row(const PlyElement& element, std::uint64_t row) {
    element_ = &element;
    row_ = row;
  }

  double number(PlyType type) {
    if (type == PlyType::float32) return static_cast<double>(take<float>());
    if (type == PlyType::float64) return take<double>();
    return static_cast<double>(integer(type));
  }

  double carried(PlyType type) { return number(type); }

  std::int64_t integer(PlyType type) {
    switch (type) {
      case PlyType::int8: return take<std::int8_t>();
      case PlyType::uint8: return take<std::uint8_t>();
      case PlyType::int16: return take<std::int16_t>();
      case PlyType::uint16: return take<std::uint16_t>();
      case PlyType::int32: return take<std::int32_t>();
      case PlyType::uint32: return take<std::uint32_t>();
      case PlyType::float32:
      case PlyType::float64: break;
    }
    errors_.fail(say("a fraction stands where a whole number should be"), place());
  }

  std::uint64_t list_length(const PlyProperty& list) {
    const std::int64_t length = integer(list.count_type);
    if (length < 0) errors_.fail(say("a list of %1 items", length), place());
    if (static_cast<std::uint64_t>(length) > (bytes_.size() - at_) / size_in_bytes(list.type)) {
      errors_.truncated(say("a list of %1 items", length), place());
    }
    return static_cast<std::uint64_t>(length);
  }

  void end_row() {}

  /// What follows is let pass if it is blank or too short for one more row; else the header's counts are wrong.
  void end_body(std::uint64_t least_row_bytes) {
    using namespace std::string_view_literals;
    const std::string_view rest = bytes_.substr(at_);
    if (rest.size() < least_row_bytes || rest.find_first_not_of("\0 \t\r\n"sv) == std::string_view::npos) return;
    errors_.fail(say("%1 bytes more than the header announces", rest.size()), place(),
                 say("The header and the data do not belong together; export the mesh again."));
  }

  static constexpr bool is_text = false;
  /// What is left, where numbers stand as this machine has them; else nothing.
  std::string_view native_bytes() const { return swap_ ? std::string_view() : bytes_.substr(at_); }
  void skip(std::size_t count) { at_ += count; }

  Message place() const { return say("byte %1", at_ + offset_); }

 private:
  template <class T>
  T take() {
    require(sizeof(T));
    char buffer[sizeof(T)];
    std::memcpy(buffer, bytes_.data() + at_, sizeof(T));
    if (swap_) {
      for (std::size_t i = 0; i < sizeof(T) / 2; ++i) std::swap(buffer[i], buffer[sizeof(T) - 1 - i]);
    }
    at_ += sizeof(T);
    return loaded<T>(buffer);
  }

  void require(std::uint64_t count) const {
    if (count > bytes_.size() - at_) {
      errors_.truncated(say("%1 %2 of %3", element_->name, row_, element_->count), place());
    }
  }

  ParseErrors errors_;
  std::string_view bytes_;
  std::size_t at_;
  std::size_t offset_;  // of bytes_ in the file
  bool swap_;
  const PlyElement* element_ = nullptr;
  std::uint64_t row_ = 0;
};

}  // namespace loopmend
