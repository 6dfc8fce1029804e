// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh format beside those of engine/io, reader and writer: docs/dev/add_a_format.md, "Add a mesh format".
#include "io/atomic_file.h"
#include "io/io_test_support.h"
#include "io/not_kept.h"
#include "io/parse_errors.h"
#include "io/polygon_soup.h"
#include "io/text_cursor.h"
#include "mesh/triangulate_polygon.h"
#include "pipeline/fill_holes.h"
#include "samples/analytic_surfaces.h"
#include "samples/mesh_facts.h"

#include <gtest/gtest.h>

#include <charconv>
#include <limits>
#include <optional>
#include <ostream>
#include <string>
#include <utility>

namespace loopmend {
namespace {

/// Medit text, ".mesh": sections of a keyword, a count and as many rows; indices from 1; a reference number ends each row.
class MeditReader {
 public:
  explicit MeditReader(const FileContent& file) : errors_(file), cursor_(mesh_text(file), '#') {}

  PolygonSoup read() {
    read_header();
    for (std::string_view word = next(); word != "End"; word = next()) read_section(word);
    if (!cursor_.next_token_across_lines().empty())
      errors_.fail(say("there is more data after \"End\""), cursor_.place());
    return std::move(soup_);
  }

 private:
  void read_header() {
    if (next() != "MeshVersionFormatted") errors_.fail(say("\"MeshVersionFormatted\" is missing"), cursor_.place());
    integer(say("the version"));
    if (next() != "Dimension" || integer(say("the dimension")) != 3)
      errors_.fail(say("only meshes of dimension 3 are supported"), cursor_.place(),
                   say("Export the surface alone, in space."));
  }

  void read_section(std::string_view keyword) {
    const std::string name(keyword);
    const std::int64_t rows = integer(say("the number of %1", name));
    const auto most = static_cast<std::int64_t>(cursor_.bytes_left() / 2);  // a digit and a separator
    if (rows < 0 || rows > most) errors_.too_many(verbatim(name), rows, cursor_.place());
    for (std::int64_t row = 0; row < rows; ++row) {
      if (name == "Vertices")
        read_vertex();
      else if (name == "Triangles")
        read_face(3);
      else if (name == "Quadrilaterals")
        read_face(4);
      else
        skip_row();
    }
    if (name == "Vertices" || name == "Triangles" || name == "Quadrilaterals") return;
    soup_.skipped_elements += static_cast<std::size_t>(rows);
    count_not_kept(soup_.not_kept, verbatim(name), static_cast<std::size_t>(rows));
  }

  void read_vertex() {
    Vec3 point;
    for (double& x : point) {
      const std::string_view token = next();
      const std::optional<double> value = parse_double(token);
      if (!value) errors_.not_a_number(token, say("a coordinate"), cursor_.place());
      x = *value;
    }
    if (!point.allFinite()) errors_.not_finite(soup_.points.size(), cursor_.place());
    if (soup_.points.size() == most_points) errors_.fail(say("more than 2147483647 vertices"), cursor_.place());
    soup_.points.push_back(point);
    read_reference(say("vertex references"));
  }

  void read_face(int size) {
    const auto count = static_cast<std::int64_t>(soup_.points.size());
    for (int corner = 0; corner < size; ++corner) {
      const std::int64_t index = integer(say("a vertex index"));
      if (index < 1 || index > count)
        errors_.bad_index(soup_.polygon_count(), index, say("there are %1, from 1 on", count), cursor_.place());
      soup_.corners.push_back(static_cast<int>(index - 1));
    }
    soup_.close_polygon();
    read_reference(say("face references"));
  }

  /// The number of a material or a part; 0 where there is none.
  void read_reference(const Message& what) {
    if (integer(say("a reference number")) != 0) count_not_kept(soup_.not_kept, what);
  }

  void skip_row() {
    next();
    cursor_.skip_line();
  }

  std::string_view next() {
    const std::string_view token = cursor_.next_token_across_lines();
    if (token.empty()) errors_.truncated(say("a section; \"End\" is missing"), cursor_.place());
    return token;
  }

  std::int64_t integer(const Message& what) {
    const std::string_view token = next();
    const std::optional<std::int64_t> value = parse_integer(token);
    if (!value) errors_.not_a_number(token, what, cursor_.place());
    return *value;
  }

  static constexpr std::size_t most_points = std::numeric_limits<int>::max();

  ParseErrors errors_;
  TextCursor cursor_;
  PolygonSoup soup_;
};

PolygonSoup parse_medit(const FileContent& file) { return MeditReader(file).read(); }

/// The shortest text that reads back as the same bits, whatever the locale.
std::string shortest(double value) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

void write_medit(std::ostream& out, const TriangleSoup& soup) {
  out << "MeshVersionFormatted 2\nDimension 3\nVertices " << std::to_string(soup.points.size()) << '\n';
  for (const Vec3& p : soup.points) out << shortest(p[0]) << ' ' << shortest(p[1]) << ' ' << shortest(p[2]) << " 0\n";
  out << "Triangles " << std::to_string(soup.triangles.size()) << '\n';
  for (const Triangle& t : soup.triangles)
    out << std::to_string(t[0] + 1) << ' ' << std::to_string(t[1] + 1) << ' ' << std::to_string(t[2] + 1) << " 0\n";
  out << "End\n";
}

TriangleSoup read_medit_file(const std::filesystem::path& path) {
  PolygonSoup polygons = parse_medit(load_file(path));
  TriangleSoup soup;
  soup.points = std::move(polygons.points);
  for (std::size_t k = 0; k < polygons.polygon_count(); ++k)
    triangulate_polygon(soup.points, polygons.polygon(k), soup.triangles);
  return soup;
}

void write_medit_file(const std::filesystem::path& path, const TriangleSoup& soup) {
  write_file_atomically(path, [&](std::ostream& out) { write_medit(out, soup); });
}

/// A square of side 1 with a quadrilateral and two triangles on an edge of it, and what the engine has no room for.
const std::string small_file =
    "MeshVersionFormatted 1\n"
    "# a comment\n"
    "Dimension\n3\n"
    "Vertices\n6\n0 0 0 0\n1 0 0 0\n1 1 0 7\n0 1 0 0\n2 0 0 0\n2 1 0 0\n"
    "Quadrilaterals 1\n1 2 3 4 5\n"
    "Triangles 2\n2 5 6 0\n2 6 3 0\n"
    "Edges 1\n1 2 0\n"
    "Corners 2\n1\n5\n"
    "End\n";

TEST(AddAFormat, FacesAreReadAndTheRestIsCounted) {
  const PolygonSoup soup = parse_medit({"a.mesh", small_file});
  ASSERT_EQ(soup.points.size(), 6u);
  EXPECT_EQ(soup.points[5], Vec3(2, 1, 0));
  ASSERT_EQ(soup.polygon_count(), 3u);
  EXPECT_EQ(soup.corners, (std::vector<int>{0, 1, 2, 3, 1, 4, 5, 1, 5, 2}));
  EXPECT_EQ(soup.skipped_elements, 3u);
  EXPECT_EQ(to_string(soup.not_kept), "vertex references (1), face references (1), Edges (1), Corners (2)");
}

TEST(AddAFormat, AFileCutOffAnywhereIsRefused) {
  const std::size_t last = small_file.size() - 1;  // without the last line end it is complete
  EXPECT_EQ(parse_medit({"a.mesh", small_file.substr(0, last)}).polygon_count(), 3u);
  for (std::size_t size = 0; size < last; ++size)
    EXPECT_THROW(parse_medit({"a.mesh", small_file.substr(0, size)}), ReadError) << size;
}

void expect_refused(const std::string& from, const std::string& to, const std::string& words) {
  std::string text = small_file;
  text.replace(text.find(from), from.size(), to);
  try {
    parse_medit({"a.mesh", text});
    ADD_FAILURE() << "was read with " << to;
  } catch (const ReadError& error) {
    EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
  }
}

TEST(AddAFormat, AFaultIsNamedWithItsLine) {
  expect_refused("2 5 6 0", "2 5 7 0", "face 1 names vertex 7, but there are 6, from 1 on (line 16)");
  expect_refused("2 5 6 0", "0 5 6 0", "face 1 names vertex 0");
  expect_refused("1 1 0 7", "1 nan 0 7", "vertex 2 has a coordinate that is not a finite number (line 9)");
  expect_refused("1 1 0 7", "1 1,5 0 7", "\"1,5\" stands where a coordinate should be (line 9)");
  expect_refused("Vertices\n6", "Vertices\n600000000", "announces 600000000 Vertices");
  expect_refused("Dimension\n3", "Dimension\n2", "dimension 3");
  expect_refused("End\n", "End\n1\n", "more data");
}

TEST(AddAFormat, WritingAndReadingKeepsEveryBit) {
  const TemporaryFolder folder;
  const TriangleSoup soup = awkward_soup();
  write_medit_file(folder / "a.mesh", soup);
  const TriangleSoup back = read_medit_file(folder / "a.mesh");
  EXPECT_TRUE(same_bits(back.points, soup.points));
  EXPECT_EQ(back.triangles, soup.triangles);
}

TEST(AddAFormat, AHoleInAFileIsFilled) {
  const TemporaryFolder folder;
  const TriangleSoup open = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.8; });
  write_medit_file(folder / "open.mesh", open);
  SurfaceModel model = make_surface_model(read_medit_file(folder / "open.mesh"));
  ASSERT_EQ(find_boundary_loops(model).size(), 1u);
  fill_all_holes(model);
  write_medit_file(folder / "closed.mesh", model.soup);
  const test::MeshFacts closed = test::mesh_facts(read_medit_file(folder / "closed.mesh"));
  EXPECT_TRUE(closed.loops.empty());
  EXPECT_TRUE(closed.oriented);
  EXPECT_EQ(closed.euler_characteristic(), 2);
}

}  // namespace
}  // namespace loopmend
