// SPDX-License-Identifier: GPL-3.0-or-later
#include "problems/paper_examples.h"

#include "samples/paper_inputs.h"

namespace loopmend {

namespace {

std::vector<TriangleSoup> tubes(const std::vector<TubeShape>& shapes) {
  std::vector<TriangleSoup> parts;
  for (const TubeShape& shape : shapes) parts.push_back(make_tube(shape));
  return parts;
}

}  // namespace

const std::vector<PaperExample>& paper_examples() {
  using Kind = PaperExample::Kind;
  using Flows = PaperExample::Flows;
  static const std::vector<PaperExample> all{
      {"fig5.1a", "Cylinder", "A cylinder with parts missing", Kind::holes, Flows::one,
       [] { return std::vector{make_pierced_cylinder()}; }},
      {"fig5.1d", "Sphere", "A wire-frame of a sphere with eight openings", Kind::holes, Flows::one,
       [] { return std::vector{make_sphere_wireframe()}; }},
      {"fig5.2a", "Three tubes", "Three tubes", Kind::blend, Flows::one, [] { return tubes(three_tubes()); }},
      {"fig5.2d", "Six tubes", "Six tubes", Kind::blend, Flows::one, [] { return tubes(six_tubes()); }},
      {"fig5.2g", "T piece", "Three tubes that form a T", Kind::blend, Flows::one, [] { return tubes(tee_tubes()); }},
      {"fig5.3", "Head", "A head-like mesh with holes in nose, face and jaw", Kind::holes, Flows::one,
       [] { return std::vector{make_holed_head()}; }},
      {"fig5.4", "Dodecahedron", "A dodecahedron", Kind::points, Flows::one,
       [] { return std::vector{make_dodecahedron()}; }},
      {"fig5.5", "Flows, tubes", "MMCVF, SDF and WF on the six tubes", Kind::blend, Flows::all,
       [] { return tubes(six_tubes(24)); }},
      {"fig5.6", "Flows, graph", "The graph of a function: MCF, SDF, WF and MMCVF", Kind::region, Flows::all,
       [] { return std::vector{make_bumps()}; }}};
  return all;
}

const PaperExample* paper_example(const std::string& id) {
  for (const PaperExample& example : paper_examples())
    if (id == example.id) return &example;
  return nullptr;
}

std::vector<int> bumps_region(const TriangleSoup& soup) {
  std::vector<int> vertices;
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    if (soup.points[i].z() > bumps_threshold) vertices.push_back(static_cast<int>(i));
  return vertices;
}

}  // namespace loopmend
