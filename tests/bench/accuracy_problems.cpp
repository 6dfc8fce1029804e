// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy_problems.h"

#include <cmath>
#include <numbers>

namespace loopmend::bench {

namespace {

constexpr double pi = std::numbers::pi;
constexpr unsigned mesh_seed = 11;

using Inside = std::function<bool(const Vec3&)>;

double radians(double degrees) { return degrees * pi / 180; }

HoleProblem finished(const std::string& name, const KnownSurface& regular, MeshKind kind, const Inside& inside) {
  const KnownSurface surface = with_mesh(regular, kind, mesh_seed);
  return cut_problem(name, surface.mesh, inside,
                     [project = surface.project](const Vec3& p) { return (p - project(p)).norm(); });
}

/// A disc about `center`, with a neighborhood of 30 rings.
HoleProblem disc_hole(const std::string& name, const KnownSurface& surface, MeshKind kind, const Vec3& center,
                      double radius, double edge) {
  return finished(name, cropped(surface, center, radius + 30 * edge), kind,
                  [=](const Vec3& p) { return (p - center).norm() < radius; });
}

/// Vertices of a sphere of which a cap of this angular radius holds `removed`.
int frequency_for(double angle, int removed) {
  return static_cast<int>(std::lround(std::sqrt(removed / (10 * (1 - std::cos(angle)) / 2))));
}

/// The cap's boundary lies slightly off the pole of the icosahedron, so that no symmetry helps anybody.
HoleProblem sphere_cap(const std::string& name, double angle, int removed, MeshKind kind) {
  const int frequency = frequency_for(angle, removed);
  const double edge = 1.2 / frequency;
  const Vec3 axis = Vec3(0.3, -0.2, 1).normalized();
  KnownSurface sphere = known_sphere(frequency);
  if (angle + 30 * edge < 1.2) sphere = cropped(sphere, axis, 2 * std::sin((angle + 30 * edge) / 2));
  return finished(name, sphere, kind, [=](const Vec3& p) { return p.dot(axis) > std::cos(angle); });
}

AccuracyCase sphere_case(int percent, int removed, const std::string& label, double target, bool compares_g2) {
  const std::string name = "sphere " + std::to_string(percent) + " %, " + label;
  return {name, [=](MeshKind kind) { return sphere_cap(name, std::asin(percent / 100.0), removed, kind); }, target,
          compares_g2};
}

HoleProblem eight_openings(MeshKind kind) {
  return finished("sphere, eight openings", known_sphere(33), kind, [](const Vec3& p) {
    return std::abs(p.x()) + std::abs(p.y()) + std::abs(p.z()) > std::sqrt(3.0) * std::cos(radians(25));
  });
}

HoleProblem three_pieces(MeshKind kind) {
  return finished("cylinder, three pieces", known_cylinder(4, 120), kind, [](const Vec3& p) {
    for (double middle : {0.0, 2 * pi / 3, -2 * pi / 3}) {
      const double turn = std::remainder(std::atan2(p.y(), p.x()) - middle, 2 * pi);
      if (std::hypot(turn, p.z()) < 0.7) return true;
    }
    return false;
  });
}

/// A rounded window: the cylinder stays whole above and below.
HoleProblem most_of_cylinder(MeshKind kind) {
  return finished("cylinder, 240° missing", known_cylinder(6, 60), kind, [](const Vec3& p) {
    const double turn = std::atan2(p.y(), p.x()) / radians(120);
    return std::pow(turn, 4) + std::pow(p.z() / 1.2, 4) < 1;
  });
}

HoleProblem unduloid_hole(const std::string& name, int around, MeshKind kind) {
  const KnownSurface surface = known_unduloid(0.4, 4, around);
  const double radius = std::sqrt(1 + 0.4 * 0.4);
  return disc_hole(name, surface, kind, {radius, 0, 0}, 0.7, 2 * pi / around);
}

HoleProblem catenoid_hole(MeshKind kind) {
  return disc_hole("catenoid", known_catenoid(1.3, 145), kind, {std::cosh(0.3), 0, 0.3}, 0.6, 2 * pi / 145);
}

HoleProblem torus_hole(MeshKind kind) {
  const Vec3 center = Vec3(1 + 0.4 * std::cos(1.0), 0, 0.4 * std::sin(1.0));
  return disc_hole("torus", known_torus(0.4, 250), kind, center, 0.36, 2 * pi / 250);
}

HoleProblem ellipsoid_hole(MeshKind kind) {
  const Vec3 axes(1, 0.8, 0.6);
  const Vec3 center = axes.cwiseProduct(Vec3(0.6, 0.4, std::sqrt(1 - 0.36 - 0.16)));
  return disc_hole("ellipsoid", known_ellipsoid(axes, 34), kind, center, 0.35, 1.0 / 34);
}

HoleProblem graph_hole(MeshKind kind) {
  const KnownSurface surface = known_graph(70);
  return disc_hole("graph surface", surface, kind, surface.project({0.1, -0.1, 0}), 0.4, 2.0 / 70);
}

/// The paper's own exact solution with H that changes.
HoleProblem mvc_hole(MeshKind kind) {
  const KnownSurface surface = known_mvc_cylinder(64);
  return disc_hole("mvc cylinder", surface, kind, surface.project({0.2, 0, 0.1}), 0.45, 2.0 / 64);
}

/// A smooth sheet, bent at random: nothing in it is rough.
AccuracyCase sheet_case(unsigned seed) {
  const std::string name = "sheet " + std::to_string(seed);
  return {name, [=](MeshKind kind) {
            constexpr int cells = 56;
            const KnownSurface surface = known_sheet(seed, cells);
            return disc_hole(name, surface, kind, surface.project({0.1, -0.1, 0}), 0.4, 2.0 / cells);
          }};
}

AccuracyCase unduloid_case(const std::string& label, int around, double target) {
  const std::string name = "unduloid, " + label;
  return {name, [=](MeshKind kind) { return unduloid_hole(name, around, kind); }, target};
}

}  // namespace

std::vector<AccuracyCase> accuracy_cases() {
  return {sphere_case(10, 500, "500", 0.006, true),
          sphere_case(30, 500, "500", 0.02, true),
          sphere_case(50, 500, "500", 0.03, true),
          sphere_case(30, 5000, "5k", 0.005, false),
          {"sphere, eight openings", eight_openings, 0.02},
          {"half a sphere missing",
           [](MeshKind kind) { return sphere_cap("half a sphere missing", radians(90), 1000, kind); }, 1},
          {"120° opening", [](MeshKind kind) { return sphere_cap("120° opening", radians(120), 1500, kind); }, 5},
          {"cylinder, three pieces", three_pieces, 0.01},
          {"cylinder, 240° missing", most_of_cylinder, 0.05},
          unduloid_case("500", 113, 0.1),
          unduloid_case("5k", 358, 0.05),
          {"catenoid", catenoid_hole, 0.05},
          {"torus", torus_hole, 0, true},
          {"ellipsoid", ellipsoid_hole, 0, true},
          {"graph surface", graph_hole, 0, true},
          {"mvc cylinder", mvc_hole, 0.05},
          sheet_case(1),
          sheet_case(2),
          sheet_case(3),
          sheet_case(4),
          sheet_case(5),
          sheet_case(6)};
}

std::vector<AccuracyCase> density_cases() {
  return {sphere_case(30, 500, "500", 0.02, true), unduloid_case("500", 113, 0.1)};
}

}  // namespace loopmend::bench
