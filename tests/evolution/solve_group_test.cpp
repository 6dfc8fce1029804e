// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/solve_group.h"
#include "mesh/mesh_arrays.h"
#include "rim/white_noise.h"
#include "samples/random.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>

namespace loopmend {
namespace {

/// A sphere with relief of scans and white noise, without its cap: the same triangles and the same hole, whatever the relief.
SurfaceModel rough_open_sphere(double relief, double noise) {
  TriangleSoup soup = trim_rims(cut(make_icosphere(5), [](const Vec3& p) { return p.z() > 0.85; }));
  Random random(7);
  for (Vec3& p : soup.points)
    p *= 1 + noise * random.bell() +
         relief * (0.01 * std::sin(17 * p.x()) * std::sin(19 * p.y()) + 0.004 * std::sin(43 * p.x() + 7 * p.z()) +
                   0.002 * std::cos(71 * p.y() - 23 * p.x()));
  return make_surface_model(soup);
}

/// What becomes of one filler when its surroundings change: the triangles stay, the free vertices are carried along. The
/// filler that belongs to each rim would have triangles of its own, which change one by one as the rim does; on a rough
/// rim another triangulation alone moves the patch by up to 5 % of an edge, whatever the kinds do.
struct Family {
  std::function<SurfaceModel(double)> surface;  ///< t = 0..1
  Patch filler;                                 ///< of t = 0

  explicit Family(std::function<SurfaceModel(double)> of)
      : surface(std::move(of)),
        filler(test::start_of(surface(0))) {}

  struct Member {
    Patch patch;
    RimRoughness rim;
  };

  Member at(double t) const {
    const SurfaceModel model = surface(t);
    Patch moved = filler;
    for (int i = moved.free_count; i < moved.vertex_count(); ++i)
      moved.positions[i] = moved.to_frame(model.mesh.point(TriMesh::VertexHandle(moved.view_vertex[i])));
    const Patch start = with_noise_again(filler, moved);
    Evolved evolved = evolve_filler(FillSite(model), start, {}, nullptr, {});
    EXPECT_EQ(evolved.status, LoopStatus::converged) << evolved.message;
    EXPECT_EQ(evolved.patch.free_count, filler.free_count) << "remeshed at t = " << t;
    return {std::move(evolved.patch), rim_roughness(start)};
  }
};

/// The way of the vertex that moves farthest, mesh units.
double change(const Family::Member& a, const Family::Member& b) {
  double most = 0;
  for (int i = 0; i < std::min(a.patch.free_count, b.patch.free_count); ++i)
    most = std::max(most, a.patch.scale * (a.patch.positions[i] - b.patch.positions[i]).norm());
  return most;
}

/// Where the patch changes most, and where the kind changes, the interval is halved again and again: a jump stays.
/// @returns what is left of the change over 1/4000 of the family or less.
double steepest(const Family& family, int intervals) {
  std::vector<Family::Member> members;
  for (int k = 0; k <= intervals; ++k) members.push_back(family.at(static_cast<double>(k) / intervals));
  double most = 0, left = 0;
  for (int k = 0; k < intervals; ++k) most = std::max(most, change(members[k], members[k + 1]));
  for (int k = 0; k < intervals; ++k) {
    Family::Member a = members[k], b = members[k + 1];
    if (change(a, b) < most && a.rim.kind == b.rim.kind) continue;
    double from = static_cast<double>(k) / intervals, to = static_cast<double>(k + 1) / intervals;
    while (to - from > 1.0 / 4000) {
      const double middle = (from + to) / 2;
      Family::Member m = family.at(middle);
      if (change(a, m) > change(m, b)) {
        b = std::move(m);
        to = middle;
      } else {
        a = std::move(m);
        from = middle;
      }
    }
    left = std::max(left, change(a, b));
  }
  return left;
}

constexpr double edge = 0.038;  // mean, of the icosphere
/// Measured: 0.003 of an edge from smooth to rough and from rough to noisy, less from smooth to noisy.
constexpr double tolerance = 0.005 * edge;

TEST(PassageOfKinds, FromSmoothToRoughWithoutAJump) {
  EXPECT_LT(steepest(Family([](double t) { return rough_open_sphere(t, 0); }), 8), tolerance);
}

TEST(PassageOfKinds, FromSmoothToNoisyWithoutAJump) {
  EXPECT_LT(steepest(Family([](double t) { return rough_open_sphere(0, 0.01 * edge * t); }), 8), tolerance);
}

TEST(PassageOfKinds, FromRoughToNoisyWithoutAJump) {
  EXPECT_LT(steepest(Family([](double t) { return rough_open_sphere(0.3, 0.05 * edge * t); }), 8), tolerance);
}

}  // namespace
}  // namespace loopmend
