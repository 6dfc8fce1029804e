// SPDX-License-Identifier: GPL-3.0-or-later
// On the way from one accepted state of a surface to the next: pictures come evenly, although states do not.
// Only what is drawn lies between states; every number that a person reads is that of an accepted one.
#pragma once

#include "scene/surface_shape.h"

#include <chrono>

namespace loopmend {

/// How a surface comes to a new state.
enum class Arrival {
  at_once,
  soon,           ///< within a moment: it is the last for now
  with_the_next,  ///< in about the time that the next state will take to come
};

class ShapeGlide {
 public:
  using Clock = std::chrono::steady_clock;

  /// Whether both are states of one surface, vertex by vertex.
  static bool is_possible(const SurfaceShape& from, const SurfaceShape& to);

  /// @param from  is_possible() with `to`; not needed any more afterwards.
  ShapeGlide(const SurfaceShape& from, SurfaceShapePtr to, Clock::time_point now, Clock::duration time);

  /// Goes to where the surface is at this time.
  void advance(Clock::time_point now);
  bool has_arrived(Clock::time_point now) const { return now >= end_; }
  /// Be there at this time, if not earlier.
  void hurry(Clock::time_point now, Clock::time_point end);

  /// Without triangles. The arrays stay where they are in memory.
  const SurfaceShape& shown() const { return shown_; }
  const SurfaceShapePtr& goal() const { return to_; }

 private:
  void start_from_shown(Clock::time_point now, Clock::time_point end);

  SurfaceShape from_, shown_;
  SurfaceShapePtr to_;
  Clock::time_point begin_, end_;
};

}  // namespace loopmend
