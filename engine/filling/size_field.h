// Target edge length over a patch: that of its rim, interpolated by inverse distance.
#pragma once

#include "core/types.h"

#include <vector>

namespace loopmend {

/// size(p) = Σ w_k size_k / Σ w_k with w_k = (|p − place_k|² + (0.1 h)²)⁻², h the mean size (FILLING.md, step 3).
class SizeField {
 public:
  /// @param places  rim vertices, at least one; long rims are thinned to some 256.
  /// @param sizes   edge length at each, same unit as the places.
  SizeField(const Points& places, const std::vector<double>& sizes);
  double at(const Vec3& p) const;

 private:
  Points place_;
  std::vector<double> size_;
  double floor_ = 0;
};

}  // namespace loopmend
