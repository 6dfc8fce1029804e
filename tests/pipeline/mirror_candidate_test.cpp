// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/mirror_candidate.h"

#include "core/error.h"
#include "core/random.h"
#include "mesh/surface_tree.h"
#include "pipeline/fill_holes.h"
#include "samples/mesh_facts.h"
#include "support/filled_surface.h"
#include "support/mirror_models.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

namespace loopmend {
namespace {

FillOptions mirrored(int threads = 1) {
  FillOptions options;
  options.mirror = FillOptions::Mirror::find;
  options.threads = threads;
  return options;
}

struct Filled {
  TriangleSoup before, after;
  std::vector<HoleResult> holes;

  explicit Filled(const TriangleSoup& open, const FillOptions& options = mirrored()) : before(open) {
    SurfaceModel model = make_surface_model(open);
    holes = fill_all_holes(model, options);
    after = model.soup;
  }

  /// The largest of the new points, in diameters of the hole.
  double farthest(const test::BumpyEllipsoid& shape) const {
    double most = 0;
    for (std::size_t v = before.points.size(); v < after.points.size(); ++v)
      most = std::max(most, shape.distance(after.points[v]));
    return most / holes.front().loop.diameter;
  }
};

TEST(MirrorImage, BringsBackABump) {
  const test::BumpyEllipsoid shape;
  const Filled mirror(shape.open_mesh(5)), flow(shape.open_mesh(5), {});
  ASSERT_EQ(mirror.holes.size(), 1u);
  const HoleResult& hole = mirror.holes.front();
  EXPECT_EQ(hole.outcome().made_by, "mirror image");
  EXPECT_EQ(hole.method(), "mirror_image");
  EXPECT_TRUE(hole.mirror.is_proposed());
  EXPECT_EQ(hole.verdict().grade, Grade::good) << hole.verdict().message();
  // The image's facets leave the surface by their sagitta, some 0.002 diameters; the bump's top is 0.35 diameters above its foot.
  EXPECT_LT(mirror.farthest(shape), 0.004);
  EXPECT_GT(flow.farthest(shape), 5 * mirror.farthest(shape));
}

TEST(MirrorImage, LeavesTheRestAsItIsAndClosesTheSurface) {
  const Filled filled(test::BumpyEllipsoid().open_mesh(5));
  ASSERT_GT(filled.after.points.size(), filled.before.points.size());
  EXPECT_EQ(
      std::memcmp(filled.after.points.data(), filled.before.points.data(), filled.before.points.size() * sizeof(Vec3)),
      0);
  EXPECT_TRUE(
      std::equal(filled.before.triangles.begin(), filled.before.triangles.end(), filled.after.triangles.begin()));
  const test::CgalMesh mesh = test::to_cgal(filled.after);
  EXPECT_TRUE(CGAL::is_closed(mesh));
  EXPECT_FALSE(CGAL::Polygon_mesh_processing::does_self_intersect(mesh));
}

TEST(MirrorImage, HasTheSameBitsForOneThreadAndTwo) {
  const TriangleSoup open = test::BumpyEllipsoid().open_mesh(5);
  const Filled one(open, mirrored(1)), two(open, mirrored(2));
  ASSERT_EQ(one.after.points.size(), two.after.points.size());
  EXPECT_EQ(std::memcmp(one.after.points.data(), two.after.points.data(), one.after.points.size() * sizeof(Vec3)), 0);
  EXPECT_EQ(one.after.triangles, two.after.triangles);
}

TEST(MirrorImage, BringsBackABumpUnderNoise) {
  const test::BumpyEllipsoid shape;
  TriangleSoup noisy = shape.open_mesh(5, 0.32);  // the whole bump: the surface around it is smooth
  constexpr double noise = 1e-3;
  Random random(5);
  for (Vec3& p : noisy.points)
    p += noise * Vec3(random.uniform(-1.7, 1.7), random.uniform(-1.7, 1.7), random.uniform(-1.7, 1.7));
  const Filled mirror(noisy), flow(noisy, {});
  const HoleResult& hole = mirror.holes.front();
  ASSERT_EQ(hole.mirror.answer, MirrorFit::Answer::proposed) << hole.reason();
  EXPECT_GT(hole.mirror.difference, 3 * hole.mirror.misfit);
  EXPECT_LT(mirror.farthest(shape), 8 * noise / hole.loop.diameter);
  EXPECT_GT(flow.farthest(shape), 0.2);  // the bump is 0.25 high over a hole of 0.7
}

/// Around a place on the plane x = 0, more of it on the right.
TriangleSoup open_across(const test::BumpyEllipsoid& shape) {
  const Vec3 middle = Vec3(0.3, 0.75, 0.3).normalized();
  return trim_boundaries(cut(shape.mesh(5), [&](const Vec3& p) {
    return ((shape.motion().inverse() * p).normalized() - middle).norm() < 0.55;
  }));
}

TEST(MirrorImage, OfAHoleAcrossThePlaneMakesItsPatchSymmetric) {
  const test::BumpyEllipsoid shape;
  const Filled mirror(open_across(shape)), flow(open_across(shape), {});
  const HoleResult& hole = mirror.holes.front();
  ASSERT_EQ(hole.mirror.answer, MirrorFit::Answer::symmetric) << hole.reason();
  EXPECT_EQ(hole.status, PatchStatus::faired);  // no flow ends there
  EXPECT_NE(hole.reason().english().find("made symmetric"), std::string::npos);
  const auto asymmetry = [&](const Filled& filled) {
    const MirrorPlane plane = make_mirror_plane(shape.plane_point(), shape.plane_normal());
    const SurfaceTree surface(filled.after.points, filled.after.triangles);
    double most = 0;
    for (std::size_t v = filled.before.points.size(); v < filled.after.points.size(); ++v) {
      const Vec3 image = plane.image_of(filled.after.points[v]);
      most = std::max(most, (surface.closest(image).place - image).norm());
    }
    return most / filled.holes.front().loop.diameter;
  };
  EXPECT_LT(asymmetry(mirror), 0.3 * asymmetry(flow));
  EXPECT_LT(mirror.farthest(shape), flow.farthest(shape));
}

TEST(MirrorImage, LeavesAPatchAcrossThePlaneAsItIsWhereTheSidesDiffer) {
  test::BumpyEllipsoid shape;
  shape.left_height = 0.1;
  FillOptions options;
  options.mirror_planes = {make_mirror_plane(shape.plane_point(), shape.plane_normal())};
  const Filled mirror(open_across(shape), options), flow(open_across(shape), {});
  EXPECT_FALSE(mirror.holes.front().mirror.is_used()) << mirror.holes.front().reason();
  EXPECT_EQ(mirror.after.points, flow.after.points);
}

TEST(MirrorImage, IsRefusedWhereTheOtherSideIsAnother) {
  test::BumpyEllipsoid shape;
  shape.left_height = 0.1;
  const Filled mirror(shape.open_mesh(5)), flow(shape.open_mesh(5), {});
  const HoleResult& hole = mirror.holes.front();
  EXPECT_EQ(hole.mirror.answer, MirrorFit::Answer::no_gain);
  EXPECT_GT(hole.mirror.misfit, 0.01);
  EXPECT_LT(hole.mirror.difference, 3 * hole.mirror.misfit);
  EXPECT_NE(hole.outcome().made_by, "mirror image");
  EXPECT_NE(hole.reason().english().find("not copied from the mirror image"), std::string::npos) << hole.reason();
  EXPECT_EQ(hole.outcome().attempts.front(), "mirror image");
  ASSERT_EQ(mirror.after.points.size(), flow.after.points.size());  // and the ordinary patch is the same
  EXPECT_EQ(std::memcmp(mirror.after.points.data(), flow.after.points.data(), flow.after.points.size() * sizeof(Vec3)),
            0);
}

TEST(MirrorImage, IsRefusedOnASurfaceWithoutSymmetry) {
  TriangleSoup soup = make_icosphere(4);
  const std::vector<std::pair<Vec3, double>> bumps = {{{1, 0.2, 0.1}, 0.7},
                                                      {{-0.3, 1, 0.4}, 0.4},
                                                      {{0.1, -0.5, 1}, -0.4},
                                                      {{-0.8, -0.6, -0.3}, 0.9},
                                                      {{0.3, 0.2, -1}, -0.3}};
  for (Vec3& p : soup.points) {
    double radius = 1;
    for (const auto& [at, height] : bumps) radius += height * std::exp(-(p - at.normalized()).squaredNorm() / 0.3);
    p *= radius;
  }
  for (const Vec3& hole : {Vec3(1.6, 0.3, 0.2), Vec3(-0.4, 1.3, 0.5), Vec3(0, 0, -0.7), Vec3(-1.4, -1.1, -0.5)}) {
    const Filled mirror(trim_boundaries(cut(soup, [&](const Vec3& p) { return (p - hole).norm() < 0.3; })));
    ASSERT_EQ(mirror.holes.size(), 1u);
    EXPECT_FALSE(mirror.holes[0].mirror.is_proposed()) << mirror.holes[0].reason();
    EXPECT_NE(mirror.holes[0].method(), "mirror_image");
    EXPECT_TRUE(is_filled(mirror.holes[0].status));
  }
}

TEST(MirrorImage, IsRefusedWhereItIsOpenItself) {
  const test::BumpyEllipsoid shape;
  const TriangleSoup open = trim_boundaries(cut(shape.open_mesh(5), [&](const Vec3& p) {
    return ((shape.motion().inverse() * p).normalized() - shape.left_bump).norm() < 0.1;
  }));
  const Filled mirror(open);
  ASSERT_EQ(mirror.holes.size(), 2u);
  EXPECT_EQ(mirror.holes[0].mirror.answer, MirrorFit::Answer::open_there);  // the larger hole
  EXPECT_NE(mirror.holes[0].outcome().made_by, "mirror image");
}

TEST(MirrorImage, TakesAPlaneAndNoOther) {
  const test::BumpyEllipsoid shape;
  FillOptions options;
  options.mirror_planes = {make_mirror_plane(shape.plane_point(), shape.plane_normal())};
  const Filled right(shape.open_mesh(5), options);
  EXPECT_EQ(right.holes.front().method(), "mirror_image");
  EXPECT_EQ(right.holes.front().mirror.plane.point, shape.plane_point());
  options.mirror_planes = {make_mirror_plane(shape.plane_point(), Vec3(1, 1, 1))};
  const Filled wrong(shape.open_mesh(5), options);
  EXPECT_NE(wrong.holes.front().method(), "mirror_image");
}

TEST(MirrorImage, OfTwoNeighboringHolesIsTakenForEach) {
  const test::BumpyEllipsoid shape;
  const Vec3 beside = (shape.right_bump + Vec3(0, -0.32, 0.12)).normalized();
  const TriangleSoup open = trim_boundaries(cut(shape.open_mesh(5), [&](const Vec3& p) {
    return ((shape.motion().inverse() * p).normalized() - beside).norm() < 0.08;
  }));
  const SurfaceModel model = make_surface_model(open);
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  ASSERT_EQ(loops.size(), 2u);
  ASSERT_EQ(group_loops(model, loops).size(), 1u);
  const Filled filled(open);
  EXPECT_EQ(filled.holes[0].method(), "mirror_image") << filled.holes[0].reason();
  EXPECT_TRUE(CGAL::is_closed(test::to_cgal(filled.after)));
}

TEST(MirrorImage, NeedsAFlow) {
  FillOptions options = mirrored();
  options.evolution.reset();
  EXPECT_THROW(check(options), InvalidArgument);
}

TEST(ExpectedMirrorDeviation, GrowsWithTheDifferenceAndTheBendOfTheSeam) {
  const ExpectedDeviation small = expected_mirror_deviation(0.02, 3, 0), rough = expected_mirror_deviation(0.02, 20, 0);
  EXPECT_LT(small.half, small.likely);
  EXPECT_LT(small.likely, small.most);
  EXPECT_LT(small.likely, rough.half);
  EXPECT_LT(small.likely, expected_mirror_deviation(0.2, 3, 0).likely);
  EXPECT_DOUBLE_EQ(expected_mirror_deviation(0.02, 3, 0.05).likely, 0.05);
}

}  // namespace
}  // namespace loopmend
