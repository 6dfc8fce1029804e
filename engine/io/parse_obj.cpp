// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/parse_errors.h"
#include "io/polygon_soup.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace loopmend {

namespace {

template <std::size_t Size>
bool is_among(std::string_view word, const std::array<std::string_view, Size>& words) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// Statements with a name after them: a backslash at their end is part of the name.
bool is_naming(std::string_view word) {
  constexpr std::array<std::string_view, 14> words = {"o",         "g",      "s",        "mg",      "usemtl",
                                                      "mtllib",    "usemap", "maplib",   "lod",     "shadow_obj",
                                                      "trace_obj", "bevel",  "c_interp", "d_interp"};
  return is_among(word, words);
}

/// Statements with numbers after them that are neither vertices nor faces.
bool is_numeric_aside(std::string_view word) {
  constexpr std::array<std::string_view, 17> words = {"vn",   "vt",   "vp",    "cstype", "deg",  "bmat",
                                                      "step", "parm", "trim",  "hole",   "scrv", "sp",
                                                      "end",  "con",  "ctech", "stech",  "res"};
  return is_among(word, words);
}

/// Elements that are no faces; counted, because they are left out. ("call", which includes another file, is not known
/// on purpose: leaving it out would show a part of the mesh as if it were all.)
bool is_other_element(std::string_view word) {
  constexpr std::array<std::string_view, 9> words = {"l", "p", "curv", "curv2", "surf", "bsp", "bzp", "cdc", "cdp"};
  return is_among(word, words);
}

class ObjReader {
 public:
  explicit ObjReader(const FileContent& file) : errors_(file), cursor_(mesh_text(file), '#') {}

  PolygonSoup read() {
    while (cursor_.next_line()) {
      continues_ = false;
      const std::string_view word = next();
      if (!word.empty()) read_statement(word);
    }
    require_forward_references();
    finish_colors();
    for (const auto& [what, count] : asides_) count_not_kept(soup_.not_kept, what, count);
    for (const auto& [what, names] : names_) count_not_kept(soup_.not_kept, what, names.size());
    return std::move(soup_);
  }

 private:
  /// The next token of a statement, which goes on in the next line after a backslash.
  std::string_view next() {
    for (;;) {
      if (continues_ && !cursor_.next_line()) return {};
      continues_ = false;
      std::string_view token = cursor_.next_token();
      if (token.empty() || token.back() != '\\' || !cursor_.at_line_end()) return token;
      continues_ = true;
      token.remove_suffix(1);
      if (!token.empty()) return token;
    }
  }

  void read_statement(std::string_view word) {
    if (word == "v") {
      read_vertex();
    } else if (word == "f" || word == "fo") {
      read_face();
    } else if (is_naming(word)) {
      remember_name(word);
      cursor_.skip_line();
    } else if (is_numeric_aside(word) || is_other_element(word)) {
      soup_.skipped_elements += is_other_element(word) ? 1 : 0;
      count_aside(kind_of(word));
      while (!next().empty()) {
      }
    } else {
      errors_.fail(in_quotes(word) + " is not a statement of an OBJ file", cursor_.place(),
                   "The file is damaged or is something else under this name.");
    }
  }

  /// What a statement without vertices or faces of ours gives; null for parts of one.
  static const char* kind_of(std::string_view word) {
    if (word == "vn") return "normals";
    if (word == "vt") return "texture coordinates";
    if (word == "vp") return "points in parameter space";
    if (word == "l") return "lines";
    if (word == "p") return "points";
    return is_other_element(word) ? "free-form curves and surfaces" : nullptr;
  }

  /// There may be as many of them as vertices: no text is made for each.
  void count_aside(const char* what) {
    if (what == nullptr) return;
    for (auto& [known, count] : asides_)
      if (std::string_view(known) == what) {
        ++count;
        return;
      }
    asides_.emplace_back(what, 1);
  }

  /// Groups, objects and materials are told by their names: each may be named many times.
  void remember_name(std::string_view word) {
    const char* what = word == "usemtl"                       ? "materials"
                       : word == "mtllib"                     ? "material libraries"
                       : word == "usemap" || word == "maplib" ? "texture maps"
                       : word == "o"                          ? "objects"
                       : word == "g"                          ? "groups"
                       : word == "s"                          ? "smoothing groups"
                                                              : nullptr;
    if (what == nullptr) return;
    std::string name;
    for (std::string_view token = cursor_.next_token(); !token.empty(); token = cursor_.next_token())
      name.append(name.empty() ? "" : " ").append(token);
    const bool none = word == "s" && (name == "off" || name == "0");
    if (none || name.empty()) return;
    const auto known =
        std::find_if(names_.begin(), names_.end(), [&](const auto& entry) { return entry.first == what; });
    (known != names_.end() ? *known : names_.emplace_back(what, std::set<std::string>())).second.insert(name);
  }

  /// x y z; x y z w (w belongs to free-form curves); x y z r g b; x y z r g b a.
  void read_vertex() {
    std::array<double, 7> values{};
    std::size_t count = 0;
    for (std::string_view token = next(); !token.empty(); token = next()) {
      const std::optional<double> value = parse_double(token);
      if (!value) errors_.not_a_number(token, "a coordinate", cursor_.place());
      if (count == values.size()) fail_vertex_size();
      values[count++] = *value;
    }
    if (count < 3 || count == 5) fail_vertex_size();
    if (soup_.points.size() == std::numeric_limits<int>::max()) errors_.fail("more than 2147483647 vertices", "");
    const Vec3 point(values[0], values[1], values[2]);
    if (!point.allFinite()) errors_.not_finite(soup_.points.size() + 1, cursor_.place());
    if (count >= 6) remember_color({values[3], values[4], values[5], count == 7 ? values[6] : 1.0});
    soup_.points.push_back(point);
  }

  [[noreturn]] void fail_vertex_size() const {
    errors_.fail(
        "vertex " + std::to_string(soup_.points.size() + 1) + " does not have 3 coordinates (or 6 with a colour)",
        cursor_.place(), "Correct that line, or export the mesh again.");
  }

  /// Colours wait until the end: only then is it known whether they are of 0..1 or of 0..255.
  void remember_color(const std::array<double, 4>& channels) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (!std::isfinite(channels[c])) return;
      if (channels[c] > 1.0) color_scale_ = 255.0;
    }
    colors_.emplace_back(soup_.points.size(), channels);
  }

  void finish_colors() {
    if (colors_.empty()) return;
    soup_.colors.assign(soup_.points.size(), opaque_white);
    soup_.missing_colors = soup_.points.size() - colors_.size();
    for (const auto& [vertex, channels] : colors_) {
      Color& color = soup_.colors[vertex];
      for (std::size_t c = 0; c < 3; ++c) color[c] = color_channel(channels[c], color_scale_);
      const double full_alpha = channels[3] > 1.0 ? 255.0 : 1.0;
      if (std::isfinite(channels[3])) color[3] = color_channel(channels[3], full_alpha);
    }
  }

  void read_face() {
    const std::size_t begin = soup_.corners.size();
    const std::string place = cursor_.place();
    for (std::string_view token = next(); !token.empty(); token = next()) read_corner(token);
    const std::size_t size = soup_.corners.size() - begin;
    if (size < 3) errors_.too_few_corners(soup_.polygon_count() + 1, size, place);
    soup_.close_polygon();
  }

  /// a, a/b, a//c or a/b/c, where only a matters; a negative a counts back from the last vertex so far.
  void read_corner(std::string_view token) {
    const std::string_view first = token.substr(0, token.find('/'));
    const std::optional<std::int64_t> index = parse_integer(first);
    if (!index || !has_good_tail(token.substr(first.size())))
      errors_.not_a_number(token, "a vertex index", cursor_.place());
    const auto known = static_cast<std::int64_t>(soup_.points.size());
    if (*index == 0 || *index < -known || *index > std::numeric_limits<int>::max()) fail_index(*index, known);
    const std::int64_t vertex = *index > 0 ? *index - 1 : known + *index;
    if (vertex >= known && vertex > farthest_.vertex) {
      farthest_ = {vertex, soup_.polygon_count() + 1, cursor_.line_number()};
    }
    soup_.corners.push_back(static_cast<int>(vertex));
  }

  /// "", "/b", "//c" or "/b/c", each number possibly left out.
  static bool has_good_tail(std::string_view tail) {
    for (int part = 0; part < 2 && !tail.empty(); ++part) {
      tail.remove_prefix(1);
      const std::string_view number = tail.substr(0, tail.find('/'));
      if (!number.empty() && !parse_integer(number)) return false;
      tail.remove_prefix(number.size());
    }
    return tail.empty();
  }

  [[noreturn]] void fail_index(std::int64_t index, std::int64_t known) const {
    errors_.bad_index(soup_.polygon_count() + 1, std::to_string(index),
                      index == 0 ? "OBJ counts from 1" : "there are " + std::to_string(known) + " before it",
                      cursor_.place());
  }

  /// A face may stand before its vertices; at the end they must be there.
  void require_forward_references() const {
    const auto count = static_cast<std::int64_t>(soup_.points.size());
    if (farthest_.vertex < count) return;
    errors_.bad_index(farthest_.face, std::to_string(farthest_.vertex + 1), "there are " + std::to_string(count),
                      "line " + std::to_string(farthest_.line));
  }

  struct Reference {
    std::int64_t vertex = -1;
    std::size_t face = 0;
    std::size_t line = 0;
  };

  ParseErrors errors_;
  TextCursor cursor_;
  bool continues_ = false;  // the last token was followed by a backslash at the end of the line
  PolygonSoup soup_;
  std::vector<std::pair<std::size_t, std::array<double, 4>>> colors_;  // vertex; red, green, blue, alpha
  double color_scale_ = 1.0;
  std::vector<std::pair<const char*, std::size_t>> asides_;
  std::vector<std::pair<std::string, std::set<std::string>>>
      names_;           // of materials, groups, ... in order of appearance
  Reference farthest_;  // the highest index that was not yet there when it was named
};

}  // namespace

PolygonSoup parse_obj(const FileContent& file) { return ObjReader(file).read(); }

}  // namespace loopmend
