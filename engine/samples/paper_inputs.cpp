// SPDX-License-Identifier: GPL-3.0-or-later
#include "samples/paper_inputs.h"

#include "core/rotation.h"
#include "samples/analytic_surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace loopmend {

TriangleSoup make_tube(const TubeShape& shape) {
  TriangleSoup tube = make_cylinder(shape.length / shape.radius, shape.around);
  const Eigen::Quaterniond turn = rotation_between(Vec3::UnitZ(), shape.direction);
  for (Vec3& p : tube.points) p = shape.start + shape.radius * (turn * p);
  return tube;
}

TriangleSoup make_pierced_cylinder() {
  return trim_boundaries(cut(make_cylinder(6, 99), [](const Vec3& p) {
    for (int k = 0; k < 3; ++k)
      if ((p - Vec3(std::cos(2.1 * k), std::sin(2.1 * k), 2 + k)).norm() < 0.745) return true;
    return false;
  }));
}

TriangleSoup make_sphere_wireframe() {
  return trim_boundaries(cut(make_icosphere(5), [](const Vec3& p) { return p.cwiseAbs().minCoeff() > 0.22; }));
}

namespace {

std::vector<TubeShape> tubes_along(const std::vector<Vec3>& directions, int around) {
  std::vector<TubeShape> tubes;
  for (const Vec3& d : directions) tubes.push_back({1.5 * d, d, 0.8, 2, around});
  return tubes;
}

/// Smooth bump of height 1 in the unit direction d.
double bump(const Vec3& p, const Vec3& d, double width) {
  return std::exp(-(p - d.normalized()).squaredNorm() / (width * width));
}

}  // namespace

std::vector<TubeShape> three_tubes() { return tubes_along({Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, 47); }

std::vector<TubeShape> six_tubes(int around) {
  return tubes_along({Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(), -Vec3::UnitY(), Vec3::UnitZ(), -Vec3::UnitZ()},
                     around);
}

std::vector<TubeShape> tee_tubes() { return tubes_along({Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitZ()}, 37); }

TriangleSoup make_holed_head() {
  TriangleSoup head = make_icosphere(5);
  const Vec3 nose(0, -1, 0.02), cheek(0.62, -0.75, -0.12), jaw(-0.25, -0.75, -0.72);
  for (Vec3& p : head.points) {
    const double r = 1 + 0.28 * bump(p, nose, 0.24) + 0.10 * bump(p, {0, -1, -0.72}, 0.38) +
                     0.05 * bump(p, {0.42, -0.9, -0.05}, 0.3) + 0.05 * bump(p, {-0.42, -0.9, -0.05}, 0.3) -
                     0.07 * bump(p, {0.36, -0.9, 0.26}, 0.2) - 0.07 * bump(p, {-0.36, -0.9, 0.26}, 0.2) +
                     0.04 * bump(p, {0, -0.9, 0.5}, 0.35);
    p = Vec3(0.78 * r * p.x(), 0.92 * r * p.y(), 1.1 * r * p.z());
  }
  const TriangleSoup directions = make_icosphere(5);
  std::vector<char> inside(head.points.size(), 0);
  for (std::size_t i = 0; i < inside.size(); ++i) {
    const Vec3& d = directions.points[i];
    inside[i] = (d - nose.normalized()).norm() < 0.255 || (d - cheek.normalized()).norm() < 0.255 ||
                (d - jaw.normalized()).norm() < 0.255;
  }
  // cut() asks by place: the places are those of the head, one for each direction.
  std::map<std::array<double, 3>, char> at;
  for (std::size_t i = 0; i < inside.size(); ++i)
    at[{head.points[i].x(), head.points[i].y(), head.points[i].z()}] = inside[i];
  return trim_boundaries(cut(head, [&](const Vec3& p) { return at.at({p.x(), p.y(), p.z()}) != 0; }));
}

TriangleSoup make_dodecahedron() {
  const TriangleSoup icosahedron = make_icosphere(0);  // its dual
  TriangleSoup soup;
  for (const Triangle& t : icosahedron.triangles)
    soup.points.push_back(
        (icosahedron.points[t[0]] + icosahedron.points[t[1]] + icosahedron.points[t[2]]).normalized());
  for (int v = 0; v < static_cast<int>(icosahedron.points.size()); ++v) {
    std::vector<std::pair<double, int>> around;
    const Vec3 n = icosahedron.points[v], e1 = n.unitOrthogonal(), e2 = n.cross(e1);
    for (int f = 0; f < static_cast<int>(icosahedron.triangles.size()); ++f)
      for (int corner : icosahedron.triangles[f])
        if (corner == v) around.emplace_back(std::atan2(soup.points[f].dot(e2), soup.points[f].dot(e1)), f);
    std::sort(around.begin(), around.end());
    for (int k = 1; k < 4; ++k) soup.triangles.push_back({around[0].second, around[k].second, around[k + 1].second});
  }
  return soup;
}

double bumps_height(double x, double y) {
  const auto e = [](double u, double v) {
    return std::exp(-81.0 / 16 * ((u - 0.5) * (u - 0.5) + (v - 0.5) * (v - 0.5)));
  };
  return e(x, y) + e(x + 1, y) + e(x, y + 1) + e(x + 1, y + 1);
}

TriangleSoup make_bumps() { return make_graph(bumps_height, 1, 60); }

}  // namespace loopmend
