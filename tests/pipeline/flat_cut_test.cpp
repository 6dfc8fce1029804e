// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/flat_cut.h"

#include "core/random.h"
#include "pipeline/fill_holes.h"
#include "repair/plane_cut.h"
#include "samples/analytic_surfaces.h"
#include "support/mirror_models.h"
#include "support/sharp_surfaces.h"

#include <Eigen/Geometry>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>

namespace loopmend {
namespace {

/// A surface of revolution about z, open above in a plane.
SurfaceModel open_above(const std::function<double(double)>& radius, double top) {
  return make_surface_model(make_revolution(radius, 0, top, 40, 64));
}

BoundaryLoop upper(const SurfaceModel& model) {
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  return loops[0].center.z() > loops[1].center.z() ? loops[0] : loops[1];
}

TEST(FlatCut, IsTheEndOfATubeAndOfACone) {
  const SurfaceModel tube = open_above([](double) { return 1.0; }, 3);
  EXPECT_EQ(loop_end(tube, upper(tube)), LoopEnd::flat);
  const SurfaceModel cone = open_above([](double z) { return 2 - 0.3 * z; }, 3);
  EXPECT_EQ(loop_end(cone, upper(cone)), LoopEnd::flat);
  const SurfaceModel bell = open_above([](double z) { return 1 + 0.05 * z * z; }, 3);
  EXPECT_EQ(loop_end(bell, upper(bell)), LoopEnd::flat);
}

/// The wall leans over the plane at one end of the ellipse and away from it at the other.
TEST(FlatCut, IsTheEndOfATubeThatIsCutAtAnyAngle) {
  for (const double degrees : {20, 40, 45, 50, 55, 60})
    for (const int around : {24, 40, 96})
      for (const int rows : {3, 20, 60}) {
        const double slope = std::tan(degrees * std::numbers::pi / 180), length = 4;
        TriangleSoup soup = make_revolution([](double) { return 1.0; }, 0, length, around, rows);
        for (Vec3& p : soup.points) p.z() *= 1 + slope * p.x() / length;
        const SurfaceModel tube = make_surface_model(soup);
        EXPECT_EQ(loop_end(tube, upper(tube)), LoopEnd::flat) << degrees << ' ' << around << ' ' << rows;
      }
}

/// Its wall bends like half a ball at the base alone, and sweeps in above.
TEST(FlatCut, IsTheBaseOfAStandingFigure) {
  const auto foot = [](double z) {
    return z > -0.45 ? std::sqrt(1 - z * z) : 0.3 + (std::sqrt(1 - 0.45 * 0.45) - 0.3) * std::exp(6 * (z + 0.45));
  };
  for (const int around : {64, 96})
    for (const int rows : {40, 80}) {
      const SurfaceModel figure = make_surface_model(make_revolution(foot, -2, 0, around, rows));
      EXPECT_EQ(loop_end(figure, upper(figure)), LoopEnd::flat_or_dome) << around << ' ' << rows;
      const SurfaceModel ball =
          make_surface_model(make_revolution([](double z) { return std::sqrt(1 - z * z); }, -0.9, 0, around, rows));
      EXPECT_EQ(loop_end(ball, upper(ball)), LoopEnd::runs_on) << around << ' ' << rows;
    }
}

TEST(FlatCut, IsTheMouthOfABellThatFlares) {
  for (const double slope : {0.7, 1.5, 3.0}) {  // of the radius over the height, at the mouth
    const SurfaceModel bell = open_above([=](double z) { return 0.6 + slope * z * z / 4; }, 2);
    EXPECT_EQ(loop_end(bell, upper(bell)), LoopEnd::flat) << slope;
  }
}

/// Corners, and rows so wide that a wall has only two or three of them.
TEST(FlatCut, IsTheTopOfAnOpenBoxAndTheEndOfAFewRows) {
  for (const int cells : {4, 8})
    for (const double width : {0.5, 1.1, 2.5})
      for (const double height : {0.4, 0.94, 2.0}) {
        TriangleSoup box = test::make_cube(cells);
        double top = 0;
        for (const Vec3& p : box.points) top = std::max(top, p.z());
        box = cut(box, [=](const Vec3& p) { return p.z() > top * (1 - 1e-9); });
        for (Vec3& p : box.points) p = Vec3(2 * p.x(), width * p.y(), height * p.z());
        const SurfaceModel model = make_surface_model(box);
        const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
        ASSERT_EQ(loops.size(), 1U);
        EXPECT_EQ(loop_end(model, loops[0]), LoopEnd::flat) << cells << ' ' << width << ' ' << height;
      }
  for (const int rows : {1, 2, 3})
    for (const int around : {12, 24, 32, 64})
      for (const double height : {0.1, 0.3, 0.5, 1.0}) {
        const SurfaceModel tube =
            make_surface_model(make_revolution([](double) { return 1.0; }, 0, height, around, rows));
        EXPECT_EQ(loop_end(tube, upper(tube)), LoopEnd::flat) << rows << ' ' << around << ' ' << height;
      }
}

/// Profiles of an ellipsoid bend by other shares of a ball's where it is cut aslant.
TEST(FlatCut, IsNotWhatIsMissingOfAnEllipsoid) {
  for (const Vec3& axes : {Vec3(1, 0.7, 0.45), Vec3(0.6, 0.6, 1), Vec3(0.8, 0.5, 0.9), Vec3(0.5, 0.9, 0.7)})
    for (const double angle : {0.8, 1.0, 1.2})
      for (const int level : {4, 5}) {
        const Vec3 tip = Vec3(0.5, 0.3, 0.81).normalized();
        TriangleSoup soup = cut(make_icosphere(level), [&](const Vec3& p) { return p.dot(tip) > std::cos(angle); });
        for (Vec3& p : soup.points) p = p.cwiseProduct(axes);
        const SurfaceModel ellipsoid = make_surface_model(soup);
        const std::vector<BoundaryLoop> loops = find_boundary_loops(ellipsoid);
        ASSERT_EQ(loops.size(), 1U);
        EXPECT_EQ(loop_end(ellipsoid, loops[0]), LoopEnd::runs_on) << axes.transpose() << ' ' << angle << ' ' << level;
      }
}

/// The walls of long ellipsoids are nearly straight where they are cut.
TEST(FlatCut, OfALongEllipsoidHangsOnHowFarItWouldGoOn) {
  for (const double length : {3.2, 3.6, 4.0})
    for (const auto& [height, end] :
         {std::pair{0.35, LoopEnd::runs_on},  // of the missing tip, in diameters of the loop
          std::pair{0.7, LoopEnd::flat_or_dome}, std::pair{1.3, LoopEnd::flat}}) {
      // At z = length · c the radius is √(1 − c²), and length (1 − c) are missing.
      const double q = std::pow(2 * height / length, 2), c = (1 - q) / (1 + q);
      const auto radius = [&](double z) { return std::sqrt(std::max(0.0, 1 - z * z / (length * length))); };
      const SurfaceModel ellipsoid = open_above(radius, length * c);
      EXPECT_EQ(loop_end(ellipsoid, upper(ellipsoid)), end) << length << ' ' << height;
    }
}

/// An egg without its end, torn off along the triangles, goes on.
TEST(FlatCut, IsNoneWhereTheWallClearlyBendsLikeADome) {
  const Vec3 tip = Vec3(0.5, 0.3, 0.81).normalized();
  const auto shaped = [](const Vec3& p) {
    return Vec3(p.cwiseProduct(Vec3(0.7 + 0.15 * p.z(), 0.7 + 0.15 * p.z(), 1)));
  };
  TriangleSoup soup = cut(make_icosphere(5), [&](const Vec3& p) { return p.dot(tip) > std::cos(1.0); });
  for (Vec3& p : soup.points) p = shaped(p);
  SurfaceModel egg = make_surface_model(soup);
  const std::vector<HoleResult> results = fill_all_holes(egg);
  ASSERT_EQ(results.size(), 1U);
  EXPECT_EQ(results[0].verdict().grade, Grade::good);
  for (int v = results[0].first_point; v < results[0].first_point + results[0].free_vertices; ++v) {
    // On the surface x² + y² = (1 − z²) (0.7 + 0.15 z)².
    const Vec3& p = egg.soup.points[v];
    const double radius = std::sqrt(std::max(0.0, 1 - p.z() * p.z())) * (0.7 + 0.15 * p.z());
    EXPECT_NEAR(p.head<2>().norm(), radius, 0.06 * results[0].loop.diameter);
  }
}

/// A figure whose base curves in, with noise of almost a percent of its radius.
TriangleSoup figure(double bends, std::uint64_t seed) {
  TriangleSoup soup =
      make_revolution([&](double z) { return 1 + 0.25 * std::cos(bends * z) + 0.15 * z; }, -2, 0, 60, 30);
  Random random(seed);
  for (Vec3& p : soup.points) p += 0.009 * Vec3(random.bell(), random.bell(), random.bell());
  return soup;
}

/// Nothing tells a round end that was cut by a plane from a base that curves in: closed flat, and said so.
TEST(FlatCut, IsDoubtfulWhereTheWallBendsLikeADomeOnNoQuadric) {
  SurfaceModel bust = make_surface_model(figure(3, 1));
  const std::vector<HoleResult> results = fill_holes(bust, {upper(bust)}, {}, {}, {});
  ASSERT_EQ(results.size(), 1U);
  const Verdict verdict = results[0].verdict();
  EXPECT_EQ(verdict.grade, Grade::look);
  ASSERT_FALSE(verdict.findings.empty());
  EXPECT_EQ(verdict.findings[0].code, NoticeCode::flat_or_dome);
}

/// A wall that curves in at its end, with noise of more than a percent of its radius, is on a quadric up to that noise and no further.
TEST(FlatCut, ANoisyFigureThatCurvesInAtItsBaseEnds) {
  for (const double bends : {2.5, 3.0, 3.5})
    for (const unsigned seed : {1, 2, 3}) {
      const SurfaceModel model = make_surface_model(figure(bends, seed));
      EXPECT_EQ(loop_end(model, upper(model)), LoopEnd::flat_or_dome) << bends << ' ' << seed;
    }
}

/// Where triangles are too few for profiles, the turning of the normals decides.
TEST(FlatCut, IsNotWhatIsMissingOfANoisyBallOfFewTriangles) {
  for (const double noise : {0.001, 0.003})
    for (const double top : {-0.2, 0.1, 0.4}) {
      TriangleSoup ball = make_revolution([](double z) { return std::sqrt(1 - z * z); }, -0.95, top, 12, 4);
      Random random(7);
      for (Vec3& p : ball.points) p += noise * Vec3(random.bell(), random.bell(), random.bell());
      const SurfaceModel model = make_surface_model(ball);
      EXPECT_EQ(loop_end(model, upper(model)), LoopEnd::runs_on) << noise << ' ' << top;
    }
}

TEST(FlatCut, IsNotWhatIsMissingOfABallOrInAPlane) {
  for (double top : {-0.2, 0.3, 0.7}) {
    const SurfaceModel ball =
        make_surface_model(make_revolution([](double z) { return std::sqrt(1 - z * z); }, -0.9, top, 40, 64));
    EXPECT_EQ(loop_end(ball, upper(ball)), LoopEnd::runs_on) << top;
  }
}

/// The walls of a bump are as straight as those of a cut at the height of the hole; but the hole is not quite plane.
/// Most edges of its loop lie at the lids, which stand upright over it; the wall is of one or two rows.
TEST(FlatCut, IsNotAWindowInAWallFromLidToLid) {
  for (const int around : {36, 60})
    for (const int rows : {1, 2})
      for (const double height : {1.0, 2.0, 3.0})
        for (const double half_angle : {10, 20, 36}) {
          const SurfaceModel model = make_surface_model(test::make_windowed_cylinder(around, rows, height, half_angle));
          const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
          ASSERT_EQ(loops.size(), 1U);
          EXPECT_EQ(loop_end(model, loops[0]), LoopEnd::runs_on)
              << around << ' ' << rows << ' ' << height << ' ' << half_angle;
        }
}

TEST(FlatCut, IsNotTheTopOfABump) {
  const test::BumpyEllipsoid shape;
  for (double size : {0.15, 0.2}) {
    SurfaceModel model = make_surface_model(shape.open_mesh(5, size));
    const std::size_t before = model.soup.points.size();
    ASSERT_EQ(fill_all_holes(model).size(), 1u);
    EXPECT_GT(model.soup.points.size(), before);
    double height = 0;  // what a cap across the hole keeps of the bump's top, which is 0.25 high
    for (std::size_t v = before; v < model.soup.points.size(); ++v)
      height =
          std::max(height, (test::BumpyEllipsoid::motion().inverse() * model.soup.points[v]).dot(shape.right_bump));
    const double top = shape.radius(shape.right_bump);
    EXPECT_NEAR(height, top, 0.1) << size;
  }
}

/// However far from plane an upright wall ends, it is closed between its lowest and its highest vertex, as minimal surfaces are.
TEST(FlatCut, IsNoDomeOverWavyEnds) {
  for (const double planarity : {0.01, 0.029, 0.0300001, 0.035, 0.05, 0.09, 0.13, 0.2, 0.28})
    for (const int waves : {2, 3}) {
      if (waves == 3 && planarity > 0.13) continue;  // the diameter would be another one
      SurfaceModel tube = open_above([](double) { return 1.0; }, 3);
      for (Vec3& p : tube.soup.points) {  // rms of a wave: its amplitude over sqrt(2); the diameter is 2
        const double wave = planarity * 2 * std::sqrt(2) * std::cos(waves * std::atan2(p.y(), p.x()));
        p.z() += wave * p.z() / 3;
      }
      tube = make_surface_model(tube.soup);
      const BoundaryLoop end = upper(tube);
      ASSERT_NEAR(end.planarity * end.diameter, planarity * 2, 0.1 * planarity);
      EXPECT_EQ(loop_end(tube, end), planarity < 0.0305 ? LoopEnd::flat : LoopEnd::curved) << planarity;
      double highest = 0, lowest = 3;
      for (const int v : end.vertices) {
        highest = std::max(highest, tube.soup.points[v].z());
        lowest = std::min(lowest, tube.soup.points[v].z());
      }
      const std::size_t before = tube.soup.points.size();
      fill_all_holes(tube);
      ASSERT_GT(tube.soup.points.size(), before + 100);
      for (std::size_t v = before; v < tube.soup.points.size(); ++v) {
        const double z = tube.soup.points[v].z();
        if (z < 1.5) continue;  // the other end
        EXPECT_LE(z, highest + 1e-6) << planarity;
        EXPECT_GE(z, lowest - 1e-6) << planarity;
      }
    }
}

TEST(FlatCut, IsClosedByAPlane) {
  SurfaceModel tube = open_above([](double) { return 1.0; }, 3);
  const std::size_t before = tube.soup.points.size();
  for (const HoleResult& result : fill_all_holes(tube)) {
    EXPECT_EQ(result.outcome().made_by, "minimal surface over a cut") << result.message;
    EXPECT_NE(result.reason().english().find("boundary exact"), std::string::npos);
  }
  ASSERT_GT(tube.soup.points.size(), before + 100);
  for (std::size_t v = before; v < tube.soup.points.size(); ++v) {
    const double z = tube.soup.points[v].z();
    EXPECT_NEAR(std::min(std::abs(z), std::abs(z - 3)), 0, 1e-9);
  }
}

/// Turned about, in other numbers of sides, with noise, in single precision: both ends of a tube are closed flat.
TEST(FlatCut, GetsADomeWithoutAFaultWhereATangentPatchIsAskedFor) {
  SurfaceModel model = make_surface_model(make_cylinder(3, 40));
  FillOptions options;
  options.evolution = EvolutionOptions();
  options.evolution->continuity = SeamContinuity::tangent;
  for (const HoleResult& hole : fill_holes(model, find_boundary_loops(model), options, nullptr, {})) {
    EXPECT_NE(hole.verdict().grade, Grade::bad) << hole.verdict().message();
    EXPECT_GT(hole.verdict().height, 0.1);
  }
  EXPECT_TRUE(find_boundary_loops(model).empty());
}

TEST(FlatCut, ClosesBothEndsOfAnyStraightTube) {
  constexpr double length = 2;
  int ends = 0;
  for (const int sides : {8, 24, 48})
    for (const double noise : {0.0, 1e-4, 2e-3, 1e-2})
      for (const bool single : {false, true}) {
        const int rows = std::max(1, static_cast<int>(length * sides / 6));
        TriangleSoup soup = make_revolution([](double) { return 1.0; }, 0, length, sides, rows);
        const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.1, Vec3(1, 2, 3).normalized()).toRotationMatrix();
        Random random(17);
        for (Vec3& p : soup.points) {
          p = turn * (p + 2 * noise * Vec3(random.bell(), random.bell(), random.bell()) / std::sqrt(3.0));
          if (single) p = p.cast<float>().cast<double>();
        }
        SurfaceModel tube = make_surface_model(soup);
        const std::size_t before = tube.soup.points.size();
        for (const HoleResult& result : fill_all_holes(tube)) {
          ++ends;
          EXPECT_NE(result.verdict().grade, Grade::bad)
              << sides << " sides, noise " << noise << ": " << result.verdict().message();
        }
        for (std::size_t v = before; v < tube.soup.points.size(); ++v) {
          const double z = (turn.transpose() * tube.soup.points[v]).z();
          EXPECT_LT(std::min(std::abs(z), std::abs(z - length)), std::max(1e-6, 6 * noise)) << sides << " " << noise;
        }
      }
  EXPECT_EQ(ends, 48);
}

/// A tube of facets that a plane cuts at 60°: the cut runs straight along each facet, up to rounding. What closes the section is removed.
TEST(FlatCut, IsClosedWhereThePlaneCutsTheFacetsOfATube) {
  for (const int sides : {32, 48, 64})
    for (const double turned : {0.4, 1.3, 2.2}) {
      const Eigen::AngleAxisd turn(turned, Vec3(1, 2, 3).normalized());
      TriangleSoup tube = make_revolution([](double) { return 1.0; }, -3, 3, sides, 36);
      const Vec3 normal = turn * Vec3(std::sin(1.05), 0, std::cos(1.05));
      for (Vec3& p : tube.points) p = turn * p;
      TriangleSoup cut = cut_by_plane(tube, make_cut_plane(0.02 * normal, normal)).soup;
      std::erase_if(cut.triangles, [&](const Triangle& t) {
        return std::ranges::all_of(t, [&](int v) { return normal.dot(cut.points[v]) > 0.02 - 1e-7; });
      });
      SurfaceModel model = make_surface_model(cut);
      for (const HoleResult& hole : fill_all_holes(model)) {
        EXPECT_EQ(hole.outcome().attempts.size(), 1u) << sides << ' ' << turned << ' ' << hole.loop.edges();
        EXPECT_NE(hole.verdict().grade, Grade::bad) << sides << ' ' << turned << ' ' << hole.message;
      }
    }
}

/// The ends of a slot along a tube are less than a tenth of its boundary: the wall leans along nine tenths.
TEST(FlatCut, ALongSlotInATubeRunsOn) {
  for (const double half_width : {0.5, 0.7})
    for (const double half_length : {5.0, 8.0, 14.0}) {
      const TriangleSoup tube = make_revolution([](double) { return 1.0; }, -half_length - 2, half_length + 2, 48,
                                                static_cast<int>(15 * (half_length + 2)));
      const SurfaceModel model = make_surface_model(cut(tube, [&](const Vec3& p) {
        return std::abs(std::atan2(p.y(), p.x())) < half_width && std::abs(p.z()) < half_length;
      }));
      const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
      const BoundaryLoop& slot = loops.front();
      ASSERT_GT(slot.diameter, 9) << half_length;
      EXPECT_EQ(loop_end(model, slot), LoopEnd::runs_on) << half_width << ' ' << half_length;
    }
}

/// Triangles below a plane were removed, up to three rows of them: the wall runs straight on to a plane.
TEST(FlatCut, ATornTubeStandsOnAPlaneBase) {
  for (const int around : {48, 90})
    for (const double rows : {1, 2, 3})
      for (const double wide : {1.0, 1.4}) {
        const double edge = 2 * std::numbers::pi / around;
        TriangleSoup tube = make_revolution([](double) { return 1.0; }, 0, 30 * edge, around, 30);
        for (Vec3& p : tube.points) p.x() *= wide;
        Random random(static_cast<std::uint64_t>(around + rows));
        std::vector<double> torn_to(static_cast<std::size_t>(around) + 1);
        for (double& height : torn_to) height = rows * edge * random.uniform();
        std::erase_if(tube.triangles, [&](const Triangle& t) {
          const Vec3 center = (tube.points[t[0]] + tube.points[t[1]] + tube.points[t[2]]) / 3;
          const double turn = std::atan2(center.y(), center.x() / wide) / (2 * std::numbers::pi) + 0.5;
          return center.z() < torn_to[static_cast<std::size_t>(turn * around)];
        });
        SurfaceModel model = make_surface_model(tube);
        const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
        // Beside tiny ones; the other end has `around` edges.
        const BoundaryLoop torn = *std::ranges::max_element(loops, {}, [](const BoundaryLoop& l) { return l.edges(); });
        EXPECT_EQ(loop_end(model, torn), LoopEnd::toothed) << around << ' ' << rows << ' ' << wide;
        double lowest = 1;
        for (const int v : torn.vertices) lowest = std::min(lowest, model.mesh.point(TriMesh::VertexHandle(v)).z());
        for (const HoleResult& hole : fill_all_holes(model)) {
          EXPECT_EQ(hole.verdict().grade, Grade::good) << hole.verdict().message();
          if (hole.loop.number != torn.number) continue;
          EXPECT_EQ(hole.method(), "straight_base");
          EXPECT_GT(hole.free_vertices, around / 2);
          for (int v = hole.first_point; v < hole.first_point + hole.free_vertices; ++v) {
            EXPECT_LT(model.soup.points[v].z(), lowest) << around << ' ' << rows << ' ' << wide;
            EXPECT_GT(model.soup.points[v].z(), lowest - 1.5 * edge) << around << ' ' << rows << ' ' << wide;
          }
        }
        EXPECT_TRUE(find_boundary_loops(make_surface_model(model.soup)).empty());
      }
}

/// Fits to the wall of a coarse box mostly hold one of its edges, which is no noise.
TEST(FlatCut, ATornBoxOfFewCellsStandsOnAPlaneBase) {
  for (const int cells : {8, 9, 10, 12})
    for (const double noise : {0.0, 0.03, 0.06}) {
      TriangleSoup box = make_revolution([](double) { return 1.0; }, 0, 1, 4 * cells, cells);
      Random random(static_cast<std::uint64_t>(cells + 100 * noise));
      for (Vec3& p : box.points) {
        const double turn = std::round((std::atan2(p.y(), p.x()) / (2 * std::numbers::pi) + 0.5) * 4 * cells);
        const int k = static_cast<int>(turn) % (4 * cells), side = k / cells;
        const double along = static_cast<double>(k % cells) / cells;
        const Eigen::Vector2d corners[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
        p.head<2>() = (1 - along) * corners[side] + along * corners[(side + 1) % 4];
        for (double& x : p) x += noise / cells * random.bell();
      }
      std::erase_if(box.triangles, [&](const Triangle& t) {
        const double z = (box.points[t[0]] + box.points[t[1]] + box.points[t[2]]).z() / 3;
        return z < 1.0 / cells && random.uniform() < 0.5;
      });
      const SurfaceModel model = make_surface_model(box);
      const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
      const BoundaryLoop torn = *std::ranges::max_element(loops, {}, [](const BoundaryLoop& l) { return l.edges(); });
      EXPECT_EQ(loop_end(model, torn), LoopEnd::toothed) << cells << ' ' << noise;
    }
}

/// A wave of the same height that takes many edges is no tooth.
TEST(FlatCut, WavesAreNoTeeth) {
  for (const int waves : {3, 5}) {
    TriangleSoup tube = make_revolution([](double) { return 1.0; }, 0, 3, 90, 40);
    for (Vec3& p : tube.points) p.z() += 0.08 * std::cos(waves * std::atan2(p.y(), p.x())) * (1 - p.z() / 3);
    const SurfaceModel model = make_surface_model(tube);
    for (const BoundaryLoop& loop : find_boundary_loops(model)) EXPECT_NE(loop_end(model, loop), LoopEnd::toothed);
  }
}

/// A lumpy figure with a base whose boundary has noise of two thirds of a percent.
TEST(FlatCut, ANoisyBaseIsClosedFlatFromTrianglesThatCutNothing) {
  constexpr double base = -0.6;
  TriangleSoup figure = make_icosphere(5);
  for (Vec3& p : figure.points) {
    const double wave = 1 + 0.1 * std::sin(5 * p.x()) * std::cos(4 * p.y()) + 0.03 * std::sin(17 * p.z() + 9 * p.x());
    p = wave * p.cwiseProduct(Vec3(0.8, 0.6, 1.1));
  }
  figure = cut(figure, [&](const Vec3& p) { return p.z() < base; });
  const std::vector<int> boundary = find_boundary_loops(make_surface_model(figure)).at(0).vertices;
  for (const unsigned seed : {134, 148, 153}) {  // three of sixty whose first patches cut the ragged wall
    Random random(seed);
    for (const int v : boundary) figure.points[v].z() = base + 0.01 * random.bell();
    SurfaceModel model = make_surface_model(figure);
    const std::vector<HoleResult> results = fill_all_holes(model);
    ASSERT_EQ(results.size(), 1u);
    EXPECT_EQ(results[0].verdict().grade, Grade::good) << results[0].verdict().message();
    EXPECT_EQ(results[0].outcome().attempts.front(), "minimal surface over a cut");
    for (std::size_t v = figure.points.size(); v < model.soup.points.size(); ++v)
      EXPECT_NEAR(model.soup.points[v].z(), base, 0.04);
  }
}

/// The side that is out does not matter to what is missing.
TEST(FlatCut, IsTheSameForASurfaceTurnedInsideOut) {
  for (const double top : {-0.2, 0.5}) {
    TriangleSoup ball = make_revolution([](double z) { return std::sqrt(1 - z * z); }, -0.9, top, 40, 64);
    for (Triangle& t : ball.triangles) std::swap(t[1], t[2]);
    const SurfaceModel turned = make_surface_model(ball);
    EXPECT_EQ(loop_end(turned, upper(turned)), LoopEnd::runs_on) << top;
  }
}

}  // namespace
}  // namespace loopmend
