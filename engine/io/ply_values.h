// SPDX-License-Identifier: GPL-3.0-or-later
// Internal: how PLY names and writes numbers.
#pragma once

#include "io/format_writers.h"

#include <cstdint>
#include <utility>

namespace loopmend {

inline const char* ply_name(ScalarType type) {
  switch (type) {
    case ScalarType::int8: return "char";
    case ScalarType::uint8: return "uchar";
    case ScalarType::int16: return "short";
    case ScalarType::uint16: return "ushort";
    case ScalarType::int32: return "int";
    case ScalarType::uint32: return "uint";
    case ScalarType::float32: return "float";
    case ScalarType::float64: break;
  }
  return "double";
}

/// One value after the other in the types of a PLY file, binary or as text.
class PlyValues {
 public:
  PlyValues(Output& out, Encoding encoding) : out_(out), encoding_(encoding) {}

  void put(ScalarType type, double value) {
    if (encoding_ == Encoding::ascii) return put_text(type, value);
    switch (type) {
      case ScalarType::int8: return out_.little_endian(static_cast<std::int8_t>(value));
      case ScalarType::uint8: return out_.little_endian(static_cast<std::uint8_t>(value));
      case ScalarType::int16: return out_.little_endian(static_cast<std::int16_t>(value));
      case ScalarType::uint16: return out_.little_endian(static_cast<std::uint16_t>(value));
      case ScalarType::int32: return out_.little_endian(static_cast<std::int32_t>(value));
      case ScalarType::uint32: return out_.little_endian(static_cast<std::uint32_t>(value));
      case ScalarType::float32: return out_.little_endian(static_cast<float>(value));
      case ScalarType::float64: return out_.little_endian(value);
    }
  }

  /// A row of the column; without one, a list of none or a 0.
  void put(const AttributeColumn& column, bool has_row, std::size_t row) {
    const std::size_t items = has_row ? column.items(row) : (column.is_list() ? 0 : 1);
    if (column.is_list()) put(*column.count_type(), static_cast<double>(items));
    for (std::size_t k = 0; k < items; ++k) put(column.type(), has_row ? column.value(row, k) : 0);
  }

  void end_row() {
    if (encoding_ == Encoding::ascii) out_ << '\n';
    first_ = true;
  }

 private:
  void put_text(ScalarType type, double value) {
    if (!std::exchange(first_, false)) out_ << ' ';
    if (type == ScalarType::float32)
      out_ << static_cast<float>(value);
    else if (type == ScalarType::float64)
      out_ << value;
    else
      out_ << static_cast<std::int64_t>(value);
  }

  Output& out_;
  Encoding encoding_;
  bool first_ = true;
};

}  // namespace loopmend
