// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/vertex_survey.h"

#include "core/threads.h"
#include "mesh/boundary_loops.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace loopmend {
namespace {

std::vector<int> numbers(std::size_t count) {
  std::vector<int> result(count);
  std::iota(result.begin(), result.end(), 0);
  return result;
}

TEST(VertexSurvey, CleanSurfaces) {
  const TriangleSoup ball = make_icosphere(3), sheet = make_graph([](double, double) { return 0; }, 1, 8);
  for (const TriangleSoup* soup : {&ball, &sheet}) {
    const VertexSurvey survey = survey_vertices(soup->triangles, soup->points.size() + 3);  // some are unused
    EXPECT_FALSE(survey.any(VertexState::several));
    EXPECT_FALSE(survey.any(VertexState::disordered));
    EXPECT_EQ(survey.non_manifold_edges, 0U);
  }
}

TEST(VertexSurvey, FansAreSeparatedAndTheFirstKeepsTheNumber) {
  // An open fan, another open one and a closed one, all at vertex 0.
  Triangles triangles = {{4, 5, 0}, {0, 1, 2}, {0, 2, 3}, {0, 5, 6}, {0, 7, 8}, {0, 8, 9}, {0, 9, 7}};
  const VertexSurvey survey = survey_vertices(triangles, 10);
  EXPECT_EQ(survey.state[0], VertexState::several);
  EXPECT_EQ(std::count(survey.state.begin(), survey.state.end(), VertexState::clean), 9);
  std::vector<int> origin = numbers(10);
  separate_fans(survey, triangles, origin);
  EXPECT_EQ(triangles, (Triangles{{4, 5, 0}, {10, 1, 2}, {10, 2, 3}, {0, 5, 6}, {11, 7, 8}, {11, 8, 9}, {11, 9, 7}}));
  EXPECT_EQ(origin[10], 0);
  EXPECT_EQ(origin[11], 0);
  EXPECT_FALSE(survey_vertices(triangles, origin.size()).any(VertexState::several));
}

TEST(VertexSurvey, TwoClosedFansOfTheSameNeighborsAreToldApart) {
  TriangleSoup two = make_icosphere(1);
  const int shift = static_cast<int>(two.points.size());
  for (const Triangle& t : make_icosphere(1).triangles) {
    Triangle moved{t[0] + shift, t[1] + shift, t[2] + shift};
    for (int& v : moved) v = v == shift ? 0 : v;  // touching at vertex 0
    two.triangles.push_back(moved);
  }
  EXPECT_EQ(survey_vertices(two.triangles, 2 * static_cast<std::size_t>(shift)).state[0], VertexState::several);
}

TEST(VertexSurvey, DisorderedEdges) {
  const VertexSurvey three = survey_vertices({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}, 5);
  EXPECT_EQ(three.non_manifold_edges, 1U);
  EXPECT_EQ(three.state[0], VertexState::disordered);
  EXPECT_EQ(three.state[1], VertexState::disordered);
  EXPECT_EQ(three.state[2], VertexState::clean);
  const VertexSurvey same_way = survey_vertices({{0, 1, 2}, {0, 1, 3}}, 4);
  EXPECT_EQ(same_way.non_manifold_edges, 0U);
  EXPECT_EQ(same_way.state[0], VertexState::disordered);
  EXPECT_EQ(same_way.state[1], VertexState::disordered);
}

TEST(VertexSurvey, TrianglesWithACornerTwiceCountForNothingElse) {
  TriangleSoup soup = make_icosphere(1);
  const VertexSurvey whole = survey_vertices(soup.triangles, soup.points.size());
  EXPECT_EQ(whole.collapsed_triangles, 0u);
  soup.triangles.insert(soup.triangles.begin() + 7, {5, 5, 9});
  soup.triangles.push_back({3, 3, 3});
  const VertexSurvey survey = survey_vertices(soup.triangles, soup.points.size());
  EXPECT_EQ(survey.collapsed_triangles, 2u);
  EXPECT_EQ(survey.state, whole.state);
  EXPECT_EQ(survey.at_boundary, whole.at_boundary);
  EXPECT_FALSE(survey.may_repeat);
}

TEST(VertexSurvey, OpenVertices) {
  const auto open = [](const Triangles& triangles) { return open_vertices(survey_vertices(triangles, 6), triangles); };
  EXPECT_EQ(open({{0, 1, 2}, {0, 2, 3}}), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(open({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}}), (std::vector<int>{1, 2, 3}));
  EXPECT_EQ(open({{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {3, 2, 1}}), std::vector<int>());
  // Disordered: three triangles at the edge 0-1, of which two go round; and the same two triangles twice, which close.
  EXPECT_EQ(open({{0, 1, 2}, {1, 0, 3}, {0, 1, 4}}), (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(open({{0, 1, 2}, {0, 2, 1}, {0, 1, 2}, {0, 2, 1}}), std::vector<int>());
}

TEST(VertexSurvey, RepeatedTriangles) {
  EXPECT_EQ(repeated_triangles({{2, 1, 0}, {0, 1, 2}, {1, 1, 2}, {1, 1, 2}, {0, 2, 3}, {1, 0, 2}}, 4),
            (std::vector<char>{0, 1, 0, 0, 0, 1}));
}

/// A vertex with 100 000 triangles, in as many fans of two: what is quadratic would take minutes.
TEST(VertexSurvey, VerticesOfAnyValence) {
  Triangles triangles;
  constexpr int fans = 50'000;
  for (int k = 0; k < fans; ++k) {
    triangles.push_back({0, 3 * k + 1, 3 * k + 2});
    triangles.push_back({0, 3 * k + 2, 3 * k + 3});
  }
  std::vector<int> origin = numbers(3 * fans + 1);
  separate_fans(survey_vertices(triangles, origin.size()), triangles, origin);
  EXPECT_EQ(origin.size(), 4U * fans);
}

/// One flipped triangle and one fin far from each other, and a piece that is in order and stays as it is.
TEST(VertexSurvey, OnlyWhatIsDisorderedIsMended) {
  TriangleSoup soup = make_icosphere(2);
  const std::size_t first = soup.triangles.size();
  std::swap(soup.triangles[7][1], soup.triangles[7][2]);
  TriangleSoup other = make_icosphere(2);
  for (Vec3& p : other.points) p += Vec3(5, 0, 0);
  for (Triangle& t : other.triangles) std::swap(t[1], t[2]);  // inward all over: in order
  append(soup, other);
  soup.points.emplace_back(9, 9, 9);
  const Triangle& edge = soup.triangles[first + 3];
  const Triangles before = soup.triangles;
  soup.triangles.push_back({edge[0], edge[1], static_cast<int>(soup.points.size()) - 1});
  const SurfaceModel model = make_surface_model(soup);
  EXPECT_EQ(model.repairs.reoriented_faces, 1U);
  EXPECT_EQ(model.repairs.non_manifold_edges, 1U);
  for (std::size_t f = 0; f < before.size(); ++f) {
    if (f == 7) continue;
    EXPECT_EQ(model.soup.triangles[f], before[f]);
  }
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops[0].kind, LoopKind::cut);
}

}  // namespace
}  // namespace loopmend
