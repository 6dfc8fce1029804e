// SPDX-License-Identifier: GPL-3.0-or-later
#include "compare/flow_canvas.h"

#include "compare/picture_clock.h"
#include "document/preferences.h"
#include "scene/mesh_scene.h"
#include "scene/view_direction.h"
#include "views/turn_style.h"

#include <QVTKOpenGLNativeWidget.h>
#include <vtkCamera.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkInteractorStyle.h>
#include <vtkNew.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <QMouseEvent>
#include <QPainter>
#include <QPointer>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace loopmend {
namespace {

constexpr int grip_px = 8;  ///< the line is caught from so far, logical pixels
constexpr double narrowest = 0.02;

/// The line between the two sides, with a grip, over the picture.
class LineSheet : public QWidget {
 public:
  explicit LineSheet(QWidget* parent) : QWidget(parent) { setAttribute(Qt::WA_TransparentForMouseEvents); }
  double share = 0.5;

 protected:
  void paintEvent(QPaintEvent*) override {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const double x = share * width(), middle = 0.5 * height();
    painter.setPen(QPen(QColor(255, 255, 255, 230), 3));
    painter.drawLine(QPointF(x, 0), QPointF(x, height()));
    painter.setPen(QPen(QColor(30, 34, 40), 1));
    painter.drawLine(QPointF(x, 0), QPointF(x, height()));
    painter.setBrush(QColor(255, 255, 255, 240));
    painter.drawEllipse(QPointF(x, middle), 11, 11);
    painter.setBrush(QColor(30, 34, 40));
    for (const double side : {-1.0, 1.0}) {
      const QPointF arrow[3] = {{x + side * 7, middle}, {x + side * 2.5, middle - 4}, {x + side * 2.5, middle + 4}};
      painter.drawPolygon(arrow, 3);
    }
  }
};

}  // namespace

struct FlowCanvas::Impl {
  explicit Impl(PictureClock& c) : clock(&c) {}

  QPointer<PictureClock> clock;  ///< both belong to the same window, and go in any order
  QVTKOpenGLNativeWidget* canvas = nullptr;
  LineSheet* sheet = nullptr;
  vtkNew<vtkGenericOpenGLRenderWindow> window;
  std::vector<std::unique_ptr<MeshScene>> scenes;
  std::array<vtkMTimeType, 2> seen{};
  CameraPose pose;
  Look look;
  double line = 0.5;
  int frames = 0;
  bool moving = false;   ///< towards the next state
  bool placing = false;  ///< the camera is moved by us, not by the person
  enum class Drag { none, line } drag = Drag::none;

  vtkCamera* camera(std::size_t side) const { return scenes[side]->renderer()->GetActiveCamera(); }
  double aspect() const { return static_cast<double>(canvas->width()) / std::max(1, canvas->height()); }
};

FlowCanvas::FlowCanvas(const char* name, Sides sides, PictureClock& clock, QWidget* parent)
    : QWidget(parent),
      impl_(std::make_unique<Impl>(clock)) {
  setObjectName(QLatin1String(name));
  setMinimumSize(140, 100);
  impl_->canvas = new QVTKOpenGLNativeWidget(this);
  impl_->canvas->setObjectName(QLatin1String(name) + QStringLiteral("Canvas"));
  impl_->canvas->setFocusPolicy(Qt::StrongFocus);
  impl_->canvas->installEventFilter(this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(impl_->canvas);
  impl_->window->SetMultiSamples(0);
  impl_->canvas->setRenderWindow(impl_->window);
  for (int side = 0; side < (sides == Sides::two ? 2 : 1); ++side) {
    impl_->scenes.push_back(std::make_unique<MeshScene>());
    impl_->scenes.back()->set_legend(LegendPlace::none);
    impl_->window->AddRenderer(impl_->scenes.back()->renderer());
  }
  if (sides == Sides::two) {
    impl_->canvas->setMouseTracking(true);
    impl_->sheet = new LineSheet(this);
  }
  impl_->window->GetInteractor()->SetInteractorStyle(
      make_turn_style(std::make_shared<TurnRules>(TurnRules{load_navigation(), Hand::empty, {}})));
  impl_->window->AddObserver(vtkCommand::StartEvent, this, &FlowCanvas::before_drawing);
  update_palette();
  place_sides();
}

FlowCanvas::~FlowCanvas() {
  if (impl_->clock) impl_->clock->forget(this);
}

QWidget* FlowCanvas::canvas() const { return impl_->canvas; }

int FlowCanvas::frames() const { return impl_->frames; }
int FlowCanvas::neighborhood_drawn() const { return impl_->scenes.front()->still_drawn(); }
bool FlowCanvas::is_moving() const { return impl_->moving; }

void FlowCanvas::set_neighborhood(SurfaceShapePtr shape) {
  for (auto& scene : impl_->scenes) shape ? scene->set_scan(0, shape) : scene->keep_scans({});
  redraw();
}

void FlowCanvas::set_seams(const std::vector<LoopLine>& lines) {
  for (auto& scene : impl_->scenes) scene->set_loops(lines);
  redraw();
}

void FlowCanvas::show_patch(int side, SurfaceShapePtr shape, Arrival arrival) {
  MeshScene& scene = *impl_->scenes[side];
  shape ? scene.set_patch(0, 0, std::move(shape), arrival) : scene.keep_patches({});
  redraw();
}

void FlowCanvas::expect_news() {
  for (auto& scene : impl_->scenes) scene->expect_news(0);
}

/// Only what is another: a new colour map goes to the graphics with every vertex.
void FlowCanvas::set_look(const Look& look, double half_width) {
  const Look old = std::exchange(impl_->look, look);
  for (auto& scene : impl_->scenes) {
    if (look.shading != old.shading) scene->set_shading(look.shading);
    if (look.edges != old.edges) scene->set_edges(look.edges);
    if (look.seams != old.seams) scene->set_seams(look.seams);
    if (look.map != old.map) scene->set_color_map(look.map);
    if (look.stripes != old.stripes) scene->set_stripes(look.stripes);
    if (half_width > 0 && half_width != scene->range()) scene->set_range(half_width);
  }
  redraw();
}

void FlowCanvas::redraw() { impl_->clock->request(this); }

void FlowCanvas::draw() {
  if (!isVisible()) return;
  impl_->moving = false;
  for (auto& scene : impl_->scenes) impl_->moving = scene->update() || impl_->moving;
  impl_->window->Render();
  ++impl_->frames;
  if (impl_->moving) redraw();
}

/// One eye for both sides: the side that the person turned leads.
void FlowCanvas::before_drawing() {
  bool moved = false;
  for (std::size_t side = 0; side < impl_->scenes.size(); ++side) {
    if (impl_->camera(side)->GetMTime() == impl_->seen[side]) continue;
    impl_->pose = pose_of(impl_->camera(side));
    moved = true;
    break;
  }
  for (std::size_t side = 0; side < impl_->scenes.size(); ++side) {
    vtkCamera* camera = impl_->camera(side);
    if (moved) apply(impl_->pose, camera);
    impl_->scenes[side]->fit_depths();
    impl_->seen[side] = camera->GetMTime();
  }
  if (moved && !impl_->placing) Q_EMIT turned();
}

CameraPose FlowCanvas::pose() const { return pose_of(impl_->camera(0)); }

void FlowCanvas::set_pose(const CameraPose& pose) {
  impl_->pose = pose;
  for (std::size_t side = 0; side < impl_->scenes.size(); ++side) {
    apply(pose, impl_->camera(side));
    impl_->scenes[side]->fit_depths();
    impl_->seen[side] = impl_->camera(side)->GetMTime();
  }
  redraw();
}

void FlowCanvas::look_at(const Eigen::Vector3d& middle, double radius, const Eigen::Vector3d& towards_eye) {
  const CameraPose now = pose();
  const bool turn = towards_eye.squaredNorm() > 0;
  Stand stand;
  stand.focus = middle;
  stand.radius = radius;
  stand.direction = turn ? Vec3(towards_eye) : Vec3((now.position - now.focus).normalized());
  stand.up = turn ? view_up(towards_eye, Vec3::UnitZ()) : Vec3(now.up);
  stand.aspect = impl_->aspect();
  place_camera(impl_->camera(0), stand);
  impl_->camera(0)->OrthogonalizeViewUp();
  set_pose(pose_of(impl_->camera(0)));
}

double FlowCanvas::line() const { return impl_->line; }

void FlowCanvas::set_line(double share) {
  impl_->line = std::clamp(share, narrowest, 1 - narrowest);
  place_sides();
  redraw();
  Q_EMIT line_moved();
}

/// Each side draws its part of one and the same picture: a frustum to the left and to the right of the line.
void FlowCanvas::place_sides() {
  if (impl_->scenes.size() < 2) return;
  const double f = impl_->line;
  impl_->scenes[0]->renderer()->SetViewport(0, 0, f, 1);
  impl_->scenes[1]->renderer()->SetViewport(f, 0, 1, 1);
  impl_->camera(0)->SetWindowCenter(-(1 - f) / f, 0);
  impl_->camera(1)->SetWindowCenter(f / (1 - f), 0);
  for (std::size_t side = 0; side < 2; ++side) impl_->seen[side] = impl_->camera(side)->GetMTime();
  impl_->sheet->share = f;
  impl_->sheet->update();
}

bool FlowCanvas::drag_line(QEvent* event) {
  const auto type = event->type();
  if (type != QEvent::MouseMove && type != QEvent::MouseButtonPress && type != QEvent::MouseButtonRelease) return false;
  const auto* mouse = static_cast<QMouseEvent*>(event);
  const bool on_line = std::abs(mouse->pos().x() - impl_->line * impl_->canvas->width()) <= grip_px;
  if (impl_->drag == Impl::Drag::line) {
    if (type == QEvent::MouseMove)
      set_line(static_cast<double>(mouse->pos().x()) / std::max(1, impl_->canvas->width()));
    if (type == QEvent::MouseButtonRelease) impl_->drag = Impl::Drag::none;
    return true;
  }
  if (type == QEvent::MouseMove && mouse->buttons() == Qt::NoButton)
    impl_->canvas->setCursor(on_line ? Qt::SplitHCursor : Qt::ArrowCursor);
  if (type != QEvent::MouseButtonPress || !on_line || mouse->button() != Qt::LeftButton) return false;
  impl_->drag = Impl::Drag::line;
  return true;
}

bool FlowCanvas::eventFilter(QObject* watched, QEvent* event) {
  if (watched == impl_->canvas && impl_->scenes.size() == 2 && drag_line(event)) return true;
  return QWidget::eventFilter(watched, event);
}

QImage FlowCanvas::picture(const QSize& size, PictureOptions::Ground ground) {
  const bool see_through = ground == PictureOptions::Ground::transparent;
  impl_->canvas->makeCurrent();
  const QSize old = impl_->canvas->size() * impl_->canvas->devicePixelRatioF();
  impl_->window->SetSize(size.width(), size.height());
  for (auto& scene : impl_->scenes) {
    scene->arrive();
    scene->set_ground(see_through ? MeshScene::Ground::transparent : MeshScene::Ground::shown);
  }
  impl_->window->SetAlphaBitPlanes(1);
  impl_->window->Render();
  vtkNew<vtkUnsignedCharArray> pixels;
  impl_->window->GetRGBACharPixelData(0, 0, size.width() - 1, size.height() - 1, 0, pixels);
  QImage picture;
  if (pixels->GetNumberOfTuples() == static_cast<vtkIdType>(size.width()) * size.height())
    picture = QImage(pixels->GetPointer(0), size.width(), size.height(), QImage::Format_RGBA8888)
                  .mirrored()
                  .convertToFormat(see_through ? QImage::Format_ARGB32 : QImage::Format_RGB32);
  for (auto& scene : impl_->scenes) scene->set_ground(MeshScene::Ground::shown);
  impl_->window->SetSize(old.width(), old.height());
  redraw();
  return picture;
}

void FlowCanvas::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (impl_->sheet) {
    impl_->sheet->setGeometry(rect());
    impl_->sheet->raise();
  }
  redraw();
}

void FlowCanvas::changeEvent(QEvent* event) {
  QWidget::changeEvent(event);
  if (event->type() == QEvent::PaletteChange) update_palette();
}

void FlowCanvas::update_palette() {
  const bool dark = palette().color(QPalette::Window).lightness() < 128;
  for (auto& scene : impl_->scenes)
    scene->set_background(dark ? MeshScene::Background::dark : MeshScene::Background::light);
  redraw();
}

}  // namespace loopmend
