// SPDX-License-Identifier: GPL-3.0-or-later
#include "scans.h"

#include "io/read_mesh.h"
#include "mesh/mesh_arrays.h"
#include "mesh/surface_model.h"
#include "region_cut.h"
#include "samples/analytic_surfaces.h"

#include <Eigen/Geometry>

#include <map>

namespace loopmend::bench {

namespace {

TriangleSoup load(const std::string& name) {
  const std::filesystem::path folder = std::filesystem::path(LOOPMEND_SHARED_DIR) / "data";
  const std::string extension = name == "demosthenes" || name == "doll" ? ".obj" : ".ply";
  const SurfaceModel model = make_surface_model(read_mesh(folder / (name + extension)).soup);
  const TriangleSoup soup{points_of(model.mesh), triangles_of(model.mesh), {}};
  // Of a large scan only a neighbourhood is ever used, and trimmed then.
  return largest_component(soup.points.size() > most_kept_whole ? soup : trim_boundaries(soup));
}

}  // namespace

const std::vector<std::string>& scan_names() {
  static const std::vector<std::string> names{"bunny", "dragon", "head", "lps_head", "demosthenes", "doll"};
  return names;
}

const TriangleSoup& scan(const std::string& name) {
  static std::map<std::string, TriangleSoup> scans;
  const auto found = scans.find(name);
  return found != scans.end() ? found->second : scans.emplace(name, load(name)).first->second;
}

double extent(const TriangleSoup& soup) {
  Eigen::AlignedBox3d box;
  for (const Vec3& p : soup.points) box.extend(p);
  return box.sizes().maxCoeff();
}

}  // namespace loopmend::bench
