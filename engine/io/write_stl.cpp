// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/format_writers.h"

#include <Eigen/Geometry>

#include <cmath>
#include <utility>

namespace loopmend {

namespace {

const Vec3& corner(const TriangleSoup& soup, const Triangle& triangle, std::size_t i) {
  return soup.points[triangle[i]];
}

/// The unit normal; zero for a triangle without area, as STL has it.
Vec3 unit_normal(const TriangleSoup& soup, const Triangle& t) {
  Vec3 u = corner(soup, t, 1) - corner(soup, t, 0);
  Vec3 v = corner(soup, t, 2) - corner(soup, t, 0);
  const double scale = std::max(u.cwiseAbs().maxCoeff(), v.cwiseAbs().maxCoeff());
  if (!(scale > 0.0) || !std::isfinite(scale)) return Vec3::Zero();
  const Vec3 n = (u / scale).cross(v / scale);
  const double length = n.norm();
  return length > 0.0 ? Vec3(n / length) : Vec3(Vec3::Zero());
}

void write_stl_binary(Output& out, const TriangleSoup& soup) {
  const ScanAttributes& scan = attributes_of(soup);
  std::string header = "Loopmend binary STL";  // must not begin with "solid"
  // Header and attributes belong together: by some conventions the one says what the other's bits mean.
  if (!scan.header.empty() && scan.header.substr(0, 5) != "solid") header = scan.header;
  header.resize(80, ' ');
  out << std::string_view(header);
  out.little_endian(static_cast<std::uint32_t>(soup.triangles.size()));
  const auto column = find_stl_attribute(scan);
  std::size_t new_triangles = 0;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const Triangle& triangle = soup.triangles[f];
    for (const double x : unit_normal(soup, triangle)) out.little_endian(static_cast<float>(x));
    for (std::size_t i = 0; i < 3; ++i) {
      for (const double x : corner(soup, triangle, i)) out.little_endian(static_cast<float>(x));
    }
    double attribute = 0;
    const int row = triangle_row(soup, f);
    if (column && row >= 0) attribute = scan.faces[*column].value(scan.face_of_triangle(static_cast<std::size_t>(row)));
    if (column && row < 0 && soup.continued) attribute = soup.continued->faces[*column].value(new_triangles);
    new_triangles += row < 0 ? 1 : 0;
    out.little_endian(static_cast<std::uint16_t>(attribute));
  }
}

void write_stl_text(Output& out, const TriangleSoup& soup) {
  const FaceNames* solids = find_names(attributes_of(soup), "solid");
  std::string name = " loopmend";
  bool open = false;
  const auto close = [&] {
    if (std::exchange(open, false)) out << "endsolid" << name << '\n';
  };
  int solid = -1;
  std::size_t new_triangles = 0;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const Triangle& triangle = soup.triangles[f];
    if (solids) {
      const int row = triangle_row(soup, f);
      AttributeRow place;
      if (row >= 0)
        place = {soup.attributes.get(), soup.attributes->face_of_triangle(static_cast<std::size_t>(row))};
      else
        place = {soup.continued.get(), new_triangles++};
      if (const int next = name_of(*solids, place); next >= 0 && next != solid) {
        close();
        solid = next;
        name = solids->names[solid];
      }
    }
    if (!std::exchange(open, true)) out << "solid" << name << '\n';
    const Eigen::Vector3f n = unit_normal(soup, triangle).cast<float>();  // readers compute it again: keep it short
    out << "facet normal " << n[0] << ' ' << n[1] << ' ' << n[2] << "\n outer loop\n";
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3& p = corner(soup, triangle, i);
      out << "  vertex " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
    }
    out << " endloop\nendfacet\n";
  }
  if (soup.triangles.empty()) out << "solid" << name << '\n', open = true;
  close();
}

}  // namespace

void write_stl(Output& out, const TriangleSoup& soup, Encoding encoding) {
  if (encoding == Encoding::binary)
    write_stl_binary(out, soup);
  else
    write_stl_text(out, soup);
}

}  // namespace loopmend
