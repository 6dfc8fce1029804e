// SPDX-License-Identifier: GPL-3.0-or-later
// Many small patches drawn as one surface: thousands of actors would take longer to draw than the scan itself.
#pragma once

#include "scene/surface_actor.h"

#include <map>

namespace loopmend {

class PatchBatch {
 public:
  explicit PatchBatch(vtkLookupTable* table) : surface_(SurfaceActor::Role::patch, table) {}

  using Shapes = std::map<int, SurfaceShapePtr>;
  /// Joins them again where they are others than before.
  void show(const Shapes& shapes);
  SurfaceActor& surface() { return surface_; }

 private:
  Shapes shown_;
  SurfaceActor surface_;
};

}  // namespace loopmend
