// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/opened_scan.h"

#include <bit>

namespace loopmend {

std::uint64_t fingerprint_of(const TriangleSoup& soup) {
  std::uint64_t hash = 0xCBF29CE484222325ull;  // FNV-1a, a word at a time
  const auto mix = [&hash](std::uint64_t word) { hash = (hash ^ word) * 0x100000001B3ull; };
  mix(soup.points.size());
  for (const Vec3& p : soup.points)
    for (double x : p) mix(std::bit_cast<std::uint64_t>(x));
  mix(soup.triangles.size());
  for (const Triangle& t : soup.triangles)
    for (int v : t) mix(static_cast<std::uint64_t>(v));
  return hash;
}

}  // namespace loopmend
