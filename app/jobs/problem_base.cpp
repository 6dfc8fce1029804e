// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/problem_base.h"

#include "analysis/curvature_field.h"
#include "core/error.h"
#include "jobs/near_shape.h"
#include "mesh/join_parts.h"
#include "pipeline/append_colored_patch.h"

#include <algorithm>

namespace loopmend {
namespace {

SurfaceShapePtr colored(const SurfaceModel& model, const Vec3& origin) {
  return std::make_shared<SurfaceShape>(with_curvature(shape_of(model.mesh, origin), curvature_field(model.mesh)));
}

TriangleSoup filled(const BaseParts::Part& part) {
  if (part.patches.empty()) return part.scan->model->soup;
  SurfaceModel model = *part.scan->model;
  for (const PatchStatePtr& state : part.patches) append_colored_patch(model, patch_geometry(state->patch));
  return model.soup;
}

}  // namespace

BaseParts parts_of(const Document& document, const std::vector<int>& scans) {
  BaseParts base{scans, {}, document.origin()};
  for (int index : scans) {
    const auto scan = document.scan(index);
    BaseParts::Part part{scan, scan->shape, {}};
    for (const OpenPatch& patch : document.patches())
      if (patch.scan == index) part.patches.push_back(patch.state);
    base.parts.push_back(std::move(part));
  }
  return base;
}

ProblemBase make_base(const BaseParts& parts) {
  ProblemBase base;
  base.scans = parts.scans;
  const BaseParts::Part& first = parts.parts.front();
  if (parts.parts.size() == 1 && first.patches.empty()) {
    base.model = first.scan->model;
    base.shape = first.shape;
    base.first_point = {0, base.model->soup.points.size()};
    return base;
  }
  if (parts.parts.size() == 1) {
    base.model = make_shared_surface_model(filled(first));
    base.first_point = {0, base.model->soup.points.size()};
  } else {
    std::vector<TriangleSoup> soups;
    for (const BaseParts::Part& part : parts.parts) soups.push_back(filled(part));
    JoinedParts joined = join_parts(soups);
    base.model = std::make_shared<const SurfaceModel>(std::move(joined.model));
    base.first_point = std::move(joined.first_point);
  }
  base.shape = colored(*base.model, parts.origin);
  return base;
}

SurfaceShapePtr shape_without(const ProblemBase& base, const std::vector<int>& soup_triangles) {
  if (soup_triangles.empty()) return base.shape;
  std::vector<char> own(base.model->soup.triangles.size(), 0);
  for (int f : soup_triangles) own[f] = 1;
  std::vector<char> left_out(base.model->soup_face.size());
  for (std::size_t f = 0; f < left_out.size(); ++f) left_out[f] = own[base.model->soup_face[f]];
  SurfaceShape whole = *base.shape;
  whole.triangles = triangles_of_view(base.model->mesh);  // those of a large shape are in another order
  return without_triangles(whole, left_out);
}

BoundaryLoop loop_in_base(const ProblemBase& base, std::size_t part, const OpenedScan& scan, const BoundaryLoop& loop) {
  std::vector<int> wanted;
  for (int v : loop.vertices) wanted.push_back(scan.model->soup_vertex[v] + static_cast<int>(base.first_point[part]));
  std::sort(wanted.begin(), wanted.end());
  for (const BoundaryLoop& candidate : find_boundary_loops(*base.model)) {
    if (candidate.vertices.size() != wanted.size()) continue;
    std::vector<int> points;
    for (int v : candidate.vertices) points.push_back(base.model->soup_vertex[v]);
    std::sort(points.begin(), points.end());
    if (points == wanted) return candidate;
  }
  throw InvalidArgument(say("loop %1 of %2 is filled already: discard its patch, or choose another loop", loop.number,
                            scan.name.toStdString()));
}

}  // namespace loopmend
