// SPDX-License-Identifier: GPL-3.0-or-later
// PLY as scanners, libraries and modellers write it.
#include "exporter_variants.h"

#include <algorithm>
#include <cstdint>

namespace loopmend {
namespace exporters_ply {

const std::string head = "ply\nformat ascii 1.0\n";
const std::string xyz = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n";
const std::string list = "element face 2\nproperty list uchar int vertex_indices\n";
const std::string end = "end_header\n";
const std::string places = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";
const std::string faces = "3 0 1 2\n3 0 2 3\n";
const std::string plain = head + xyz + list + end + places + faces;

/// The square with further properties of its vertices, declared after z, and what stands in each row for them.
std::string vertices_with(const std::string& properties, const std::string& values) {
  return head + xyz + properties + list + end + around_lines(places, "", " " + values) + faces;
}

/// The same for faces.
std::string faces_with(const std::string& properties, const std::string& values) {
  return head + xyz + list + properties + end + places + around_lines(faces, "", " " + values);
}

enum class Order { little, big };

template <class T>
void append(std::string& bytes, T value, Order order) {
  std::string raw(reinterpret_cast<const char*>(&value), sizeof value);
  if (order == Order::big) std::reverse(raw.begin(), raw.end());
  bytes += raw;
}

/// The square's rows in binary.
/// @tparam Place, Count, Index  types of the coordinates, the lists' lengths and their items
template <class Place = float, class Count = std::uint8_t, class Index = std::int32_t>
std::string binary_rows(Order order = Order::little) {
  std::string bytes;
  for (const int x : {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) append(bytes, static_cast<Place>(x), order);
  for (const auto& face : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
    append(bytes, static_cast<Count>(3), order);
    for (const int v : face) append(bytes, static_cast<Index>(v), order);
  }
  return bytes;
}

std::string binary_head(Order order = Order::little) {
  return std::string("ply\nformat binary_") + (order == Order::big ? "big" : "little") + "_endian 1.0\n";
}

constexpr const char* lone = "vertices without a place that no face uses, now at the origin (1)";

std::vector<Variant> headers() {
  const std::string both = xyz + list;
  return {
      {"MeshLab", "a.ply",
       head + "comment VCGLIB generated\ncomment TextureFile a.png\n" + both + end + places + faces},
      {"CloudCompare, VTK", "a.ply",
       replaced_once(plain, "element vertex", "comment VTK generated PLY File\nobj_info vtkPolyData\nelement vertex")},
      {"Stanford: obj_info with numbers", "a.ply",
       replaced_once(plain, "element vertex",
                     "obj_info num_cols 512\nobj_info echo_rgb_offset_x 0.013\nelement vertex")},
      {"comment without a text", "a.ply", replaced_once(plain, "element vertex", "comment\nelement vertex")},
      {"comment before the format", "a.ply", replaced_once(plain, "format", "comment made by hand\nformat")},
      {"comments between the properties", "a.ply", replaced(plain, "property", "comment property char x\nproperty")},
      {"comment with the end of a header", "a.ply",
       replaced_once(plain, "element face", "comment end_header\nelement face")},
      {"comment in Latin-1", "a.ply",
       replaced_once(plain, "element vertex",
                     "comment L\xF6"
                     "cher\nelement vertex")},
      {"byte order mark", "a.ply", "\xEF\xBB\xBF" + plain},
      {"blank line before it", "a.ply", "\n" + plain},
      {"blank lines in the header", "a.ply", replaced(plain, "property float y", "\nproperty float y\n")},
      {"lines of Windows", "a.ply", replaced(plain, "\n", "\r\n")},
      {"lines of the old Mac", "a.ply", replaced(plain, "\n", "\r")},
      {"header of Windows, rows of Unix", "a.ply", replaced(head + both + end, "\n", "\r\n") + places + faces},
      {"tabs", "a.ply", replaced(plain, " ", "\t")},
      {"blanks before each line", "a.ply", around_lines(plain, "  ", "")},
      {"blanks after each line", "a.ply", around_lines(plain, "", "  ")},
      {"columns", "a.ply", replaced(plain, " ", "    ")},
      {"no line end at the end", "a.ply", plain.substr(0, plain.size() - 1)},
      {"blank lines at the end", "a.ply", plain + "\n\n \n"},
      {"zero after the text", "a.ply", plain + std::string(1, '\0')},
      {"end of file of DOS", "a.ply", plain + "\x1A"},
      {"blank lines between the rows", "a.ply", head + both + end + replaced(places + faces, "\n", "\n\n")},
      {"a row over two lines", "a.ply", replaced(plain, "3 0 1 2", "3\n0 1 2")},
      {"user element without rows", "a.ply",
       replaced_once(plain, "element face", "element user 0\nproperty int k\nelement face")},
      {"user element without properties", "a.ply", replaced_once(plain, "end_header", "element nothing 3\nend_header")},
      {"edges of Blender", "a.ply",
       head + both + "element edge 1\nproperty int vertex1\nproperty int vertex2\n" + end + places + faces + "0 1\n"},
      {"camera of MeshLab", "a.ply",
       head + "element camera 1\nproperty float view_px\nproperty float view_py\nproperty int viewportx\n" + both +
           end + "0.5 -0.5 800\n" + places + faces},
      {"material of a user between vertices and faces", "a.ply",
       head + xyz + "element material 2\nproperty list uchar uchar name\nproperty float shine\n" + list + end + places +
           "3 114 101 100 0.5\n0 1\n" + faces},
      {"faces before the vertices", "a.ply", head + list + xyz + end + faces + places},
      {"name of another format", "a.stl", plain},
      {"no name", "a", plain},
  };
}

std::vector<Variant> types() {
  const auto typed = [](const std::string& place, const std::string& count, const std::string& index) {
    return replaced_once(replaced(plain, "float", place), "uchar int", count + " " + index);
  };
  return {
      {"doubles", "a.ply", typed("double", "uchar", "int")},
      {"float32, int32: Open3D, trimesh", "a.ply", typed("float32", "uint8", "int32")},
      {"float64, uint32", "a.ply", typed("float64", "uint8", "uint32")},
      {"vertex_index: Stanford", "a.ply", replaced(plain, "vertex_indices", "vertex_index")},
      {"list counted by int", "a.ply", typed("float", "int", "int")},
      {"list counted by uint, of uint", "a.ply", typed("float", "uint", "uint")},
      {"list of ushort", "a.ply", typed("float", "ushort", "ushort")},
      {"list of short, counted by char", "a.ply", typed("float", "char", "short")},
      {"list of int8", "a.ply", typed("float", "int8", "int8")},
      {"whole coordinates of voxels", "a.ply", typed("short", "uchar", "int")},
      {"coordinates of bytes", "a.ply", typed("uchar", "uchar", "int")},
      {"numbers 1. and +0", "a.ply", replaced(replaced(plain, "1 1 0\n", "1. +1 +0\n"), "0 1 0\n", ".0 1.0 -0.0\n")},
      {"numbers of old Windows compilers", "a.ply",
       replaced(replaced(plain, "1 1 0\n", "1.000000e+000 1E+00 0\n"), "0 1 0\n", "0.0e-010 1 0\n")},
      {"numbers of many digits", "a.ply",
       replaced(plain, "1 1 0\n", "1.00000000000000000000000000000001 0.99999999999999999999999999999 0\n")},
      {"binary, little endian", "a.ply", binary_head() + xyz + list + end + binary_rows()},
      {"binary, big endian", "a.ply", binary_head(Order::big) + xyz + list + end + binary_rows(Order::big)},
      {"binary doubles, big endian: MATLAB", "a.ply",
       binary_head(Order::big) + replaced(xyz, "float", "double") + replaced(list, "uchar int", "int int") + end +
           binary_rows<double, std::int32_t>(Order::big)},
      {"binary doubles", "a.ply",
       binary_head() + replaced(xyz, "float", "double") + list + end + binary_rows<double>()},
      {"binary list of uint, counted by int", "a.ply",
       binary_head() + xyz + replaced(list, "uchar int", "int uint") + end +
           binary_rows<float, std::int32_t, std::uint32_t>()},
      {"binary list of ushort, counted by ushort", "a.ply",
       binary_head() + xyz + replaced(list, "uchar int", "ushort ushort") + end +
           binary_rows<float, std::uint16_t, std::uint16_t>()},
      {"binary shorts", "a.ply",
       binary_head() + replaced(xyz, "float", "int16") + list + end + binary_rows<std::int16_t>()},
      {"binary after a header of Windows", "a.ply",
       replaced(binary_head() + xyz + list + end, "\n", "\r\n") + binary_rows()},
      {"binary after a header of the old Mac", "a.ply",
       replaced(binary_head() + xyz + list + end, "\n", "\r") + binary_rows()},
      {"binary, blanks after end_header", "a.ply", binary_head() + xyz + list + "end_header  \n" + binary_rows()},
      {"binary, line end at the end", "a.ply", binary_head() + xyz + list + end + binary_rows() + "\r\n"},
      {"binary, zeros to the next 512 bytes", "a.ply",
       binary_head() + xyz + list + end + binary_rows() + std::string(300, '\0')},
      {"binary, byte order mark", "a.ply", "\xEF\xBB\xBF" + binary_head() + xyz + list + end + binary_rows()},
  };
}

std::vector<Variant> properties() {
  return {
      {"normals first: PCL", "a.ply",
       head +
           "element vertex 4\nproperty float nx\nproperty float ny\nproperty float nz\nproperty float x\n"
           "property float y\nproperty float z\n" +
           list + end + around_lines(places, "0 0 1 ", "") + faces},
      {"z before x", "a.ply",
       head + "element vertex 4\nproperty float z\nproperty float x\nproperty float y\n" + list + end +
           "0 0 0\n0 1 0\n0 1 1\n0 0 1\n" + faces},
      {"colours between the coordinates", "a.ply",
       head + "element vertex 4\nproperty float x\nproperty uchar red\nproperty float y\nproperty float z\n" + list +
           end + "0 7 0 0\n1 7 0 0\n1 7 1 0\n0 7 1 0\n" + faces},
      {"colours with alpha", "a.ply",
       vertices_with("property uchar red\nproperty uchar green\nproperty uchar blue\nproperty uchar alpha\n",
                     "9 8 7 255")},
      {"diffuse_red: old MeshLab", "a.ply",
       vertices_with("property uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar diffuse_blue\n",
                     "9 8 7")},
      {"r, g, b", "a.ply", vertices_with("property uint8 r\nproperty uint8 g\nproperty uint8 b\n", "9 8 7")},
      {"colours of floats", "a.ply",
       vertices_with("property float red\nproperty float green\nproperty float blue\n", "0.5 1 nan")},
      {"colours of 16 bits", "a.ply",
       vertices_with("property ushort red\nproperty ushort green\nproperty ushort blue\n", "65535 0 1")},
      {"confidence and intensity: Stanford", "a.ply",
       vertices_with("property float confidence\nproperty float intensity\n", "0.9 0.2")},
      {"quality NAN", "a.ply", vertices_with("property float quality\n", "NAN")},
      {"quality -nan(ind): Visual C++", "a.ply", vertices_with("property float quality\n", "-nan(ind)")},
      {"quality -1.#IND: old Visual C++", "a.ply", vertices_with("property float quality\n", "-1.#IND")},
      {"quality 1.#INF and Infinity", "a.ply",
       vertices_with("property float quality\nproperty double other\n", "1.#INF -Infinity")},
      {"quality NaN(0x0)", "a.ply", vertices_with("property float quality\n", "NaN(0x0)")},
      {"texture s, t: Blender", "a.ply", vertices_with("property float s\nproperty float t\n", "0 1")},
      {"scalar fields: CloudCompare", "a.ply",
       vertices_with("property float scalar_C2C_absolute_distances\nproperty double scalar_Time\n", "0.1 1e9")},
      {"lists of vertices", "a.ply", vertices_with("property list uchar int tags\n", "2 7 8")},
      {"names with a dash and a dot", "a.ply", vertices_with("property int class-id\nproperty int a.b\n", "1 2")},
      {"flags before the list: MeshLab", "a.ply",
       head + xyz + "element face 2\nproperty int flags\nproperty list uchar int vertex_indices\n" + end + places +
           around_lines(faces, "0 ", "")},
      {"texture at corners: MeshLab", "a.ply",
       faces_with("property list uchar float texcoord\nproperty int texnumber\n", "6 0 0 1 0 1 1 0")},
      {"texture of no corner", "a.ply", faces_with("property list uchar float texcoord\n", "0")},
      {"colours and quality of faces", "a.ply",
       faces_with("property uchar red\nproperty uchar green\nproperty uchar blue\nproperty float quality\n",
                  "1 2 3 NaN")},
      {"place that is none", "a.ply",
       replaced_once(replaced_once(plain, "vertex 4", "vertex 5"), "3 0 1 2", "NAN 1.#QNAN 0\n3 0 1 2"), lone, 5},
      {"quads", "a.ply", head + xyz + replaced_once(list, "2", "1") + end + places + "4 0 1 2 3\n"},
      {"a triangle and a line",
       "a.ply",
       replaced_once(plain, "3 0 2 3", "2 0 2"),
       "faces of fewer than three corners, left out (1)",
       4,
       1,
       {0, 0, 0.5}},
      {"a face of no corner",
       "a.ply",
       replaced_once(plain, "3 0 2 3", "0"),
       "faces of fewer than three corners, left out (1)",
       4,
       1,
       {0, 0, 0.5}},
      {"strips: Stanford", "a.ply",
       head + xyz + "element tristrips 1\nproperty list int int vertex_indices\n" + end + places + "4 0 1 3 2\n"},
      {"strips that begin anew", "a.ply",
       head + xyz + "element tristrips 1\nproperty list int int vertex_indices\n" + end + places +
           "7 0 1 2 -1 0 2 3\n"},
      {"strips beside faces", "a.ply",
       head + xyz +
           "element face 1\nproperty list uchar int vertex_indices\nelement tristrips 1\n"
           "property list int int vertex_indices\n" +
           end + places + "3 0 1 2\n3 0 2 3\n"},
      {"no strips beside faces", "a.ply",
       replaced_once(plain, end, "element tristrips 0\nproperty list int int vertex_indices\n" + end)},
  };
}

std::vector<Refusal> refusals() {
  const std::string counts = "The header and the data do not belong together; export the mesh again.";
  const std::string damaged = "The file is damaged or incomplete; export or copy it again.";
  const std::string need = "Loopmend needs a surface: export the mesh together with its faces.";
  const std::string little = binary_head() + xyz + list + end + binary_rows();
  return {
      {"points alone", "a.ply", head + xyz + end + places, "holds points but no faces (4 points). " + need},
      {"range grid: Stanford's raw scans", "a.ply",
       head + xyz + "element range_grid 2\nproperty list uchar int vertex_indices\n" + end + places + "1 0\n0\n",
       "holds points but no faces (4 points). " + need},
      {"64 bits", "a.ply", replaced(plain, "uchar int", "uchar int64"),
       "unknown PLY type \"int64\" (line 8). " + damaged},
      {"two properties of one name", "a.ply", vertices_with("property float x\n", "0"),
       "a second property \"x\" (line 7). " + damaged},
      {"fewer rows than announced", "a.ply", replaced(plain, "face 2", "face 3"),
       "the file ends too early, in face 2 of 3 (line 15). It is incomplete; export or copy it again."},
      {"more rows than announced", "a.ply", replaced(plain, "face 2", "face 1"),
       "there is more data than the header announces (line 15). " + counts},
      {"more numbers than announced", "a.ply", around_lines(plain, "", "").replace(plain.find("0 0 0\n"), 5, "0 0 0 7"),
       "this row holds more values than the header says, from \"7\" on (line 10). " + counts},
      {"decimal commas", "a.ply", replaced_once(plain, "1 1 0\n", "1,0 1 0\n"),
       "\"1,0\" stands where a number should be (line 12). Numbers are written with a point, not a comma."},
      {"binary, one more face than announced", "a.ply", replaced(little, "face 2", "face 1"),
       "13 bytes more than the header announces (byte 230). " + counts},
      {"binary, cut off", "a.ply", little.substr(0, little.size() - 1),
       "the file ends too early, in a list of 3 items (byte 231). It is incomplete; export or copy it again."},
      {"no place that a face uses", "a.ply", replaced_once(plain, "1 1 0", "nan 1 0"),
       "vertex 2 has a coordinate that is not a finite number (line 12). Remove or repair that vertex in the program "
       "the "
       "file comes from."},
      {"indices from 1", "a.ply", replaced(replaced(plain, "3 0 2 3", "3 1 3 4"), "3 0 1 2", "3 1 2 3"),
       "face 1 names vertex 4, but there are 4, from 0 on (line 15). " + damaged},
  };
}

class ExportersPly : public ExporterTest {};

TEST_F(ExportersPly, HeadersAndLines) { expect_read(headers()); }
TEST_F(ExportersPly, TypesAndBytes) { expect_read(types()); }
TEST_F(ExportersPly, PropertiesAndElements) { expect_read(properties()); }
TEST_F(ExportersPly, AreRefusedWithTheReason) { expect_refusals(refusals()); }

}  // namespace exporters_ply
}  // namespace loopmend
