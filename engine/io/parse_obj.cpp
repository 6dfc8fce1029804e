// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/lone_places.h"
#include "io/parse_errors.h"
#include "io/polygon_soup.h"
#include "io/text_cursor.h"
#include "io/text_rows.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
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
  constexpr std::array<std::string_view, 15> words = {"vp",   "cstype", "deg", "bmat", "step",  "parm",  "trim", "hole",
                                                      "scrv", "sp",     "end", "con",  "ctech", "stech", "res"};
  return is_among(word, words);
}

/// Elements that are no faces; counted, because they are left out. ("call", which includes another file, is not known
/// on purpose: leaving it out would show a part of the mesh as if it were all.)
bool is_other_element(std::string_view word) {
  constexpr std::array<std::string_view, 9> words = {"l", "p", "curv", "curv2", "surf", "bsp", "bzp", "cdc", "cdp"};
  return is_among(word, words);
}

/// A keyword of some exporter's own: a word of letters. What looks like a damaged v or f, or includes another file, is none.
bool may_be_statement(std::string_view word) {
  const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
  return word.size() >= 3 && word != "call" && word != "csh" && std::all_of(word.begin(), word.end(), is_letter);
}

class ObjReader {
 public:
  explicit ObjReader(const FileContent& file) : errors_(file), cursor_(mesh_text(file), '#') {}

  PolygonSoup read() {
    for (read_runs(); cursor_.next_line(); read_runs()) {
      continues_ = false;
      const std::string_view word = next();
      if (!word.empty()) read_statement(word);
    }
    require_forward_references();
    lone_.finish(soup_, errors_);
    finish_colors();
    finish_corners(say("numbers of texture coordinates that are not there"), texture_, soup_.attributes.texture);
    finish_corners(say("numbers of normals that are not there"), normals_, soup_.attributes.normals);
    finish_names();
    for (const auto& [what, count] : asides_) count_not_kept(soup_.not_kept, say(what), count);
    return std::move(soup_);
  }

 private:
  /// As FaceNames has them, in the order in which they are written.
  static constexpr std::array<std::string_view, 4> kept_names = {"o", "g", "usemtl", "s"};

  struct Values {
    int dimension = 0;
    std::vector<std::array<double, 3>> all;
    std::vector<int> at;  ///< per corner so far, as far as one has any
  };

  struct NamesSoFar {
    std::vector<std::string> names;
    std::map<std::string, int> number;
    std::vector<int> of_face;  ///< so far, as far as one has any
    int now = -1;
  };

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
    } else if (word == "vt") {
      read_values(texture_, text_to_say("texture coordinates that are no numbers"));
    } else if (word == "vn") {
      read_values(normals_, text_to_say("normals that are no numbers"));
    } else if (is_naming(word)) {
      read_name(word);
      cursor_.skip_line();
    } else if (is_numeric_aside(word) || is_other_element(word)) {
      soup_.skipped_elements += is_other_element(word) ? 1 : 0;
      count_aside(kind_of(word));
      while (!next().empty()) {
      }
    } else if (word.substr(0, 2) == "//") {
      count_not_kept(soup_.oddities, say("comments that begin with //"));
      cursor_.skip_line();
    } else if (may_be_statement(word)) {
      count_not_kept(soup_.oddities, say("unknown statements"));
      cursor_.skip_line();
    } else {
      errors_.fail(say("%1 is not a statement of an OBJ file", in_quotes(word)), cursor_.place(),
                   say("The file is damaged or is something else under this name."));
    }
  }

  /// Many plain vertices or triangles one after the other: by several threads. Whatever is not so is left to the statements.
  void read_runs() {
    while (read_run_of_vertices() || read_run_of_triangles()) {
    }
  }

  std::size_t length_of_run(bool tried_in_vain, std::string_view keyword) {
    constexpr std::size_t worth_it = 1000;
    if (tried_in_vain || cursor_.line_number() < no_run_before_) return 0;
    if (cursor_.next_lines().substr(0, keyword.size()) != keyword) return 0;
    const std::size_t rows = count_rows(cursor_.next_lines(), keyword);
    if (rows >= worth_it && rows < std::numeric_limits<int>::max() / 3) return rows;
    no_run_before_ = cursor_.line_number() + rows;  // not to be counted again
    return 0;
  }

  bool read_run_of_vertices() {
    const std::size_t count = length_of_run(vertices_are_not_plain_, "v "), begin = soup_.points.size();
    if (count == 0 || begin + count > std::numeric_limits<int>::max()) return false;
    soup_.points.resize(begin + count);
    const auto keep = [&](std::size_t v, const double* numbers) {
      soup_.points[begin + v] = {numbers[0], numbers[1], numbers[2]};
      return soup_.points[begin + v].allFinite();
    };
    const auto bytes = read_rows(cursor_.next_lines(), count, 3, KeepRow(keep), "v ");
    if (bytes)
      cursor_.skip_lines(*bytes, count);
    else
      soup_.points.resize(begin);
    vertices_are_not_plain_ = !bytes;
    return bytes.has_value();
  }

  bool read_run_of_triangles() {
    const std::size_t count = length_of_run(faces_are_not_plain_, "f "), begin = soup_.corners.size();
    if (count == 0) return false;
    const auto known = static_cast<std::int64_t>(soup_.points.size());
    soup_.corners.resize(begin + 3 * count);
    const auto keep = [&](std::size_t f, const std::int64_t* numbers) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (numbers[c] < 1 || numbers[c] > known) return false;
        soup_.corners[begin + 3 * f + c] = static_cast<int>(numbers[c] - 1);
      }
      return true;
    };
    const auto bytes = read_rows(cursor_.next_lines(), count, 3, KeepIntegers(keep), "f ");
    faces_are_not_plain_ = !bytes;
    if (!bytes) {
      soup_.corners.resize(begin);
      return false;
    }
    for (NamesSoFar& names : names_) {
      if (names.now < 0) continue;
      names.of_face.resize(soup_.polygon_count(), -1);
      names.of_face.resize(soup_.polygon_count() + count, names.now);
    }
    soup_.close_triangles(count);
    cursor_.skip_lines(*bytes, count);
    return true;
  }

  /// What a statement without vertices or faces of ours gives; null for parts of one.
  static const char* kind_of(std::string_view word) {
    if (word == "vp") return text_to_say("points in parameter space");
    if (word == "l") return text_to_say("lines");
    if (word == "p") return text_to_say("points");
    return is_other_element(word) ? text_to_say("free-form curves and surfaces") : nullptr;
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

  /// Materials, groups, objects and smoothing groups hold for the faces that follow.
  void read_name(std::string_view word) {
    std::string name(cursor_.rest_with_comment());
    name.erase(0, name.find_first_not_of(" \t"));
    name.erase(name.find_last_not_of(" \t") + 1);
    if (word == "mtllib") {
      auto& libraries = soup_.attributes.material_libraries;
      if (!name.empty() && std::find(libraries.begin(), libraries.end(), name) == libraries.end())
        libraries.push_back(name);
      return;
    }
    const auto kept = std::find(kept_names.begin(), kept_names.end(), word);
    if (kept == kept_names.end()) return count_aside(text_to_say("display statements"));
    NamesSoFar& names = names_[kept - kept_names.begin()];
    const auto [known, is_new] = names.number.emplace(name, static_cast<int>(names.names.size()));
    if (is_new) names.names.push_back(name);
    names.now = known->second;
  }

  /// Numbers of a vt or vn. One that is none does not make the surface worse: it is 0, and counted.
  void read_values(Values& values, const char* what) {
    std::array<double, 3> numbers{};
    int size = 0;
    for (std::string_view token = next(); !token.empty(); token = next()) {
      const std::optional<double> value = parse_double(token);
      if (!value) count_aside(what);
      if (size < 3) numbers[size++] = value.value_or(0);
    }
    values.dimension = std::max(values.dimension, size);
    values.all.push_back(numbers);
  }

  /// A corner may name a value that is not there, or does not say one: it has none then.
  void finish_corners(const Message& lost, const Values& values, CornerValues& kept) {
    const int count = static_cast<int>(values.all.size());
    if (count == 0 || values.dimension == 0) return;
    kept.dimension = values.dimension;
    for (const auto& numbers : values.all)
      kept.values.insert(kept.values.end(), numbers.begin(), numbers.begin() + values.dimension);
    kept.at = values.at;
    kept.at.resize(soup_.corners.size(), -1);
    std::size_t wrong = 0;
    for (int& at : kept.at)
      if (at >= count) {
        at = -1;
        ++wrong;
      }
    count_not_kept(soup_.not_kept, lost, wrong);
  }

  void finish_names() {
    std::size_t unused = 0;
    for (std::size_t k = 0; k < kept_names.size(); ++k) {
      FaceNames names{std::string(kept_names[k]), std::move(names_[k].names), std::move(names_[k].of_face)};
      const std::set<int> used(names.of_face.begin(), names.of_face.end());
      unused += names.names.size() + used.count(-1) - used.size();
      if (names.of_face.empty()) continue;
      names.of_face.resize(soup_.polygon_count(), names_[k].now);
      soup_.attributes.names.push_back(std::move(names));
    }
    count_not_kept(soup_.not_kept, say("names of no face"), unused);
  }

  /// x y z; x y z w (w belongs to free-form curves); x y z r g b; x y z r g b a.
  void read_vertex() {
    std::array<double, 7> values{};
    std::size_t count = 0;
    for (std::string_view token = next(); !token.empty(); token = next()) {
      const std::optional<double> value = parse_double(token);
      if (!value) errors_.not_a_number(token, say("a coordinate"), cursor_.place());
      if (count == values.size()) fail_vertex_size();
      values[count++] = *value;
    }
    if (count < 3 || count == 5) fail_vertex_size();
    if (soup_.points.size() == std::numeric_limits<int>::max()) errors_.fail(say("more than 2147483647 vertices"), {});
    const int vertex = static_cast<int>(soup_.points.size());
    const Vec3 point = lone_.checked({values[0], values[1], values[2]}, vertex, soup_.points.size() + 1,
                                     [&] { return cursor_.place(); });
    if (count >= 6) remember_color({values[3], values[4], values[5], count == 7 ? values[6] : 1.0});
    soup_.points.push_back(point);
  }

  [[noreturn]] void fail_vertex_size() const {
    errors_.fail(say("vertex %1 does not have 3 coordinates (or 6 with a colour)", soup_.points.size() + 1),
                 cursor_.place(), say("Correct that line, or export the mesh again."));
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
    for (std::string_view token = next(); !token.empty(); token = next()) read_corner(token);
    const std::size_t size = soup_.corners.size() - begin;
    if (size < 3) {
      for (Values* values : {&texture_, &normals_})
        if (values->at.size() > begin) values->at.resize(begin);
      soup_.close_face(begin);
      return;
    }
    for (NamesSoFar& names : names_) {
      if (names.now < 0) continue;
      names.of_face.resize(soup_.polygon_count(), -1);
      names.of_face.push_back(names.now);
    }
    soup_.close_polygon();
  }

  /// a, a/b, a//c or a/b/c: vertex, texture coordinates, normal; a negative one counts back from the last so far.
  void read_corner(std::string_view token) {
    const std::string_view first = token.substr(0, token.find('/'));
    const std::optional<std::int64_t> index = parse_integer(first);
    const std::optional<std::array<std::int64_t, 2>> tail = tail_of(token.substr(first.size()));
    if (!index || !tail) errors_.not_a_number(token, say("a vertex index"), cursor_.place());
    const auto known = static_cast<std::int64_t>(soup_.points.size());
    if (*index == 0 || *index < -known || *index > std::numeric_limits<int>::max()) fail_index(*index, known);
    const std::int64_t vertex = *index > 0 ? *index - 1 : known + *index;
    if (vertex >= known && vertex > farthest_.vertex) {
      farthest_ = {vertex, soup_.polygon_count() + 1, cursor_.line_number()};
    }
    note_corner(texture_, (*tail)[0]);
    note_corner(normals_, (*tail)[1]);
    soup_.corners.push_back(static_cast<int>(vertex));
  }

  /// "", "/b", "//c" or "/b/c", each number possibly left out: 0 then.
  static std::optional<std::array<std::int64_t, 2>> tail_of(std::string_view tail) {
    std::array<std::int64_t, 2> numbers{};
    for (std::size_t part = 0; part < 2 && !tail.empty(); ++part) {
      tail.remove_prefix(1);
      const std::string_view text = tail.substr(0, tail.find('/'));
      if (const std::optional<std::int64_t> number = parse_integer(text))
        numbers[part] = *number;
      else if (!text.empty())
        return std::nullopt;
      tail.remove_prefix(text.size());
    }
    return tail.empty() ? std::optional(numbers) : std::nullopt;
  }

  /// Called before the corner itself is noted. @param number  from 1, or back from the last; 0: none
  void note_corner(Values& values, std::int64_t number) {
    if (number == 0) return;
    const std::int64_t place = number > 0 ? number - 1 : static_cast<std::int64_t>(values.all.size()) + number;
    const bool is_place = place >= 0 && place < std::numeric_limits<int>::max();
    values.at.resize(soup_.corners.size(), -1);
    values.at.push_back(is_place ? static_cast<int>(place) : std::numeric_limits<int>::max());
  }

  [[noreturn]] void fail_index(std::int64_t index, std::int64_t known) const {
    errors_.bad_index(soup_.polygon_count() + 1, index,
                      index == 0 ? say("OBJ counts from 1") : say("there are %1 before it", known), cursor_.place());
  }

  /// A face may stand before its vertices; at the end they must be there.
  void require_forward_references() const {
    const auto count = static_cast<std::int64_t>(soup_.points.size());
    if (farthest_.vertex < count) return;
    errors_.bad_index(farthest_.face, farthest_.vertex + 1, say("there are %1", count), say("line %1", farthest_.line));
  }

  struct Reference {
    std::int64_t vertex = -1;
    std::size_t face = 0;
    std::size_t line = 0;
  };

  ParseErrors errors_;
  TextCursor cursor_;
  bool vertices_are_not_plain_ = false, faces_are_not_plain_ = false;
  std::size_t no_run_before_ = 0;  // a line
  bool continues_ = false;         // the last token was followed by a backslash at the end of the line
  LonePlaces lone_;
  PolygonSoup soup_;
  std::vector<std::pair<std::size_t, std::array<double, 4>>> colors_;  // vertex; red, green, blue, alpha
  double color_scale_ = 1.0;
  std::vector<std::pair<const char*, std::size_t>> asides_;
  Values texture_, normals_;
  std::array<NamesSoFar, kept_names.size()> names_;
  Reference farthest_;  // the highest index that was not yet there when it was named
};

}  // namespace

PolygonSoup parse_obj(const FileContent& file) { return ObjReader(file).read(); }

}  // namespace loopmend
