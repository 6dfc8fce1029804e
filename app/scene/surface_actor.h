// SPDX-License-Identifier: GPL-3.0-or-later
// One surface in the scene, the scan or a patch: arrays in, an actor with our own lighting out.
#pragma once

#include "scene/color_map.h"
#include "scene/shading.h"
#include "scene/shape_glide.h"
#include "scene/surface_shape.h"

#include <vtkNew.h>

#include <memory>
#include <optional>

class vtkActor;
class vtkFloatArray;
class vtkLookupTable;
class vtkPlane;
class vtkPolyData;
class vtkRenderer;

namespace loopmend {

class SendingMapper;

/// Of a patch where nothing else colours it.
inline constexpr Rgb patch_color{0.50, 0.74, 0.70};

class SurfaceActor {
 public:
  enum class Role { scan, patch };

  SurfaceActor(Role role, vtkLookupTable* table);
  ~SurfaceActor();

  using Clock = ShapeGlide::Clock;

  /// Draws another surface, or another state of the same one.
  void set_shape(SurfaceShapePtr shape) { set_shape(std::move(shape), Arrival::at_once, {}); }
  void set_shape(SurfaceShapePtr shape, Arrival arrival, Clock::time_point now);
  /// From now on another state of the surface is being worked at: the first one will take as long to be reached as it took
  /// to come.
  void expect_news(Clock::time_point now) { last_news_ = now; }
  /// Moves on towards the shape that was set last. @returns whether it is still on its way.
  bool advance(Clock::time_point now);
  void set_shading(Shading shading);
  void set_edges(Edges edges);
  /// Does nothing to a scan.
  void set_tint(Tint tint);
  /// What lies before the plane is not drawn; null: everything is.
  void set_clipping(vtkPlane* plane);
  /// How many stripes zebra and isophotes have; 3..40.
  void set_stripes(int count);
  /// Device pixels per logical pixel.
  void set_pixel_ratio(double ratio);
  void set_table(vtkLookupTable* table);
  /// To be called after the table's range changed.
  void recolor();
  /// The pictures of the two are the same one in the graphics, where they have the same.
  void share_texture(const SurfaceActor& other);
  /// Gives the graphics what they do not have yet, so that the next picture need not; does nothing before their first picture.
  void send(vtkRenderer* renderer);

  vtkActor* actor() const;
  /// Where it is, or is going.
  const SurfaceShape* shape() const { return shape_.get(); }

 private:
  void show(SurfaceShapePtr shape);
  void glide(SurfaceShapePtr shape, Arrival arrival, Clock::time_point now);
  void choose_program();
  void update_tint();
  void update_triangles();
  void update_scalars();
  void update_texture();

  Role role_;
  Shading shading_ = Shading::curvature;
  Tint tint_ = Tint::none;
  float pixel_ratio_ = 1;
  SurfaceShapePtr shape_, triangles_of_;
  std::shared_ptr<const Picture> picture_;  ///< of the actor's texture
  std::unique_ptr<ShapeGlide> glide_;
  std::optional<Clock::time_point> last_news_;
  vtkNew<vtkPolyData> data_;
  vtkNew<SendingMapper> mapper_;
  vtkNew<vtkActor> actor_;
};

}  // namespace loopmend
