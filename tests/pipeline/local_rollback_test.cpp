// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/local_rollback.h"

#include "operators/topology.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace loopmend {
namespace {

/// The free vertex farthest from the boundary.
int innermost(const Patch& patch) {
  const Topology topology(patch.vertex_count(), patch.triangles);
  std::vector<int> way(patch.vertex_count(), -1), queue;
  for (int i = patch.free_count; i < patch.vertex_count(); ++i) {
    way[i] = 0;
    queue.push_back(i);
  }
  for (std::size_t q = 0; q < queue.size(); ++q)
    for (int w : topology.neighbors(queue[q]))
      if (way[w] < 0) {
        way[w] = way[queue[q]] + 1;
        queue.push_back(w);
      }
  return queue.back();
}

constexpr double edge = 0.038;  // mean, of the icosphere

struct Scene {
  SurfaceModel model = test::open_sphere(5, 0.6);
  Patch start = test::exact_sphere_patch(5, 0.6);
  Patch evolved = start;
  int middle = innermost(start);
  Validity limit;

  Scene() { test::disturb(evolved, 0.005); }

  /// The middle goes beyond one of its neighbours.
  void fold() {
    const Topology topology(start.vertex_count(), start.triangles);
    const Vec3 &p = evolved.positions[middle], &q = evolved.positions[topology.neighbors(middle)[0]];
    evolved.positions[middle] = p + 1.6 * (q - p);
  }
  /// A piece of surface of its own, a little above the middle, through which the evolved patch runs.
  void cut() {
    TriangleSoup soup = ::loopmend::cut(make_icosphere(5), [](const Vec3& p) { return p.z() > 0.6; });
    const Vec3 top = start.to_mesh(start.positions[middle]), n = top.normalized(), u = n.unitOrthogonal();
    const Vec3 v = n.cross(u), at = top + 0.7 * edge * n;
    const int first = static_cast<int>(soup.points.size());
    soup.points.insert(soup.points.end(), {at + 2 * edge * u, at + 2 * edge * (v - u), at - 2 * edge * (v + u)});
    soup.triangles.push_back({first, first + 1, first + 2});
    model = make_surface_model(soup);
    const Topology topology(start.vertex_count(), start.triangles);
    const auto around = topology.neighbors(middle);
    std::vector<int> raised(around.begin(), around.end());
    raised.push_back(middle);
    for (int i : raised) evolved.positions[i] += 1.4 * edge * n / start.scale;
  }
  Validity validity() const { return validate(ScanIndex(model), evolved); }
  std::optional<LocalRollback> rollback(const CancelToken& cancel = {}) const {
    return roll_back_locally(ScanIndex(model), start, evolved, limit, cancel);
  }
};

/// Clean; the other vertices as evolved, to the last bit; each that went back lies between the two.
void expect_local(const Scene& scene, const LocalRollback& rollback) {
  EXPECT_EQ(validate(ScanIndex(scene.model), rollback.patch).folds, 0);
  EXPECT_EQ(validate(ScanIndex(scene.model), rollback.patch).intersections, 0);
  EXPECT_GT(rollback.rings, 0);
  EXPECT_GT(rollback.moved, 0);
  int changed = 0;
  for (int i = 0; i < scene.start.vertex_count(); ++i) {
    const Vec3 &from = scene.start.positions[i], &to = scene.evolved.positions[i], &at = rollback.patch.positions[i];
    changed += at != to;
    EXPECT_LE((at - from).norm() + (to - at).norm(), (to - from).norm() + 1e-12) << i << " is not on its way";
  }
  EXPECT_LE(changed, rollback.moved);
  EXPECT_LT(changed, scene.start.free_count / 3) << "not local";
  EXPECT_EQ(rollback.patch.positions[scene.middle], scene.start.positions[scene.middle]);
}

TEST(LocalRollback, TakesAFoldBackAndNothingElse) {
  Scene scene;
  scene.fold();
  ASSERT_GT(scene.validity().folds, 0);
  const std::optional<LocalRollback> rollback = scene.rollback();
  ASSERT_TRUE(rollback);
  expect_local(scene, *rollback);
}

TEST(LocalRollback, TakesACutBackAndNothingElse) {
  Scene scene;
  scene.cut();
  ASSERT_GT(scene.validity().intersections, 0);
  const std::optional<LocalRollback> rollback = scene.rollback();
  ASSERT_TRUE(rollback);
  expect_local(scene, *rollback);
}

TEST(LocalRollback, LeavesWhatMayBeKeptAsItIs) {
  Scene scene;
  scene.limit = scene.validity();
  const std::optional<LocalRollback> clean = scene.rollback();
  ASSERT_TRUE(clean);
  EXPECT_EQ(clean->rings, 0);
  EXPECT_EQ(clean->patch.positions, scene.evolved.positions);
  scene.fold();
  scene.limit = scene.validity();
  const std::optional<LocalRollback> as_bad = scene.rollback();
  ASSERT_TRUE(as_bad);
  EXPECT_EQ(as_bad->patch.positions, scene.evolved.positions);
}

TEST(LocalRollback, NeedsTheVerticesOfTheStart) {
  Scene scene;
  scene.fold();
  scene.start = test::exact_sphere_patch(5, 0.7);
  ASSERT_NE(scene.start.free_count, scene.evolved.free_count);
  EXPECT_FALSE(scene.rollback());
}

/// Turns the first edge between two triangles whose corners are all free.
void turn_an_edge(Patch& patch) {
  const auto is_free = [&](const Triangle& t) { return *std::max_element(t.begin(), t.end()) < patch.free_count; };
  for (int f = 0; f < patch.patch_triangles; ++f)
    for (int g = f + 1; g < patch.patch_triangles; ++g)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l) {
          const Triangle s = patch.triangles[f], t = patch.triangles[g];
          const int a = s[k], b = s[(k + 1) % 3], c = s[(k + 2) % 3], d = t[(l + 2) % 3];
          if (!is_free(s) || !is_free(t) || t[l] != b || t[(l + 1) % 3] != a) continue;
          patch.triangles[f] = {a, d, c};
          patch.triangles[g] = {d, b, c};
          return;
        }
}

/// What the start has is of no account.
TEST(LocalRollback, KeepsTheTrianglesOfTheEvolvedPatch) {
  Scene scene;
  scene.fold();
  ASSERT_GT(scene.validity().folds, 0);
  turn_an_edge(scene.start);
  ASSERT_NE(scene.start.triangles, scene.evolved.triangles);
  const std::optional<LocalRollback> rollback = scene.rollback();
  ASSERT_TRUE(rollback);
  expect_local(scene, *rollback);
  EXPECT_EQ(rollback->patch.triangles, scene.evolved.triangles);
}

TEST(LocalRollback, IsNoneWhereTheWholePatchWouldGoBack) {
  Scene scene;
  // Inside out: folded along the whole boundary, and on its way back everywhere.
  for (int i = 0; i < scene.start.free_count; ++i)
    scene.evolved.positions[i] = scene.start.to_frame(-3 * scene.start.to_mesh(scene.start.positions[i]));
  EXPECT_FALSE(scene.rollback());
}

TEST(LocalRollback, EndsWhenCancelled) {
  Scene scene;
  scene.fold();
  const CancelToken cancel;
  cancel.cancel();
  EXPECT_FALSE(scene.rollback(cancel));
}

}  // namespace
}  // namespace loopmend
