// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/format_writers.h"

#include <vector>

namespace loopmend {

namespace {

class ObjWriter {
 public:
  ObjWriter(Output& out, const TriangleSoup& soup)
      : out_(out),
        soup_(soup),
        scan_(attributes_of(soup)),
        normals_per_point_(!has_rows(scan_.normals) && find_column(scan_.points, "nx") &&
                           find_column(scan_.points, "ny") && find_column(scan_.points, "nz")) {}

  void write() {
    out_ << "# Loopmend\n";
    const ScanAttributes* continued = soup_.continued.get();
    const bool has_more = continued && !continued->material_libraries.empty();
    for (const std::string& library : has_more ? continued->material_libraries : scan_.material_libraries)
      out_ << "mtllib " << library << '\n';
    write_points();
    write_values("vt", &ScanAttributes::texture);
    if (!normals_per_point_) write_values("vn", &ScanAttributes::normals);
    for_each_face(soup_, [&](const WrittenFace& face) { write_face(face); });
  }

 private:
  void write_points() {
    for (std::size_t v = 0; v < soup_.points.size(); ++v) {
      const Vec3& p = soup_.points[v];
      out_ << "v " << p[0] << ' ' << p[1] << ' ' << p[2];
      if (!soup_.colors.empty()) {
        for (std::size_t c = 0; c < 3; ++c) out_ << ' ' << soup_.colors[v][c] / 255.0;  // the format knows no alpha
      }
      out_ << '\n';
    }
    if (!normals_per_point_) return;
    PointRows rows(soup_);
    for (std::size_t v = 0; v < soup_.points.size(); ++v) {
      const AttributeRow row = rows.next();
      out_ << "vn";
      for (const char* name : {"nx", "ny", "nz"})
        out_ << ' ' << (row.table ? find_column(row.table->points, name)->value(row.row) : 0);
      out_ << '\n';
    }
  }

  void write_values(const char* keyword, CornerValues ScanAttributes::*values) {
    for (const ScanAttributes* table : {&scan_, soup_.continued.get()}) {
      if (!table) continue;
      const CornerValues& all = table->*values;
      for (std::size_t k = 0; k < all.count(); ++k) {
        out_ << keyword;
        for (int c = 0; c < all.dimension; ++c)
          out_ << ' ' << all.values[k * static_cast<std::size_t>(all.dimension) + static_cast<std::size_t>(c)];
        out_ << '\n';
      }
    }
  }

  void write_face(const WrittenFace& face) {
    for (std::size_t k = 0; k < scan_.names.size(); ++k) {
      const FaceNames& names = scan_.names[k];
      if (names.keyword == "solid") continue;
      now_.resize(scan_.names.size(), -1);
      const int mine = name_of(names, face.row);
      if (mine == now_[k]) continue;
      now_[k] = mine;
      if (mine < 0) {  // after others: a face of none would be taken for one of theirs
        out_ << names.keyword << (names.keyword == "s" ? " off\n" : " default\n");
        continue;
      }
      const std::vector<std::string>& words =
          face.row.table == &scan_ ? names.names : find_names(*face.row.table, names.keyword)->names;
      out_ << names.keyword;
      if (!words[mine].empty()) out_ << ' ' << words[mine];
      out_ << '\n';
    }
    out_ << 'f';
    for (std::size_t k = 0; k < face.vertices.size(); ++k) {
      out_ << ' ' << face.vertices[k] + 1;
      const int texture = number(face, k, &ScanAttributes::texture);
      const int normal = normals_per_point_ ? face.vertices[k] + 1 : number(face, k, &ScanAttributes::normals);
      if (texture > 0 || normal > 0) out_ << '/';
      if (texture > 0) out_ << texture;
      if (normal > 0) out_ << '/' << normal;
    }
    out_ << '\n';
  }

  /// Of a corner's value in the file, from 1; 0: none. A face has it at all corners or at none.
  int number(const WrittenFace& face, std::size_t k, CornerValues ScanAttributes::*values) const {
    if (face.corners.empty()) return 0;
    const CornerValues& mine = face.row.table->*values;
    if (mine.dimension == 0) return 0;
    for (const int corner : face.corners)
      if (corner < 0 || mine.at[corner] < 0) return 0;
    const int first = face.row.table == &scan_ ? 1 : 1 + static_cast<int>((scan_.*values).count());
    return first + mine.at[face.corners[k]];
  }

  Output& out_;
  const TriangleSoup& soup_;
  const ScanAttributes& scan_;
  bool normals_per_point_;
  std::vector<int> now_;  // per keyword
};

}  // namespace

void write_obj(Output& out, const TriangleSoup& soup) { ObjWriter(out, soup).write(); }

}  // namespace loopmend
