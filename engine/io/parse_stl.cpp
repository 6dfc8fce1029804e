// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/first_occurrence.h"
#include "io/parse_errors.h"
#include "io/polygon_soup.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <vector>

namespace loopmend {

namespace {

constexpr std::size_t header_bytes = 84;
constexpr std::size_t facet_bytes = 50;

/// STL repeats a vertex in every facet: corners at the same place become one point, in order of first occurrence.
class Welder {
 public:
  explicit Welder(PolygonSoup& soup) : soup_(soup), first_(first_point_table(soup.points)) {}

  void add_corner(const Vec3& point) {
    const int index = static_cast<int>(soup_.points.size());
    soup_.points.push_back(point);
    const int first = first_.find_or_add(index);
    if (first != index) {
      soup_.points.pop_back();
      ++soup_.vertices_welded;
    }
    soup_.corners.push_back(first);
  }

 private:
  PolygonSoup& soup_;
  FirstPoint first_;
};

/// Text STL: words across lines, as the format has them; upper and lower case are the same.
class AsciiStl {
 public:
  explicit AsciiStl(const FileContent& file) : errors_(file), cursor_(mesh_text(file)), welder_(soup_) {}

  PolygonSoup read() {
    bool inside = false;
    FaceNames names{"solid", {}, {}};
    for (;;) {
      const std::string_view word = cursor_.next_token_across_lines();
      if (word.empty()) break;
      if (equals_ignoring_case(word, "solid")) {
        if (inside) count_not_kept(soup_.oddities, say(missing_end));
        inside = true;
        names.names.emplace_back(cursor_.rest_of_line());
        cursor_.skip_line();
      } else if (inside && equals_ignoring_case(word, "endsolid")) {
        inside = false;
        cursor_.skip_line();
      } else if (inside && equals_ignoring_case(word, "facet")) {
        read_facet();
        names.of_face.push_back(static_cast<int>(names.names.size()) - 1);
      } else if (is_remark(word)) {
        skip_remark();
      } else {
        fail_word(word, inside ? say("\"facet\" or \"endsolid\"") : verbatim("\"solid\""));
      }
    }
    if (inside) count_not_kept(soup_.oddities, say(missing_end));
    soup_.attributes.names.push_back(std::move(names));
    return std::move(soup_);
  }

 private:
  static constexpr const char* missing_end = text_to_say("missing \"endsolid\" (the file may be cut off)");

  void read_facet() {
    std::string_view word = next_word();
    if (equals_ignoring_case(word, "normal")) {
      for (int i = 0; i < 3; ++i) cursor_.next_token_across_lines();  // not needed: it follows from the corners
      word = next_word();
    }
    if (!equals_ignoring_case(word, "outer")) fail_word(word, verbatim(in_quotes("outer")));
    expect("loop");
    for (std::size_t corner = 0; corner < 3; ++corner) {
      expect("vertex");
      Vec3 point;
      for (double& x : point) x = coordinate();
      if (!point.allFinite()) errors_.not_finite(3 * soup_.polygon_count() + corner, cursor_.place());
      welder_.add_corner(point);
    }
    expect("endloop");
    skip_words_before("endfacet");
    expect("endfacet");
    skip_words_before("facet");
    soup_.close_polygon();
  }

  /// What some exporters write between the statements.
  static bool is_remark(std::string_view word) {
    constexpr std::array<std::string_view, 7> words = {"color",    "colour", "comment", "attribute",
                                                       "material", "name",   "units"};
    if (word.front() == '#' || word.front() == ';' || word.substr(0, 2) == "//") return true;
    return std::any_of(words.begin(), words.end(),
                       [&](std::string_view known) { return equals_ignoring_case(word, known); });
  }

  void skip_remark() {
    count_not_kept(soup_.oddities, say("remarks between the facets"));
    cursor_.skip_line();
  }

  /// The rest of the line, unless it goes on with the next statement.
  void skip_words_before(std::string_view statement) {
    TextCursor rest(cursor_.rest_of_line());
    if (!rest.next_line()) return;
    const std::string_view word = rest.next_token();
    if (word.empty() || equals_ignoring_case(word, statement) || equals_ignoring_case(word, "endsolid")) return;
    count_not_kept(soup_.oddities, say("words after \"endloop\" or \"endfacet\""));
    cursor_.skip_line();
  }

  double coordinate() {
    const std::string_view token = cursor_.next_token();
    const std::optional<double> value = parse_double(token);
    if (!value) errors_.not_a_number(token, say("a coordinate"), cursor_.place());
    return *value;
  }

  /// The next one within a facet that begins no remark.
  std::string_view next_word() {
    std::string_view word = cursor_.next_token_across_lines();
    while (!word.empty() && is_remark(word)) {
      skip_remark();
      word = cursor_.next_token_across_lines();
    }
    return word;
  }

  void expect(std::string_view word) {
    const std::string_view token = next_word();
    if (!equals_ignoring_case(token, word)) fail_word(token, verbatim(in_quotes(word)));
  }

  [[noreturn]] void fail_word(std::string_view word, const Message& expected) const {
    if (word.empty()) errors_.truncated(say("facet %1", soup_.polygon_count()), cursor_.place());
    errors_.fail(say("%1 stands where %2 should be", in_quotes(word), expected), cursor_.place(),
                 say("Correct that place, or export the mesh again."));
  }

  ParseErrors errors_;
  TextCursor cursor_;
  PolygonSoup soup_;
  Welder welder_;
};

std::uint32_t little_endian_word(const char* bytes) {
  std::uint32_t word = 0;
  for (int i = 3; i >= 0; --i) word = (word << 8) | static_cast<unsigned char>(bytes[i]);
  return word;
}

/// The announced number of facets must be there, and not many more.
std::size_t require_facet_count(const FileContent& file, const ParseErrors& errors, std::vector<NotKept>& oddities) {
  using namespace std::string_view_literals;
  const std::string_view bytes = file.bytes;
  if (bytes.size() < header_bytes)
    errors.truncated(say("the header of a binary STL file"), say("byte %1", bytes.size()));
  std::uint64_t count = little_endian_word(bytes.data() + 80);
  const std::uint64_t left = bytes.size() - header_bytes;
  if (count == 0 && left >= facet_bytes && left % facet_bytes == 0) {  // written before it was known
    count = left / facet_bytes;
    count_not_kept(oddities, say("count of triangles that is 0: taken from the file's size"));
  }
  const std::uint64_t needed = header_bytes + facet_bytes * count;
  if (bytes.size() < needed) {
    errors.fail(say("announces %1 triangles, which take %2 bytes, but the file has %3", count, needed, bytes.size()),
                say("byte 80"), say("It is incomplete or damaged; export or copy it again."));
  }
  const std::string_view rest = bytes.substr(needed);
  const bool is_blank = rest.find_first_not_of("\0 \t\r\n"sv) == std::string_view::npos;
  const bool is_small = rest.size() < std::max<std::uint64_t>(1000, needed / 10);
  if (!is_blank && is_small && rest.size() % facet_bytes != 0)
    count_not_kept(oddities, say("bytes after the last triangle, left out"), rest.size());
  else if (rest.size() >= facet_bytes && !is_blank) {
    errors.fail(say("announces %1 triangles, but %2 more bytes follow them", count, rest.size()), say("byte 80"),
                say("The count and the data do not belong together; export the mesh again."));
  }
  if (count > std::numeric_limits<int>::max() / 3) errors.fail(say("more than 715827882 triangles"), say("byte 80"));
  return count;
}

}  // namespace

PolygonSoup parse_stl_ascii(const FileContent& file) { return AsciiStl(file).read(); }

PolygonSoup parse_stl_binary(const FileContent& file) {
  const ParseErrors errors(file);
  PolygonSoup soup;
  const std::size_t count = require_facet_count(file, errors, soup.oddities);
  Welder welder(soup);
  soup.corners.reserve(3 * count);
  bool has_attributes = false;
  AttributeColumn attributes("attribute", ScalarType::uint16);
  attributes.reserve(count);
  for (std::size_t facet = 0; facet < count; ++facet) {
    const std::size_t corners_at = header_bytes + facet * facet_bytes + 12;  // after the normal
    for (std::size_t corner = 0; corner < 3; ++corner) {
      Vec3 point;
      const char* bytes = file.bytes.data() + corners_at + 12 * corner;
      for (double& x : point) {
        x = static_cast<double>(std::bit_cast<float>(little_endian_word(bytes)));
        bytes += 4;
      }
      if (!point.allFinite()) {
        errors.not_finite(3 * facet + corner, say("byte %1", corners_at + 12 * corner));
      }
      welder.add_corner(point);
    }
    soup.close_polygon();
    const std::size_t attribute_at = header_bytes + facet * facet_bytes + 48;
    const int low = static_cast<unsigned char>(file.bytes[attribute_at]);
    const int high = static_cast<unsigned char>(file.bytes[attribute_at + 1]);
    attributes.push(low + 256 * high);
    has_attributes = has_attributes || low + high > 0;
  }
  soup.attributes.header = file.bytes.substr(0, 80);
  if (has_attributes) soup.attributes.faces.push_back(std::move(attributes));
  return soup;
}

}  // namespace loopmend
