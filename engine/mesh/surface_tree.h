// SPDX-License-Identifier: GPL-3.0-or-later
// The point of a surface that is closest to a given one (CGAL's AABB tree).
#pragma once

#include "core/types.h"

#include <memory>

namespace loopmend {

struct SurfacePoint {
  Vec3 place = Vec3::Zero();
  int triangle = -1;
};

/// Any triangles. Keeps a copy of what it needs; about 200 bytes a triangle.
class SurfaceTree {
 public:
  /// @param triangles  those without area are left out.
  SurfaceTree(const Points& points, const Triangles& triangles);
  ~SurfaceTree();
  SurfaceTree(SurfaceTree&&) noexcept;
  SurfaceTree& operator=(SurfaceTree&&) noexcept;
  /// Safe to call from several threads; the same bits for the same triangles in the same order. No triangle (-1) and p itself where
  /// there is none.
  SurfacePoint closest(const Vec3& p) const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace loopmend
