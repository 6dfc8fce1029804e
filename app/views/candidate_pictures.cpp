// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/candidate_pictures.h"

#include "scene/mesh_scene.h"
#include "scene/view_direction.h"

#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <QOffscreenSurface>
#include <QOpenGLContext>

#include <Eigen/Geometry>

namespace loopmend {
namespace {

/// Drawn larger, then reduced: the graphics do not smooth edges.
constexpr int supersampling = 2;

}  // namespace

struct CandidatePictures::Impl {
  QOffscreenSurface surface;
  QOpenGLContext context;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  std::unique_ptr<MeshScene> scene = std::make_unique<MeshScene>();
  Setting setting;
  bool usable = false;

  void make_current() { context.makeCurrent(&surface); }
  void is_current(vtkObject*, unsigned long, void* answer) {
    *static_cast<bool*>(answer) = QOpenGLContext::currentContext() == &context;
  }
  void yes(vtkObject*, unsigned long, void* answer) { *static_cast<int*>(answer) = 1; }
  void make_current_for(vtkObject*, unsigned long, void*) { make_current(); }

  Stand stand(double aspect) const {
    Eigen::AlignedBox3d box;
    for (const auto& line : setting.loops)
      for (std::size_t i = 0; i + 2 < line.size(); i += 3) box.extend(Vec3(line[i], line[i + 1], line[i + 2]));
    Stand stand;
    stand.focus = box.center();
    stand.radius = 0.45 * box.diagonal().norm();
    stand.direction = (setting.eye.position - setting.eye.focus).normalized();
    stand.up = setting.eye.up;
    stand.aspect = aspect;
    return stand;
  }
};

CandidatePictures::CandidatePictures() : impl_(std::make_unique<Impl>()) {
  impl_->surface.create();
  impl_->context.setShareContext(nullptr);
  if (!impl_->context.create() || !impl_->surface.isValid()) return;
  vtkGenericOpenGLRenderWindow* window = impl_->window;
  window->AddObserver(vtkCommand::WindowMakeCurrentEvent, impl_.get(), &Impl::make_current_for);
  window->AddObserver(vtkCommand::WindowIsCurrentEvent, impl_.get(), &Impl::is_current);
  window->AddObserver(vtkCommand::WindowIsDirectEvent, impl_.get(), &Impl::yes);
  window->AddObserver(vtkCommand::WindowSupportsOpenGLEvent, impl_.get(), &Impl::yes);
  window->SetMultiSamples(0);
  window->SetReadyForRendering(true);
  window->SetOwnContext(0);
  window->AddRenderer(impl_->scene->renderer());
  impl_->scene->set_legend(LegendPlace::none);
  impl_->usable = true;
}

CandidatePictures::~CandidatePictures() {
  if (!impl_->usable) return;
  impl_->make_current();
  impl_->window->RemoveRenderer(impl_->scene->renderer());
  impl_->scene.reset();
  impl_->window->Finalize();
  impl_->context.doneCurrent();
}

void CandidatePictures::set(const Setting& setting) {
  impl_->setting = setting;
  MeshScene& scene = *impl_->scene;
  if (setting.neighborhood)
    scene.set_scan(0, setting.neighborhood);
  else
    scene.keep_scans({});
  std::vector<LoopLine> lines;
  for (const auto& line : setting.loops) lines.push_back({line, LoopStyle::filled});
  scene.set_loops(lines);
  scene.set_shading(setting.look.shading);
  scene.set_edges(Edges::hidden);
  scene.set_seams(setting.look.seams);
  scene.set_tint(setting.look.tint);
  scene.set_color_map(setting.look.map);
  scene.set_stripes(setting.look.stripes);
  if (setting.half_width > 0) scene.set_range(setting.half_width);
  scene.set_background(setting.dark ? MeshScene::Background::dark : MeshScene::Background::light);
}

QImage CandidatePictures::draw(const std::vector<SurfaceShapePtr>& patches, const QSize& size, double ratio) {
  if (!impl_->usable || size.isEmpty()) return {};
  impl_->make_current();
  MeshScene& scene = *impl_->scene;
  const QSize large = supersampling * size;
  vtkGenericOpenGLRenderWindow* window = impl_->window;
  window->SetSize(large.width(), large.height());
  std::vector<int> ids;
  for (const auto& shape : patches) {
    ids.push_back(static_cast<int>(ids.size()));
    scene.set_patch(ids.back(), 0, shape);
  }
  scene.keep_patches(ids);
  scene.set_pixel_ratio(supersampling * ratio);
  scene.set_size(large.width(), large.height());
  place_camera(scene.renderer()->GetActiveCamera(), impl_->stand(static_cast<double>(size.width()) / size.height()));
  scene.arrive();
  scene.renderer()->ResetCameraClippingRange();
  window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetRGBACharPixelData(0, 0, large.width() - 1, large.height() - 1, 0, pixels);
  QImage picture;
  if (pixels->GetNumberOfTuples() == static_cast<vtkIdType>(large.width()) * large.height())
    picture = QImage(pixels->GetPointer(0), large.width(), large.height(), QImage::Format_RGBA8888)
                  .mirrored()
                  .convertToFormat(QImage::Format_RGB32)
                  .scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  impl_->context.doneCurrent();
  picture.setDevicePixelRatio(ratio);
  return picture;
}

}  // namespace loopmend
