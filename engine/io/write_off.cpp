// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/format_writers.h"

namespace loopmend {

void write_off(Output& out, const TriangleSoup& soup) {
  const ScanAttributes& scan = attributes_of(soup);
  const bool has_normals =
      find_column(scan.points, "nx") && find_column(scan.points, "ny") && find_column(scan.points, "nz");
  const bool has_texture = find_column(scan.points, "s") && find_column(scan.points, "t");
  const bool has_colors = !soup.colors.empty();
  const AttributeColumn* face_color = scan.format == "OFF" ? find_column(scan.faces, "color") : nullptr;
  out << (has_texture ? "ST" : "") << (has_colors ? "C" : "") << (has_normals ? "N" : "") << "OFF\n";
  std::size_t faces = 0;
  for_each_face(soup, [&](const WrittenFace&) { ++faces; });
  out << soup.points.size() << ' ' << faces << " 0\n";
  PointRows rows(soup);
  for (std::size_t v = 0; v < soup.points.size(); ++v) {
    const AttributeRow row = rows.next();
    const auto put = [&](const char* name) {
      out << ' ' << (row.table ? find_column(row.table->points, name)->value(row.row) : 0);
    };
    const Vec3& p = soup.points[v];
    out << p[0] << ' ' << p[1] << ' ' << p[2];
    if (has_normals)
      for (const char* name : {"nx", "ny", "nz"}) put(name);
    if (has_colors)
      for (const unsigned char channel : soup.colors[v]) out << ' ' << static_cast<int>(channel);
    if (has_texture)
      for (const char* name : {"s", "t"}) put(name);
    out << '\n';
  }
  for_each_face(soup, [&](const WrittenFace& face) {
    out << face.vertices.size();
    for (const int v : face.vertices) out << ' ' << v;
    if (face_color && face.row.table) {
      const AttributeColumn& column = *find_column(face.row.table->faces, "color");
      for (std::size_t k = 0; k < column.items(face.row.row); ++k) out << ' ' << column.value(face.row.row, k);
    }
    out << '\n';
  });
}

}  // namespace loopmend
