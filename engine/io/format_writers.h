// SPDX-License-Identifier: GPL-3.0-or-later
// Internal: how each of the formats is written, and what they share.
#pragma once

#include "io/gzip.h"
#include "io/write_mesh.h"
#include "io/written_rows.h"
#include "mesh/scan_attributes.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstdint>
#include <optional>
#include <ostream>
#include <string>
#include <string_view>
#include <utility>

namespace loopmend {

/// Gathers text and bytes and passes them on in large pieces. Numbers are the shortest that read back as the same bits.
class Output {
 public:
  /// @param gzip  null: not compressed
  Output(std::ostream& stream, GzipWriter* gzip) : stream_(stream), gzip_(gzip) {}
  /// To be called last.
  void finish() {
    pass_on();
    if (gzip_) gzip_->finish();
  }
  Output(const Output&) = delete;
  Output& operator=(const Output&) = delete;

  Output& operator<<(std::string_view text) {
    piece_ += text;
    if (piece_.size() > piece_size) pass_on();
    return *this;
  }
  Output& operator<<(char c) { return *this << std::string_view(&c, 1); }
  Output& operator<<(double value) { return number(value); }
  Output& operator<<(float value) { return number(value); }
  Output& operator<<(int value) { return number(value); }
  Output& operator<<(std::size_t value) { return number(value); }
  Output& operator<<(std::int64_t value) { return number(value); }

  /// The value's bytes, lowest first.
  template <class T>
  void little_endian(T value) {
    auto bytes = std::bit_cast<std::array<char, sizeof(T)>>(value);
    if constexpr (std::endian::native == std::endian::big) std::reverse(bytes.begin(), bytes.end());
    *this << std::string_view(bytes.data(), bytes.size());
  }

 private:
  static constexpr std::size_t piece_size = 1 << 16;

  template <class T>
  Output& number(T value) {
    char buffer[32];
    const auto result = std::to_chars(buffer, buffer + sizeof buffer, value);
    return *this << std::string_view(buffer, static_cast<std::size_t>(result.ptr - buffer));
  }

  void pass_on() {
    if (gzip_)
      gzip_->write(piece_);
    else
      stream_.write(piece_.data(), static_cast<std::streamsize>(piece_.size()));
    piece_.clear();
  }

  std::ostream& stream_;
  GzipWriter* gzip_;
  std::string piece_;
};

/// What the file held beside; an empty table where there is none.
const ScanAttributes& attributes_of(const TriangleSoup& soup);
bool has_rows(const CornerValues& values);
/// Whether texture coordinates of corners go into a PLY file: its faces may have a list of that name already.
bool writes_texture(const ScanAttributes& scan);
/// The two columns of points with texture coordinates, where corners have none; null: there are none.
std::pair<const AttributeColumn*, const AttributeColumn*> point_texture(const ScanAttributes& scan);
/// Whether PLY elements do: their numbers of vertices hold only while the points are where they were.
bool keeps_elements(const TriangleSoup& soup);
/// The names under a keyword; null: none.
const FaceNames* find_names(const ScanAttributes& scan, std::string_view keyword);
/// What a face is called under the keyword of `names`; −1: nothing.
int name_of(const FaceNames& names, const AttributeRow& row);
/// The place of the column that becomes the two bytes behind each facet of STL.
std::optional<std::size_t> find_stl_attribute(const ScanAttributes& scan);

/// The first remark of a PLY file that we write.
inline constexpr std::string_view remark_of_loopmend = "comment Loopmend";

void write_ply(Output& out, const TriangleSoup& soup, Encoding encoding);
void write_stl(Output& out, const TriangleSoup& soup, Encoding encoding);
void write_obj(Output& out, const TriangleSoup& soup);
void write_off(Output& out, const TriangleSoup& soup);

enum class GltfContainer {
  binary,  ///< .glb
  text     ///< .gltf, everything within
};
/// @param path  for messages. @throws WriteError for coordinates that no float holds, or more than 4 GB
void write_gltf(Output& out, const std::filesystem::path& path, const TriangleSoup& soup, GltfContainer container);
/// Where the nodes of a glTF file are put so that floats hold the coordinates; zero where they do so anyhow.
Vec3 gltf_shift(const TriangleSoup& soup);

void write_3mf(Output& out, const TriangleSoup& soup);
/// Whether faces have columns red, green and blue that 3MF holds.
bool has_face_colors(const ScanAttributes& scan);

enum class Format { ply, stl, obj, off, glb, gltf, three_mf, polydata };

/// By the extension. @throws WriteError for one that is not known.
Format format_of(const std::filesystem::path& path);

}  // namespace loopmend
