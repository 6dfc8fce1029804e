// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/paste.h"

#include "core/error.h"
#include "core/threads.h"
#include "mesh/chord_faces.h"
#include "mesh/self_intersections.h"
#include "mesh/validity.h"
#include "pipeline/append_colored_patch.h"
#include "pipeline/initial_patch.h"

#include <zlib.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cstring>
#include <new>
#include <numeric>
#include <optional>
#include <stdexcept>

namespace loopmend {

namespace {

/// A patch in place.
struct PlacedPart {
  Points points;
  Triangles triangles;
  Eigen::AlignedBox3d box;
  int loop = 0;  ///< the first that it closes
  bool is_pasted = false;

  PlacedPart(const SurfaceModel& model, const PatchGeometry& patch, int first)
      : triangles(patch.triangles),
        loop(first) {
    for (int v : patch.boundary) points.push_back(model.mesh.point(TriMesh::VertexHandle(v)));
    points.insert(points.end(), patch.points.begin(), patch.points.end());
    for (const Vec3& p : points) box.extend(p);
  }

  bool intersects(const PlacedPart& other) const {
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

/// The patches in the order in which they are pasted, and which of their boxes meet.
class PlacedParts {
 public:
  PlacedParts(const SurfaceModel& model, const std::vector<const Patch*>& patches,
              const std::vector<std::size_t>& order) {
    parts_.reserve(order.size());
    for (std::size_t k : order) {
      const PlacedPart& part = parts_.emplace_back(model, patch_geometry(*patches[k]), first_loop(*patches[k]));
      const int corner = static_cast<int>(corners_.size());
      corners_.insert(corners_.end(), {part.box.min(), part.box.max()});
      boxes_.push_back({corner, corner + 1, corner});
    }
    index_.emplace(corners_, boxes_);
  }
  PlacedPart& operator[](std::size_t place) { return parts_[place]; }
  /// The first pasted one that the part at this place intersects; null where there is none.
  const PlacedPart* pasted_across(std::size_t place) const {
    for (int other : index_->near_box(parts_[place].box.min(), parts_[place].box.max()))
      if (parts_[other].is_pasted && parts_[place].intersects(parts_[other])) return &parts_[other];
    return nullptr;
  }

 private:
  std::vector<PlacedPart> parts_;
  Points corners_;   ///< two of each box
  Triangles boxes_;  ///< each box as that of a triangle
  std::optional<TriangleIndex> index_;
};

/// @returns why the patch was left out; empty where it was pasted.
Message paste(SurfaceModel& model, const Patch& patch, PlacedParts& parts, std::size_t place, ChordFaces& chords) {
  const PatchGeometry geometry = patch_geometry(patch);
  if (const int edges = chords.count_crowded(model, geometry); edges > 0)
    return joined(nonmanifold_message(edges), ": ", say("left open"));
  if (const PlacedPart* cut = parts.pasted_across(place)) {
    const std::string other = std::to_string(cut->loop), own = std::to_string(parts[place].loop);
    return joined(say("its patch would cut that of loop %1: left open", other), "; ",
                  say("'loopmend blend --loops 1:%1,1:%2' may join the two by one surface", other, own))
        .with_code("patches_cross");
  }
  try {
    append_colored_patch(model, geometry);
  } catch (const InvalidArgument& error) {
    return error.message();
  }
  chords.add_patch(model, geometry);
  parts[place].is_pasted = true;
  return {};
}

}  // namespace

std::vector<PastedPatch> paste_patches(SurfaceModel& model, const std::vector<const Patch*>& patches) {
  const SoupRecord before = record_of(model.soup);
  std::vector<std::size_t> order(patches.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return first_loop(*patches[a]) < first_loop(*patches[b]); });
  std::vector<PastedPatch> outcomes(patches.size(), {no_memory_message()});
  PlacedParts parts(model, patches, order);
  std::size_t points = 0, triangles = 0;
  for (const Patch* patch : patches) {
    points += static_cast<std::size_t>(patch->free_count);
    triangles += static_cast<std::size_t>(patch->patch_triangles);
  }
  ChordFaces chords;
  for (const Patch* patch : patches) chords.add_chords(model, patch_geometry(*patch));
  chords.add_faces(model);
  reserve_patches(model, points, triangles);
  for (std::size_t place = 0; place < order.size(); ++place) {
    const std::size_t k = order[place];
    const int first_point = static_cast<int>(model.soup.points.size());
    const int first_triangle = static_cast<int>(model.soup.triangles.size());
    try {
      outcomes[k].fault = paste(model, *patches[k], parts, place, chords);
      if (outcomes[k].fault.empty()) outcomes[k] = {{}, first_point, first_triangle};
    } catch (const std::bad_alloc&) {  // as it says already
    }
  }
  check_exterior(before, model.soup);
  return outcomes;
}

namespace {

constexpr std::size_t stretch = 1 << 16;  ///< elements that have one checksum

[[noreturn]] void throw_changed() {
  throw std::logic_error("the surface outside the patches was changed: nothing is handed on");
}

template <class T>
std::uint32_t add_to_sum(std::uint32_t sum, const T* from, std::size_t count) {
  const void* bytes = from;
  return static_cast<std::uint32_t>(::crc32_z(sum, static_cast<const unsigned char*>(bytes), count * sizeof(T)));
}

std::size_t sums_of(std::size_t count) { return (count + stretch - 1) / stretch; }

/// The checksum of one stretch of the first points and triangles, as many as the record says. Takes no memory.
std::uint32_t sum_of(const TriangleSoup& soup, const SoupRecord& record, const std::vector<int>& turned,
                     std::size_t k) {
  if (k < sums_of(record.points)) {
    const std::size_t first = k * stretch;
    return add_to_sum(0, soup.points.data() + first, std::min(stretch, record.points - first));
  }
  std::size_t at = (k - sums_of(record.points)) * stretch;
  const std::size_t end = std::min(at + stretch, record.triangles);
  std::uint32_t sum = 0;
  for (auto f = std::lower_bound(turned.begin(), turned.end(), static_cast<int>(at)); at < end; ++f) {
    const std::size_t next = f == turned.end() ? end : std::min(end, static_cast<std::size_t>(*f));
    sum = add_to_sum(sum, soup.triangles.data() + at, next - at);
    at = next;
    if (at == end) break;
    const auto& [a, b, c] = soup.triangles[at++];
    const Triangle back{a, c, b};
    sum = add_to_sum(sum, &back, 1);
  }
  return sum;
}

}  // namespace

SoupRecord record_of(const TriangleSoup& soup, const std::vector<int>& turned) {
  SoupRecord record{soup.points.size(), soup.triangles.size(), {}};
  record.sums.resize(sums_of(record.points) + sums_of(record.triangles));
  parallel_for(0, static_cast<int>(record.sums.size()), 4,
               [&](int k) { record.sums[k] = sum_of(soup, record, turned, static_cast<std::size_t>(k)); });
  return record;
}

// On one thread: sharing the work would take memory, and of that there may be none left when patches have been pasted.
void check_exterior(const SoupRecord& before, const TriangleSoup& now, const std::vector<int>& turned) {
  if (now.points.size() < before.points || now.triangles.size() < before.triangles) throw_changed();
  for (std::size_t k = 0; k < before.sums.size(); ++k)
    if (sum_of(now, before, turned, k) != before.sums[k]) throw_changed();
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
  if (changed()) throw_changed();
}

}  // namespace loopmend
