// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices without a finite place: a fault where a face uses them, an oddity of the exporter where none does.
#pragma once

#include "core/message.h"
#include "io/parse_errors.h"
#include "io/polygon_soup.h"

#include <cstdint>
#include <map>

namespace loopmend {

class LonePlaces {
 public:
  /// The point as it is, or the origin in place of one that is none. @param vertex  from 0. @param number  as the format counts. @param place  gives it
  Vec3 checked(const Vec3& point, int vertex, std::uint64_t number, const auto& place) {
    if (point.allFinite()) return point;
    places_.emplace(vertex, Place{number, place()});
    return Vec3::Zero();
  }

  /// When all faces are there. @throws ReadError where one of them uses such a vertex
  void finish(PolygonSoup& soup, const ParseErrors& errors) const {
    if (places_.empty()) return;
    for (const int v : soup.corners)
      if (const auto found = places_.find(v); found != places_.end())
        errors.not_finite(found->second.number, found->second.place);
    count_not_kept(soup.oddities, say("vertices without a place that no face uses, now at the origin"), places_.size());
  }

 private:
  struct Place {
    std::uint64_t number;
    Message place;
  };
  std::map<int, Place> places_;
};

}  // namespace loopmend
