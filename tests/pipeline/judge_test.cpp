// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/judge.h"

#include "pipeline/fill_holes.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

/// A sphere open above z = 0.5 along a plane circle, and what a judge says of patches over it.
struct OpenSphere {
  SurfaceModel model =
      make_surface_model(make_revolution([](double z) { return std::sqrt(1 - z * z); }, -0.95, 0.5, 48, 32));
  BoundaryLoop loop = upper();
  Patch initial = *make_initial_patch(model, {loop}, {}, {}).patch;
  ScanIndex scan{model};
  Judge judge{initial, {LoopEnd::runs_on}, Judge::Creases::unwanted};

  BoundaryLoop upper() const {
    const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
    return loops[0].center.z() > loops[1].center.z() ? loops[0] : loops[1];
  }

  /// The initial patch with each free vertex where `place` puts it, mesh units.
  template <class Place>
  Verdict of(const Place& place) const {
    Patch patch = initial;
    for (int i = 0; i < patch.free_count; ++i)
      patch.positions[i] = patch.to_frame(place(patch.to_mesh(patch.positions[i])));
    return judge(patch, validate(scan, patch), seam_reports(patch)).at(0);
  }
};

TEST(Judge, CallsTheSphereGoodAndThePlaneACrease) {
  const OpenSphere open;
  const Verdict sphere = open.of([](const Vec3& p) { return p.normalized(); });
  EXPECT_EQ(sphere.grade, Grade::good) << sphere.message();
  EXPECT_LT(sphere.crease_deg.value(), 10);
  EXPECT_NEAR(sphere.height, 0.5 / std::sqrt(3.0), 0.02);  // of the cap over its circle of diameter √3
  EXPECT_EQ(sphere.message().english(), "");
  const Verdict plane = open.of([](const Vec3& p) { return Vec3(p.x(), p.y(), 0.5); });
  EXPECT_EQ(plane.grade, Grade::look);
  ASSERT_EQ(plane.findings.size(), 1u);
  EXPECT_EQ(plane.findings[0].code, NoticeCode::crease);
  EXPECT_NEAR(plane.findings[0].arguments.at(0), 60, 8);  // acos 0.5
  EXPECT_EQ(plane.findings[0].arguments.at(1), static_cast<double>(open.initial.loops[0].size()));
}

/// The sphere, and beside a sector of its seam the plane of the seam, 60° away from the sphere.
TEST(Judge, TheCreaseIsTheBendThatDecides) {
  const OpenSphere open;
  const auto sector = [&](double half_angle) {
    return open.of([&](const Vec3& p) {
      const Vec3 on = p.normalized();
      if (std::abs(std::atan2(p.y(), p.x())) > half_angle) return on;
      return Vec3(on.x() / on.head<2>().norm() * p.head<2>().norm(), on.y() / on.head<2>().norm() * p.head<2>().norm(),
                  0.5);
    });
  };
  const double edge = 2 * std::acos(-1) / static_cast<double>(open.initial.loops[0].size());
  const Verdict narrow = sector(edge), wide = sector(6 * edge);
  EXPECT_LT(narrow.crease_deg.value(), 35) << narrow.message();
  EXPECT_EQ(std::ranges::count(narrow.findings, NoticeCode::crease, &Notice::code), 0) << narrow.message();
  EXPECT_GT(wide.crease_deg.value(), 35);
  EXPECT_EQ(std::ranges::count(wide.findings, NoticeCode::crease, &Notice::code), 1);
}

/// Over the sphere, a dome that meets it with an angle: its slope at the circle is √3 + 2 · 0.3 / r in place of √3, r = √3 / 2.
TEST(Judge, NamesASeamThatBendsMoreThanTheInitialPatch) {
  const OpenSphere open;
  const auto dome_of = [&](double height) {
    Patch patch = open.initial;
    for (int i = 0; i < patch.free_count; ++i) {
      Vec3 on = patch.to_mesh(patch.positions[i]).normalized();
      on.z() += height * (1 - on.head<2>().squaredNorm() / 0.75);
      patch.positions[i] = patch.to_frame(on);
    }
    return patch;
  };
  const Patch sphere = dome_of(0), dome = dome_of(0.3);
  const auto verdict = [&](const Patch& initial, const Patch& of, Judge::Creases creases) {
    return Judge(initial, {LoopEnd::runs_on}, creases)(of, validate(open.scan, of), seam_reports(of)).at(0);
  };
  const Verdict worse = verdict(sphere, dome, Judge::Creases::unwanted);
  ASSERT_EQ(worse.findings.size(), 1u);
  EXPECT_EQ(worse.grade, Grade::look);
  EXPECT_EQ(worse.findings[0].code, NoticeCode::seam_worse);
  const double right =
      (std::atan(std::sqrt(3.0) + 1.2 / std::sqrt(3.0)) - std::atan(std::sqrt(3.0))) * 180 / 3.14159265;
  EXPECT_NEAR(worse.findings[0].arguments.at(0), right, 1.5);
  EXPECT_EQ(verdict(sphere, dome, Judge::Creases::asked_for).grade, Grade::good);
  // A person sees creases that were asked for, too.
  EXPECT_EQ(verdict(sphere, dome_of(-1), Judge::Creases::asked_for).grade, Grade::look);
  EXPECT_EQ(verdict(dome, dome, Judge::Creases::unwanted).grade, Grade::good);
  EXPECT_EQ(verdict(dome, sphere, Judge::Creases::unwanted).grade, Grade::good);
}

/// A ridge across the sphere: its crest and both its feet are about as long as the loop is wide.
TEST(Judge, NamesABendInsideThePatch) {
  const OpenSphere open;
  const auto ridge = [&](double height) {
    return open.of([&](const Vec3& p) {
      const Vec3 on = p.normalized();
      return Vec3(on + Vec3(0, 0, height * std::max(0.0, 1 - std::abs(on.x()) / 0.2)));
    });
  };
  EXPECT_EQ(ridge(0.02).grade, Grade::good) << ridge(0.02).message();
  const Verdict bent = ridge(0.35);
  EXPECT_NE(bent.grade, Grade::good);
  const auto found = std::ranges::find(bent.findings, NoticeCode::bent_inside, &Notice::code);
  ASSERT_NE(found, bent.findings.end());
  EXPECT_GT(found->arguments.at(0), 45);
  EXPECT_LT(found->arguments.at(0), 130);
  EXPECT_GT(found->arguments.at(1), 1);
  EXPECT_LT(found->arguments.at(1), 6);
}

/// A sliver of the wall that turns over at its seam edge is no fault of a cap that has to lie in the plane; many of them are.
TEST(Judge, DoesNotBlameACapForASliverOfItsWall) {
  const OpenSphere open;
  const auto cap = [&](LoopEnd end, std::size_t slivers) {
    Patch patch = open.initial;
    for (int i = 0; i < patch.free_count; ++i) {
      const Vec3 p = patch.to_mesh(patch.positions[i]);
      patch.positions[i] = patch.to_frame(Vec3(p.x(), p.y(), 0.5));
    }
    const std::vector<int>& loop = patch.loops[0];
    for (std::size_t f = patch.patch_triangles; f < patch.triangles.size() && slivers > 0; ++f)
      for (int k = 0; k < 3; ++k) {
        const int a = patch.triangles[f][k], b = patch.triangles[f][(k + 1) % 3];
        if (std::ranges::count(loop, a) == 0 || std::ranges::count(loop, b) == 0) continue;
        int& apex = patch.triangles[f][(k + 2) % 3];  // a vertex of its own, over the cap
        patch.positions.push_back(
            patch.to_frame(0.7 * patch.to_mesh((patch.positions[a] + patch.positions[b]) / 2) + Vec3(0, 0, 0.2)));
        patch.ring.push_back(1);
        patch.view_vertex.push_back(patch.view_vertex.back());
        apex = patch.vertex_count() - 1;
        --slivers;
        break;
      }
    return Judge(patch, {end}, Judge::Creases::unwanted)(patch, Validity(), seam_reports(patch)).at(0);
  };
  EXPECT_EQ(cap(LoopEnd::flat, 0).grade, Grade::good);
  EXPECT_FALSE(cap(LoopEnd::flat, 0).crease_deg.has_value());  // the edge belongs there
  EXPECT_EQ(cap(LoopEnd::flat, 1).grade, Grade::good) << cap(LoopEnd::flat, 1).message();
  EXPECT_EQ(cap(LoopEnd::flat, 1).folds, 1);
  EXPECT_EQ(cap(LoopEnd::runs_on, 1).folds, 1);
  EXPECT_EQ(cap(LoopEnd::runs_on, 1).grade, Grade::bad);
  EXPECT_EQ(cap(LoopEnd::flat, 12).folds, 12);
  EXPECT_EQ(cap(LoopEnd::flat, 12).grade, Grade::bad);
}

/// A dome over a flat loop is seen at once, a folded edge is not.
TEST(Judge, HoldsADomeOverAFlatLoopWorseThanAFold) {
  Verdict dome, folded;
  dome.grade = folded.grade = Grade::bad;
  dome.findings = {{NoticeCode::dome_over_flat_loop, {0.2}}};
  folded.folds = 2;
  folded.findings = {{NoticeCode::folded_edges, {2}}};
  EXPECT_LT(faults({folded}), faults({dome}));
  Verdict crossing = dome;
  crossing.crossings = 1;
  EXPECT_LT(faults({dome}), faults({crossing}));
}

TEST(Judge, FindsAFold) {
  const OpenSphere open;
  const auto from_middle_ring = [](const Vec3& p) { return std::abs(p.head<2>().norm() - 0.45); };
  double least = 1;
  open.of([&](const Vec3& p) {
    least = std::min(least, from_middle_ring(p));
    return p;
  });
  const Verdict folded = open.of([&](const Vec3& p) {
    const Vec3 on = p.normalized();
    const Vec3 inward = Vec3(-on.x(), -on.y(), 0).normalized();
    return from_middle_ring(p) == least ? Vec3((on + 0.25 * inward).normalized()) : on;  // by two edges and more
  });
  EXPECT_EQ(folded.grade, Grade::bad);
  EXPECT_GT(folded.folds, 0);
  EXPECT_GT(faults({folded}).folds, 0);
}

TEST(Judge, FindsABumpThatNoBallExplains) {
  const OpenSphere open;
  const Verdict bump = open.of([](const Vec3& p) {
    const Vec3 on = p.normalized();
    const double r = std::hypot(on.x(), on.y()) / 0.87;
    return Vec3(on.x(), on.y(), on.z() + 1.0 * std::exp(-6 * r * r));
  });
  EXPECT_NE(bump.grade, Grade::good);
  EXPECT_NEAR(bump.height, 1.5 / std::sqrt(3.0), 0.08);
}

TEST(Judge, ADomeOverAFlatLoopIsBad) {
  const OpenSphere open;
  const Judge flat{open.initial, {LoopEnd::flat}, Judge::Creases::unwanted};
  Patch dome = open.initial;
  for (int i = 0; i < dome.free_count; ++i)
    dome.positions[i] = dome.to_frame(dome.to_mesh(dome.positions[i]).normalized());
  const Verdict verdict = flat(dome, validate(open.scan, dome), seam_reports(dome)).at(0);
  EXPECT_EQ(verdict.grade, Grade::bad);
  EXPECT_EQ(verdict.findings.at(0).code, NoticeCode::dome_over_flat_loop);
  const Verdict initial = flat(open.initial, validate(open.scan, open.initial), seam_reports(open.initial)).at(0);
  EXPECT_EQ(initial.grade, Grade::good) << initial.message();  // its crease is what was cut
}

}  // namespace
}  // namespace loopmend
