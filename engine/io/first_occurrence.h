// SPDX-License-Identifier: GPL-3.0-or-later
// Finds things that were seen before: a hash table of indices, small and without an allocation per entry.
#pragma once

#include "core/types.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace loopmend {

/// @tparam Hash   std::uint64_t(int index)
/// @tparam Equal  bool(int index, int index)
template <class Hash, class Equal>
class FirstOccurrence {
 public:
  FirstOccurrence(Hash hash, Equal equal) : hash_(hash), equal_(equal), slots_(1024) {}

  /// The earlier index that equals `index`; or `index` itself, which is then remembered.
  int find_or_add(int index) {
    if (2 * (count_ + 1) > slots_.size()) grow();
    const auto hash = static_cast<std::uint32_t>(hash_(index));
    std::size_t at = hash & (slots_.size() - 1);
    for (; slots_[at].index >= 0; at = (at + 1) & (slots_.size() - 1)) {
      if (slots_[at].hash == hash && equal_(slots_[at].index, index)) return slots_[at].index;
    }
    slots_[at] = {hash, index};
    ++count_;
    return index;
  }

 private:
  /// The hash is kept beside the index: most comparisons, and growing, then need not look at the things themselves.
  struct Slot {
    std::uint32_t hash = 0;
    int index = -1;
  };

  void grow() {
    std::vector<Slot> old(4 * slots_.size());
    old.swap(slots_);
    for (const Slot& slot : old) {
      if (slot.index < 0) continue;
      std::size_t at = slot.hash & (slots_.size() - 1);
      while (slots_[at].index >= 0) at = (at + 1) & (slots_.size() - 1);
      slots_[at] = slot;
    }
  }

  Hash hash_;
  Equal equal_;
  std::vector<Slot> slots_;  // a power of two, at most half full
  std::size_t count_ = 0;
};

/// Spreads the bits of `value` over `seed`.
inline std::uint64_t mix_hash(std::uint64_t seed, std::uint64_t value) {
  std::uint64_t z = seed ^ (value + 0x9E3779B97F4A7C15ull + (seed << 6) + (seed >> 2));
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

/// Points at exactly the same place are equal.
struct PointHash {
  const Points* points;
  std::uint64_t operator()(int index) const {
    std::uint64_t hash = 0;
    // Adding 0.0 turns -0.0 into 0.0, which compares equal to it.
    for (const double x : (*points)[index]) {
      hash = mix_hash(hash, std::bit_cast<std::uint64_t>(x + 0.0));
    }
    return hash;
  }
};

struct PointEqual {
  const Points* points;
  bool operator()(int a, int b) const { return (*points)[a] == (*points)[b]; }
};

using FirstPoint = FirstOccurrence<PointHash, PointEqual>;

/// Refers to `points`, which may grow meanwhile.
inline FirstPoint first_point_table(const Points& points) {
  return FirstPoint(PointHash{&points}, PointEqual{&points});
}

}  // namespace loopmend
