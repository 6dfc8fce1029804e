// SPDX-License-Identifier: GPL-3.0-or-later
// Small pictures of patches in their neighborhood, drawn without a widget on the window's thread.
#pragma once

#include "scene/look.h"
#include "scene/surface_shape.h"
#include "views/camera_flight.h"

#include <QImage>

#include <memory>
#include <vector>

namespace loopmend {

class CandidatePictures {
 public:
  CandidatePictures();
  ~CandidatePictures();

  /// What all of the pictures have in common.
  struct Setting {
    SurfaceShapePtr neighborhood;
    std::vector<std::vector<float>> loops;  ///< lines, 3 × #V each, in the scene's frame
    Look look;
    double half_width = 1;  ///< of the colour range, in force instead of the look's own
    CameraPose eye;         ///< the direction in which it looks; it stands where the loops fill the picture
    bool dark = false;      ///< ground
  };
  void set(const Setting& setting);
  /// @param size  device pixels. @param ratio  of these to logical ones
  /// @returns a null picture where the graphics cannot draw.
  QImage draw(const std::vector<SurfaceShapePtr>& patches, const QSize& size, double ratio);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace loopmend
