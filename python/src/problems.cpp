// SPDX-License-Identifier: GPL-3.0-or-later
#include "problems.h"

#include "arrays.h"
#include "interruptible.h"
#include "results.h"
#include "words.h"

#include "analysis/seam_report.h"
#include "mesh/part_loops.h"
#include "pipeline/blend.h"
#include "pipeline/evolve_region.h"
#include "pipeline/interpolate.h"

#include <pybind11/stl.h>

#include <utility>

namespace loopmend {

namespace {

namespace py = pybind11;
using namespace py::literals;

/// A surface, and how its patch came to be.
struct Solved {
  TriangleSoup surface;
  PatchResult outcome;
  Message refusal;                 ///< why the surface should not be used; empty: it may
  std::size_t given_vertices = 0;  ///< the first of the surface are given, bit for bit
  std::size_t turned_faces = 0;    ///< of those given
  bool remeshed = false;           ///< the region has other vertices than it had
};

using Solve = std::function<Solved(const Evolution::OnStep& on_step, const CancelToken& cancel)>;

py::dict solved(const Solve& solve, const py::object& on_step) {
  Solved result;
  run_interruptibly(
      [&](const CancelToken& cancel, const PostEvent& post) {
        const auto tell = [&](const Evolution&, const StepRecord& record) {
          post([step = record.step, energy = record.energy] { return py::make_tuple(step, energy); });
        };
        result = solve(tell, cancel);
      },
      on_step);
  py::dict figures = patch_figures(result.outcome);
  figures["refusal"] = result.refusal.english();
  figures["given_vertices"] = result.given_vertices;
  figures["turned_faces"] = result.turned_faces;
  figures["remeshed"] = result.remeshed;
  figures["vertices"] = points_array(std::move(result.surface.points));
  figures["faces"] = triangles_array(std::move(result.surface.triangles));
  return figures;
}

/// @param parts  pairs of arrays. @param loops  "1:2,2:1", part and loop from 1; empty: those that face one another.
py::dict blend(const std::vector<std::pair<py::array, py::array>>& parts, const std::string& loops,
               const py::dict& options, const py::object& on_step) {
  std::vector<TriangleSoup> soups;
  soups.reserve(parts.size());
  for (const auto& [vertices, faces] : parts) soups.push_back(soup_of(vertices, faces, py::none()));
  if (soups.empty()) throw InvalidArgument(say("a blend needs one part at least"));
  const GroupOptions group = group_options(options);
  return solved(
      [&](const Evolution::OnStep& tell, const CancelToken& cancel) {
        std::vector<TriangleSoup> oriented;
        oriented.reserve(soups.size());
        for (TriangleSoup& soup : soups) oriented.push_back(make_surface_model(std::move(soup)).soup);
        const JoinedParts joined = join_parts(oriented);
        std::vector<BoundaryLoop> chosen;
        for (const NamedLoop& loop : choose_part_loops(joined, loops)) chosen.push_back(loop.loop);
        SurfaceModel model = joined.model;
        BlendResult result = blend_loops(model, chosen, group, cancel, tell);
        Solved done{
            std::move(model.soup), std::move(result.outcome), {}, joined.model.soup.points.size(), result.turned_faces};
        if (done.outcome.status == PatchStatus::failed)
          done.refusal = say("the loops were not joined: %1", done.outcome.message);
        return done;
      },
      on_step);
}

py::dict interpolate(const py::array& vertices, const py::array& faces, const std::vector<int>& fixed, int subdivide,
                     const std::string& boundary, const py::dict& options, const py::object& on_step) {
  TriangleSoup soup = soup_of(vertices, faces, py::none());
  const GroupOptions group = group_options(options);
  SubdivisionOptions subdivision;
  subdivision.subdivisions = subdivide;
  subdivision.fixed = fixed;
  subdivision.boundary = boundary == "smooth" ? PolyhedronBoundary::smooth : PolyhedronBoundary::refuse;
  return solved(
      [&](const Evolution::OnStep& tell, const CancelToken& cancel) {
        const SurfaceModel polyhedron = make_surface_model(std::move(soup));
        Interpolation found = interpolate_points(polyhedron, subdivision, group.evolution, cancel, tell);
        const Message refusal = refusal_of(found.outcome);
        return Solved{std::move(found.surface), std::move(found.outcome), refusal,
                      static_cast<std::size_t>(found.fixed_count)};
      },
      on_step);
}

py::dict evolve(const py::array& vertices, const py::array& faces, const std::vector<int>& region,
                const py::dict& options, const py::object& on_step) {
  TriangleSoup soup = soup_of(vertices, faces, py::none());
  const GroupOptions group = group_options(options);
  if (!group.evolution) throw InvalidArgument(say("flow 'none' would leave the region as it is"));
  return solved(
      [&](const Evolution::OnStep& tell, const CancelToken& cancel) {
        const SurfaceModel model = make_surface_model(std::move(soup));
        const Region posed = make_region(model, region);
        Solved done{model.soup, evolve_region(posed, *group.evolution, tell, cancel), {}};
        if (cancel.cancelled()) return done;
        done.refusal = refusal_of(posed, done.outcome);
        done.remeshed = done.outcome.patch.free_count != posed.patch.free_count;
        done.outcome.seams_before = seam_reports(posed.patch);
        done.outcome.seams = seam_reports(done.outcome.patch);
        if (done.refusal.empty()) done.surface = with_region(model, posed, done.outcome.patch);
        return done;
      },
      on_step);
}

}  // namespace

void define_problems(py::module_& m) {
  m.def("blend", &blend, "parts"_a, "loops"_a, "options"_a, "progress"_a);
  m.def("interpolate", &interpolate, "vertices"_a, "faces"_a, "fixed"_a, "subdivide"_a, "rim"_a, "options"_a,
        "progress"_a);
  m.def("evolve", &evolve, "vertices"_a, "faces"_a, "region"_a, "options"_a, "progress"_a);
}

}  // namespace loopmend
