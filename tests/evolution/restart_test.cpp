// SPDX-License-Identifier: GPL-3.0-or-later
// What is called converged stands still when it starts again from there; what is not, is not called so.
#include "evolution/evolution.h"

#include "io/read_mesh.h"
#include "support/patches.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace loopmend {
namespace {

/// Holes in spheres with relief and noise of several heights, in units of an edge.
std::vector<Patch> generated_holes() {
  std::vector<Patch> patches;
  const std::vector<double> relief = test::random_relief(make_icosphere(4), 9);
  Random random(5);
  for (const double height : {0.0, 0.85})
    for (const auto& [rough, noise] :
         {std::pair(0.0, 0.0), {1e-4, 0.0}, {0.01, 0.0}, {0.1, 0.0}, {0.0, 0.02}, {0.05, 0.02}}) {
      TriangleSoup soup = make_icosphere(4);
      for (std::size_t i = 0; i < soup.points.size(); ++i)
        soup.points[i] *= 1 + 0.075 * (rough * relief[i] + noise * random.bell());
      patches.push_back(test::start_of(
          make_surface_model(trim_boundaries(cut(soup, [&](const Vec3& p) { return p.z() > height; })))));
    }
  return patches;
}

/// The largest holes of the shared scans.
std::vector<Patch> real_holes() {
  std::vector<Patch> patches;
  for (const char* name : {"data/head_holes.ply", "data/demosthenes.obj", "data/bunny.ply", "data/lps_head.ply"}) {
    const std::filesystem::path file = std::filesystem::path(LOOPMEND_SHARED_DIR) / name;
    if (!std::filesystem::exists(file)) continue;
    const SurfaceModel scan = make_surface_model(read_mesh(file).soup);
    int taken = 0;
    for (const BoundaryLoop& loop : find_boundary_loops(scan)) {
      if (loop.kind != LoopKind::hole || loop.vertices.size() > 150 || ++taken > 6) continue;
      const auto made = make_initial_patch(scan, {loop}, {}, {});
      if (made.patch && made.patch->free_count > 0) patches.push_back(*made.patch);
    }
  }
  return patches;
}

/// Holes of 2.5 to 9 edges across, cut at random: few vertices round about, so that cubic fits pass through them.
std::vector<Patch> cut_holes() {
  std::vector<Patch> patches;
  const std::filesystem::path file = std::filesystem::path(LOOPMEND_SHARED_DIR) / "data/quadknot.obj";
  if (!std::filesystem::exists(file)) return patches;
  const TriangleSoup soup = read_mesh(file).soup;
  const double edge = mean_edge_length(soup.points, soup.triangles, static_cast<int>(soup.triangles.size()));
  Random random(71);
  for (int k = 0; k < 40; ++k) {
    const Vec3 center = soup.points[static_cast<std::size_t>(random.uniform() * soup.points.size())];
    const double radius = edge * random.uniform(2.5, 9);
    const SurfaceModel scan =
        make_surface_model(cut(soup, [&](const Vec3& p) { return (p - center).norm() < radius; }));
    for (const BoundaryLoop& loop : find_boundary_loops(scan))
      if (loop.kind == LoopKind::hole)
        if (const auto made = make_initial_patch(scan, {loop}, {}, {}); made.patch && made.patch->free_count > 0)
          patches.push_back(*made.patch);
  }
  return patches;
}

/// rms move of the free vertices by a second run, of the diameter of the hole.
double move_of_a_restart(const Evolution& first) {
  EvolutionOptions options = first.options();
  options.start = SteadyStart::as_given;
  options.split = first.split();
  Evolution again(first.patch(), options);
  again.run(nullptr, {});
  EXPECT_EQ(again.patch().free_count, first.patch().free_count);
  double squares = 0;
  for (int i = 0; i < first.patch().free_count; ++i)
    squares += (again.patch().positions[i] - first.patch().positions[i]).squaredNorm();
  return std::sqrt(squares / first.patch().free_count) / (2 * first.split()->radius);
}

int count_converged(const std::vector<Patch>& patches) {
  int converged = 0;
  for (std::size_t k = 0; k < patches.size(); ++k) {
    EvolutionOptions options;
    options.literal_relief = SplitEstimate::exact_hole;
    Evolution evolution(patches[k], options);
    if (evolution.run(nullptr, {}) != PatchStatus::converged) continue;
    ++converged;
    EXPECT_LT(move_of_a_restart(evolution), 2e-3) << "hole " << k << ": " << patches[k].free_count << " vertices, "
                                                  << method_name(evolution.method(), FlowKind::mmcvf);
  }
  return converged;
}

TEST(Restart, GeneratedHolesThatAreConvergedStandStill) { EXPECT_GE(count_converged(generated_holes()), 3); }

TEST(Restart, RealHolesThatAreConvergedStandStill) {
  const std::vector<Patch> holes = real_holes(), cut = cut_holes();
  if (holes.empty() || cut.empty()) GTEST_SKIP() << "the shared scans are not here";
  count_converged(holes);
  EXPECT_GE(count_converged(cut), 3);
}

}  // namespace
}  // namespace loopmend
