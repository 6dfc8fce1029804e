// A scan as the worker prepared it.
#pragma once

#include "io/read_mesh.h"
#include "mesh/boundary_loops.h"
#include "scene/surface_shape.h"

#include <QString>

#include <cstdint>
#include <memory>
#include <vector>

namespace loopmend {

/// Never changes once it is open; only `shape` comes again, with curvature.
struct OpenedScan {
  QString path;  ///< empty: the embedded sample
  QString name;  ///< as shown
  ImportReport import;
  std::shared_ptr<const SurfaceModel> model;
  std::vector<BoundaryLoop> loops;
  Vec3 origin = Vec3::Zero();  ///< of `shape`
  std::shared_ptr<const SurfaceShape> shape;
  std::uint64_t fingerprint = 0;  ///< of points and triangles: tells whether a file is still the same
};

std::uint64_t fingerprint_of(const TriangleSoup& soup);

}  // namespace loopmend
