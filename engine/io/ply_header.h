// SPDX-License-Identifier: GPL-3.0-or-later
// The header of a PLY file: which elements follow, how many, and what each row holds.
#pragma once

#include "core/message.h"
#include "io/file_content.h"
#include "mesh/scan_attributes.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace loopmend {

enum class PlyEncoding { ascii, little_endian, big_endian };
using PlyType = ScalarType;

struct PlyProperty {
  std::string name;
  PlyType type = PlyType::float32;  ///< of a list: of its items
  bool is_list = false;
  PlyType count_type = PlyType::uint8;
};

struct PlyElement {
  std::string name;
  std::uint64_t count = 0;
  std::vector<PlyProperty> properties;
  Message place;  ///< "line 7", where it was announced

  /// The least that one row takes: every list empty.
  std::uint64_t least_row_bytes(PlyEncoding encoding) const;
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::ascii;
  std::vector<PlyElement> elements;
  std::vector<std::string> remarks;  ///< lines of comments and obj_info, whole
  std::size_t body_offset = 0;       ///< into mesh_text(file)
  std::size_t lines = 0;             ///< lines of the header, so that the body's can be numbered

  const PlyElement* find(const std::string& name) const;
};

/// Also checks that what is announced can be in a file of this size.
/// @throws ReadError naming the line.
PlyHeader parse_ply_header(const FileContent& file);

}  // namespace loopmend
