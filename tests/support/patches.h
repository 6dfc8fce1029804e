// SPDX-License-Identifier: GPL-3.0-or-later
// Hole problems that several tests share.
#pragma once

#include "core/random.h"
#include "operators/topology.h"
#include "pipeline/fill_holes.h"
#include "samples/analytic_surfaces.h"
#include "surfaces/roughen.h"

#include <Eigen/Geometry>

#include <cmath>

namespace loopmend::test {

inline Vec3 onto_sphere(const Vec3& p) { return p.normalized(); }

/// Unit sphere without its cap above z = height.
inline SurfaceModel open_sphere(int level, double height) {
  return make_surface_model(cut(make_icosphere(level), [=](const Vec3& p) { return p.z() > height; }));
}

/// The same with jittered vertices and flipped edges.
inline SurfaceModel rough_open_sphere(int level, double height) {
  return make_surface_model(
      cut(roughen(make_icosphere(level), 0.2, 0.25, 11, onto_sphere), [=](const Vec3& p) { return p.z() > height; }));
}

/// The initial patch of all holes of a model as one patch.
inline Patch start_of(const SurfaceModel& model) {
  return *make_initial_patch(model, find_boundary_loops(model), InitialPatchOptions{}, CancelToken()).patch;
}

/// A patch whose free vertices lie exactly on the unit sphere.
inline Patch exact_sphere_patch(int level, double height) {
  Patch patch = start_of(open_sphere(level, height));
  for (int i = 0; i < patch.free_count; ++i)
    patch.positions[i] = patch.to_frame(patch.to_mesh(patch.positions[i]).normalized());
  return patch;
}

/// Heights of a relief with waves from an edge to a dozen edges, their height as their length; rms about 1. One for each point.
inline std::vector<double> random_relief(const TriangleSoup& soup, std::uint64_t seed) {
  const int n = static_cast<int>(soup.points.size());
  const Topology topology(n, soup.triangles);
  Random random(seed);
  std::vector<double> relief(n, 0);
  for (const int rounds : {1, 2, 4, 8, 16, 32}) {
    std::vector<double> wave(n);
    for (double& w : wave) w = random.bell();
    for (int round = 0; round < rounds; ++round) {
      std::vector<double> next(n);
      for (int i = 0; i < n; ++i) {
        next[i] = wave[i];
        for (int j : topology.neighbors(i)) next[i] += wave[j];
        next[i] /= 1 + topology.valence(i);
      }
      wave = std::move(next);
    }
    double squares = 0;
    for (double w : wave) squares += w * w / n;
    for (int i = 0; i < n; ++i) relief[i] += std::sqrt(rounds / 63.0) * wave[i] / std::sqrt(squares);
  }
  return relief;
}

/// Bumps on the free vertices, in mean edge lengths of about 1/20 of the frame.
inline void disturb(Patch& patch, double amount) {
  for (int i = 0; i < patch.free_count; ++i) {
    const Vec3& p = patch.positions[i];
    patch.positions[i] += amount * std::sin(9 * p.x() + 2) * std::cos(7 * p.y()) * Vec3(0.1, -0.2, 1).normalized();
  }
}

}  // namespace loopmend::test
