// Everything that is drawn in the view: the scan, the patches, the loops, the legend. One renderer, no window.
#pragma once

#include "scene/loop_lines.h"
#include "scene/shading.h"
#include "scene/surface_shape.h"

#include <array>
#include <memory>

class vtkRenderer;

namespace loopmend {

class MeshScene {
 public:
  enum class Background { light, dark };

  MeshScene();
  ~MeshScene();
  vtkRenderer* renderer() const;

  void clear();
  void set_surface(std::shared_ptr<const SurfaceShape> shape);
  /// Adds the patch, or shows its new state.
  void set_patch(int id, std::shared_ptr<const SurfaceShape> shape);
  /// Every patch whose id is not in `ids` goes.
  void keep_patches(const std::vector<int>& ids);
  void set_loops(const std::vector<LoopLine>& loops);

  void set_shading(Shading shading);
  void set_edges(Edges edges);
  /// Colours run over [−half_width, half_width], in 1/length.
  void set_range(double half_width);
  double range() const;

  /// For a scene beside another one that shows the same legend.
  void hide_legend();
  void set_background(Background background);
  void set_pixel_ratio(double device_pixels_per_logical);
  /// Device pixels. Places the legend.
  void set_size(int width, int height);

  /// Of everything drawn, in the scene's frame: x0 x1 y0 y1 z0 z1.
  std::array<double, 6> bounds() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace loopmend
