// SPDX-License-Identifier: GPL-3.0-or-later
#include "tube_sets.h"

#include "core/random.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace loopmend::bench {

namespace {

constexpr double least_room = 0.15;  ///< radians between the boundaries of two tubes, as seen from the origin

double half_width(const TubeShape& tube) { return std::atan2(tube.radius, tube.start.norm()); }

/// The tubes run straight outwards: where their boundaries are apart, so are they.
bool has_room(const std::vector<TubeShape>& tubes, const TubeShape& next) {
  return std::all_of(tubes.begin(), tubes.end(), [&](const TubeShape& tube) {
    const double angle = std::acos(std::clamp(tube.direction.dot(next.direction), -1.0, 1.0));
    return angle > half_width(tube) + half_width(next) + least_room;
  });
}

Vec3 random_direction(Random& random) {
  Vec3 d;
  do {
    for (double& x : d) x = random.uniform(-1, 1);
  } while (d.norm() > 1 || d.norm() < 0.1);
  return d.normalized();
}

Vec3 random_axis(Random& random) {
  Vec3 d = Vec3::Zero();
  d[static_cast<int>(random.next() % 3)] = random.next() % 2 == 0 ? 1 : -1;
  return d;
}

}  // namespace

TubeSet make_tube_set(std::uint64_t seed, int finer) {
  constexpr std::array<std::size_t, 4> counts{2, 3, 4, 6};
  const std::size_t count = counts[seed % 4];
  const bool right = seed / 4 % 2 == 0, equal = seed / 8 % 2 == 0;
  TubeSet set{{}, right ? "right" : "odd", equal ? "equal" : "unequal"};
  Random random(seed);
  const double shared_radius = random.uniform(0.4, 0.8), shared_distance = random.uniform(1.2, 2.2);
  int tries = 0;
  while (set.tubes.size() < count) {
    if (++tries > 500) {  // no room left for the next one: begin again
      tries = 0;
      set.tubes.clear();
    }
    TubeShape tube;
    tube.direction = right ? random_axis(random) : random_direction(random);
    tube.radius = equal ? shared_radius : random.uniform(0.4, 0.8);
    const double distance = equal ? shared_distance : random.uniform(1.2, 2.2);
    tube.start = distance * tube.direction;
    tube.length = 2;
    tube.around = finer * (equal ? 24 : 16 + static_cast<int>(random.next() % 25));
    if (has_room(set.tubes, tube)) set.tubes.push_back(tube);
  }
  return set;
}

}  // namespace loopmend::bench
