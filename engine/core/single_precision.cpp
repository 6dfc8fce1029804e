// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/single_precision.h"

#include "core/threads.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <optional>
#include <string>

namespace loopmend {

double as_float(double value) {
  volatile float narrow = static_cast<float>(value);  // in a register, a pair of them would stay double
  return static_cast<double>(narrow);
}

Vec3 as_floats(const Vec3& point) { return {as_float(point.x()), as_float(point.y()), as_float(point.z())}; }

bool holds_as_floats(const Points& points) {
  return std::all_of(points.begin(), points.end(), [](const Vec3& p) { return as_floats(p) == p; });
}

namespace {

/// Of up to nine digits, by whole numbers. @returns nothing where that does not decide.
std::optional<bool> nine_digits_say_all(double value, double narrow) {
  static constexpr std::array powers{1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12};
  const int shift = 8 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  if (shift < 0 || shift >= static_cast<int>(powers.size())) return std::nullopt;
  const double power = powers[shift], number = std::round(value * power);
  constexpr double rounding = 1e-5;  // of what double precision makes of a number of nine digits, a few units of 1e-7
  if (std::abs(value * power - number) > rounding) return std::nullopt;  // more than nine
  double last = 1;                                                       // the unit of the last digit that is no zero
  for (auto digits = std::llabs(std::llround(number)); digits >= 10 && digits % 10 == 0; digits /= 10) last *= 10;
  const double off = std::abs(narrow * power - number);
  if (std::abs(off - last / 2) < rounding) return std::nullopt;
  return off < last / 2;
}

/// With so many digits behind the first; with none, as few as mean this double.
std::string scientific(double value, std::optional<int> fraction) {
  std::array<char, 400> text{};
  char* const begin = text.data();
  char* const room = begin + text.size();
  constexpr auto format = std::chars_format::scientific;
  const auto end =
      fraction ? std::to_chars(begin, room, value, format, *fraction) : std::to_chars(begin, room, value, format);
  return {begin, end.ptr};
}

}  // namespace

bool float_says_all(double value) {
  const double narrow = as_float(value);
  if (narrow == value) return true;
  if (!std::isfinite(narrow)) return false;
  if (const auto says_all = nine_digits_say_all(value, narrow)) return *says_all;
  const std::string digits = scientific(value, std::nullopt);
  const std::size_t exponent = digits.find('e'), point = std::min(digits.find('.'), exponent - 1);
  return digits == scientific(narrow, static_cast<int>(exponent - point - 1));
}

FloatRounding round_to_floats(Points& points) {
  std::atomic<std::size_t> longer{0};
  std::atomic<bool> in_range{true};
  const auto count = static_cast<int>(points.size());
  constexpr int grain = 1 << 12;
  parallel_for(0, (count + grain - 1) / grain, 1, [&](int block) {
    std::size_t longer_here = 0;
    for (int v = grain * block; v < std::min(grain * (block + 1), count); ++v) {
      const Vec3& p = points[v];
      if (!as_floats(p).allFinite()) in_range = false;
      longer_here += !float_says_all(p.x()) || !float_says_all(p.y()) || !float_says_all(p.z());
    }
    longer += longer_here;
  });
  if (in_range) std::for_each(points.begin(), points.end(), [](Vec3& p) { p = as_floats(p); });
  return {longer, in_range};
}

}  // namespace loopmend
