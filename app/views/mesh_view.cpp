// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/mesh_view.h"

#include "document/labels.h"
#include "panels/parts.h"
#include "views/mesh_view_impl.h"
#include "views/picture_pace.h"

#include <vtkCommand.h>
#include <vtkInteractorStyle.h>
#include <vtkRenderWindowInteractor.h>

#include <QElapsedTimer>
#include <QLocale>
#include <QSurfaceFormat>
#include <QVBoxLayout>

namespace loopmend {
namespace {

LoopStyle style_of(HoleState state) {
  switch (state) {
    case HoleState::open: return LoopStyle::open;
    case HoleState::left_out: return LoopStyle::left_out;
    case HoleState::failed: return LoopStyle::failed;
    default: return LoopStyle::filled;
  }
}

constexpr int trial_scan = -1;      ///< what is tried out, in place of scans
constexpr int every_scan = -2;      ///< the legend is of all of them
constexpr int first_instead = -10;  ///< patches that are shown in place of others have ids from here down

QString elided(const QString& name) {
  constexpr int most = 14;
  return name.size() <= most ? name : name.left(most - 1) + QStringLiteral("\u2026");
}

std::vector<float> line_of(const SurfaceShape& shape, const BoundaryLoop& loop) {
  std::vector<float> line;
  line.reserve(3 * loop.vertices.size());
  for (int v : loop.vertices) {
    const auto at = shape.points.begin() + 3 * static_cast<std::ptrdiff_t>(v);
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

MeshView::MeshView(const Document& document, SceneVisibility& visibility, HoleSelection& selection, QWidget* parent)
    : QWidget(parent),
      impl_(std::make_unique<Impl>(document, visibility, selection)) {
  setObjectName(QStringLiteral("meshView"));
  setMinimumSize(320, 240);
  impl_->canvas = new QVTKOpenGLNativeWidget(this);
  impl_->canvas->setObjectName(QStringLiteral("meshCanvas"));
  impl_->canvas->setMouseTracking(true);
  impl_->canvas->setFocusPolicy(Qt::StrongFocus);
  impl_->canvas->installEventFilter(this);
  auto* layout = make_layout<QVBoxLayout>(this);
  layout->addWidget(impl_->canvas);
  impl_->overlay = new ViewOverlay(this);
  impl_->sheet = new ToolSheet(this, [this](QPainter& painter) {
    if (impl_->tool) impl_->tool->paint(painter, space());
  });
  impl_->cube = new ViewCube(this);
  impl_->flight = new CameraFlight(this);
  impl_->hidden_note = make_button("hiddenNote", {},
                                   tr("Show everything that was hidden (Ctrl+H). It is filled and "
                                      "exported all the same"));
  impl_->hidden_note->setParent(this);
  impl_->hidden_note->hide();
  connect(impl_->hidden_note, &QPushButton::clicked, &impl_->visibility, &SceneVisibility::show_all);

  impl_->window->SetMultiSamples(0);
  impl_->scene.set_large_scans(MeshScene::LargeScans::reduced_at_first);
  impl_->canvas->setRenderWindow(impl_->window);
  impl_->window->AddRenderer(impl_->renderer());
  impl_->turning->up = [this] { return up(); };
  impl_->window->GetInteractor()->SetInteractorStyle(make_turn_style(impl_->turning));
  update_palette();
  update_legend_words();
  impl_->scene.spread_first_legend();

  impl_->redraw_timer.setParent(this);
  impl_->redraw_timer.setSingleShot(true);
  connect(&impl_->redraw_timer, &QTimer::timeout, this, [this] {
    QElapsedTimer clock;
    clock.start();
    const int to_rest = impl_->time_to_rest();
    const bool moving = impl_->scene.update(to_rest > 0 ? MeshScene::Eye::moves : MeshScene::Eye::rests);
    match_parallel_scale(impl_->camera());
    impl_->scene.fit_depths();
    impl_->window->Render();
    impl_->pause_ms = wait_after_picture(clock.elapsed());
    impl_->last_picture.start();
    if (moving) redraw();
  });
  impl_->window->AddObserver(vtkCommand::EndEvent, this, &MeshView::after_render);
  follow_document();
}

MeshView::~MeshView() = default;

void MeshView::follow_document() {
  const Document& document = impl_->document;
  const HoleSelection& selection = impl_->selection;
  connect(&document, &Document::opened, this, [this] {
    impl_->fresh_scene = true;
    impl_->trial = {};
    impl_->hidden_loops.clear();
    impl_->instead.clear();
    // A preview is of the scan that is about to come: it stays until that is drawn.
    if (!impl_->preview_shown) impl_->scene.keep_scans({});
    impl_->scene.keep_patches({});
    impl_->scene.set_ghosts({});
    impl_->scene.set_loops({});
    impl_->loop_styles.clear();
    impl_->picker.set_loops({});
    drop_probe();
    if (!impl_->document.has_scan()) impl_->overlay->hide_axes();
    redraw();
  });
  connect(&document, &Document::scans_changed, this, &MeshView::on_scans_changed);
  connect(&document, &Document::shape_changed, this, [this] {
    if (impl_->preview_shown) return;  // of another scan, which is about to come
    show_surfaces();
    update_colors();
    frame_if_untouched();  // now there is a legend, which the scan should not lie under
    redraw();
  });
  connect(&document, &Document::patches_changed, this, &MeshView::on_patches_changed);
  for (auto signal : {&Document::units_changed, &Document::scans_changed})
    connect(&document, signal, this, [this] {
      impl_->overlay->set_unit(labels::unit_symbol(impl_->document.unit()));
      update_legend_words();
    });
  connect(&impl_->visibility, &SceneVisibility::changed, this, &MeshView::on_visibility_changed);
  connect(&document, &Document::patch_moved, this, &MeshView::on_patch_moved);
  connect(&document, &Document::running_changed, this, [this] {
    for (const OpenPatch& patch : impl_->document.patches())
      if (impl_->document.is_running(patch.id)) impl_->scene.expect_news(patch.id);
  });
  connect(&document, &Document::holes_changed, this, [this] {
    if (update_loops()) redraw_at_leisure();
    update_highlight();  // names the state
  });
  connect(&selection, &HoleSelection::selection_changed, this, [this] {
    if (legend_scan() != every_scan) update_colors();
    if (update_loops()) redraw();
    update_marks();
  });
  connect(&selection, &HoleSelection::hover_changed, this, &MeshView::update_highlight);
}

QWidget* MeshView::canvas() const { return impl_->canvas; }

void MeshView::redraw() {
  // Not restarted by each request: a flow that moves faster than the graphics would never be seen.
  const QTimer& timer = impl_->redraw_timer;
  if (!timer.isActive() || timer.remainingTime() > impl_->pause_ms) impl_->redraw_timer.start(impl_->pause_ms);
}

/// What comes in hundreds need not be seen one by one: the pictures would take longer than the work.
void MeshView::redraw_at_leisure() {
  constexpr qint64 leisure_ms = 200;
  const qint64 since = impl_->last_picture.isValid() ? impl_->last_picture.elapsed() : leisure_ms;
  if (!impl_->redraw_timer.isActive())
    impl_->redraw_timer.start(std::max(impl_->pause_ms, static_cast<int>(std::max<qint64>(0, leisure_ms - since))));
}

const Look& MeshView::look() const { return impl_->look; }

/// A picture that is not yet what it will be is followed by others; while the eye moves they would be like it.
void MeshView::redraw_at_rest() {
  if (!impl_->redraw_timer.isActive()) impl_->redraw_timer.start(std::max(impl_->pause_ms, impl_->time_to_rest()));
}

double MeshView::range() const { return impl_->scene.range(); }

double MeshView::range_of(int scan) const { return impl_->scene.range_of(scan); }

void MeshView::set_look(const Look& look) {
  const Look old = std::exchange(impl_->look, look);
  MeshScene& scene = impl_->scene;
  if (look.shading != old.shading) scene.set_shading(look.shading);
  if (look.edges != old.edges) scene.set_edges(look.edges);
  if (look.seams != old.seams) scene.set_seams(look.seams);
  if (look.tint != old.tint) scene.set_tint(look.tint);
  if (look.map != old.map) scene.set_color_map(look.map);
  if (look.stripes != old.stripes) scene.set_stripes(look.stripes);
  if (look.up != old.up) face_front();
  update_colors();
  redraw();
  Q_EMIT look_set();
}

Viewpoint MeshView::viewpoint() const {
  const CameraPose pose = pose_of(impl_->camera());
  const Vec3 origin = impl_->document.origin();
  return {pose.focus + origin, pose.position + origin, pose.up};
}

void MeshView::set_viewpoint(const Viewpoint& viewpoint) {
  impl_->flight->stop();
  const Vec3 origin = impl_->document.origin();
  apply({viewpoint.focus - origin, viewpoint.eye - origin, viewpoint.up}, impl_->camera());
  match_parallel_scale(impl_->camera());
  redraw();
}

void MeshView::update_colors() {
  update_legend_words();
  update_range();
}

void MeshView::update_range() {
  if (!is_colored(impl_->look.shading)) return;
  constexpr double nearly_all = 98;
  if (impl_->look.shading == Shading::deviation) {  // scans have none
    use_ranges(range_of_patches(nearly_all), {});
    return;
  }
  const ColorRange& wanted = impl_->look.range();
  if (wanted.rule == ColorRange::Rule::own) {
    use_ranges(wanted.half_width, {});
    return;
  }
  std::map<int, double> of_scans;
  double widest = 0;
  for (int index : impl_->document.scans()) {
    const auto shape = impl_->document.scan(index)->shape;
    const double half_width = impl_->scan_ranges.of(index, shape, impl_->look.shading, wanted.percent);
    if (half_width > 0) of_scans[index] = half_width;
    widest = std::max(widest, half_width);
  }
  if (widest == 0) widest = range_of_patches(wanted.percent);  // the curvature of a large scan is still being computed
  const int of_legend = legend_scan();
  if (of_legend == every_scan || !of_scans.contains(of_legend)) {
    use_ranges(widest, {});
    return;
  }
  // What is tried out stands for the scans that it hides.
  for (int index : impl_->trial.hidden_scans)
    if (of_scans.contains(index)) of_scans[trial_scan] = of_scans[index];
  use_ranges(of_scans[of_legend], of_scans);
}

double MeshView::range_of_patches(double percent) const {
  double widest = 0;
  for (const OpenPatch& patch : impl_->document.patches()) {
    const std::vector<float>& values = values_of(*patch.state->shape, impl_->look.shading);
    if (!values.empty()) widest = std::max(widest, symmetric_range(values, percent));
  }
  return widest;
}

void MeshView::use_ranges(double half_width, const std::map<int, double>& of_scans) {
  if (!(half_width > 0) || (half_width == impl_->scene.range() && of_scans == impl_->ranges)) return;
  impl_->ranges = of_scans;
  impl_->scene.set_range(half_width, of_scans);
}

/// Whose range the legend shows: that of the selected hole's scan, else of the first one; `every_scan` where they share one.
int MeshView::legend_scan() const {
  const Document& document = impl_->document;
  if (impl_->look.shading == Shading::deviation) return every_scan;
  if (impl_->look.range().rule != ColorRange::Rule::percentile_each || document.scans().size() < 2) return every_scan;
  for (int loop : impl_->selection.selected())
    if (document.present(loop)) return document.scan_of(loop);
  return document.scans().front();
}

void MeshView::update_legend_words() {
  const QString symbol = labels::unit_symbol(impl_->document.unit());
  if (impl_->look.shading == Shading::deviation) {
    impl_->scene.set_legend_words(
        {tr("Likely error").toStdString(),
         (symbol.isEmpty() ? tr("in the file's units") : tr("in %1").arg(symbol)).toStdString(),
         tr("far from what was there").toStdString(), tr("near").toStdString(), QLocale().decimalPoint().toLatin1()});
    return;
  }
  LegendWords words;
  const bool mean = impl_->look.shading != Shading::gaussian;
  words.title = (mean ? tr("Mean curvature H") : tr("Gaussian curvature K")).toStdString();
  QString unit = mean ? tr("in 1/length") : tr("in 1/length\u00b2");
  if (!symbol.isEmpty()) unit = (mean ? tr("in 1/%1") : tr("in 1/%1\u00b2")).arg(symbol);
  if (const int scan = legend_scan(); scan != every_scan)
    unit = elided(impl_->document.scan(scan)->name) + QStringLiteral(" \u00b7 ") + unit;
  words.unit = unit.toStdString();
  words.top = (mean ? tr("hollow") : tr("dome or bowl")).toStdString();
  words.bottom = (mean ? tr("bulging") : tr("saddle")).toStdString();
  words.decimal_mark = QLocale().decimalPoint().toLatin1();
  impl_->scene.set_legend_words(words);
}

void MeshView::show_ghosts(const std::vector<SurfaceShapePtr>& ghosts) {
  impl_->scene.set_ghosts(ghosts);
  redraw();
}

void MeshView::show_instead(const std::set<int>& loops, const std::vector<SurfaceShapePtr>& shapes) {
  if (loops == impl_->hidden_loops && shapes == impl_->instead) return;
  impl_->hidden_loops = loops;
  impl_->instead = loops.empty() ? std::vector<SurfaceShapePtr>() : shapes;
  show_surfaces();
  redraw();
}

std::vector<float> MeshView::line_of_loop(int loop) const {
  const Document& document = impl_->document;
  return line_of(*document.scan(document.scan_of(loop))->shape, document.loop(loop));
}

void MeshView::show_marked(SurfaceShapePtr shape) {
  impl_->scene.set_marked(std::move(shape));
  impl_->place.reset();
  update_marks();
  redraw();
}

void MeshView::show_preview(SurfaceShapePtr shape) {
  if (!std::exchange(impl_->preview_shown, true)) impl_->pose_before = pose_of(impl_->camera());
  impl_->scene.clear();
  impl_->picker.set_loops({});
  impl_->loop_styles.clear();
  impl_->overlay->clear_highlight();
  drop_probe();
  impl_->scene.set_scan(0, std::move(shape));
  face_front();
}

void MeshView::drop_preview() {
  if (!std::exchange(impl_->preview_shown, false)) return;
  impl_->scene.clear();
  impl_->loop_styles.clear();
  if (impl_->document.has_scan()) {
    on_scans_changed();
    on_patches_changed();
  }
  apply(impl_->pose_before, impl_->camera());  // for what comes back
  impl_->fresh_scene = false;
  redraw();
}

void MeshView::on_scans_changed() {
  const Document& document = impl_->document;
  update_hidden_note();
  show_surfaces();
  update_colors();
  std::vector<std::vector<float>> lines(document.loops().size());
  for (int loop = 0; loop < document.loop_count(); ++loop)
    if (impl_->shows(loop)) lines[loop] = line_of(*document.scan(document.scan_of(loop))->shape, document.loop(loop));
  impl_->picker.set_loops(std::move(lines));
  impl_->loop_styles.clear();
  impl_->seen_camera = 0;
  drop_probe();
  update_loops();
  update_marks();
  const bool preview = std::exchange(impl_->preview_shown, false);
  const bool first_seen = !document.scans().empty() && std::exchange(impl_->fresh_scene, document.scans().empty()) &&
                          !preview && document.patches().empty();
  first_seen ? face_front() : redraw();
}

/// Scans that come or go tell it as well, and bring their own picture.
void MeshView::on_visibility_changed() {
  update_hidden_note();
  if (impl_->preview_shown || !impl_->document.has_scan()) return;
  const int hovered = impl_->selection.hovered();
  if (hovered >= 0 && hovered < impl_->document.loop_count() && !impl_->shows(hovered)) impl_->selection.hover(no_loop);
  on_scans_changed();
}

/// Beside the cube, in the corner where neither banner nor legend, axes nor scale are.
void MeshView::update_hidden_note() {
  constexpr int margin = 10;
  const int hidden = impl_->document.has_scan() ? impl_->visibility.hidden_count() : 0;
  QPushButton* note = impl_->hidden_note;
  note->setText(tr("%Ln hidden: show all", nullptr, hidden));
  note->setAccessibleName(note->text());
  note->resize(note->sizeHint());
  ViewCube* cube = impl_->cube;
  cube->move(width() - cube->width() - margin, height() - cube->height() - margin);
  cube->setVisible(impl_->document.has_scan());
  note->move(cube->x() - note->width() - margin, height() - note->height() - margin);
  note->setVisible(hidden > 0);
  note->raise();
}

void MeshView::on_patches_changed() {
  update_hidden_note();
  show_surfaces();
  if (is_colored(impl_->look.shading)) update_range();
  update_marks();
  redraw_at_leisure();
}

/// A flow at work moves on evenly; what a person asks for is there at once.
Arrival MeshView::arrival(int patch) const {
  return impl_->document.is_running(patch) ? Arrival::with_the_next : Arrival::at_once;
}

/// Scans and patches, or what is tried out in their place.
void MeshView::show_surfaces() {
  const Document& document = impl_->document;
  std::vector<int> scans, patches;
  for (int index : document.scans()) {
    if (impl_->trial.hidden_scans.contains(index)) continue;
    const ShownShapes::Shown& shown = impl_->shapes.of(document, impl_->visibility, index);
    if (!shown.whole) continue;
    scans.push_back(index);
    impl_->scene.set_scan(index, shown.whole, shown.parts);
  }
  if (impl_->trial.backdrop) {
    scans.push_back(trial_scan);
    impl_->scene.set_scan(trial_scan, impl_->trial.backdrop);
  }
  for (const OpenPatch& patch : document.patches()) {
    if (impl_->trial.hidden_scans.contains(patch.scan) || impl_->visibility.is_hidden_patch(patch)) continue;
    if (impl_->is_replaced(patch)) continue;
    patches.push_back(patch.id);
    impl_->scene.set_patch(patch.id, patch.scan, patch.state->shape, Arrival::soon);
  }
  for (const auto& shape : impl_->instead) {
    patches.push_back(first_instead - static_cast<int>(&shape - impl_->instead.data()));
    impl_->scene.set_patch(patches.back(), document.scan_of(*impl_->hidden_loops.begin()), shape);
  }
  if (impl_->trial.patch) {
    patches.push_back(trial_scan);
    impl_->scene.set_patch(trial_scan, trial_scan, impl_->trial.patch, impl_->trial.arrival);
  }
  impl_->scene.keep_scans(scans);
  impl_->scene.keep_patches(patches);
}

void MeshView::show_trial(const ProblemPicture& picture) {
  impl_->trial = picture;
  update_range();
  show_surfaces();
  redraw();
}

void MeshView::place_scan(int scan, const Eigen::Matrix4d& placement) {
  impl_->scene.place_scan(scan, placement);
  redraw();
}

void MeshView::on_patch_moved(int id) {
  const OpenPatch* patch = impl_->document.patch(id);
  if (patch && !impl_->trial.hidden_scans.contains(patch->scan) && !impl_->visibility.is_hidden_patch(*patch) &&
      !impl_->is_replaced(*patch))
    impl_->scene.set_patch(id, patch->scan, patch->state->shape, arrival(id));
  redraw();
}

bool MeshView::update_loops() {
  const Document& document = impl_->document;
  std::vector<LoopStyle> styles;
  for (int loop = 0; loop < document.loop_count(); ++loop) {
    const LoopStyle chosen = document.patch_of(loop) ? LoopStyle::judged : LoopStyle::selected;
    styles.push_back(impl_->selection.selected().contains(loop) ? chosen : style_of(document.state(loop)));
  }
  if (styles == impl_->loop_styles) return false;
  impl_->loop_styles = styles;
  std::vector<LoopLine> lines;
  for (int loop = 0; loop < document.loop_count(); ++loop) {
    if (!impl_->shows(loop)) continue;
    const auto scan = document.scan(document.scan_of(loop));
    lines.push_back({line_of(*scan->shape, document.loop(loop)), styles[loop]});
  }
  impl_->scene.set_loops(lines);
  return true;
}

}  // namespace loopmend
