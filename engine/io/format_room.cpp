// SPDX-License-Identifier: GPL-3.0-or-later
// What of a soup a format has no room for.
#include "io/format_writers.h"
#include "io/texture_files.h"
#include "mesh/material_table.h"

#include <algorithm>
#include <initializer_list>
#include <set>
#include <string>
#include <vector>

namespace loopmend {

/// What the file held beside; an empty table where there is none.
const ScanAttributes& attributes_of(const TriangleSoup& soup) {
  static const ScanAttributes none;
  return soup.attributes ? *soup.attributes : none;
}

bool has_rows(const CornerValues& values) { return values.count() > 0 && !values.at.empty(); }

/// The faces of a PLY file may have a list of that name already.
bool writes_texture(const ScanAttributes& scan) {
  return has_rows(scan.texture) && !find_column(scan.faces, "texcoord");
}

std::pair<const AttributeColumn*, const AttributeColumn*> point_texture(const ScanAttributes& scan) {
  if (has_rows(scan.texture)) return {};
  constexpr std::array<std::array<const char*, 2>, 3> names = {{{"s", "t"}, {"u", "v"}, {"texture_u", "texture_v"}}};
  for (const auto& [first, second] : names) {
    const AttributeColumn *u = find_column(scan.points, first), *v = find_column(scan.points, second);
    if (u && v && !u->is_list() && !v->is_list()) return {u, v};
  }
  return {};
}

/// Their numbers of vertices hold only while the points are where they were.
bool keeps_elements(const TriangleSoup& soup) { return soup.attributes && soup.point_rows.empty(); }

const FaceNames* find_names(const ScanAttributes& scan, std::string_view keyword) {
  const auto found =
      std::find_if(scan.names.begin(), scan.names.end(), [&](const FaceNames& n) { return n.keyword == keyword; });
  return found == scan.names.end() ? nullptr : &*found;
}

namespace {

/// Two bytes behind each facet; of several columns of faces that could be them it is the first.
bool is_stl_attribute(const AttributeColumn& column) {
  return column.name() == "attribute" && column.type() == ScalarType::uint16 && !column.is_list();
}

}  // namespace

/// The place of the column that becomes the two bytes behind each facet.
std::optional<std::size_t> find_stl_attribute(const ScanAttributes& scan) {
  for (std::size_t k = 0; k < scan.faces.size(); ++k)
    if (is_stl_attribute(scan.faces[k])) return k;
  return {};
}

/// What a face is called under a keyword; −1: nothing.
int name_of(const FaceNames& names, const AttributeRow& row) {
  if (!row.table) return -1;
  for (const FaceNames& mine : row.table->names)
    if (mine.keyword == names.keyword) return row.row < mine.of_face.size() ? mine.of_face[row.row] : -1;
  return -1;
}

namespace {

/// What a column holds, in words. Columns that belong together share theirs.
Message column_said(bool of_faces, const AttributeColumn& column, const std::string& format) {
  const auto is_one_of = [&](std::initializer_list<std::string_view> names) {
    return std::find(names.begin(), names.end(), column.name()) != names.end();
  };
  if (role_of(column.name()) == AttributeRole::normal) return of_faces ? say("face normals") : say("normals");
  if (!is_integer(column.type()) && is_one_of({"s", "t", "u", "v", "texture_u", "texture_v", "texcoord"}))
    return of_faces ? say("texture coordinates of faces") : say("texture coordinates");
  if (of_faces && (role_of(column.name()) == AttributeRole::color || (format == "OFF" && column.name() == "color")))
    return say("face colours");
  if (of_faces && format == "STL") return say("face attributes");
  return of_faces ? say("face properties \"%1\"", column.name()) : say("vertex properties \"%1\"", column.name());
}

Message names_said(std::string_view keyword) {
  if (keyword == "usemtl") return say("materials");
  if (keyword == "o") return say("objects");
  if (keyword == "s") return say("smoothing groups");
  return keyword == "solid" ? say("separate solids") : say("groups");
}

/// What a file has room for; without a format, nothing.
struct Room {
  std::optional<Format> format;
  Encoding encoding = Encoding::binary;

  bool is(Format other) const { return format == other; }
  bool is_gltf() const { return is(Format::glb) || is(Format::gltf); }
};

bool is_texture_coordinate(const std::string& name) { return name == "s" || name == "t"; }

/// Its one attribute of faces, in binary.
bool stl_holds(const Room& room, const ScanAttributes& scan, const AttributeColumn& column) {
  return room.encoding == Encoding::binary && is_stl_attribute(column) &&
         &scan.faces[*find_stl_attribute(scan)] == &column;
}

/// Colours of vertices are said by themselves.
bool holds(const Room& room, const TriangleSoup& soup, bool of_faces, const AttributeColumn& column) {
  const ScanAttributes& scan = attributes_of(soup);
  const std::string& name = column.name();
  const AttributeRole role = role_of(name);
  if (room.is(Format::ply)) return true;
  if (room.is(Format::polydata)) return !column.is_list();
  if (!of_faces && role == AttributeRole::color && !soup.colors.empty()) return true;
  if (room.is(Format::stl)) return of_faces && stl_holds(room, scan, column);
  if (room.is(Format::off) && of_faces) return scan.format == "OFF" && name == "color";
  if (room.is(Format::off) && is_texture_coordinate(name)) return true;
  if (room.is(Format::three_mf))
    return of_faces && role == AttributeRole::color && soup.colors.empty() && has_face_colors(scan);
  if (room.is_gltf() && !of_faces)
    if (const auto [u, v] = point_texture(scan); &column == u || &column == v) return true;
  const bool holds_normals = room.is(Format::off) || room.is(Format::obj) || room.is_gltf();
  return holds_normals && !of_faces && role == AttributeRole::normal;
}

/// Of formats that have them, 3MF writes materials where there are no colours.
bool holds_names(const Room& room, const TriangleSoup& soup, std::string_view keyword) {
  if (room.is(Format::obj)) return keyword != "solid";
  if (room.is(Format::stl)) return keyword == "solid" && room.encoding == Encoding::ascii;
  if (keyword == "o") return room.is_gltf() || room.is(Format::three_mf);
  if (keyword != "usemtl") return false;
  return room.is_gltf() || (room.is(Format::three_mf) && soup.colors.empty() && !has_face_colors(attributes_of(soup)));
}

void add_table(std::vector<NotKept>& list, const Room& room, const TriangleSoup& soup) {
  const ScanAttributes& scan = attributes_of(soup);
  if (scan.materials && !room.is_gltf())
    count_not_kept(list, say("pictures of materials"), scan.materials->pictures.size());
  if (scan.materials && !room.is(Format::three_mf))
    count_not_kept(list, say("metadata"), scan.materials->metadata.size());
  const bool has_unit = room.is(Format::three_mf) || (room.is_gltf() && scan.unit == "meter");
  // Of a scan in metres nothing is lost but the word.
  if (!scan.unit.empty() && !has_unit && scan.unit != "meter") count_not_kept(list, say("unit (%1)", scan.unit));
}

void add_columns(std::vector<NotKept>& list, const Room& room, const TriangleSoup& soup, bool of_faces) {
  const ScanAttributes& scan = attributes_of(soup);
  std::set<std::string> known;
  for (const NotKept& entry : list) known.insert(entry.what.english());
  for (const AttributeColumn& column : of_faces ? scan.faces : scan.points) {
    if (holds(room, soup, of_faces, column)) continue;
    const Message what = column_said(of_faces, column, scan.format);
    if (column.rows() > 0 && known.insert(what.english()).second) list.push_back({what, column.rows()});
  }
}

std::size_t count_names(const FaceNames& names) {
  return static_cast<std::size_t>(std::count_if(names.names.begin(), names.names.end(), [&](const std::string& name) {
    return !(names.keyword == "s" && (name == "off" || name == "0"));
  }));
}

/// What a PLY header says: names of pictures, which export/write_scan.h brings into glTF, and remarks of people and programs.
void add_remarks(std::vector<NotKept>& list, const Room& room, const ScanAttributes& scan) {
  if (room.is(Format::ply)) return;
  std::size_t pictures = 0, comments = 0;
  for (const std::string& remark : scan.remarks)
    if (!TextureFiles::name_in(remark).empty())
      ++pictures;
    else if (remark != remark_of_loopmend)
      ++comments;
  if (!room.is_gltf()) count_not_kept(list, say("pictures"), pictures);
  count_not_kept(list, say("comments"), comments);
}

/// Programs write their names there; some write the colour of the part.
void add_header(std::vector<NotKept>& list, const Room& room, const ScanAttributes& scan) {
  const bool kept = room.is(Format::stl) && room.encoding == Encoding::binary;
  if (!kept && scan.header.find("COLOR=") != std::string::npos) count_not_kept(list, say("colour of the part"));
}

void add_attributes(std::vector<NotKept>& list, const Room& room, const TriangleSoup& soup) {
  const ScanAttributes& scan = attributes_of(soup);
  add_columns(list, room, soup, false);
  add_columns(list, room, soup, true);
  const bool obj = room.is(Format::obj), ply = room.is(Format::ply), gltf = room.is_gltf();
  if (!obj && !gltf && !(ply && writes_texture(scan)))
    count_not_kept(list, say("texture coordinates"), scan.texture.count());
  if (!obj && !gltf) count_not_kept(list, say("normals"), scan.normals.count());
  for (const FaceNames& names : scan.names) {
    const std::size_t count = count_names(names);
    if (!holds_names(room, soup, names.keyword) && !(names.keyword == "solid" && count <= 1))
      count_not_kept(list, names_said(names.keyword), count);
  }
  add_table(list, room, soup);
  add_remarks(list, room, scan);
  add_header(list, room, scan);
  if (!obj) count_not_kept(list, say("material libraries"), scan.material_libraries.size());
  if (!(ply && keeps_elements(soup)))
    for (const OtherElement& element : scan.elements)
      if (element.rows > 0) list.push_back({say("elements \"%1\"", element.name), element.rows});
}

}  // namespace

std::vector<NotKept> not_kept_by_format(const std::filesystem::path& path, const TriangleSoup& soup,
                                        Encoding encoding) {
  std::vector<NotKept> list;
  const Format format = format_of(path);
  if (format == Format::obj) {
    const auto see_through = [](const Color& color) { return color[3] != 255; };
    const auto count = std::count_if(soup.colors.begin(), soup.colors.end(), see_through);
    count_not_kept(list, say("alpha values"), static_cast<std::size_t>(count));
  }
  const bool gltf = format == Format::glb || format == Format::gltf;
  if (format == Format::stl || gltf) {
    std::vector<char> used(soup.points.size(), 0);
    for (const Triangle& triangle : soup.triangles)
      for (const int v : triangle) used[v] = 1;
    if (!gltf) count_not_kept(list, say("vertex colours"), soup.colors.size());
    count_not_kept(list, say("vertices without faces"),
                   static_cast<std::size_t>(std::count(used.begin(), used.end(), 0)));
  }
  add_attributes(list, {format, encoding}, soup);
  return list;
}

std::vector<NotKept> carried_attributes(const TriangleSoup& soup) {
  std::vector<NotKept> list;
  add_attributes(list, {}, soup);
  return list;
}

}  // namespace loopmend
