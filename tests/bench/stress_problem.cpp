// SPDX-License-Identifier: GPL-3.0-or-later
#include "stress_problem.h"

#include "known_surfaces.h"
#include "region_cut.h"
#include "scans.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loopmend::bench {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int least_removed = 3, most_removed = 5000, most_vertices = 120000;

/// What a seed asks for, before it is known whether it can be had.
struct Request {
  int surface = 0;  ///< 0..6 analytic, from 7 on scans
  MeshKind mesh = MeshKind::regular;
  HoleShape shape;
  double size = 0;     ///< of the hole, parts of the extent
  double removed = 0;  ///< vertices
  unsigned mesh_seed = 0;
};

constexpr int analytic_surfaces = 7;

Request draw(Random& random) {
  Request request;
  const bool analytic = random.uniform() < 0.75;
  request.surface = static_cast<int>(analytic ? random.next() % analytic_surfaces
                                              : analytic_surfaces + random.next() % scan_names().size());
  request.mesh = static_cast<MeshKind>(random.next() % 3);
  request.shape = random_shape(static_cast<ShapeKind>(random.next() % 5), random);
  request.size = 0.03 * std::pow(20, std::sqrt(random.uniform()));
  request.removed = least_removed * std::pow(double(most_removed) / least_removed, std::sqrt(random.uniform()));
  request.mesh_seed = random.next();
  return request;
}

/// Extent and area of each analytic surface as built below, to choose a mesh for a wish.
struct SurfaceSize {
  double extent, area;
};
constexpr SurfaceSize sizes[analytic_surfaces] = {{2, 12.6}, {3, 18.9}, {2.8, 15.8}, {2.8, 16.3},
                                                  {6, 34},   {2, 5},    {2, 7.9}};

/// Edge length at which the hole holds as many vertices as wished, within what a mesh may have in all.
double edge_length(const Request& request) {
  const SurfaceSize& size = sizes[request.surface];
  const double radius = request.size * size.extent / 2;
  const double hole = request.shape.area() * radius * radius;
  const double finest = std::sqrt(size.area / (0.87 * most_vertices)), coarsest = std::sqrt(size.area / (0.87 * 300));
  return std::clamp(std::sqrt(hole / (0.87 * request.removed)), finest, coarsest);
}

KnownSurface analytic_surface(const Request& request) {
  const double edge = edge_length(request);
  const int around = std::max(8, static_cast<int>(std::lround(2 * pi / edge)));
  const int frequency = std::max(1, static_cast<int>(std::lround(1.2 / edge)));
  switch (request.surface) {
    case 0: return known_sphere(frequency);
    case 1: return known_cylinder(3, around);
    case 2: return known_torus(0.4, around);
    case 3: return known_catenoid(1.2, around);
    case 4: return known_unduloid(0.4, 3, around);
    case 5: return known_graph(std::max(8, static_cast<int>(std::lround(2 / edge))));
    default: return known_ellipsoid({1, 0.8, 0.6}, std::max(1, frequency));
  }
}

/// True if the surface is sound where it was cut: a patch for a place where the scan cuts or folds itself has no truth.
bool sound(const RegionCut& cut) {
  const OriginalFaults faults = faults_of_original(cut.removed, cut.open);
  return faults.cuts == 0 && faults.folds == 0;
}

/// A few places for the hole; the first that gives a clean cut of the right size out of a sound surface.
std::optional<RegionCut> find_cut(const TriangleSoup& whole, const Request& request, double scale, Random& random) {
  RegionPlan plan;
  plan.shape = request.shape;
  plan.radius = request.size * scale / 2;
  plan.clearance = 2;
  for (int attempt = 0; attempt < 8; ++attempt) {
    plan.center = static_cast<int>(random.next() % whole.points.size());
    plan.turn = random.uniform(0, 2 * pi);
    if (expected_vertices(whole, plan) > 2 * most_removed) continue;
    std::optional<RegionCut> cut = cut_region(whole, plan);
    if (cut && cut->removed_vertices >= least_removed && cut->removed_vertices <= most_removed && sound(*cut))
      return cut;
  }
  return std::nullopt;
}

std::optional<StressProblem> realise(const Request& request, Random& random) {
  StressProblem result;
  const bool analytic = request.surface < analytic_surfaces;
  const std::string name = analytic ? "" : scan_names()[request.surface - analytic_surfaces];
  KnownSurface surface;
  if (analytic) surface = with_mesh(analytic_surface(request), request.mesh, request.mesh_seed);
  const TriangleSoup& whole = analytic ? surface.mesh : scan(name);
  const double scale = analytic ? sizes[request.surface].extent : extent(whole);
  std::optional<RegionCut> cut = find_cut(whole, request, scale, random);
  if (!cut) return std::nullopt;
  result.removed = cut->removed;
  result.problem = problem_of("", std::move(*cut),
                              analytic ? [project = surface.project](const Vec3& p) { return (p - project(p)).norm(); }
                                       : std::function<double(const Vec3&)>([](const Vec3&) { return 0.0; }));
  result.has_answer = analytic && surface.name != "torus" && surface.name != "graph" && surface.name != "ellipsoid";
  if (result.problem.loops.size() != 1) return std::nullopt;
  result.surface = analytic ? surface.name : "scan " + name;
  result.mesh = analytic ? to_string(request.mesh) : "scan";
  result.shape = to_string(request.shape.kind);
  result.size = result.problem.diameter() / scale;
  return result;
}

}  // namespace

std::optional<StressProblem> make_stress_problem(std::uint64_t seed) {
  Random random(seed);
  for (int attempt = 0; attempt < 12; ++attempt) {
    const Request request = draw(random);
    if (std::optional<StressProblem> result = realise(request, random)) {
      result->problem.name = result->surface + ", " + result->shape + ", " + result->mesh;
      return result;
    }
  }
  return std::nullopt;
}

}  // namespace loopmend::bench
