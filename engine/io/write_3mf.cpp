// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/format_writers.h"
#include "io/written_triangles.h"
#include "io/xml_text.h"
#include "io/zip_archive.h"

#include <array>
#include <map>
#include <sstream>
#include <vector>

namespace loopmend {

namespace {

constexpr std::string_view content_types =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Types xmlns=\"http://schemas.openxmlformats.org/package/2006/content-types\">"
    "<Default Extension=\"rels\" ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
    "<Default Extension=\"model\" ContentType=\"application/vnd.ms-package.3dmanufacturing-3dmodel+xml\"/></Types>\n";
constexpr std::string_view relations =
    "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
    "<Relationships xmlns=\"http://schemas.openxmlformats.org/package/2006/relationships\">"
    "<Relationship Target=\"/3D/3dmodel.model\" Id=\"rel0\" "
    "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/></Relationships>\n";

std::string hex(const Color& color) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string text = "#";
  for (std::size_t k = 0; k < (color[3] == 255 ? 3 : 4); ++k) {
    text += digits[color.at(k) >> 4];
    text += digits[color.at(k) & 15];
  }
  return text;
}

class ModelWriter {
 public:
  explicit ModelWriter(const TriangleSoup& soup)
      : soup_(soup),
        scan_(attributes_of(soup)),
        materials_(written_materials(soup)),
        triangles_(written_triangles(soup)) {}

  std::string text() {
    std::ostringstream stream;
    {
      Output out(stream, nullptr);
      write(out);
      out.finish();
    }
    return std::move(stream).str();
  }

 private:
  static constexpr int color_group = 1, material_group = 2, first_object = 3;

  void write(Output& out) {
    find_colors();
    out << "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model unit=\""
        << (scan_.unit.empty() ? "millimeter" : scan_.unit)
        << "\" xml:lang=\"en-US\" xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"";
    if (!colors_.empty()) out << " xmlns:m=\"http://schemas.microsoft.com/3dmanufacturing/material/2015/02\"";
    out << ">\n";
    for (const auto& [name, value] : materials_.metadata) {
      if (name.find(':') != std::string::npos) continue;  // of a namespace that is not there
      out << " <metadata name=\"" << xml_text(name) << "\">" << xml_text(value) << "</metadata>\n";
    }
    out << " <metadata name=\"Application\">Loopmend</metadata>\n";
    out << " <resources>\n";
    write_properties(out);
    const int objects = write_objects(out);
    out << " </resources>\n <build>\n";
    for (int k = 0; k < objects; ++k) out << "  <item objectid=\"" << first_object + k << "\"/>\n";
    out << " </build>\n</model>\n";
  }

  /// Colours of vertices; else of faces, as the columns red, green, blue and alpha have them.
  void find_colors() {
    const auto number_of = [&](const Color& color) {
      return number_.try_emplace(color, static_cast<int>(number_.size())).first->second;
    };
    if (!soup_.colors.empty()) {
      for (const Color& color : soup_.colors) color_of_point_.push_back(number_of(color));
    } else if (has_face_colors(scan_)) {
      for (const WrittenTriangle& triangle : triangles_) color_of_face_.push_back(number_of(face_color(triangle.row)));
    }
    colors_.resize(number_.size());
    for (const auto& [color, number] : number_) colors_[number] = color;
  }

  static Color face_color(const AttributeRow& row) {
    Color color{255, 255, 255, 255};
    constexpr std::array<const char*, 4> names = {"red", "green", "blue", "alpha"};
    for (std::size_t k = 0; k < 4 && row.table; ++k)
      if (const AttributeColumn* column = find_column(row.table->faces, names[k]))
        color.at(k) = static_cast<unsigned char>(column->value(row.row));
    return color;
  }

  void write_properties(Output& out) {
    if (!colors_.empty()) {
      out << "  <m:colorgroup id=\"" << color_group << "\">\n";
      for (const Color& color : colors_) out << "   <m:color color=\"" << hex(color) << "\"/>\n";
      out << "  </m:colorgroup>\n";
    } else if (!materials_.materials.empty()) {
      out << "  <basematerials id=\"" << material_group << "\">\n";
      for (const ScanMaterial& material : materials_.materials)
        out << "   <base name=\"" << xml_text(material.name) << "\" displaycolor=\""
            << hex(material.color.value_or(Color{255, 255, 255, 255})) << "\"/>\n";
      out << "  </basematerials>\n";
    }
  }

  /// One object for each name; faces without one last. @returns how many
  int write_objects(Output& out) {
    std::map<unsigned, std::vector<std::size_t>> faces_of;
    for (std::size_t f = 0; f < triangles_.size(); ++f)
      faces_of[static_cast<unsigned>(triangles_[f].object)].push_back(f);
    const std::vector<std::string> names = object_names(soup_);
    std::vector<int> number(soup_.points.size());
    std::vector<char> is_used(soup_.points.size(), 0);
    for (const Triangle& t : soup_.triangles)
      for (const int v : t) is_used[v] = 1;
    int objects = 0;
    for (const auto& [object, faces] : faces_of) {
      std::vector<char> is_mine(soup_.points.size(), 0);
      for (const std::size_t f : faces)
        for (const int v : triangles_[f].points) is_mine[v] = 1;
      out << "  <object id=\"" << first_object + objects << "\" type=\"model\"";
      if (static_cast<int>(object) >= 0) out << " name=\"" << xml_text(names.at(object)) << '"';
      if (!colors_.empty())
        out << " pid=\"" << color_group << "\" pindex=\"0\"";
      else if (!materials_.materials.empty() && has_material(faces))
        out << " pid=\"" << material_group << "\" pindex=\"0\"";
      out << ">\n   <mesh>\n    <vertices>\n";
      int count = 0;
      for (std::size_t v = 0; v < soup_.points.size(); ++v) {
        if (!is_mine[v] && (objects > 0 || is_used[v])) continue;  // those of no face go with the first object
        number[v] = count++;
        const Vec3& p = soup_.points[v];
        out << "     <vertex x=\"" << p[0] << "\" y=\"" << p[1] << "\" z=\"" << p[2] << "\"/>\n";
      }
      out << "    </vertices>\n    <triangles>\n";
      for (const std::size_t f : faces) write_triangle(out, f, number);
      out << "    </triangles>\n   </mesh>\n  </object>\n";
      ++objects;
    }
    return objects;
  }

  bool has_material(const std::vector<std::size_t>& faces) const {
    for (const std::size_t f : faces)
      if (triangles_[f].material >= 0) return true;
    return false;
  }

  void write_triangle(Output& out, std::size_t f, const std::vector<int>& number) const {
    const WrittenTriangle& triangle = triangles_[f];
    out << "     <triangle";
    constexpr std::array<const char*, 3> vertex = {" v1=\"", " v2=\"", " v3=\""},
                                         member = {" p1=\"", " p2=\"", " p3=\""};
    for (std::size_t k = 0; k < 3; ++k) out << vertex[k] << number[triangle.points[k]] << '"';
    if (!color_of_point_.empty()) {
      out << " pid=\"" << color_group << '"';
      for (std::size_t k = 0; k < 3; ++k) out << member[k] << color_of_point_[triangle.points[k]] << '"';
    } else if (!color_of_face_.empty()) {
      out << " pid=\"" << color_group << '"' << member[0] << color_of_face_[f] << '"';
    } else if (triangle.material >= 0 && !materials_.materials.empty()) {
      out << " pid=\"" << material_group << '"' << member[0] << triangle.material << '"';
    }
    out << "/>\n";
  }

  const TriangleSoup& soup_;
  const ScanAttributes& scan_;
  MaterialTable materials_;
  std::vector<WrittenTriangle> triangles_;
  std::map<Color, int> number_;
  std::vector<Color> colors_;
  std::vector<int> color_of_point_, color_of_face_;
};

}  // namespace

bool has_face_colors(const ScanAttributes& scan) {
  for (const char* name : {"red", "green", "blue"}) {
    const AttributeColumn* column = find_column(scan.faces, name);
    if (!column || column->is_list() || column->type() != ScalarType::uint8) return false;
  }
  return true;
}

void write_3mf(Output& out, const TriangleSoup& soup) {
  out << zip_archive({{"[Content_Types].xml", std::string(content_types)},
                      {"_rels/.rels", std::string(relations)},
                      {"3D/3dmodel.model", ModelWriter(soup).text()}});
}

}  // namespace loopmend
