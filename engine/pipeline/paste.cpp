// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/paste.h"

#include "core/error.h"
#include "mesh/self_intersections.h"
#include "pipeline/append_colored_patch.h"
#include "pipeline/initial_patch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cstring>
#include <new>
#include <numeric>
#include <stdexcept>

namespace loopmend {

namespace {

/// A patch as it was pasted.
struct PastedPart {
  Points points;
  Triangles triangles;
  Eigen::AlignedBox3d box;
  int loop = 0;  ///< the first that it closes

  PastedPart(const SurfaceModel& model, const PatchGeometry& patch, int first)
      : triangles(patch.triangles),
        loop(first) {
    for (int v : patch.rim) points.push_back(model.mesh.point(TriMesh::VertexHandle(v)));
    points.insert(points.end(), patch.points.begin(), patch.points.end());
    for (const Vec3& p : points) box.extend(p);
  }

  bool intersects(const PastedPart& other) const {
    if (!box.intersects(other.box)) return false;
    Points both = points;
    both.insert(both.end(), other.points.begin(), other.points.end());
    Triangles all = triangles;
    const int shift = static_cast<int>(points.size());
    for (const Triangle& t : other.triangles) all.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    return !self_intersections(both, all, static_cast<int>(triangles.size())).empty();
  }
};

int first_loop(const Patch& patch) {
  return patch.loop_numbers.empty() ? 0 : *std::min_element(patch.loop_numbers.begin(), patch.loop_numbers.end());
}

/// @returns why the patch was left out; empty where it was pasted.
std::string paste(SurfaceModel& model, const Patch& patch, std::vector<PastedPart>& pasted) {
  const PatchGeometry geometry = patch_geometry(patch);
  PastedPart part(model, geometry, first_loop(patch));
  const auto cut =
      std::find_if(pasted.begin(), pasted.end(), [&](const PastedPart& other) { return part.intersects(other); });
  if (cut != pasted.end()) {
    const std::string other = std::to_string(cut->loop), own = std::to_string(part.loop);
    return "its patch would cut that of loop " + other + ": left open; 'loopmend blend --loops " + other + "," + own +
           "' joins the two by one surface";
  }
  try {
    append_colored_patch(model, geometry);
  } catch (const InvalidArgument& error) {
    return error.what();
  }
  pasted.push_back(std::move(part));  // has room
  return "";
}

}  // namespace

std::vector<std::string> paste_patches(SurfaceModel& model, const std::vector<const Patch*>& patches) {
  const TriangleSoup before = model.soup;
  std::vector<std::size_t> order(patches.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return first_loop(*patches[a]) < first_loop(*patches[b]); });
  std::vector<std::string> faults(patches.size(), no_memory_message);
  std::vector<PastedPart> pasted;
  pasted.reserve(patches.size());
  std::size_t points = 0, triangles = 0;
  for (const Patch* patch : patches) {
    points += static_cast<std::size_t>(patch->free_count);
    triangles += static_cast<std::size_t>(patch->patch_triangles);
  }
  reserve_patches(model, points, triangles);
  for (std::size_t k : order) {
    try {
      faults[k] = paste(model, *patches[k], pasted);
    } catch (const std::bad_alloc&) {  // as it says already
    }
  }
  check_exterior(before, model.soup, 0);
  return faults;
}

void check_exterior(const TriangleSoup& before, const TriangleSoup& now, std::size_t turned) {
  const auto changed = [&] {
    if (now.points.size() < before.points.size() || now.triangles.size() < before.triangles.size()) return true;
    if (std::memcmp(now.points.data(), before.points.data(), before.points.size() * sizeof(Vec3)) != 0) return true;
    std::size_t found_turned = 0;
    for (std::size_t f = 0; f < before.triangles.size(); ++f) {
      const Triangle& t = before.triangles[f];
      if (now.triangles[f] == t) continue;
      if (now.triangles[f] != Triangle{t[0], t[2], t[1]}) return true;
      ++found_turned;
    }
    return found_turned != turned;
  };
  if (changed()) throw std::logic_error("the surface outside the patches was changed: nothing is handed on");
}

}  // namespace loopmend
