#include "scene/mesh_scene.h"

#include "scene/color_map.h"
#include "scene/legend.h"
#include "scene/surface_actor.h"

#include <vtkActor.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <map>

namespace loopmend {

struct MeshScene::Impl {
  vtkNew<vtkRenderer> renderer;
  vtkSmartPointer<vtkLookupTable> table = make_diverging_table();
  SurfaceActor surface{SurfaceActor::Role::scan, table};
  std::map<int, std::unique_ptr<SurfaceActor>> patches;
  LoopLines loops;
  Legend legend{table};
  Shading shading = Shading::curvature;
  Edges edges = Edges::hidden;
  bool with_legend = true;
  int width = 1, height = 1;

  void each_surface(const auto& act) {
    act(surface);
    for (auto& [id, patch] : patches) act(*patch);
  }
  void update_legend() {
    const bool colored = with_legend && surface.shape() && !surface.shape()->H.empty() && shading == Shading::curvature;
    if (colored) {
      legend.lay_out(width, height);
      legend.show();
    } else {
      legend.hide();
    }
  }
};

MeshScene::MeshScene() : impl_(std::make_unique<Impl>()) {
  impl_->surface.actor()->VisibilityOff();
  impl_->renderer->AddActor(impl_->surface.actor());
  impl_->loops.add_to(impl_->renderer);
  impl_->legend.add_to(impl_->renderer);
  impl_->legend.hide();
  set_background(Background::light);
}

MeshScene::~MeshScene() = default;

vtkRenderer* MeshScene::renderer() const { return impl_->renderer; }

void MeshScene::clear() {
  impl_->surface.actor()->VisibilityOff();
  keep_patches({});
  set_loops({});
  impl_->legend.hide();
}

void MeshScene::set_surface(std::shared_ptr<const SurfaceShape> shape) {
  impl_->surface.set_shape(std::move(shape));
  impl_->surface.actor()->VisibilityOn();
  impl_->update_legend();
}

void MeshScene::set_patch(int id, std::shared_ptr<const SurfaceShape> shape) {
  auto& patch = impl_->patches[id];
  if (!patch) {
    patch = std::make_unique<SurfaceActor>(SurfaceActor::Role::patch, impl_->table);
    patch->set_shading(impl_->shading);
    patch->set_edges(impl_->edges);
    impl_->renderer->AddActor(patch->actor());
  }
  patch->set_shape(std::move(shape));
}

void MeshScene::keep_patches(const std::vector<int>& ids) {
  std::erase_if(impl_->patches, [&](const auto& entry) {
    if (std::find(ids.begin(), ids.end(), entry.first) != ids.end()) return false;
    impl_->renderer->RemoveActor(entry.second->actor());
    return true;
  });
}

void MeshScene::set_loops(const std::vector<LoopLine>& loops) { impl_->loops.set_lines(loops); }

void MeshScene::set_shading(Shading shading) {
  impl_->shading = shading;
  impl_->each_surface([&](SurfaceActor& surface) { surface.set_shading(shading); });
  impl_->update_legend();
}

void MeshScene::set_edges(Edges edges) {
  impl_->edges = edges;
  impl_->each_surface([&](SurfaceActor& surface) { surface.set_edges(edges); });
}

void MeshScene::set_range(double half_width) {
  impl_->table->SetRange(-half_width, half_width);
  impl_->each_surface([](SurfaceActor& surface) { surface.recolor(); });
  impl_->update_legend();
}

double MeshScene::range() const { return impl_->table->GetRange()[1]; }

void MeshScene::hide_legend() {
  impl_->with_legend = false;
  impl_->update_legend();
}

void MeshScene::set_background(Background background) {
  const bool light = background == Background::light;
  vtkRenderer* renderer = impl_->renderer;
  renderer->GradientBackgroundOn();
  if (light) {
    renderer->SetBackground(0.84, 0.855, 0.87);
    renderer->SetBackground2(0.955, 0.96, 0.965);
  } else {
    renderer->SetBackground(0.115, 0.125, 0.14);
    renderer->SetBackground2(0.20, 0.215, 0.235);
  }
  impl_->legend.set_ink(light ? 0.14 : 0.92);
}

void MeshScene::set_pixel_ratio(double ratio) {
  impl_->legend.set_pixel_ratio(ratio);
  impl_->loops.set_pixel_ratio(ratio);
  impl_->update_legend();
}

void MeshScene::set_size(int width, int height) {
  if (width == impl_->width && height == impl_->height) return;
  impl_->width = width;
  impl_->height = height;
  impl_->update_legend();
}

std::array<double, 6> MeshScene::bounds() const {
  std::array<double, 6> b{};
  impl_->renderer->ComputeVisiblePropBounds(b.data());
  return b;
}

}  // namespace loopmend
