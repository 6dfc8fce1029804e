#include "views/mesh_view.h"

#include "document/words.h"
#include "views/mesh_view_impl.h"

#include <vtkCommand.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkObjectFactory.h>
#include <vtkRenderWindowInteractor.h>

#include <QSurfaceFormat>
#include <QVBoxLayout>

namespace loopmend {
namespace {

/// Turning and zooming only: VTK's own keys (q quits!) are not ours.
class TurnStyle : public vtkInteractorStyleTrackballCamera {
 public:
  static TurnStyle* New();
  vtkTypeMacro(TurnStyle, vtkInteractorStyleTrackballCamera) void OnChar() override {}
  void OnKeyPress() override {}
  void OnKeyDown() override {}
};
vtkStandardNewMacro(TurnStyle)

    LoopStyle style_of(HoleState state) {
  switch (state) {
    case HoleState::open: return LoopStyle::open;
    case HoleState::left_out: return LoopStyle::left_out;
    case HoleState::failed: return LoopStyle::failed;
    default: return LoopStyle::filled;
  }
}

std::vector<float> line_of(const OpenedScan& scan, const BoundaryLoop& loop) {
  std::vector<float> line;
  line.reserve(3 * loop.vertices.size());
  for (int v : loop.vertices) {
    const auto at = scan.shape->points.begin() + 3 * static_cast<std::ptrdiff_t>(v);
    line.insert(line.end(), at, at + 3);
  }
  return line;
}

}  // namespace

void MeshView::prepare_graphics() {
  QSurfaceFormat format = QVTKOpenGLNativeWidget::defaultFormat();
  format.setSamples(0);  // multisampling costs a factor of five where OpenGL runs in software
  QSurfaceFormat::setDefaultFormat(format);
}

MeshView::MeshView(const Document& document, HoleSelection& selection, QWidget* parent)
    : QWidget(parent),
      impl_(std::make_unique<Impl>(document, selection)) {
  setObjectName(QStringLiteral("meshView"));
  setMinimumSize(320, 240);
  impl_->canvas = new QVTKOpenGLNativeWidget(this);
  impl_->canvas->setObjectName(QStringLiteral("meshCanvas"));
  impl_->canvas->setMouseTracking(true);
  impl_->canvas->setFocusPolicy(Qt::StrongFocus);
  impl_->canvas->installEventFilter(this);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->addWidget(impl_->canvas);
  impl_->overlay = new ViewOverlay(this);
  impl_->flight = new CameraFlight(this);

  impl_->window->SetMultiSamples(0);
  impl_->canvas->setRenderWindow(impl_->window);
  impl_->window->AddRenderer(impl_->renderer());
  vtkNew<TurnStyle> style;
  impl_->window->GetInteractor()->SetInteractorStyle(style);
  update_palette();

  impl_->redraw_timer.setSingleShot(true);
  impl_->redraw_timer.setInterval(0);
  connect(&impl_->redraw_timer, &QTimer::timeout, this, [this] {
    impl_->renderer()->ResetCameraClippingRange();
    impl_->window->Render();
  });
  impl_->window->AddObserver(vtkCommand::EndEvent, this, &MeshView::after_render);
  follow_document();
}

MeshView::~MeshView() = default;

void MeshView::follow_document() {
  const Document& document = impl_->document;
  const HoleSelection& selection = impl_->selection;
  connect(&document, &Document::opened, this, &MeshView::on_opened);
  connect(&document, &Document::shape_changed, this, [this] {
    impl_->scene.set_surface(impl_->document.scan().shape);
    impl_->scene.set_range(symmetric_range(impl_->document.scan().shape->H));
    redraw();
  });
  connect(&document, &Document::patches_changed, this, &MeshView::on_patches_changed);
  connect(&document, &Document::patch_moved, this, &MeshView::on_patch_moved);
  connect(&document, &Document::holes_changed, this, &MeshView::update_loops);
  connect(&selection, &HoleSelection::selection_changed, this, &MeshView::update_loops);
  connect(&selection, &HoleSelection::hover_changed, this, &MeshView::update_highlight);
}

QWidget* MeshView::canvas() const { return impl_->canvas; }

void MeshView::redraw() { impl_->redraw_timer.start(); }

Shading MeshView::shading() const { return impl_->shading; }

void MeshView::set_shading(Shading shading) {
  impl_->shading = shading;
  impl_->scene.set_shading(shading);
  redraw();
}

void MeshView::set_edges(Edges edges) {
  impl_->scene.set_edges(edges);
  redraw();
}

void MeshView::show_preview(std::shared_ptr<const SurfaceShape> shape) {
  if (!std::exchange(impl_->preview_shown, true)) impl_->pose_before = pose_of(impl_->camera());
  impl_->scene.clear();
  impl_->picker.set_loops({});
  impl_->loop_styles.clear();
  impl_->overlay->clear_highlight();
  impl_->scene.set_surface(std::move(shape));
  face_front();
}

void MeshView::drop_preview() {
  if (!std::exchange(impl_->preview_shown, false)) return;
  if (impl_->document.has_scan()) {
    on_opened();
    on_patches_changed();
    apply(impl_->pose_before, impl_->camera());
  } else {
    impl_->scene.clear();
    redraw();
  }
}

void MeshView::on_opened() {
  const OpenedScan& scan = impl_->document.scan();
  impl_->scene.clear();
  impl_->scene.set_surface(scan.shape);
  if (!scan.shape->H.empty()) impl_->scene.set_range(symmetric_range(scan.shape->H));
  std::vector<std::vector<float>> lines;
  for (const BoundaryLoop& loop : scan.loops) lines.push_back(line_of(scan, loop));
  impl_->picker.set_loops(std::move(lines));
  impl_->loop_styles.clear();
  impl_->seen_camera = 0;
  update_loops();
  if (!std::exchange(impl_->preview_shown, false)) face_front();
}

void MeshView::on_patches_changed() {
  std::vector<int> ids;
  for (const OpenPatch& patch : impl_->document.patches()) {
    ids.push_back(patch.id);
    impl_->scene.set_patch(patch.id, patch.state->shape);
  }
  impl_->scene.keep_patches(ids);
  redraw();
}

void MeshView::on_patch_moved(int id) {
  if (const OpenPatch* patch = impl_->document.patch(id)) impl_->scene.set_patch(id, patch->state->shape);
  redraw();
}

void MeshView::update_loops() {
  if (!impl_->document.has_scan()) return;
  const OpenedScan& scan = impl_->document.scan();
  std::vector<LoopStyle> styles;
  for (int loop = 0; loop < static_cast<int>(scan.loops.size()); ++loop)
    styles.push_back(impl_->selection.selected().contains(loop) ? LoopStyle::selected
                                                                : style_of(impl_->document.state(loop)));
  if (styles == impl_->loop_styles) return;
  impl_->loop_styles = styles;
  std::vector<LoopLine> lines(scan.loops.size());
  for (std::size_t l = 0; l < lines.size(); ++l) lines[l] = {line_of(scan, scan.loops[l]), styles[l]};
  impl_->scene.set_loops(lines);
  redraw();
}

void MeshView::update_highlight() {
  const int loop = impl_->selection.hovered();
  if (loop < 0 || loop >= impl_->picker.count() || !impl_->document.has_scan()) {
    impl_->overlay->clear_highlight();
    return;
  }
  impl_->follow_camera();
  const double ratio = impl_->canvas->devicePixelRatioF();
  QPolygonF line;
  for (const LoopPicker::Pixel& p : impl_->picker.projected(loop))
    if (p.z() >= 0) line << QPointF(p.x(), p.y()) / ratio;
  const BoundaryLoop& l = impl_->document.loops()[static_cast<std::size_t>(loop)];
  impl_->overlay->set_highlight(line, tr("%1 %2 \u00b7 %3 edges \u00b7 %4 across \u00b7 %5")
                                          .arg(l.kind == LoopKind::hole ? tr("Hole") : words::kind(l.kind))
                                          .arg(l.number)
                                          .arg(l.edges())
                                          .arg(words::number(l.diameter), words::state(impl_->document.state(loop))));
}

}  // namespace loopmend
