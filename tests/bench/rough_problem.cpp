// SPDX-License-Identifier: GPL-3.0-or-later
#include "rough_problem.h"

#include "known_surfaces.h"
#include "pipeline/validate.h"
#include "region_cut.h"
#include "samples/analytic_surfaces.h"
#include "scans.h"

#include <cmath>
#include <numbers>

namespace loopmend::bench {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int surrounding_rings = 30, least_removed = 20, most_removed = 6000;

/// Problems 2j and 2j + 1 are of one kind, so that the tuned and the set-aside half hold the same scans and shapes; 24
/// kinds are all the pairs.
struct RoughKind {
  std::string scan;
  ShapeKind shape;
};

RoughKind kind_of(int k) {
  constexpr ShapeKind shapes[] = {ShapeKind::disc, ShapeKind::ellipse, ShapeKind::star, ShapeKind::slit};
  const std::size_t j = static_cast<std::size_t>(k) / 2;
  return {scan_names()[j % scan_names().size()], shapes[(j + j / 12) % 4]};
}

/// Outward, area-weighted, unit.
Points unit_normals(const TriangleSoup& soup) {
  Points normals(soup.points.size(), Vec3::Zero());
  for (const auto& [a, b, c] : soup.triangles) {
    const Vec3 n = (soup.points[b] - soup.points[a]).cross(soup.points[c] - soup.points[a]);
    for (int v : {a, b, c}) normals[v] += n;
  }
  for (Vec3& n : normals) n.normalize();
  return normals;
}

void add_noise(TriangleSoup& soup, double sigma, unsigned seed) {
  const Points normals = unit_normals(soup);
  Random random(seed);
  for (std::size_t v = 0; v < soup.points.size(); ++v) soup.points[v] += sigma * random.bell() * normals[v];
}

}  // namespace

std::optional<RoughProblem> make_rough_problem(std::uint64_t seed, int k) {
  const auto [name, shape] = kind_of(k);
  const TriangleSoup& whole = scan(name);
  Random random(seed * 1000003 + static_cast<std::uint64_t>(k));
  RegionPlan plan;
  for (int attempt = 0; attempt < 60; ++attempt) {
    plan.shape = random_shape(shape, random);
    plan.center = static_cast<int>(random.next() % whole.points.size());
    plan.radius = extent(whole) * 0.05 * std::pow(6, random.uniform()) / 2;
    plan.turn = random.uniform(0, 2 * pi);
    plan.clearance = 6;
    if (expected_vertices(whole, plan) > 1.5 * most_removed) continue;
    std::optional<RegionCut> cut = cut_region(whole, plan);
    if (!cut || cut->removed_vertices < least_removed || cut->removed_vertices > most_removed) continue;
    crop_around_cut(*cut, surrounding_rings);
    RoughProblem result;
    result.problem = problem_of(name + " " + std::to_string(k), std::move(*cut));
    if (result.problem.loops.size() != 1) continue;
    if (pierced_edges(ScanIndex(result.problem.model), result.problem.loops.front()) > 0) continue;
    result.scan = name;
    result.shape = to_string(plan.shape.kind);
    result.size = result.problem.diameter() / extent(whole);
    return result;
  }
  return std::nullopt;
}

HoleProblem make_noisy_problem(NoisySurface kind, double noise, unsigned seed) {
  const bool sphere = kind == NoisySurface::sphere;
  const double edge = sphere ? 1.2 / 30 : 2 * pi / 150;
  KnownSurface surface = with_mesh(sphere ? known_sphere(30) : known_torus(0.4, 150), MeshKind::jittered, seed);
  add_noise(surface.mesh, noise * edge, seed + 1);
  const Vec3 center =
      sphere ? Vec3(Vec3(0.3, -0.2, 1).normalized()) : Vec3(1 + 0.4 * std::cos(1.0), 0, 0.4 * std::sin(1.0));
  const double radius = sphere ? 0.4 : 0.36;
  return cut_problem(
      surface.name, surface.mesh, [=](const Vec3& p) { return (p - center).norm() < radius; },
      [project = surface.project](const Vec3& p) { return (p - project(p)).norm(); });
}

}  // namespace loopmend::bench
