#include "samples/paper_inputs.h"

#include "samples/analytic_surfaces.h"

#include <Eigen/Geometry>

namespace loopmend {

TriangleSoup make_tube(const TubeShape& shape) {
  TriangleSoup tube = make_cylinder(shape.length / shape.radius, shape.around);
  const Eigen::Quaterniond turn = Eigen::Quaterniond::FromTwoVectors(Vec3::UnitZ(), shape.direction);
  for (Vec3& p : tube.points) p = shape.start + shape.radius * (turn * p);
  return tube;
}

TriangleSoup joined(const std::vector<TriangleSoup>& parts) {
  TriangleSoup all;
  for (const TriangleSoup& part : parts) {
    const int shift = static_cast<int>(all.points.size());
    all.points.insert(all.points.end(), part.points.begin(), part.points.end());
    for (const Triangle& t : part.triangles) all.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  }
  return all;
}

}  // namespace loopmend
