// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/divided_faces.h"

#include "mesh/scan_attributes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

using Weights = std::array<double, 3>;  ///< of the corners of a face, with sum 1

/// Of a point in the triangle; rounding may have put it slightly beside.
Weights weights_in(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 normal = (b - a).cross(c - a);
  const double whole = normal.squaredNorm();
  if (!(whole > 0)) return {1, 0, 0};
  Weights weights{normal.dot((b - p).cross(c - p)) / whole, normal.dot((c - p).cross(a - p)) / whole,
                  normal.dot((a - p).cross(b - p)) / whole};
  double sum = 0;
  for (double& w : weights) sum += w = std::max(w, 0.0);
  for (double& w : weights) w /= sum;
  return weights;
}

std::size_t largest(const Weights& weights) {
  return static_cast<std::size_t>(std::max_element(weights.begin(), weights.end()) - weights.begin());
}

class DividedRows {
 public:
  DividedRows(const TriangleSoup& from, const DividedFaces& faces, TriangleSoup& to)
      : from_(from),
        faces_(faces),
        to_(to),
        given_(*from.attributes),
        made_(std::make_shared<ScanAttributes>(given_)) {}

  void add() {
    add_points();
    for (std::size_t k = 0; k < faces_.part_of.size(); ++k)
      to_.triangle_rows.push_back(add_face(faces_.part_of[k], to_.triangles[faces_.kept.size() + k]));
    to_.attributes = std::move(made_);
  }

 private:
  Weights weights_of(int v, const Triangle& corners) const {
    return weights_in(to_.points[v], from_.points[corners[0]], from_.points[corners[1]], from_.points[corners[2]]);
  }

  void add_points() {
    const std::array<const AttributeColumn*, 3> normal{
        find_column(given_.points, "nx"), find_column(given_.points, "ny"), find_column(given_.points, "nz")};
    const bool has_normals = normal[0] && normal[1] && normal[2];
    for (std::size_t k = 0; k < faces_.beneath.size(); ++k) {
      const Triangle& corners = from_.triangles[faces_.beneath[k]];
      const Weights weights = weights_of(static_cast<int>(from_.points.size() + k), corners);
      std::array<int, 3> rows{};
      for (std::size_t c = 0; c < 3; ++c) rows[c] = point_row(from_, static_cast<std::size_t>(corners[c]));
      if (*std::min_element(rows.begin(), rows.end()) < 0) {  // a corner is new itself
        to_.point_rows.push_back(-1);
        continue;
      }
      const auto mean = [&](const AttributeColumn& column) {
        double sum = 0;
        for (std::size_t c = 0; c < 3; ++c) sum += weights[c] * column.value(static_cast<std::size_t>(rows[c]));
        return sum;
      };
      double length = 1;
      if (has_normals) length = Vec3(mean(*normal[0]), mean(*normal[1]), mean(*normal[2])).norm();
      for (std::size_t p = 0; p < given_.points.size(); ++p) {
        const AttributeColumn& column = given_.points[p];
        const bool is_normal = has_normals && role_of(column.name()) == AttributeRole::normal && length > 0;
        if (is_smooth(column))
          made_->points[p].push(is_normal ? mean(column) / length : mean(column));
        else
          copy_row(column, rows[largest(weights)], made_->points[p]);
      }
      to_.point_rows.push_back(static_cast<int>(made_->point_count++));
    }
  }

  /// @returns the row of the new triangle.
  int add_face(int face, const Triangle& part) {
    const int row = triangle_row(from_, static_cast<std::size_t>(face));
    if (row < 0) return -1;
    const int of_file = static_cast<int>(given_.face_of_triangle(static_cast<std::size_t>(row)));
    for (std::size_t k = 0; k < given_.faces.size(); ++k) copy_row(given_.faces[k], of_file, made_->faces[k]);
    for (FaceNames& names : made_->names) names.of_face.push_back(names.of_face[of_file]);
    add_corner_values(face, of_file, part, given_.texture, made_->texture);
    add_corner_values(face, of_file, part, given_.normals, made_->normals);
    const Triangle rows{to_.point_rows[part[0]], to_.point_rows[part[1]], to_.point_rows[part[2]]};
    const int number = static_cast<int>(given_.ends.empty() ? made_->triangle_count : made_->ends.size());
    if (!made_->corners.empty()) made_->corners.insert(made_->corners.end(), rows.begin(), rows.end());
    if (!made_->ends.empty()) made_->ends.push_back(made_->ends.back() + 3);
    if (!made_->face_of.empty()) {
      made_->face_of.push_back(number);
      made_->triangles.push_back(rows);
    }
    return static_cast<int>(made_->triangle_count++);
  }

  void add_corner_values(int face, int of_file, const Triangle& part, const CornerValues& given,
                         CornerValues& made) const {
    if (given.at.empty()) return;
    const Triangle& corners = from_.triangles[face];
    const std::array<int, 3> at = values_at(of_file, corners, given);
    for (int v : part) {
      if (*std::min_element(at.begin(), at.end()) < 0) {
        made.at.push_back(-1);
        continue;
      }
      if (const auto same = std::find(corners.begin(), corners.end(), v); same != corners.end()) {
        made.at.push_back(at[static_cast<std::size_t>(same - corners.begin())]);
        continue;
      }
      const Weights weights = weights_of(v, corners);
      std::vector<double> value(static_cast<std::size_t>(given.dimension), 0);
      for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t d = 0; d < value.size(); ++d)
          value[d] += weights[c] * given.values[static_cast<std::size_t>(at[c]) * value.size() + d];
      if (&given == &given_.normals) {
        const double length = std::sqrt(std::inner_product(value.begin(), value.end(), value.begin(), 0.0));
        if (length > 0)
          for (double& x : value) x /= length;
      }
      made.at.push_back(static_cast<int>(made.count()));
      made.values.insert(made.values.end(), value.begin(), value.end());
    }
  }

  /// Of the corners of a face; −1: none.
  std::array<int, 3> values_at(int of_file, const Triangle& corners, const CornerValues& given) const {
    std::array<int, 3> at{-1, -1, -1};
    if (given_.corners.empty()) return at;
    const auto face = static_cast<std::size_t>(of_file);
    for (std::size_t k = 0; k < 3; ++k)
      for (std::size_t c = given_.first_corner(face); c < given_.corner_end(face) && at[k] < 0; ++c)
        if (given_.corners[c] == point_row(from_, static_cast<std::size_t>(corners[k]))) at[k] = given.at[c];
    return at;
  }

  const TriangleSoup& from_;
  const DividedFaces& faces_;
  TriangleSoup& to_;
  const ScanAttributes& given_;
  std::shared_ptr<ScanAttributes> made_;
};

void add_colors(const TriangleSoup& from, const DividedFaces& faces, TriangleSoup& to) {
  to.colors = from.colors;
  if (from.colors.empty()) return;
  for (std::size_t k = 0; k < faces.beneath.size(); ++k) {
    const Triangle& corners = from.triangles[faces.beneath[k]];
    const Weights weights = weights_in(to.points[from.points.size() + k], from.points[corners[0]],
                                       from.points[corners[1]], from.points[corners[2]]);
    Color color{};
    for (std::size_t channel = 0; channel < color.size(); ++channel) {
      double sum = 0;
      for (std::size_t c = 0; c < 3; ++c) sum += weights[c] * from.colors[corners[c]][channel];
      color[channel] = static_cast<unsigned char>(std::lround(std::clamp(sum, 0.0, 255.0)));
    }
    to.colors.push_back(color);
  }
}

}  // namespace

void copy_divided_rows(const TriangleSoup& from, const DividedFaces& faces, TriangleSoup& to) {
  add_colors(from, faces, to);
  std::vector<int> points(from.points.size());
  std::iota(points.begin(), points.end(), 0);
  copy_rows(from, points, faces.kept, to);
  if (!from.attributes) return;
  if (faces.kept.empty()) to.triangle_rows.clear();  // copy_rows() has put a row there
  if (from.points.empty()) to.point_rows.clear();
  DividedRows(from, faces, to).add();
}

}  // namespace loopmend
