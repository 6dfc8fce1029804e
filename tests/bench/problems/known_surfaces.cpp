// SPDX-License-Identifier: GPL-3.0-or-later
#include "known_surfaces.h"

#include "profile_curve.h"
#include "samples/analytic_surfaces.h"
#include "surfaces/roughen.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <random>

namespace loopmend::bench {

namespace {

constexpr double pi = std::numbers::pi;

/// Numbers places so that the same place, reached over two triangles, is one vertex.
class PlaceIndex {
 public:
  explicit PlaceIndex(Points& points) : points_(points) {}
  int operator()(const Vec3& p) {
    const std::array<long, 3> key{std::lround(p.x() * 1e9), std::lround(p.y() * 1e9), std::lround(p.z() * 1e9)};
    const auto [entry, added] = index_.try_emplace(key, static_cast<int>(points_.size()));
    if (added) points_.push_back(p);
    return entry->second;
  }

 private:
  Points& points_;
  std::map<std::array<long, 3>, int> index_;
};

TriangleSoup geodesic_sphere(int frequency) {
  const TriangleSoup base = make_icosphere(0);
  TriangleSoup soup;
  PlaceIndex index(soup.points);
  for (const auto& [a, b, c] : base.triangles) {
    const auto at = [&, a = a, b = b, c = c](int i, int j) {
      const int k = frequency - i - j;
      return index((k * base.points[a] + i * base.points[b] + j * base.points[c]).normalized());
    };
    for (int i = 0; i < frequency; ++i)
      for (int j = 0; i + j < frequency; ++j) {
        soup.triangles.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
        if (i + j + 1 < frequency) soup.triangles.push_back({at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  return soup;
}

/// Nearest point of an ellipsoid: q = a²p / (a² + t) with t the root of Σ (q/a)² = 1.
Vec3 onto_ellipsoid(const Vec3& p, const Vec3& a) {
  const Eigen::Array3d a2 = a.array().square();
  double t = 0;
  for (int k = 0; k < 60; ++k) {
    const Eigen::Array3d q = a.array() * p.array() / (a2 + t);
    const double f = q.square().sum() - 1, slope = -2 * (q.square() / (a2 + t)).sum();
    const double next = std::max(t - f / slope, (t - 0.9 * a2.minCoeff()) / 2);
    if (std::abs(next - t) < 1e-16) break;
    t = next;
  }
  return a2 * p.array() / (a2 + t);
}

/// A height over the plane and its slope.
struct Graph {
  std::function<double(double, double)> height;
  std::function<Eigen::Vector2d(double, double)> slope;
};

double graph_height(double x, double y) { return 0.3 * std::sin(2 * x) * std::cos(1.5 * y) + 0.1 * x * x; }

Eigen::Vector2d graph_slope(double x, double y) {
  return {0.6 * std::cos(2 * x) * std::cos(1.5 * y) + 0.2 * x, -0.45 * std::sin(2 * x) * std::sin(1.5 * y)};
}

/// Four waves; the same for the same seed on every machine.
Graph waves(unsigned seed) {
  struct Wave {
    double height, kx, ky, phase;
  };
  std::mt19937 random(seed);
  const auto drawn = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / 4294967296.0;
  };
  std::array<Wave, 4> all{};
  for (Wave& wave : all) {
    wave.height = drawn(0.02, 0.2);
    wave.kx = drawn(-4, 4);
    wave.ky = drawn(-4, 4);
    wave.phase = drawn(0, 2 * pi);
  }
  return {[all](double x, double y) {
            double z = 0;
            for (const auto& [height, kx, ky, phase] : all) z += height * std::sin(kx * x + ky * y + phase);
            return z;
          },
          [all](double x, double y) {
            Eigen::Vector2d slope = Eigen::Vector2d::Zero();
            for (const auto& [height, kx, ky, phase] : all)
              slope += height * std::cos(kx * x + ky * y + phase) * Eigen::Vector2d(kx, ky);
            return slope;
          }};
}

/// Gauss-Newton over (x, y).
Vec3 onto_graph(const Vec3& p, const Graph& graph) {
  Eigen::Vector2d q = p.head<2>();
  for (int k = 0; k < 100; ++k) {
    const Eigen::Vector2d slope = graph.slope(q.x(), q.y());
    const double rise = p.z() - graph.height(q.x(), q.y());
    const Eigen::Vector2d rest = p.head<2>() - q + rise * slope;
    const Eigen::Vector2d step = rest - slope * (slope.dot(rest) / (1 + slope.squaredNorm()));
    q += step;
    if (step.norm() < 1e-16) break;
  }
  return {q.x(), q.y(), graph.height(q.x(), q.y())};
}

KnownSurface surface_of(std::string name, Graph graph, int cells) {
  TriangleSoup mesh = make_graph(graph.height, 1, cells);
  return {std::move(name), std::move(mesh), [graph = std::move(graph)](const Vec3& p) { return onto_graph(p, graph); }};
}

/// Rows evenly spaced in arc length, as far apart as the vertices of a circle of radius 1.
KnownSurface revolution(std::string name, const ProfileCurve& profile, double half_length, int around) {
  const int rows = std::max(1, static_cast<int>(std::lround(2 * half_length * around / (2 * pi))));
  KnownSurface surface;
  surface.name = std::move(name);
  surface.mesh = make_revolution([](double) { return 1.0; }, -half_length, half_length, around, rows);
  for (Vec3& p : surface.mesh.points) {
    const Eigen::Vector2d place = profile.point(p.z());
    p = {place.x() * p.x(), place.x() * p.y(), place.y()};
  }
  const double reach = half_length + 0.3;
  surface.project = [=](const Vec3& p) -> Vec3 {
    const double radius = std::hypot(p.x(), p.y());
    const Eigen::Vector2d place = profile.point(nearest_arc_length(profile, {radius, p.z()}, -reach, reach));
    return {place.x() * p.x() / radius, place.x() * p.y() / radius, place.y()};
  };
  return surface;
}

}  // namespace

const char* to_string(MeshKind kind) {
  switch (kind) {
    case MeshKind::regular: return "regular";
    case MeshKind::jittered: return "jittered";
    case MeshKind::irregular: return "irregular";
  }
  return "";
}

KnownSurface known_sphere(int frequency) {
  return {"sphere", geodesic_sphere(frequency), [](const Vec3& p) -> Vec3 { return p.normalized(); }};
}

KnownSurface known_cylinder(double height, int around) {
  KnownSurface surface{"cylinder", make_cylinder(height, around), [](const Vec3& p) -> Vec3 {
                         const double radius = std::hypot(p.x(), p.y());
                         return {p.x() / radius, p.y() / radius, p.z()};
                       }};
  for (Vec3& p : surface.mesh.points) p.z() -= height / 2;
  return surface;
}

KnownSurface known_torus(double minor, int around) {
  const int across = std::max(8, static_cast<int>(std::lround(minor * around)));
  return {"torus", make_torus(1, minor, around, across), [minor](const Vec3& p) -> Vec3 {
            const Vec3 ring = Vec3(p.x(), p.y(), 0).normalized();
            return ring + minor * (p - ring).normalized();
          }};
}

KnownSurface known_ellipsoid(const Vec3& half_axes, int frequency) {
  KnownSurface surface{"ellipsoid", geodesic_sphere(frequency),
                       [half_axes](const Vec3& p) { return onto_ellipsoid(p, half_axes); }};
  for (Vec3& p : surface.mesh.points) p = p.cwiseProduct(half_axes);
  return surface;
}

KnownSurface known_graph(int cells) { return surface_of("graph", {graph_height, graph_slope}, cells); }

KnownSurface known_sheet(unsigned seed, int cells) {
  return surface_of("sheet " + std::to_string(seed), waves(seed), cells);
}

KnownSurface known_mvc_cylinder(int cells) {
  constexpr double half_length = 1, known_beyond = 0.1;
  const ProfileCurve profile = mvc_profile({0.8, 1.2, -1.5, -0.8}, half_length + known_beyond);
  KnownSurface surface;
  surface.name = "mvc cylinder";
  surface.mesh = make_graph([](double, double) { return 0.0; }, half_length, cells);
  for (Vec3& p : surface.mesh.points) {
    const Eigen::Vector2d place = profile.point(p.x());
    p = {place.x(), place.y(), p.y()};
  }
  surface.project = [=](const Vec3& p) -> Vec3 {
    constexpr double reach = half_length + known_beyond;
    const Eigen::Vector2d place = profile.point(nearest_arc_length(profile, p.head<2>(), -reach, reach));
    return {place.x(), place.y(), p.z()};
  };
  return surface;
}

KnownSurface known_catenoid(double half_length, int around) {
  return revolution("catenoid", catenoid_profile(), half_length, around);
}

KnownSurface known_unduloid(double bulge, double half_length, int around) {
  return revolution("unduloid", unduloid_profile(bulge, half_length + 1), half_length, around);
}

KnownSurface with_mesh(KnownSurface surface, MeshKind kind, unsigned seed) {
  if (kind == MeshKind::regular) return surface;
  surface.mesh = roughen(surface.mesh, 0.2, kind == MeshKind::irregular ? 0.25 : 0, seed, surface.project);
  return surface;
}

KnownSurface cropped(KnownSurface surface, const Vec3& center, double radius) {
  surface.mesh = trim_boundaries(cut(surface.mesh, [=](const Vec3& p) { return (p - center).norm() > radius; }));
  return surface;
}

}  // namespace loopmend::bench
