// SPDX-License-Identifier: GPL-3.0-or-later
// A scan as it is drawn: a large one by its reduced version, and in slices, which go to the graphics one after another, so that
// the window answers in between.
#pragma once

#include "scene/cached_background.h"
#include "scene/surface_actor.h"

#include <vtkSmartPointer.h>

#include <deque>
#include <functional>
#include <memory>
#include <utility>
#include <vector>

class vtkMatrix4x4;

namespace loopmend {

class ScanDrawing {
 public:
  using ShapePtr = SurfaceShapePtr;
  using Shapes = std::vector<ShapePtr>;
  /// @param make  an actor that looks as those of the scene do
  ScanDrawing(CachedBackground* renderer, std::function<std::unique_ptr<SurfaceActor>()> make);
  ~ScanDrawing();
  ScanDrawing(const ScanDrawing&) = delete;
  ScanDrawing& operator=(const ScanDrawing&) = delete;

  /// From now on these are to be drawn: reduced versions at once, large surfaces when they are ready.
  void show(const Shapes& shapes);
  /// Whether reduced versions have come since this was last asked.
  bool is_new() { return std::exchange(new_, false); }
  /// Sends one slice to the graphics, where they are at work already. @returns whether there is more to send
  bool send_one();
  /// All is ready: the graphics take what they do not have yet with the next picture.
  void finish();
  void place(vtkMatrix4x4* placement);
  /// To be called for each change of how the surface looks.
  void each_actor(const std::function<void(SurfaceActor&)>& change);

 private:
  using Actors = std::vector<std::unique_ptr<SurfaceActor>>;
  /// Triangles `begin` to `end` of a surface.
  struct Slice {
    ShapePtr shape;
    std::size_t begin = 0, end = 0;
  };
  std::unique_ptr<SurfaceActor> make(ShapePtr shape, const Actors& others);
  void make_next();
  void add(const SurfaceActor& actor, CachedBackground::Part part);
  void drop(Actors& actors);
  void forget_coming();

  CachedBackground* renderer_;
  std::function<std::unique_ptr<SurfaceActor>()> make_;
  Shapes shapes_;
  Actors reduced_, drawn_, coming_;
  std::deque<Slice> to_make_;  ///< without an actor
  std::vector<int> number_;    ///< for with_triangles()
  std::size_t sent_ = 0;       ///< of those drawn, how many the graphics have as they are
  bool new_ = false;           ///< see is_new()
  bool changing_ = false;      ///< those that come are not drawn yet
  vtkSmartPointer<vtkMatrix4x4> placement_;
};

}  // namespace loopmend
