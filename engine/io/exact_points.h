// Which points stand at exactly the same place.
#pragma once

#include "core/types.h"
#include "io/first_occurrence.h"

#include <bit>

namespace loopmend {

struct PointHash {
  const Points* points;
  std::uint64_t operator()(int index) const {
    std::uint64_t hash = 0;
    // Adding 0.0 turns -0.0 into 0.0, which compares equal to it.
    for (const double x : (*points)[static_cast<std::size_t>(index)]) {
      hash = mix_hash(hash, std::bit_cast<std::uint64_t>(x + 0.0));
    }
    return hash;
  }
};

struct PointEqual {
  const Points* points;
  bool operator()(int a, int b) const {
    return (*points)[static_cast<std::size_t>(a)] == (*points)[static_cast<std::size_t>(b)];
  }
};

using FirstPoint = FirstOccurrence<PointHash, PointEqual>;

/// Refers to `points`, which may grow meanwhile.
inline FirstPoint first_point_table(const Points& points) {
  return FirstPoint(PointHash{&points}, PointEqual{&points});
}

}  // namespace loopmend
