// SPDX-License-Identifier: GPL-3.0-or-later
// What the parsers of all formats hand over: points and polygons exactly as the file holds them.
#pragma once

#include "core/message.h"
#include "core/single_precision.h"
#include "core/types.h"
#include "io/file_content.h"
#include "io/not_kept.h"
#include "mesh/scan_attributes.h"

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

namespace loopmend {

/// Polygons of any size, stored flat. Indices are in range and coordinates finite when a parser returns.
struct PolygonSoup {
  Points points;
  std::vector<Color> colors;         ///< as many as points, or empty
  std::vector<int> corners;          ///< vertex indices of all polygons, one after the other
  std::vector<std::size_t> ends;     ///< per polygon: one past its last corner; empty while all are triangles
  std::size_t missing_colors = 0;    ///< vertices without a colour of their own in a file with colours
  std::size_t skipped_elements = 0;  ///< things that are neither vertex nor face: lines, points, edges
  std::vector<NotKept> not_kept;     ///< all that was read over, the skipped elements among it, by name
  std::vector<NotKept> oddities;     ///< what is not as the format has it, and no fault of the surface, by name
  std::size_t vertices_welded = 0;   ///< STL and glTF only
  ScanAttributes attributes;         ///< but for its counts and faces, which read_mesh adds

  std::size_t polygon_count() const { return count_; }
  bool has_only_triangles() const { return ends.empty(); }
  void close_polygon() {
    ++count_;
    if (ends.empty() && corners.size() == 3 * count_) return;
    for (std::size_t k = ends.size() + 1; k < count_; ++k) ends.push_back(3 * k);
    ends.push_back(corners.size());
  }
  /// The same for corners that make `count` triangles.
  void close_triangles(std::size_t count) {
    if (ends.empty())
      count_ += count;
    else
      for (; count > 0; --count) ends.push_back(ends.back() + 3), ++count_;
  }
  /// Of the corners from `begin` on; fewer than three enclose nothing: they go, counted. @returns whether there is a face
  bool close_face(std::size_t begin) {
    if (corners.size() - begin >= 3) {
      close_polygon();
      return true;
    }
    corners.resize(begin);
    count_not_kept(oddities, say("faces of fewer than three corners, left out"));
    return false;
  }
  std::span<const int> polygon(std::size_t k) const {
    if (ends.empty()) return {corners.data() + 3 * k, 3};
    const std::size_t begin = k == 0 ? 0 : ends[k - 1];
    return {corners.data() + begin, ends[k] - begin};
  }

 private:
  std::size_t count_ = 0;
};

inline constexpr Color opaque_white = {255, 255, 255, 255};

/// A colour channel from the number range that a file uses.
/// @param scale  what full intensity is in the file: 1, 255 or 65535. `value` must be finite; it is clamped.
inline unsigned char color_channel(double value, double scale) {
  const double scaled = std::round(value / scale * 255.0);
  return static_cast<unsigned char>(scaled < 0.0 ? 0.0 : (scaled > 255.0 ? 255.0 : scaled));
}

/// Each reads one whole file. @throws ReadError naming the place; a part of a file never comes back.
PolygonSoup parse_ply(const FileContent& file, FloatText float_text = FloatText::nearest_float);
PolygonSoup parse_stl_ascii(const FileContent& file);
PolygonSoup parse_stl_binary(const FileContent& file);
PolygonSoup parse_obj(const FileContent& file);
PolygonSoup parse_off(const FileContent& file);
PolygonSoup parse_gltf(const FileContent& file);
PolygonSoup parse_3mf(const FileContent& file);

}  // namespace loopmend
