// SPDX-License-Identifier: GPL-3.0-or-later
// Which triangles cut each other (exact predicates, through CGAL).
#pragma once

#include "core/cancel.h"
#include "core/types.h"

#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace loopmend {

/// Pairs (a, b), a < b, of triangles that meet in more than their common vertices or edge, where a is among the first
/// `count`. Vertices in exactly the same place count as one. Triangles without area count as cutting nothing.
/// @returns ascending; only those found so far when cancelled.
std::vector<std::pair<int, int>> self_intersections(const Points& points, const Triangles& triangles, int count,
                                                    const CancelToken& cancel = {});

/// For each of the first `count` triangles, whether it cuts one of the others; what those cut among themselves is not looked at.
/// @returns #count; empty when cancelled, or where the boxes of more than 20 million pairs meet, which would take seconds
std::vector<char> triangles_that_cut(const Points& points, const Triangles& triangles, int count,
                                     const CancelToken& cancel = {});

/// The number of pairs that self_intersections() would return for all triangles, or `most` where there are more: loose triangles may
/// have as many as their number squared.
std::size_t count_self_intersections(const Points& points, const Triangles& triangles, std::size_t most,
                                     const CancelToken& cancel = {});

/// For each point the first in exactly the same place.
std::vector<int> merged_by_place(const Points& points);

/// Finds the triangles near a box fast. Takes about 8 bytes a triangle.
class TriangleIndex {
 public:
  /// @param points, triangles  must outlive the index, and not change. @param left_out  triangles that are never found, ascending
  TriangleIndex(const Points& points, const Triangles& triangles, const std::vector<int>& left_out = {});
  ~TriangleIndex();
  TriangleIndex(TriangleIndex&&) noexcept;
  TriangleIndex& operator=(TriangleIndex&&) noexcept;
  /// Triangles whose bounding box meets the box; ascending. Safe to call from several threads.
  std::vector<int> near_box(const Vec3& low, const Vec3& high) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// Whether the segment from p to q meets a triangle that has no corner in the place of either.
/// @param index  of these points and triangles
bool runs_through(const Points& points, const Triangles& triangles, const TriangleIndex& index, const Vec3& p,
                  const Vec3& q);

}  // namespace loopmend
