// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/ply_header.h"

#include "io/parse_errors.h"
#include "io/text_cursor.h"

#include <array>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace loopmend {

namespace {

std::optional<PlyType> ply_type(std::string_view word) {
  constexpr std::array<std::pair<std::string_view, PlyType>, 16> names = {{{"char", PlyType::int8},
                                                                           {"int8", PlyType::int8},
                                                                           {"uchar", PlyType::uint8},
                                                                           {"uint8", PlyType::uint8},
                                                                           {"short", PlyType::int16},
                                                                           {"int16", PlyType::int16},
                                                                           {"ushort", PlyType::uint16},
                                                                           {"uint16", PlyType::uint16},
                                                                           {"int", PlyType::int32},
                                                                           {"int32", PlyType::int32},
                                                                           {"uint", PlyType::uint32},
                                                                           {"uint32", PlyType::uint32},
                                                                           {"float", PlyType::float32},
                                                                           {"float32", PlyType::float32},
                                                                           {"double", PlyType::float64},
                                                                           {"float64", PlyType::float64}}};
  for (const auto& [name, type] : names) {
    if (name == word) return type;
  }
  return std::nullopt;
}

/// Reads the header line by line; each member function one kind of line.
class HeaderReader {
 public:
  explicit HeaderReader(const FileContent& file) : errors_(file), text_(mesh_text(file)), cursor_(text_) {}

  PlyHeader read() {
    cursor_.next_line();
    while (cursor_.next_token() != "ply") {  // blank lines before it are all that detect_format lets through
      if (!cursor_.next_line()) errors_.fail(say("does not begin with \"ply\""), say("byte 0"));
    }
    while (cursor_.next_line()) {
      const std::string_view word = cursor_.next_token();
      if (word == "end_header") return finish();
      read_line(word);
    }
    errors_.truncated(say("the header: there is no \"end_header\""), cursor_.place());
  }

 private:
  void read_line(std::string_view word) {
    if (word.empty()) return;
    if (word == "comment" || word == "obj_info") {
      header_.remarks.push_back(std::string(word) + std::string(cursor_.rest_of_line()));
      return;
    }
    if (word == "format") {
      read_format();
    } else if (word == "element") {
      read_element();
    } else if (word == "property") {
      read_property();
    } else {
      errors_.fail(say("%1 is not a word of a PLY header", in_quotes(word)), cursor_.place(),
                   say("The file is damaged or is something else under this name."));
    }
  }

  void read_format() {
    const std::string_view encoding = cursor_.next_token();
    const std::string_view version = cursor_.next_token();
    if (encoding == "ascii") {
      header_.encoding = PlyEncoding::ascii;
    } else if (encoding == "binary_little_endian") {
      header_.encoding = PlyEncoding::little_endian;
    } else if (encoding == "binary_big_endian") {
      header_.encoding = PlyEncoding::big_endian;
    } else {
      errors_.fail(say("unknown PLY format %1", in_quotes(encoding)), cursor_.place());
    }
    if (version != "1.0") errors_.fail(say("unknown PLY version %1", in_quotes(version)), cursor_.place());
    if (has_format_) errors_.fail(say("a second format line"), cursor_.place());
    has_format_ = true;
  }

  void read_element() {
    PlyElement element;
    element.name = cursor_.next_token();
    element.place = cursor_.place();
    const std::string_view count = cursor_.next_token();
    const std::optional<std::int64_t> number = parse_integer(count);
    if (element.name.empty() || !number || *number < 0)
      errors_.not_a_number(count, say("a count of elements"), cursor_.place());
    if (!element_names_.insert(element.name).second)
      errors_.fail(say("a second element %1", in_quotes(element.name)), cursor_.place());
    element.count = static_cast<std::uint64_t>(*number);
    header_.elements.push_back(std::move(element));
    property_names_.clear();
  }

  void read_property() {
    if (header_.elements.empty()) errors_.fail(say("a property before any element"), cursor_.place());
    PlyProperty property;
    std::string_view word = cursor_.next_token();
    if (word == "list") {
      property.is_list = true;
      property.count_type = require_type(cursor_.next_token());
      if (!is_integer(property.count_type)) errors_.fail(say("a list counted by a fraction"), cursor_.place());
      word = cursor_.next_token();
    }
    property.type = require_type(word);
    property.name = cursor_.next_token();
    if (property.name.empty()) errors_.fail(say("a property without a name"), cursor_.place());
    if (!property_names_.insert(property.name).second)
      errors_.fail(say("a second property %1", in_quotes(property.name)), cursor_.place());
    header_.elements.back().properties.push_back(std::move(property));
  }

  PlyType require_type(std::string_view word) {
    const std::optional<PlyType> type = ply_type(word);
    if (!type) errors_.fail(say("unknown PLY type %1", in_quotes(word)), cursor_.place());
    return *type;
  }

  PlyHeader finish() {
    if (!has_format_) errors_.fail(say("the header has no format line"), cursor_.place());
    header_.body_offset = body_offset();
    header_.lines = cursor_.line_number();
    const std::uint64_t bytes = text_.size() - header_.body_offset;
    for (const PlyElement& element : header_.elements) {
      const std::uint64_t row = element.least_row_bytes(header_.encoding);
      // The last row of a text needs no line end: hence the one byte more.
      const bool too_many = row == 0 ? false : element.count > (bytes + 1) / row;
      if (too_many) errors_.too_many(say("rows of %1", in_quotes(element.name)), element.count, element.place);
    }
    return std::move(header_);
  }

  /// Where a file has lone \r as line ends, a \n after the last of them belongs to the data.
  std::size_t body_offset() const {
    const std::size_t next = cursor_.next_line_offset();
    const std::size_t first_end = text_.find_first_of("\r\n");
    const bool lone_returns = text_[first_end] == '\r' && text_[first_end + 1] != '\n';
    const bool took_both = next >= 2 && text_[next - 1] == '\n' && text_[next - 2] == '\r';
    return lone_returns && took_both ? next - 1 : next;
  }

  ParseErrors errors_;
  std::string_view text_;
  TextCursor cursor_;
  PlyHeader header_;
  bool has_format_ = false;
  std::set<std::string> element_names_;
  std::set<std::string> property_names_;  ///< of the last element
};

}  // namespace

std::uint64_t PlyElement::least_row_bytes(PlyEncoding encoding) const {
  if (encoding == PlyEncoding::ascii) return 2 * properties.size();  // a digit and a separator each
  std::uint64_t bytes = 0;
  for (const PlyProperty& property : properties) {
    bytes += size_in_bytes(property.is_list ? property.count_type : property.type);
  }
  return bytes;
}

const PlyElement* PlyHeader::find(const std::string& name) const {
  for (const PlyElement& element : elements) {
    if (element.name == name) return &element;
  }
  return nullptr;
}

PlyHeader parse_ply_header(const FileContent& file) { return HeaderReader(file).read(); }

}  // namespace loopmend
