// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/lone_places.h"
#include "io/parse_errors.h"
#include "io/polygon_soup.h"
#include "io/text_cursor.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace loopmend {

namespace {

class OffReader {
 public:
  explicit OffReader(const FileContent& file) : errors_(file), cursor_(mesh_text(file), '#') {}

  PolygonSoup read() {
    read_header();
    soup_.points.reserve(vertex_count_);
    for (std::uint64_t v = 0; v < vertex_count_; ++v) read_vertex(v);
    for (std::uint64_t f = 0; f < face_count_; ++f) read_face(f);
    if (!cursor_.next_token_across_lines().empty()) {
      errors_.fail(say("there is more data than the header announces"), cursor_.place(),
                   say("The header and the data do not belong together; export the mesh again."));
    }
    lone_.finish(soup_, errors_);
    finish_colors();
    keep_face_colors();
    return std::move(soup_);
  }

 private:
  /// [ST][C][N]OFF, then the numbers of vertices, faces and (often left out) edges.
  void read_header() {
    std::string_view token = cursor_.next_token_across_lines();
    const std::string upper = upper_off_keyword(token);
    if (upper != token) {
      count_not_kept(soup_.oddities, say("keyword in lower case"));
      token = upper;
    }
    const std::size_t keyword = token.find("OFF");
    if (keyword != std::string_view::npos) {
      read_prefix(token.substr(0, keyword));
      token.remove_prefix(keyword + 3);
      if (token.empty()) token = cursor_.next_token_across_lines();
    }
    if (equals_ignoring_case(token, "BINARY")) {
      errors_.fail(say("binary OFF is not supported"), cursor_.place(), say("Save it as text OFF, or as PLY."));
    }
    vertex_count_ = count(token, say("the number of vertices"));
    face_count_ = count(cursor_.next_token_across_lines(), say("the number of faces"));
    const std::string_view edges = cursor_.next_token();
    if (!edges.empty()) count(edges, say("the number of edges"));
    require_line_end();
    // At the least: "0 0 0" and "3 0 0 0", each with a separator.
    const std::uint64_t bytes = cursor_.bytes_left() + 1;
    if (vertex_count_ > bytes / 6) errors_.too_many(say("vertices"), vertex_count_, cursor_.place());
    if (face_count_ > bytes / 8) errors_.too_many(say("faces"), face_count_, cursor_.place());
    if (vertex_count_ > std::numeric_limits<int>::max())
      errors_.fail(say("more than 2147483647 vertices"), cursor_.place());
  }

  void read_prefix(std::string_view prefix) {
    if (prefix.find_first_of("4n") != std::string_view::npos) {
      errors_.fail(say("vertices with other than 3 coordinates are not supported"), cursor_.place(),
                   say("Export the mesh as plain OFF."));
    }
    has_normals_ = prefix.find('N') != std::string_view::npos;
    has_texture_ = prefix.substr(0, 2) == "ST";
    for (const char* name : {"nx", "ny", "nz"})
      if (has_normals_) soup_.attributes.points.emplace_back(name, ScalarType::float64);
    for (const char* name : {"s", "t"})
      if (has_texture_) soup_.attributes.points.emplace_back(name, ScalarType::float64);
  }

  std::uint64_t count(std::string_view token, const Message& what) const {
    const std::optional<std::int64_t> number = parse_integer(token);
    if (!number || *number < 0) errors_.not_a_number(token, what, cursor_.place());
    return static_cast<std::uint64_t>(*number);
  }

  double number(std::string_view token, const Message& what) const {
    const std::optional<double> value = parse_double(token);
    if (!value) errors_.not_a_number(token, what, cursor_.place());
    return *value;
  }

  /// Steps to the next line that holds anything and returns its first token.
  std::string_view first_of_row(const char* kind, std::uint64_t row, std::uint64_t rows) {
    const std::string_view token = cursor_.next_token_across_lines();
    if (token.empty()) {
      errors_.truncated(say("%1 %2 of %3", std::string(kind), row, rows), cursor_.place());
    }
    return token;
  }

  void require_line_end() {
    const std::string_view token = cursor_.next_token();
    if (token.empty()) return;
    errors_.fail(say("%1 is more than this line should hold", in_quotes(token)), cursor_.place(),
                 say("Correct that line, or export the mesh again."));
  }

  /// One line: x y z [normal] [r g b [a]] [texture]; what stands in brackets as the keyword says.
  void read_vertex(std::uint64_t v) {
    Vec3 point;
    std::string_view token = first_of_row("vertex", v, vertex_count_);
    for (double& x : point) {
      x = number(token, say("a coordinate"));
      token = cursor_.next_token();
    }
    soup_.points.push_back(lone_.checked(point, static_cast<int>(v), v, [&] { return cursor_.place(); }));

    std::array<double, 9> extras{};  // normal 3, colour 4, texture 2
    std::size_t size = 0;
    for (; !token.empty() && size < extras.size(); token = cursor_.next_token()) {
      extras[size++] = number(token, say("a number"));
    }
    if (!token.empty()) fail_vertex_line();
    const std::size_t normal = has_normals_ ? 3 : 0;
    const std::size_t texture = has_texture_ ? 2 : 0;
    if (size < normal + texture) fail_vertex_line();
    for (std::size_t k = 0; k < normal; ++k) soup_.attributes.points[k].push(extras[k]);
    for (std::size_t k = 0; k < texture; ++k) soup_.attributes.points[normal + k].push(extras[size - texture + k]);
    read_color(&extras[normal], size - normal - texture);
  }

  /// Plain OFF files with colours are common enough: the number of values decides, not the keyword.
  void read_color(const double* values, std::size_t size) {
    if (size == 0) return;
    if (size != 3 && size != 4) fail_vertex_line();
    for (std::size_t c = 0; c < size; ++c) {
      if (!std::isfinite(values[c])) return;
      if (values[c] > 1.0) color_scale_ = 255.0;
    }
    std::array<double, 4> channels = {values[0], values[1], values[2], 0.0};
    if (size == 4) channels[3] = values[3];
    colors_.push_back({soup_.points.size() - 1, channels, size == 4});
  }

  void finish_colors() {
    if (colors_.empty()) return;
    soup_.colors.assign(soup_.points.size(), opaque_white);
    soup_.missing_colors = soup_.points.size() - colors_.size();
    for (const VertexColor& source : colors_) {
      Color& color = soup_.colors[source.vertex];
      for (std::size_t c = 0; c < (source.has_alpha ? 4U : 3U); ++c)
        color[c] = color_channel(source.channels[c], color_scale_);
    }
  }

  [[noreturn]] void fail_vertex_line() const {
    errors_.fail(say("vertex %1 has a wrong number of values", soup_.points.size() - 1), cursor_.place(),
                 say("Correct that line, or export the mesh again."));
  }

  /// One line: the number of corners, the corners, and a colour specification of up to four numbers.
  void read_face(std::uint64_t f) {
    const std::uint64_t size = count(first_of_row("face", f, face_count_), say("the number of a face's corners"));
    const std::size_t begin = soup_.corners.size();
    for (std::uint64_t i = 0; i < size; ++i) {
      const std::string_view token = cursor_.next_token();
      const std::optional<std::int64_t> index = parse_integer(token);
      if (!index) errors_.not_a_number(token, say("a vertex index"), cursor_.place());
      if (*index < 0 || static_cast<std::uint64_t>(*index) >= vertex_count_) {
        errors_.bad_index(f, *index, say("there are %1, from 0 on", vertex_count_), cursor_.place());
      }
      soup_.corners.push_back(static_cast<int>(*index));
    }
    const bool is_face = soup_.close_face(begin);
    for (int extra = 0; extra < 4; ++extra) {
      const std::string_view token = cursor_.next_token();
      if (!token.empty()) face_colors_.push_item(number(token, say("a colour")));
    }
    face_colors_.end_list();
    if (!is_face) face_colors_.pop_row();
    require_line_end();
  }

  /// Up to four numbers for each face, as they are: an index into a colour map, or red, green, blue and alpha.
  void keep_face_colors() {
    for (std::size_t f = 0; f < face_colors_.rows(); ++f)
      if (face_colors_.items(f) > 0) {
        soup_.attributes.faces.push_back(std::move(face_colors_));
        return;
      }
  }

  struct VertexColor {
    std::size_t vertex;
    std::array<double, 4> channels;
    bool has_alpha;
  };

  ParseErrors errors_;
  TextCursor cursor_;
  LonePlaces lone_;
  PolygonSoup soup_;
  std::uint64_t vertex_count_ = 0;
  std::uint64_t face_count_ = 0;
  bool has_normals_ = false;
  bool has_texture_ = false;
  AttributeColumn face_colors_{"color", ScalarType::float64, ScalarType::uint8};
  std::vector<VertexColor> colors_;
  double color_scale_ = 1.0;
};

}  // namespace

PolygonSoup parse_off(const FileContent& file) { return OffReader(file).read(); }

}  // namespace loopmend
