// SPDX-License-Identifier: GPL-3.0-or-later
// Distances to a triangle mesh.
#pragma once

#include "mesh/triangle_soup.h"

#include <memory>

namespace loopmend::bench {

/// Copies share one tree. Safe to ask from several threads.
class TruthMesh {
 public:
  explicit TruthMesh(const TriangleSoup& soup);
  double distance(const Vec3& p) const;

 private:
  struct Impl;
  std::shared_ptr<const Impl> impl_;
};

}  // namespace loopmend::bench
