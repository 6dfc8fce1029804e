// SPDX-License-Identifier: GPL-3.0-or-later
// The scans as they are drawn: without the pieces that are hidden.
#pragma once

#include "document/scene_visibility.h"

#include <map>

namespace loopmend {

class ShownShapes {
 public:
  using ShapePtr = SurfaceShapePtr;
  struct Shown {
    ShapePtr whole;               ///< null: all of it is hidden
    std::vector<ShapePtr> parts;  ///< in the scan's own colours
  };
  /// Rebuilt only when the scan's shape or its hidden components change.
  const Shown& of(const Document& document, const SceneVisibility& visibility, int scan);

 private:
  struct Entry {
    ShapePtr source;
    std::vector<char> hidden;  ///< by piece
    Shown shown;
  };
  std::map<int, Entry> entries_;
};

}  // namespace loopmend
