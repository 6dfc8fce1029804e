// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/defect_places.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <map>
#include <numeric>
#include <unordered_map>

namespace loopmend {
namespace {

constexpr std::array<unsigned char, 3> warning{214, 40, 34};

struct PlaceHash {
  std::size_t operator()(const Vec3& p) const {
    std::uint64_t hash = 0;
    for (int k = 0; k < 3; ++k)
      hash = (hash ^ std::bit_cast<std::uint64_t>(p[k] + 0.0)) * 0x9e3779b97f4a7c15ULL;  // −0 and 0 are one place
    return static_cast<std::size_t>(hash ^ (hash >> 32));
  }
};

/// A number for each different place.
class Places {
 public:
  std::vector<int> of(const std::vector<Vec3>& points) {
    std::vector<int> numbers;
    numbers.reserve(points.size());
    for (const Vec3& p : points)
      numbers.push_back(number_.try_emplace(p, static_cast<int>(number_.size())).first->second);
    return numbers;
  }

 private:
  std::unordered_map<Vec3, int, PlaceHash> number_;
};

std::array<int, 3> corners_of(const Triangle& t, const std::vector<int>& place) {
  return {place[static_cast<std::size_t>(t[0])], place[static_cast<std::size_t>(t[1])],
          place[static_cast<std::size_t>(t[2])]};
}

bool is_same_face(const Triangle& a, const Triangle& b) {
  for (std::size_t k = 0; k < 3; ++k)
    if (a[0] == b[k] && a[1] == b[(k + 1) % 3] && a[2] == b[(k + 2) % 3]) return true;
  return false;
}

Vec3 area_vector(const TriangleSoup& soup, int face) {
  const Triangle& t = soup.triangles[static_cast<std::size_t>(face)];
  const auto corner = [&](std::size_t k) -> const Vec3& { return soup.points[static_cast<std::size_t>(t[k])]; };
  return (corner(1) - corner(0)).cross(corner(2) - corner(0)) / 2;
}

/// A face without an area cannot be seen: those around it are marked with it.
void add_around_invisible(const TriangleSoup& soup, const std::vector<int>& place, std::vector<int>& faces) {
  std::vector<char> at_invisible(soup.points.size(), 0);
  bool any = false;
  for (int f : faces)
    if (!(area_vector(soup, f).norm() > 0)) {
      any = true;
      for (int p : corners_of(soup.triangles[static_cast<std::size_t>(f)], place))
        at_invisible[static_cast<std::size_t>(p)] = 1;
    }
  if (!any) return;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    for (int p : corners_of(soup.triangles[f], place))
      if (at_invisible[static_cast<std::size_t>(p)]) {
        faces.push_back(static_cast<int>(f));
        break;
      }
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
}

std::vector<DefectPlace> places_of(const TriangleSoup& soup, const std::vector<int>& place,
                                   const std::vector<int>& faces) {
  std::unordered_map<int, int> parent;
  const auto root = [&](int p) {
    int at = parent.try_emplace(p, p).first->second;
    while (parent[at] != at) at = parent[at] = parent[parent[at]];
    return at;
  };
  for (int f : faces) {
    const auto [a, b, c] = corners_of(soup.triangles[static_cast<std::size_t>(f)], place);
    parent[root(b)] = root(a);
    parent[root(c)] = root(a);
  }
  std::map<int, std::vector<int>> groups;
  for (int f : faces) groups[root(corners_of(soup.triangles[static_cast<std::size_t>(f)], place)[0])].push_back(f);
  std::vector<DefectPlace> result;
  for (const auto& [key, group] : groups) {
    DefectPlace one;
    Vec3 sum = Vec3::Zero(), largest = Vec3::Zero();
    double area = 0;
    for (int f : group) {
      for (int p : soup.triangles[static_cast<std::size_t>(f)]) one.center += soup.points[static_cast<std::size_t>(p)];
      const Vec3 own = area_vector(soup, f);
      sum += own;
      area += own.norm();
      if (own.norm() > largest.norm()) largest = own;
    }
    one.faces = group.size();
    one.center /= 3.0 * static_cast<double>(group.size());
    for (int f : group)
      for (int p : soup.triangles[static_cast<std::size_t>(f)])
        one.radius = std::max(one.radius, (soup.points[static_cast<std::size_t>(p)] - one.center).norm());
    constexpr double one_sided = 0.2;  // a closed piece has no side of its own
    const Vec3 direction = sum.norm() > one_sided * area ? sum : largest;
    if (direction.norm() > 0) one.direction = direction.normalized();
    result.push_back(one);
  }
  return result;
}

/// Both sides of each face, a little apart, so that each is over the scan from where it is seen.
void append_faces(const TriangleSoup& soup, const std::vector<int>& faces, double apart, TriangleSoup& to) {
  for (int f : faces) {
    const Triangle& t = soup.triangles[static_cast<std::size_t>(f)];
    const Vec3 area = area_vector(soup, f);
    if (!(area.norm() > 0)) continue;
    const Vec3 shift = apart * area.normalized();
    for (const double side : {1.0, -1.0}) {
      const int first = static_cast<int>(to.points.size());
      for (int p : t) to.points.push_back(soup.points[static_cast<std::size_t>(p)] + side * shift);
      to.triangles.push_back(side > 0 ? Triangle{first, first + 1, first + 2} : Triangle{first, first + 2, first + 1});
    }
  }
}

}  // namespace

std::vector<int> changed_faces(const TriangleSoup& before, const TriangleSoup& after) {
  Places places;
  const std::vector<int> old_place = places.of(before.points), new_place = places.of(after.points);
  const auto key = [](const Triangle& t, const std::vector<int>& place) {
    std::array<int, 3> corners = corners_of(t, place);
    std::sort(corners.begin(), corners.end());
    return corners;
  };
  std::map<std::array<int, 3>, std::vector<std::size_t>> left;
  for (std::size_t f = after.triangles.size(); f-- > 0;) left[key(after.triangles[f], new_place)].push_back(f);
  std::vector<int> changed;
  for (std::size_t f = 0; f < before.triangles.size(); ++f) {
    const auto there = left.find(key(before.triangles[f], old_place));
    if (there == left.end() || there->second.empty()) {
      changed.push_back(static_cast<int>(f));
      continue;
    }
    if (!is_same_face(before.triangles[f], after.triangles[there->second.back()]))
      changed.push_back(static_cast<int>(f));
    there->second.pop_back();
  }
  return changed;
}

DefectPlaces mark_faces(const std::vector<FacesToChange>& changes, const Vec3& origin) {
  constexpr double apart = 2e-4;  // of the extent
  DefectPlaces result;
  TriangleSoup marked;
  for (const FacesToChange& change : changes) {
    const TriangleSoup& soup = change.scan->model->soup;
    std::vector<int> faces = change.faces;
    const std::vector<int> place = Places().of(soup.points);
    add_around_invisible(soup, place, faces);
    const std::vector<DefectPlace> own = places_of(soup, place, faces);
    result.places.insert(result.places.end(), own.begin(), own.end());
    Eigen::AlignedBox3d box;
    for (const Vec3& p : soup.points) box.extend(p);
    append_faces(soup, faces, apart * box.diagonal().norm(), marked);
  }
  std::stable_sort(result.places.begin(), result.places.end(),
                   [](const DefectPlace& a, const DefectPlace& b) { return a.faces > b.faces; });
  if (marked.triangles.empty()) return result;
  auto shape = std::make_shared<SurfaceShape>(shape_of(marked, origin));
  for (std::size_t v = 0; v < marked.points.size(); ++v)
    shape->colors.insert(shape->colors.end(), warning.begin(), warning.end());
  result.shape = std::move(shape);
  return result;
}

DefectPlaces find_defect_places(const std::vector<std::shared_ptr<const OpenedScan>>& scans, Defect defect,
                                const Vec3& origin, const CancelToken& cancel) {
  std::vector<FacesToChange> changes;
  for (const auto& scan : scans) {
    const RepairedSurface repaired = repair_surface(scan->model->soup, {defect}, cancel);
    if (cancel.cancelled()) return {};
    changes.push_back({scan, changed_faces(scan->model->soup, repaired.soup)});
  }
  return mark_faces(changes, origin);
}

}  // namespace loopmend
