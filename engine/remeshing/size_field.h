// SPDX-License-Identifier: GPL-3.0-or-later
// Target edge length over a patch: that of its boundary, interpolated by inverse distance, by the density.
#pragma once

#include "mesh/patch.h"

#include <memory>
#include <vector>

namespace loopmend {

/// boundary_size(p) = Σ w_k size_k / Σ w_k with w_k = (|p − place_k|² + (0.1 h)²)⁻², h the mean size
/// (docs/dev/filling.md, "Size field"); the target is boundary_size(p) / density. Where that is finer than the boundary, whose edges stay as they are, it is reached gradually: a long
/// boundary edge with many short ones at its side would make slivers.
class SizeField {
 public:
  /// @param places   boundary vertices, at least one; long boundaries are thinned to some 256 for the interpolation.
  /// @param sizes    edge length at each, same unit as the places.
  SizeField(const Points& places, const std::vector<double>& sizes, const Grading& grading);
  ~SizeField();
  SizeField(SizeField&&) noexcept;
  SizeField& operator=(SizeField&&) noexcept;
  double at(const Vec3& p) const;

 private:
  struct Boundary;
  Points place_;
  std::vector<double> size_;
  double floor_ = 0;
  Grading grading_;
  std::unique_ptr<Boundary> boundary_;
};

}  // namespace loopmend
