// SPDX-License-Identifier: GPL-3.0-or-later
// The triangles of a surface that is drawn.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace loopmend {

/// Corners of triangles, three a triangle, which never change: copies share them. Those of a large scan take 12 bytes a triangle.
class TriangleList {
 public:
  TriangleList() = default;
  TriangleList(std::vector<int> corners) : corners_(std::make_shared<const std::vector<int>>(std::move(corners))) {}

  std::size_t size() const { return corners_ ? corners_->size() : 0; }  ///< corners, not triangles
  bool empty() const { return size() == 0; }
  int operator[](std::size_t corner) const { return (*corners_)[corner]; }
  const int* data() const { return corners_ ? corners_->data() : nullptr; }
  const int* begin() const { return data(); }
  const int* end() const { return data() + size(); }

  friend bool operator==(const TriangleList& a, const TriangleList& b) {
    return a.corners_ == b.corners_ || (a.corners_ && b.corners_ && *a.corners_ == *b.corners_);
  }

 private:
  std::shared_ptr<const std::vector<int>> corners_;
};

}  // namespace loopmend
