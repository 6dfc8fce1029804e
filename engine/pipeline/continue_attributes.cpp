// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/continue_attributes.h"

#include "filling/fairing.h"
#include "mesh/scan_attributes.h"
#include "operators/operator_set.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

/// The new triangles with their points: first those of the file, then the new ones that hang on them, then the others.
struct NewPart {
  std::vector<int> points;     ///< soup points
  std::vector<int> triangle;   ///< soup triangles
  Triangles triangles;         ///< over `points`
  int known = 0, reached = 0;  ///< so many first points are of the file, or hang on one that is
  std::vector<int> nearest;    ///< per point: of the known ones, by edges; −1: none
  std::vector<int> distance;   ///< per point: edges to it
};

NewPart new_part(const TriangleSoup& soup) {
  NewPart part;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f)
    if (triangle_row(soup, f) < 0) part.triangle.push_back(static_cast<int>(f));
  std::vector<int> local(soup.points.size(), -1);
  for (int f : part.triangle)
    for (int v : soup.triangles[f])
      if (point_row(soup, v) >= 0 && std::exchange(local[v], 0) < 0) part.points.push_back(v);
  std::sort(part.points.begin(), part.points.end());
  part.known = static_cast<int>(part.points.size());
  for (int k = 0; k < part.known; ++k) local[part.points[k]] = k;
  // From the known points outward, ring by ring: so the nearest known one is the first that arrives.
  std::vector<std::vector<int>> around(soup.points.size());
  for (int f : part.triangle) {
    const Triangle& t = soup.triangles[f];
    for (int k = 0; k < 3; ++k)
      for (int other : {t[(k + 1) % 3], t[(k + 2) % 3]})
        if (point_row(soup, other) < 0) around[t[k]].push_back(other);
  }
  part.nearest.resize(part.points.size());
  std::iota(part.nearest.begin(), part.nearest.end(), 0);
  part.distance.assign(part.points.size(), 0);
  for (std::size_t k = 0; k < part.points.size(); ++k)
    for (int other : around[part.points[k]]) {
      if (local[other] >= 0) continue;
      local[other] = static_cast<int>(part.points.size());
      part.points.push_back(other);
      part.nearest.push_back(part.nearest[k]);
      part.distance.push_back(part.distance[k] + 1);
    }
  part.reached = static_cast<int>(part.points.size());
  for (std::size_t v = 0; v < soup.points.size(); ++v)
    if (local[v] < 0 && point_row(soup, v) < 0) {
      local[v] = static_cast<int>(part.points.size());
      part.points.push_back(static_cast<int>(v));
      part.nearest.push_back(-1);
      part.distance.push_back(0);
    }
  for (int f : part.triangle) {
    const Triangle& t = soup.triangles[f];
    part.triangles.push_back({local[t[0]], local[t[1]], local[t[2]]});
  }
  return part;
}

class Continuation {
 public:
  explicit Continuation(const TriangleSoup& soup) : soup_(soup), scan_(*soup.attributes), part_(new_part(soup)) {}

  std::shared_ptr<const ScanAttributes> result() {
    auto made = std::make_shared<ScanAttributes>();
    made->format = scan_.format;
    made->point_count = part_.points.size() - static_cast<std::size_t>(part_.known);
    made->triangle_count = part_.triangle.size();
    find_neighbors();
    find_normals();
    continue_points(*made);
    continue_faces(*made);
    continue_names(*made);
    continue_corner_normals(*made);
    return made;
  }

 private:
  /// The file's faces at each known point.
  void find_neighbors() {
    faces_at_.resize(static_cast<std::size_t>(part_.known));
    std::vector<int> local(soup_.points.size(), -1);
    for (int k = 0; k < part_.known; ++k) local[part_.points[k]] = k;
    for (std::size_t f = 0; f < soup_.triangles.size(); ++f) {
      const int row = triangle_row(soup_, f);
      if (row < 0) continue;
      for (int v : soup_.triangles[f])
        if (local[v] >= 0) faces_at_[local[v]].push_back(scan_.face_of_triangle(static_cast<std::size_t>(row)));
    }
  }

  void find_normals() {
    normals_.assign(part_.points.size(), Vec3::Zero());
    for (const Triangle& t : part_.triangles) {
      const Vec3 &a = point(t[0]), &b = point(t[1]), &c = point(t[2]);
      const Vec3 n = (b - a).cross(c - a);
      for (int v : t) normals_[v] += n;
    }
    for (Vec3& n : normals_) n.normalize();
  }

  const Vec3& point(int k) const { return soup_.points[part_.points[k]]; }

  /// Values at the known points become values at all; what hangs on none gets 0.
  std::vector<std::vector<double>> harmonic(const std::vector<std::vector<double>>& known) {
    if (known.empty()) return {};
    if (!stiffness_) {
      Points points;
      for (int k = 0; k < part_.reached; ++k) points.push_back(point(k));
      Triangles triangles;
      for (const Triangle& t : part_.triangles)
        if (std::max({t[0], t[1], t[2]}) < part_.reached) triangles.push_back(t);
      std::vector<int> faces(triangles.size());
      std::iota(faces.begin(), faces.end(), 0);
      stiffness_ = clamped_cotan_stiffness(points, triangles, faces, robust_clamp);
    }
    std::vector<std::vector<double>> all(known.size(), std::vector<double>(part_.points.size(), 0));
    for (std::size_t first = 0; first < known.size(); first += 3) {  // three at a time, as a vector
      const std::size_t count = std::min<std::size_t>(3, known.size() - first);
      Points values(static_cast<std::size_t>(part_.reached), Vec3::Zero());
      for (std::size_t c = 0; c < count; ++c) {
        double sum = 0, finite = 0;
        for (double x : known[first + c])
          if (std::isfinite(x)) sum += x, finite += 1;
        const double mean = finite > 0 ? sum / finite : std::numeric_limits<double>::quiet_NaN();
        for (int k = 0; k < part_.reached; ++k) {
          const double x = k < part_.known ? known[first + c][k] : mean;
          values[k][static_cast<Eigen::Index>(c)] = std::isfinite(x) ? x : (finite > 0 ? mean : 0);
        }
      }
      minimise_quadratic_form(*stiffness_, values, part_.known, part_.reached);
      for (std::size_t c = 0; c < count; ++c)
        for (int k = 0; k < part_.reached; ++k) all[first + c][k] = values[k][static_cast<Eigen::Index>(c)];
    }
    return all;
  }

  /// Where most of the file's normals point to the other side of their faces, those of the patch shall do so too.
  double side_of(const std::array<const AttributeColumn*, 3>& normal) const {
    double sum = 0;
    for (int k = 0; k < part_.known; ++k) {
      const auto row = static_cast<std::size_t>(point_row(soup_, part_.points[k]));
      for (int c = 0; c < 3; ++c)
        if (normal[c]) sum += normals_[k][c] * normal[c]->value(row);
    }
    return sum < 0 ? -1 : 1;
  }

  static int axis_of(std::string_view name) { return name.back() - 'x'; }

  /// New points in the order of the soup.
  std::vector<int> new_points() const {
    std::vector<std::pair<int, int>> order;
    for (std::size_t k = static_cast<std::size_t>(part_.known); k < part_.points.size(); ++k)
      order.emplace_back(part_.points[k], static_cast<int>(k));
    std::sort(order.begin(), order.end());
    std::vector<int> result;
    for (const auto& [v, k] : order) result.push_back(k);
    return result;
  }

  void continue_points(ScanAttributes& made) {
    std::vector<std::vector<double>> known;
    for (const AttributeColumn& column : scan_.points) {
      if (!is_smooth(column) || role_of(column.name()) == AttributeRole::normal) continue;
      known.emplace_back();
      for (int k = 0; k < part_.known; ++k)
        known.back().push_back(column.value(static_cast<std::size_t>(point_row(soup_, part_.points[k]))));
    }
    const std::vector<std::vector<double>> smooth = harmonic(known);
    const std::vector<int> order = new_points();
    const double side =
        side_of({find_column(scan_.points, "nx"), find_column(scan_.points, "ny"), find_column(scan_.points, "nz")});
    std::size_t next = 0;
    for (const AttributeColumn& given : scan_.points) {
      AttributeColumn& column = made.points.emplace_back(given.name(), given.type(), given.count_type());
      column.reserve(order.size());
      const bool is_normal = role_of(given.name()) == AttributeRole::normal && !given.is_list();
      const std::vector<double>* values = is_smooth(given) && !is_normal ? &smooth[next++] : nullptr;
      for (int k : order) {
        if (is_normal)
          column.push(side * normals_[k][axis_of(given.name())]);
        else if (values)
          column.push((*values)[k]);
        else
          copy_row(given, part_.nearest[k] < 0 ? -1 : point_row(soup_, part_.points[part_.nearest[k]]), column);
      }
    }
  }

  /// The file's face nearest to a new triangle; −1: none.
  int nearest_face(const Triangle& t) const {
    const int corner = *std::min_element(t.begin(), t.end(), [&](int a, int b) {
      const auto rank = [&](int v) {
        const int known = part_.nearest[v];
        const bool has_any = known >= 0 && !faces_at_[known].empty();
        return std::pair(has_any ? part_.distance[v] : std::numeric_limits<int>::max(), v);
      };
      return rank(a) < rank(b);
    });
    const int known = part_.nearest[corner];
    return known < 0 || faces_at_[known].empty() ? -1 : static_cast<int>(faces_at_[known].front());
  }

  void continue_faces(ScanAttributes& made) {
    std::vector<std::vector<double>> known;
    for (const AttributeColumn& column : scan_.faces) {
      if (!is_smooth(column) || role_of(column.name()) == AttributeRole::normal) continue;
      known.emplace_back();
      for (const std::vector<std::size_t>& faces : faces_at_) {
        double sum = 0;
        for (std::size_t face : faces) sum += column.value(face);
        known.back().push_back(faces.empty() ? std::numeric_limits<double>::quiet_NaN()
                                             : sum / static_cast<double>(faces.size()));
      }
    }
    const std::vector<std::vector<double>> smooth = harmonic(known);
    std::size_t next = 0;
    for (const AttributeColumn& given : scan_.faces) {
      AttributeColumn& column = made.faces.emplace_back(given.name(), given.type(), given.count_type());
      const bool is_normal = role_of(given.name()) == AttributeRole::normal && !given.is_list();
      const std::vector<double>* values = is_smooth(given) && !is_normal ? &smooth[next++] : nullptr;
      for (const Triangle& t : part_.triangles) {
        if (is_normal) {
          const Vec3 n = (point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0])).normalized();
          column.push(n[axis_of(given.name())]);
        } else if (values) {
          column.push(((*values)[t[0]] + (*values)[t[1]] + (*values)[t[2]]) / 3);
        } else {
          copy_row(given, nearest_face(t), column);
        }
      }
    }
  }

  void continue_names(ScanAttributes& made) const {
    for (const FaceNames& given : scan_.names) {
      FaceNames& names = made.names.emplace_back(FaceNames{given.keyword, given.names, {}});
      for (const Triangle& t : part_.triangles) {
        const int face = nearest_face(t);
        names.of_face.push_back(face < 0 ? -1 : given.of_face[face]);
      }
    }
  }

  /// Of the file at its own points, so that shading does not show the seam.
  void continue_corner_normals(ScanAttributes& made) const {
    if (scan_.normals.count() == 0 || scan_.normals.at.empty()) return;
    CornerValues& normals = made.normals;
    normals.dimension = scan_.normals.dimension;
    for (std::size_t k = 0; k < part_.points.size(); ++k) {
      const double* given = static_cast<int>(k) < part_.known ? normal_of_file(static_cast<int>(k)) : nullptr;
      for (int c = 0; c < normals.dimension; ++c)
        normals.values.push_back(given ? given[c] : (c < 3 ? normals_[k][c] : 0));
    }
    for (const Triangle& t : part_.triangles) normals.at.insert(normals.at.end(), t.begin(), t.end());
  }

  /// At the first corner of the file that has this point; null: none.
  const double* normal_of_file(int known) const {
    const int row = point_row(soup_, part_.points[known]);
    for (std::size_t face : faces_at_[known])
      for (std::size_t c = scan_.first_corner(face); c < scan_.corner_end(face); ++c)
        if (scan_.corners[c] == row && scan_.normals.at[c] >= 0)
          return &scan_.normals.values[scan_.normals.at[c] * scan_.normals.dimension];
    return nullptr;
  }

  const TriangleSoup& soup_;
  const ScanAttributes& scan_;
  NewPart part_;
  std::vector<std::vector<std::size_t>> faces_at_;
  Points normals_;
  std::optional<SparseMatrix> stiffness_;
};

}  // namespace

void continue_attributes(TriangleSoup& soup) {
  soup.continued = nullptr;
  if (!soup.attributes) return;
  const ScanAttributes& scan = *soup.attributes;
  if (scan.points.empty() && scan.faces.empty() && scan.names.empty() && scan.normals.count() == 0) return;
  soup.continued = Continuation(soup).result();
}

}  // namespace loopmend
