// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/mesh_scene.h"

#include "scene/cached_background.h"
#include "scene/color_table.h"
#include "scene/patch_batch.h"
#include "scene/scan_drawing.h"
#include "scene/surface_actor.h"

#include <vtkActor.h>
#include <vtkCamera.h>
#include <vtkLookupTable.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPlane.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>
#include <utility>

namespace loopmend {

namespace {

// Above this number, small patches share one actor: each actor costs a draw call, and its first one a shader.
constexpr std::size_t most_single_patches = 12;
constexpr std::size_t small_patch_points = 6000;

using ShapePtr = SurfaceShapePtr;

}  // namespace

struct MeshScene::Impl {
  vtkNew<CachedBackground> renderer;
  vtkNew<vtkRenderer> legend_renderer;
  vtkSmartPointer<vtkLookupTable> table = make_diverging_table();  ///< of the legend
  std::map<int, vtkSmartPointer<vtkLookupTable>> tables;           ///< by scan
  std::map<int, double> own_ranges;                                ///< by scan, where it is not the legend's
  ColorMap map = ColorMap::blue_orange;
  struct Scan {
    ShapePtr shape;
    std::vector<ShapePtr> parts;
    std::unique_ptr<ScanDrawing> drawing;
  };
  std::map<int, Scan> scans;
  struct PatchGoal {
    ShapePtr shape;
    Arrival arrival = Arrival::at_once;
    int scan = 0;
  };
  std::map<int, PatchGoal> patch_shapes;
  std::map<int, std::unique_ptr<SurfaceActor>> patches;
  std::map<int, PatchBatch> batches;  ///< by scan
  PatchBatch ghosts{table}, marked{table};
  LoopLines loops;
  Legend legend{table};
  LegendPlace legend_place = LegendPlace::over_the_picture;
  Shading shading = Shading::curvature;
  Edges edges = Edges::hidden;
  Tint tint = Tint::none;
  int stripes = 9;
  double pixel_ratio = 1;
  vtkSmartPointer<vtkPlane> clipping;  ///< null: nothing is clipped
  int width = 1, height = 1, covered = 0;
  bool patches_changed = false, moving = false;
  LargeScans large_scans = LargeScans::whole;
  bool sending = false;                ///< large scans are on their way to the graphics
  std::array<double, 6> depths_for{};  ///< the box that the camera's depths were fitted to
  vtkMTimeType depths_seen = 0;        ///< the camera's, then

  void each_surface(const auto& act) {
    for (auto& [index, scan] : scans) scan.drawing->each_actor(act);
    for (auto& [id, patch] : patches) act(*patch);
    for (auto& [scan, batch] : batches) act(batch.surface());
  }
  double range_of(int scan) const {
    const auto own = own_ranges.find(scan);
    return own == own_ranges.end() ? table->GetRange()[1] : own->second;
  }
  vtkLookupTable* table_of(int scan) {
    auto& of_scan = tables[scan];
    if (!of_scan) {
      of_scan = make_diverging_table();
      paint(of_scan, range_of(scan));
    }
    return of_scan;
  }
  void paint(vtkLookupTable* one, double half_width) const {
    paint_table(one, map, begins_at_zero(shading) ? TableEnds::from_zero : TableEnds::both_signs, half_width);
  }
  void paint_tables(double half_width) {
    paint(table, half_width);
    for (auto& [scan, own] : tables) paint(own, range_of(scan));
    each_surface([](SurfaceActor& surface) { surface.recolor(); });
    update_legend();
  }
  void prepare(SurfaceActor& surface) {
    surface.set_shading(shading);
    surface.set_edges(edges);
    surface.set_tint(tint);
    surface.set_pixel_ratio(pixel_ratio);
    surface.set_stripes(stripes);
    surface.set_clipping(clipping);
  }
  std::unique_ptr<SurfaceActor> make(SurfaceActor::Role role, int scan) {
    auto made = std::make_unique<SurfaceActor>(role, table_of(scan));
    prepare(*made);
    return made;
  }
  PatchBatch& batch_of(int scan) {
    const auto [at, is_new] = batches.try_emplace(scan, table_of(scan));
    if (is_new) {
      prepare(at->second.surface());
      renderer->AddActor(at->second.surface().actor());
    }
    return at->second;
  }
  /// In its own colours a scan is drawn by its parts, else as a whole.
  void choose_shapes(Scan& scan) {
    const bool by_parts = shading == Shading::scan && !scan.parts.empty();
    scan.drawing->show(by_parts ? scan.parts : std::vector<ShapePtr>{scan.shape});
  }
  bool colored() const {
    const auto known = [this](const SurfaceShape* shape) { return shape && !values_of(*shape, shading).empty(); };
    return is_colored(shading) &&
           (std::any_of(scans.begin(), scans.end(), [&](const auto& scan) { return known(scan.second.shape.get()); }) ||
            std::any_of(patch_shapes.begin(), patch_shapes.end(),
                        [&](const auto& patch) { return known(patch.second.shape.get()); }));
  }
  bool wants_legend() const { return legend_place != LegendPlace::none && colored(); }
  void update_legend() {
    if (wants_legend()) {
      legend.lay_out(width, height - covered);
      legend.show();
    } else {
      legend.hide();
    }
  }
  /// For a moment only, where large scans may be reduced meanwhile.
  void send_scans() {
    constexpr std::chrono::milliseconds a_moment{20};
    const auto end = SurfaceActor::Clock::now() + a_moment;
    sending = false;
    for (auto& [index, scan] : scans) {
      if (large_scans == LargeScans::whole) {
        scan.drawing->finish();
        continue;
      }
      // A picture that is the first with a reduced version is late enough.
      sending = sending || scan.drawing->is_new();
      while (!sending && scan.drawing->send_one()) sending = SurfaceActor::Clock::now() >= end;
    }
  }
  void distribute_patches(SurfaceActor::Clock::time_point now) {
    std::map<int, PatchBatch::Shapes> together;  // by scan
    std::set<int> single;
    const bool many = patch_shapes.size() > most_single_patches;
    for (const auto& [id, goal] : patch_shapes) {
      const ShapePtr& shape = goal.shape;
      if (many && shape->points.size() / 3 <= small_patch_points) {
        together[goal.scan].emplace(id, shape);
        continue;
      }
      single.insert(id);
      auto& patch = patches[id];
      if (!patch) {
        patch = make(SurfaceActor::Role::patch, goal.scan);
        renderer->AddActor(patch->actor());
      }
      patch->set_table(table_of(goal.scan));
      patch->set_shape(shape, goal.arrival, now);
    }
    std::erase_if(patches, [&](const auto& entry) {
      if (single.contains(entry.first)) return false;
      renderer->RemoveActor(entry.second->actor());
      return true;
    });
    for (auto& [scan, shapes] : together) batch_of(scan);
    for (auto& [scan, batch] : batches) batch.show(together[scan]);
  }
};

MeshScene::MeshScene() : impl_(std::make_unique<Impl>()) {
  for (PatchBatch* batch : {&impl_->ghosts, &impl_->marked}) {
    batch->surface().actor()->VisibilityOff();
    impl_->renderer->AddActor(batch->surface().actor());
  }
  impl_->ghosts.surface().set_shading(Shading::plain);
  impl_->ghosts.surface().set_edges(Edges::shown);
  impl_->marked.surface().set_shading(Shading::scan);  // its own colours, where it has some
  impl_->loops.add_to(impl_->renderer);
  for (vtkActor* line : impl_->loops.actors()) impl_->renderer->add_still(line, CachedBackground::Part::line);
  impl_->legend.add_to(impl_->renderer);
  impl_->legend.hide();
  set_background(Background::light);
}

MeshScene::~MeshScene() = default;

vtkRenderer* MeshScene::renderer() const { return impl_->renderer; }

void MeshScene::clear() {
  keep_scans({});
  keep_patches({});
  set_ghosts({});
  set_loops({});
  update();
}

void MeshScene::set_scan(int index, ShapePtr shape, const std::vector<ShapePtr>& parts) {
  Impl::Scan& scan = impl_->scans[index];
  if (!scan.drawing)
    scan.drawing = std::make_unique<ScanDrawing>(
        impl_->renderer, [impl = impl_.get(), index] { return impl->make(SurfaceActor::Role::scan, index); });
  scan.shape = std::move(shape);
  scan.parts = parts;
  impl_->choose_shapes(scan);
  impl_->update_legend();
}

void MeshScene::keep_scans(const std::vector<int>& indices) {
  std::erase_if(impl_->scans, [&](const auto& entry) {
    return std::find(indices.begin(), indices.end(), entry.first) == indices.end();
  });
  impl_->update_legend();
}

void MeshScene::place_scan(int index, const Eigen::Matrix4d& placement) {
  const auto scan = impl_->scans.find(index);
  if (scan == impl_->scans.end()) return;
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 4; ++column) matrix->SetElement(row, column, placement(row, column));
  scan->second.drawing->place(placement.isIdentity() ? nullptr : matrix.Get());
  impl_->renderer->still_changed();
}

void MeshScene::set_patch(int id, int scan, ShapePtr shape, Arrival arrival) {
  impl_->patch_shapes[id] = {std::move(shape), arrival, scan};
  impl_->patches_changed = true;
}

void MeshScene::expect_news(int id) {
  const auto patch = impl_->patches.find(id);
  if (patch != impl_->patches.end()) patch->second->expect_news(SurfaceActor::Clock::now());
}

void MeshScene::keep_patches(const std::vector<int>& ids) {
  const std::set<int> kept(ids.begin(), ids.end());
  std::erase_if(impl_->patch_shapes, [&](const auto& entry) { return !kept.contains(entry.first); });
  impl_->patches_changed = true;
}

void MeshScene::set_large_scans(LargeScans way) {
  impl_->large_scans = way;
  impl_->renderer->set_large_scans(way == LargeScans::whole ? CachedBackground::LargeScans::whole
                                                            : CachedBackground::LargeScans::reduced_at_first);
}

bool MeshScene::is_rough() const { return impl_->sending || impl_->renderer->is_rough(); }

bool MeshScene::update(Eye eye) {
  impl_->send_scans();
  using Whole = CachedBackground::Whole;
  const Whole at_rest = eye == Eye::moves ? Whole::later : Whole::wanted;
  impl_->renderer->set_whole(impl_->sending ? Whole::not_ready : at_rest);
  const auto now = SurfaceActor::Clock::now();
  const bool changed = std::exchange(impl_->patches_changed, false);
  if (changed) {
    impl_->distribute_patches(now);
    if (impl_->wants_legend() != impl_->legend.is_shown()) impl_->update_legend();
  }
  impl_->moving = false;
  for (auto& [id, patch] : impl_->patches) impl_->moving = patch->advance(now) || impl_->moving;
  using Keep = CachedBackground::Keep;
  impl_->renderer->set_keep(impl_->moving ? Keep::always : Keep::while_camera_rests);
  return impl_->legend.grow() || impl_->moving;
}

void MeshScene::arrive() {
  for (auto& [id, goal] : impl_->patch_shapes) goal.arrival = Arrival::at_once;
  impl_->patches_changed = true;
  for (auto& [index, scan] : impl_->scans) scan.drawing->finish();
  impl_->legend.grow_up();
  update();
}

void MeshScene::fit_depths() {
  vtkCamera* camera = impl_->renderer->GetActiveCamera();
  std::array<double, 6>& box = impl_->depths_for;
  const std::array<double, 6> now = bounds();
  const bool fits = now[0] >= box[0] && now[1] <= box[1] && now[2] >= box[2] && now[3] <= box[3] && now[4] >= box[4] &&
                    now[5] <= box[5];
  const auto size = [](const std::array<double, 6>& b) { return Vec3(b[1] - b[0], b[3] - b[2], b[5] - b[4]).norm(); };
  constexpr double too_large = 1.5;  // depths are finer in a box that fits
  if (fits && size(box) < too_large * size(now) && camera->GetMTime() == impl_->depths_seen) return;
  constexpr double slack = 0.05;  // of the box, for what moves out of it: other depths are another view
  for (std::size_t k = 0; k < 6; k += 2) {
    const double more = slack * (now[k + 1] - now[k]);
    box[k] = now[k] - more;
    box[k + 1] = now[k + 1] + more;
  }
  if (box[0] <= box[1]) impl_->renderer->ResetCameraClippingRange(box.data());
  impl_->depths_seen = camera->GetMTime();
}

int MeshScene::still_drawn() const { return impl_->renderer->still_drawn(); }

void MeshScene::set_ghosts(const std::vector<ShapePtr>& shapes) {
  PatchBatch::Shapes numbered;
  for (const ShapePtr& shape : shapes) numbered.emplace(static_cast<int>(numbered.size()), shape);
  impl_->ghosts.show(numbered);
}

void MeshScene::set_marked(ShapePtr shape) {
  impl_->marked.show(shape ? PatchBatch::Shapes{{0, std::move(shape)}} : PatchBatch::Shapes{});
}

void MeshScene::set_loops(const std::vector<LoopLine>& loops) {
  impl_->renderer->lines_changed();
  impl_->loops.set_lines(loops);
}

void MeshScene::set_shading(Shading shading) {
  impl_->renderer->still_changed();
  impl_->shading = shading;
  impl_->each_surface([&](SurfaceActor& surface) { surface.set_shading(shading); });
  for (auto& [index, scan] : impl_->scans) impl_->choose_shapes(scan);
  impl_->paint_tables(range());
}

void MeshScene::set_edges(Edges edges) {
  impl_->renderer->still_changed();
  impl_->edges = edges;
  impl_->each_surface([&](SurfaceActor& surface) { surface.set_edges(edges); });
}

void MeshScene::set_seams(Seams seams) {
  impl_->renderer->lines_changed();
  impl_->loops.set_visible(seams);
}

void MeshScene::set_tint(Tint tint) {
  impl_->renderer->still_changed();
  impl_->tint = tint;
  impl_->each_surface([&](SurfaceActor& surface) { surface.set_tint(tint); });
}

void MeshScene::set_clipping(const std::optional<ClippingPlane>& plane) {
  impl_->renderer->still_changed();
  impl_->clipping = nullptr;
  if (plane) {
    impl_->clipping = vtkSmartPointer<vtkPlane>::New();
    impl_->clipping->SetOrigin(plane->point.x(), plane->point.y(), plane->point.z());
    impl_->clipping->SetNormal(plane->normal.x(), plane->normal.y(), plane->normal.z());
  }
  impl_->each_surface([&](SurfaceActor& surface) { surface.set_clipping(impl_->clipping); });
  impl_->ghosts.surface().set_clipping(impl_->clipping);
  impl_->marked.surface().set_clipping(impl_->clipping);
}

void MeshScene::set_stripes(int count) {
  impl_->renderer->still_changed();
  impl_->stripes = count;
  impl_->each_surface([&](SurfaceActor& surface) { surface.set_stripes(count); });
}

void MeshScene::set_color_map(ColorMap map) {
  impl_->renderer->still_changed();
  impl_->map = map;
  impl_->paint_tables(range());
}

void MeshScene::set_range(double half_width, const std::map<int, double>& own) {
  impl_->renderer->still_changed();
  impl_->own_ranges = own;
  impl_->paint_tables(half_width);
}

double MeshScene::range() const { return impl_->table->GetRange()[1]; }

double MeshScene::range_of(int scan) const { return impl_->range_of(scan); }

void MeshScene::set_legend_words(const LegendWords& words) {
  impl_->legend.set_words(words);
  impl_->update_legend();
}

void MeshScene::set_legend(LegendPlace place) {
  impl_->legend_place = place;
  impl_->legend.set_ground(place == LegendPlace::beside ? Legend::Ground::bare : Legend::Ground::plate);
  impl_->legend.add_to(place == LegendPlace::beside ? impl_->legend_renderer : impl_->renderer);
  impl_->update_legend();
}

void MeshScene::spread_first_legend() { impl_->legend.come_by_kinds(); }

vtkRenderer* MeshScene::legend_renderer() const { return impl_->legend_renderer; }

void MeshScene::set_background(Background background) {
  impl_->renderer->still_changed();
  const bool light = background == Background::light;
  for (vtkRenderer* renderer : std::initializer_list<vtkRenderer*>{impl_->renderer, impl_->legend_renderer}) {
    renderer->GradientBackgroundOn();
    if (light) {
      renderer->SetBackground(0.84, 0.855, 0.87);
      renderer->SetBackground2(0.955, 0.96, 0.965);
    } else {
      renderer->SetBackground(0.115, 0.125, 0.14);
      renderer->SetBackground2(0.20, 0.215, 0.235);
    }
  }
  impl_->legend.set_ink(light ? 0.14 : 0.92);
}

void MeshScene::set_ground(Ground ground) {
  const bool shown = ground == Ground::shown;
  impl_->renderer->still_changed();
  impl_->renderer->SetGradientBackground(shown);
  impl_->renderer->SetBackgroundAlpha(shown ? 1 : 0);
}

void MeshScene::set_pixel_ratio(double ratio) {
  impl_->renderer->still_changed();
  impl_->legend.set_pixel_ratio(ratio);
  impl_->loops.set_pixel_ratio(ratio);
  impl_->pixel_ratio = ratio;
  impl_->each_surface([&](SurfaceActor& surface) { surface.set_pixel_ratio(ratio); });
  impl_->update_legend();
}

void MeshScene::set_size(int width, int height) {
  if (width == impl_->width && height == impl_->height) return;
  impl_->width = width;
  impl_->height = height;
  impl_->update_legend();
}

void MeshScene::set_covered(int height) {
  if (std::exchange(impl_->covered, height) != height) impl_->update_legend();
}

std::vector<Eigen::AlignedBox2d> MeshScene::legend_boxes() const {
  return impl_->wants_legend() ? impl_->legend.boxes() : std::vector<Eigen::AlignedBox2d>{};
}

std::vector<float> MeshScene::sample_points() const {
  std::vector<const SurfaceShape*> shapes;
  for (const auto& [index, scan] : impl_->scans) shapes.push_back(scan.shape.get());
  for (const auto& [id, goal] : impl_->patch_shapes) shapes.push_back(goal.shape.get());
  std::size_t count = 0;
  for (const SurfaceShape* shape : shapes) count += shape->points.size() / 3;
  constexpr std::size_t enough = 20000;
  const std::size_t stride = 1 + count / enough;
  std::vector<float> sample;
  for (const SurfaceShape* shape : shapes)
    for (std::size_t v = 0; 3 * v < shape->points.size(); v += stride)
      for (std::size_t k = 0; k < 3; ++k) sample.push_back(shape->points[3 * v + k]);
  return sample;
}

std::array<double, 6> MeshScene::bounds() const {
  std::array<double, 6> b{};
  impl_->renderer->ComputeVisiblePropBounds(b.data());
  return b;
}

}  // namespace loopmend
