// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/written_rows.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace loopmend {

namespace {

/// The corners of a triangle of the file that three points have: the turn of it, or of its mirror image, that fits most of
/// them. Points that were joined with others fit none.
std::array<int, 3> best_turn(const std::array<int, 3>& rows, std::span<const int> file, int first) {
  std::array<int, 3> best{};
  int most = -1;
  for (int step : {1, 2})
    for (int turn = 0; turn < 3; ++turn) {
      std::array<int, 3> corners{};
      int fits = 0;
      for (int k = 0; k < 3; ++k) {
        corners[k] = (turn + step * k) % 3;
        fits += file[corners[k]] == rows[k];
      }
      if (fits <= most) continue;
      most = fits;
      best = corners;
    }
  for (int& corner : best) corner += first;
  return best;
}

class FaceWalk {
 public:
  FaceWalk(const TriangleSoup& soup, const std::function<void(const WrittenFace&)>& each) : soup_(soup), each_(each) {}

  void run() {
    for (std::size_t f = 0; f < soup_.triangles.size();) f += polygon_at(f) ? last_polygon_ : triangle_at(f);
  }
  void run_over_triangles() {
    for (std::size_t f = 0; f < soup_.triangles.size(); ++f) triangle_at(f);
  }

 private:
  const ScanAttributes& table() const { return *soup_.attributes; }

  std::array<int, 3> rows_of(const Triangle& t) const {
    return {point_row(soup_, t[0]), point_row(soup_, t[1]), point_row(soup_, t[2])};
  }

  /// @returns whether all triangles of a polygon of the file begin here, as they were read; it is passed on then.
  bool polygon_at(std::size_t f) {
    const int row = triangle_row(soup_, f);
    if (row < 0 || table().face_of.empty()) return false;
    const int face = table().face_of[row];
    const std::size_t first = table().first_corner(face), size = table().corner_end(face) - first;
    if (size <= 3 || (row > 0 && table().face_of[row - 1] == face)) return false;
    last_polygon_ = size - 2;
    if (f + last_polygon_ > soup_.triangles.size()) return false;
    std::map<int, int> vertex_of;  // row → soup point
    for (std::size_t k = 0; k < last_polygon_; ++k) {
      const Triangle &t = soup_.triangles[f + k], &as_read = table().triangles[row + k];
      if (triangle_row(soup_, f + k) != row + static_cast<int>(k) || rows_of(t) != as_read) return false;
      for (int corner = 0; corner < 3; ++corner) vertex_of[as_read[corner]] = t[corner];
    }
    vertices_.clear();
    for (std::size_t c = first; c < first + size; ++c) {
      const auto found = vertex_of.find(table().corners[c]);
      if (found == vertex_of.end()) return false;
      vertices_.push_back(found->second);
    }
    corners_.resize(size);
    std::iota(corners_.begin(), corners_.end(), static_cast<int>(first));
    each_({vertices_, {&table(), static_cast<std::size_t>(face)}, corners_});
    return true;
  }

  std::size_t triangle_at(std::size_t f) {
    const Triangle& t = soup_.triangles[f];
    WrittenFace written{t, {}, {}};
    if (const int row = triangle_row(soup_, f); row >= 0) {
      written.row = {&table(), table().face_of_triangle(row)};
      if (!table().corners.empty()) find_corners(t, row, written.row.row);
    } else if (soup_.continued) {
      const int first = 3 * static_cast<int>(new_triangles_);
      corners_ = {first, first + 1, first + 2};
      written.row = {soup_.continued.get(), new_triangles_};
    }
    new_triangles_ += triangle_row(soup_, f) < 0;
    if (written.row.table && (written.row.table != soup_.attributes.get() || !table().corners.empty()))
      written.corners = corners_;
    each_(written);
    return 1;
  }

  void find_corners(const Triangle& t, int row, std::size_t face) {
    const std::array<int, 3> rows = rows_of(t);
    const std::size_t first = table().first_corner(face), size = table().corner_end(face) - first;
    const std::span<const int> file(table().corners.data() + first, size);
    corners_.assign(3, -1);
    if (size == 3) {
      const std::array<int, 3> turn = best_turn(rows, file, static_cast<int>(first));
      corners_.assign(turn.begin(), turn.end());
      return;
    }
    // By the triangle that was read: its vertices may have been joined with others since.
    const Triangle& as_read = table().triangles[row];
    const std::array<int, 3> turn = best_turn(rows, as_read, 0);
    for (int k = 0; k < 3; ++k)
      if (const auto found = std::find(file.begin(), file.end(), as_read[turn[k]]); found != file.end())
        corners_[k] = static_cast<int>(first + static_cast<std::size_t>(found - file.begin()));
  }

  const TriangleSoup& soup_;
  const std::function<void(const WrittenFace&)>& each_;
  std::vector<int> vertices_, corners_;
  std::size_t last_polygon_ = 0, new_triangles_ = 0;
};

}  // namespace

AttributeRow PointRows::next() {
  const int row = point_row(soup_, point_++);
  if (row >= 0) return {soup_.attributes.get(), static_cast<std::size_t>(row)};
  return {soup_.continued.get(), new_points_++};
}

void for_each_face(const TriangleSoup& soup, const std::function<void(const WrittenFace&)>& each) {
  FaceWalk(soup, each).run();
}

void for_each_triangle(const TriangleSoup& soup, const std::function<void(const WrittenFace&)>& each) {
  FaceWalk(soup, each).run_over_triangles();
}

}  // namespace loopmend
