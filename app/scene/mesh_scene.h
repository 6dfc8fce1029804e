// SPDX-License-Identifier: GPL-3.0-or-later
// Everything that is drawn in the view: the scan, the patches, the loops, the legend. One renderer, no window.
#pragma once

#include "scene/clipping.h"
#include "scene/color_map.h"
#include "scene/legend.h"
#include "scene/loop_lines.h"
#include "scene/shading.h"
#include "scene/shape_glide.h"
#include "scene/surface_shape.h"

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <vector>

class vtkRenderer;

namespace loopmend {

class MeshScene {
 public:
  enum class Background { light, dark };

  MeshScene();
  ~MeshScene();
  vtkRenderer* renderer() const;

  void clear();
  /// @param parts  what the scan is drawn by in its own colours, where those of the shape do not say it all
  void set_scan(int index, SurfaceShapePtr shape, const std::vector<SurfaceShapePtr>& parts = {});
  /// Every scan whose index is not in `indices` goes.
  void keep_scans(const std::vector<int>& indices);
  /// Adds the patch of this scan, or shows its new state.
  void set_patch(int id, int scan, SurfaceShapePtr shape, Arrival arrival = Arrival::at_once);
  /// A flow begins on this patch: another state of it is on its way.
  void expect_news(int id);
  /// Every patch whose id is not in `ids` goes.
  void keep_patches(const std::vector<int>& ids);
  /// Patches that are only thought of: plain, with their edges.
  void set_ghosts(const std::vector<SurfaceShapePtr>& shapes);
  /// Painted over what it lies on; null: nothing.
  void set_marked(SurfaceShapePtr shape);
  void set_loops(const std::vector<LoopLine>& loops);
  /// Draws a scan elsewhere while its part is being moved, without touching its arrays.
  void place_scan(int index, const Eigen::Matrix4d& placement);
  /// How scans of more than some 200 000 triangles are drawn.
  enum class LargeScans {
    whole,             ///< in every picture
    reduced_at_first,  ///< their reduced versions, until the whole is ready: see is_rough()
  };
  void set_large_scans(LargeScans way);
  /// What the eye does: while it moves, no picture works at whole versions of large scans.
  enum class Eye { rests, moves };
  /// To be called before drawing: puts into actors what has changed, and moves on what is on its way to a new state.
  /// @returns whether the next picture will be another one.
  bool update(Eye eye = Eye::rests);
  /// Whether the last picture has reduced versions in it, or surfaces as they were before: some more pictures are to be drawn.
  bool is_rough() const;
  /// Everything is where it is going, and large scans are ready; for pictures that are kept.
  void arrive();
  /// Fits the camera's depths to what is there. They stay as they are while they do: what stands still is then not
  /// drawn again.
  void fit_depths();

  /// How often the scans were kept as a picture, to draw patches over them; for tests.
  int still_drawn() const;

  void set_shading(Shading shading);
  void set_edges(Edges edges);
  void set_seams(Seams seams);
  void set_tint(Tint tint);
  /// Cuts the surfaces open. Boundaries and seams stay whole, and are picked as before.
  void set_clipping(const std::optional<ClippingPlane>& plane);
  /// How many stripes zebra and isophotes have; 3..40.
  void set_stripes(int count);
  void set_color_map(ColorMap map);
  /// Colours run over [−half_width, half_width], in 1/length for H, 1/length² for K; so does the legend.
  /// @param own  half-widths of scans, with their patches, whose colours run over another range
  void set_range(double half_width, const std::map<int, double>& own = {});
  double range() const;
  double range_of(int scan) const;

  void set_legend_words(const LegendWords& words);
  void set_legend(LegendPlace place);
  /// The first pictures with a legend have some of it each, until arrive() or all of it is there.
  void spread_first_legend();
  /// Where the legend is with LegendPlace::beside: to be given a viewport of its own in the same window.
  vtkRenderer* legend_renderer() const;
  /// What the legend covers, in pixels from the lower left corner; nothing where there is none.
  std::vector<Eigen::AlignedBox2d> legend_boxes() const;
  void set_background(Background background);
  /// Whether the background is drawn at all.
  enum class Ground { shown, transparent };
  void set_ground(Ground ground);
  void set_pixel_ratio(double device_pixels_per_logical);
  /// Of the renderer that holds the legend, device pixels.
  void set_size(int width, int height);
  /// Device pixels at the top that something lies over: the legend is below.
  void set_covered(int height);

  /// Points of all scans and patches, three coordinates each: all of them or, of very many, every so manieth.
  std::vector<float> sample_points() const;
  /// Of everything drawn, in the scene's frame: x0 x1 y0 y1 z0 z1.
  std::array<double, 6> bounds() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace loopmend
