// SPDX-License-Identifier: GPL-3.0-or-later
// Random numbers whose bits are the same on every platform (PCG-XSH-RR 64/32, O'Neill 2014). The standard's engines are
// portable, its distributions are not.
#pragma once

#include <cstdint>

namespace loopmend {

class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed + increment) { next(); }

  /// Uniform over all 32-bit values.
  std::uint32_t next() {
    const std::uint64_t old = state_;
    state_ = old * 6364136223846793005ULL + increment;
    const auto mixed = static_cast<std::uint32_t>(((old >> 18U) ^ old) >> 27U);
    const auto turn = static_cast<std::uint32_t>(old >> 59U);
    return (mixed >> turn) | (mixed << ((32U - turn) & 31U));
  }

  /// Uniform in [0, 1), a multiple of 2⁻³².
  double uniform() { return next() * 0x1p-32; }
  /// Uniform in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Mean 0, variance 1, |x| < 3.5: the sum of four uniform numbers, close enough to a measuring error.
  double bell() {
    double sum = -2;
    for (int i = 0; i < 4; ++i) sum += uniform();
    return sum * 1.7320508075688772;
  }

 private:
  static constexpr std::uint64_t increment = 1442695040888963407ULL;
  std::uint64_t state_;
};

}  // namespace loopmend
