// SPDX-License-Identifier: GPL-3.0-or-later
// Around the hole by hand: a part of it filled, a region erased and filled, a boundary trimmed by the brush, and a boundary that
// touches itself parted. Each is undone at once.
#include "driver.h"
#include "test_main.h"

#include "document/fill_report.h"
#include "document/labels.h"
#include "io/write_mesh.h"
#include "samples/analytic_surfaces.h"
#include "views/tool_controller.h"
#include "views/view_overlay.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

/// A ball with two holes above: an oblong one and a small round one beside it.
TriangleSoup two_holes() {
  return cut(make_icosphere(5), [](const Vec3& p) {
    const bool oblong = p.z() > 0 && std::abs(p.y()) < 0.16 && std::abs(p.x()) < 0.6;
    return oblong || (p - Vec3(0, 0.7, 0.72).normalized()).norm() < 0.15;
  });
}

const OpenedScan& last_scan(MainWindow& window) { return *window.document().scan(window.document().scans().back()); }

int open_loops(MainWindow& window) {
  int open = 0;
  for (int loop = 0; loop < window.document().loop_count(); ++loop)
    open += window.document().present(loop) && !window.document().patch_of(loop);
  return open;
}

/// The vertex of a loop of the first scan that lies farthest along a direction.
int extreme_point(MainWindow& window, int loop, const Vec3& way) {
  const OpenedScan& scan = *window.document().scan(0);
  const auto along = [&](int v) { return way.dot(Vec3(scan.model->mesh.point(TriMesh::VertexHandle(v)))); };
  const std::vector<int>& vertices = window.document().loop(loop).vertices;
  const int best =
      *std::max_element(vertices.begin(), vertices.end(), [&](int a, int b) { return along(a) < along(b); });
  return scan.model->soup_vertex[best];
}

/// The vertex of the first loop of the first scan that is nearest to a place: its soup point.
int near(MainWindow& window, const Vec3& wanted) {
  const OpenedScan& scan = *window.document().scan(0);
  const auto distance = [&](int v) { return (Vec3(scan.model->mesh.point(TriMesh::VertexHandle(v))) - wanted).norm(); };
  const std::vector<int>& vertices = window.document().loop(0).vertices;
  return scan.model->soup_vertex[*std::ranges::min_element(vertices, {}, distance)];
}

void click_vertex(MainWindow& window, int soup_point, Qt::KeyboardModifiers with = {}) {
  const QPoint at = window.tools().bridge().position_of(0, soup_point, window.view().space()).toPoint();
  QTest::mouseMove(window.view().canvas(), at);
  QTest::mouseClick(window.view().canvas(), Qt::LeftButton, with, at);
}

QPoint on_canvas(MainWindow& window, const Vec3& point) {
  const ViewSpace space = window.view().space();
  const Eigen::Vector3d at = space.to_screen(point - window.document().origin());
  return QPointF(at.x() / space.ratio, at.y() / space.ratio).toPoint();
}

/// Patches and scan as one: the largest distance of a vertex from the middle.
double farthest(MainWindow& window) {
  double most = 0;
  for (const Vec3& p : last_scan(window).model->soup.points) most = std::max(most, p.norm());
  for (const OpenPatch& open : window.document().patches())
    for (int i = 0; i < open.state->patch.free_count; ++i)
      most = std::max(most, open.state->patch.to_mesh(open.state->patch.positions[i]).norm());
  return most;
}

}  // namespace

class PartsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_part_of_a_hole_is_filled_by_two_clicks();
  void the_part_that_is_lit_is_filled_with_a_smooth_edge();
  void ctrl_fills_the_longer_part();
  void a_spike_is_erased_and_filled();
  void the_brush_trims_a_boundary();
  void erasing_takes_in_the_patch_that_it_meets();
  void a_boundary_is_parted_where_it_touches_itself();
  void a_ragged_bunny_hole_is_trimmed_and_filled();
  void the_label_under_the_mouse_tells_the_state_of_now();

 private:
  QString file(const char* name, const TriangleSoup& soup) { return scan_file(folder_, QLatin1String(name), soup); }
  QTemporaryDir folder_;
};

void PartsTest::a_part_of_a_hole_is_filled_by_two_clicks() {
  Shown window({file("part.ply", two_holes())});
  const Document& document = window.document();
  QCOMPARE(document.loop_count(), 2);
  // The round hole is filled before, and its patch outlasts the bridge over the other one.
  window.selection().select({1});
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  const PatchStatePtr round = document.patch_of(1)->state;
  window.view().look_from(NamedView::front);
  QVERIFY(fly(window, 0));
  // It is found by a right click on the hole.
  QTest::mouseClick(window.view().canvas(), Qt::RightButton, {}, visible_point(window, 0));
  QAction* offered = window.findChild<QAction*>(QStringLiteral("toolFillPartAction"));
  QMenu* menu = nullptr;
  QVERIFY(wait_until([&] {
    for (QMenu* found : window.findChildren<QMenu*>(QStringLiteral("holeMenu")))
      if (found->isVisible()) menu = found;
    return menu != nullptr;
  }));
  QVERIFY(menu->actions().contains(offered));
  QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(offered).center());
  QVERIFY(wait_until([&] { return window.tools().panel()->tool() == Tool::fill_part; }));

  // Across the oblong hole, at a third of its length.
  const std::size_t before = document.scan(0)->model->soup.triangles.size();
  click_vertex(window, near(window, {0.3, 0.16, 0.94}));
  QVERIFY(window.tools().bridge().is_begun());
  click_vertex(window, near(window, {0.3, -0.16, 0.94}));
  QVERIFY(wait_until([&] { return document.scans() == std::vector<int>{1}; }));
  QVERIFY(wait_idle(window));
  const std::size_t strip = last_scan(window).model->soup.triangles.size() - before;
  QVERIFY(strip > 0);
  // The report counts it among what is new.
  const QString page = html_of(fill_report(document), PictureLinks::named);
  QVERIFY(page.contains(QStringLiteral("The scan has %1 triangles.").arg(labels::count(before))));
  QVERIFY(page.contains(QStringLiteral("a part of the scan, have %1.").arg(labels::count(strip))));
  QCOMPARE(document.patches().size(), std::size_t(2));
  QCOMPARE(open_loops(window), 1);
  int smoothed = 0, kept = 0;
  for (const OpenPatch& patch : document.patches()) {
    kept += patch.state->patch.positions == round->patch.positions;
    if (patch.state->patch.positions == round->patch.positions) continue;
    QVERIFY(!patch.state->recipe.runs.empty());
    // As good as a whole fill of such a hole.
    QVERIFY(document.state(patch.loops.front()) != HoleState::cutting && document.verdict(patch.loops.front()));
    QCOMPARE(static_cast<int>(document.verdict(patch.loops.front())->grade), static_cast<int>(Grade::good));
    QVERIFY2(patch.state->seams.front().g1_rms_deg < 4,
             qPrintable(QString::number(patch.state->seams.front().g1_rms_deg)));
    // The smaller part lies at the end where x is positive.
    ++smoothed;
    QVERIFY(document.loop(patch.loops.front()).center.x() > 0.3);
  }
  QCOMPARE(smoothed, 1);
  QCOMPARE(kept, 1);
  trigger(window, "undo");  // without a window manager, no key reaches the window behind a menu that was open
  QCOMPARE(document.scans(), std::vector<int>{0});
  QCOMPARE(document.patches().size(), std::size_t(1));
  QVERIFY(document.patch_of(1) && document.patch_of(1)->state == round);
  trigger(window, "redo");
  QCOMPARE(document.patches().size(), std::size_t(2));
  QCOMPARE(open_loops(window), 1);
}

void PartsTest::the_part_that_is_lit_is_filled_with_a_smooth_edge() {
  Shown window({file("lit.ply", two_holes())});
  const Document& document = window.document();
  window.view().look_from(NamedView::front);
  QVERIFY(fly(window, 0));
  trigger(window, "toolFillPartAction");
  BridgeTool& tool = window.tools().bridge();
  click_vertex(window, near(window, {0.3, 0.16, 0.94}));
  const QPoint second = tool.position_of(0, near(window, {0.3, -0.16, 0.94}), window.view().space()).toPoint();
  QTest::mouseMove(window.view().canvas(), second);
  QVERIFY(wait_until([&] { return !tool.lit_points().empty(); }));
  std::vector<int> lit = tool.lit_points();
  const std::vector<Vec3> drawn = tool.new_edge();
  const int own = static_cast<int>(document.scan(0)->model->soup.points.size());
  QTest::mouseClick(window.view().canvas(), Qt::LeftButton, {}, second);
  QVERIFY(wait_until([&] { return document.patches().size() == 1; }) && wait_idle(window));
  const SurfaceModel& model = *last_scan(window).model;
  std::vector<int> filled;
  double off = 0;
  int of_edge = 0;
  for (int v : document.loop(document.patches().front().loops.front()).vertices) {
    const int point = model.soup_vertex[v];
    if (point < own) {
      filled.push_back(point);
    } else {
      ++of_edge;
      off = std::max(off, std::abs(model.soup.points[point].norm() - 1));
    }
  }
  std::ranges::sort(lit);
  std::ranges::sort(filled);
  QVERIFY(filled == lit);
  // The edge that is left is the one that was drawn, point by point.
  QVERIFY(drawn.size() > 3);
  int open = 0;
  for (const BoundaryLoop& loop : last_scan(window).loops)
    for (int v : loop.vertices)
      open += std::ranges::count(drawn, model.soup.points[model.soup_vertex[v]]) > 0 &&
              &loop != &last_scan(window).loops[static_cast<std::size_t>(
                           document.patches().front().loops.front() - document.first_loop_of(document.scans().back()))];
  QCOMPARE(open, static_cast<int>(drawn.size()));
  // The new edge continues the ball, 0.32 across: a straight one would lie 0.013 below it.
  QVERIFY(of_edge > 2);
  QVERIFY2(off < 0.002, qPrintable(QString::number(off)));  // 0.0012
}

void PartsTest::ctrl_fills_the_longer_part() {
  Shown window({file("longer.ply", cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; }))});
  QVERIFY(fly(window, 0));
  key(window, Qt::Key_G, Qt::ShiftModifier);
  QVERIFY(window.tools().panel()->tool() == Tool::fill_part);
  settle();
  const int left = extreme_point(window, 0, {-1, 0.7, 0}), right = extreme_point(window, 0, {1, 0.7, 0});
  click_vertex(window, left);
  click_vertex(window, right, Qt::ControlModifier);
  QVERIFY(wait_until([&] { return window.document().patches().size() == 1; }));
  QVERIFY(wait_idle(window));
  const Document& document = window.document();
  const int filled = document.patches().front().loops.front();
  for (int loop = document.first_loop_of(1); loop < document.loop_count(); ++loop)
    QVERIFY(document.loop(loop).perimeter <= document.loop(filled).perimeter);
  // Two vertices of one edge: nothing can lie between them, and that is said.
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(document.scans(), std::vector<int>{0});
  const OpenedScan& scan = *document.scan(0);
  const std::vector<int>& vertices = document.loop(0).vertices;
  window.controller().fill_part({0, scan.model->soup_vertex[vertices[0]], scan.model->soup_vertex[vertices[1]],
                                 scan.model->soup_vertex[vertices[1]]},
                                {});
  QVERIFY(wait_idle(window));
  QCOMPARE(document.scans(), std::vector<int>{0});
  QVERIFY(part<QLabel>(window, "bannerText")->text().contains(QStringLiteral("in common")));
}

void PartsTest::a_spike_is_erased_and_filled() {
  TriangleSoup ball = make_icosphere(5);
  const Vec3 peak = Vec3(0.1, 0.2, 1).normalized();
  for (Vec3& p : ball.points)
    if ((p - peak).norm() < 0.12) p *= 1.5 - 4 * (p - peak).norm();
  Shown window({file("spike.ply", ball)});
  const Document& document = window.document();
  QCOMPARE(document.loop_count(), 0);
  QVERIFY(farthest(window) > 1.2);
  window.view().set_viewpoint({Vec3::Zero(), 4 * peak, Vec3::UnitX()});  // no side of it is hidden
  settle();
  trigger(window, "toolRegionAction");
  QVERIFY(!part<QPushButton>(window, "regionRefill")->isEnabled());
  // As wide as the spike.
  const QPoint at = on_canvas(window, peak), edge = on_canvas(window, (peak + Vec3(0.17, 0, 0)).normalized());
  part<QSlider>(window, "regionRadius")->setValue(static_cast<int>(QLineF(at, edge).length()));
  QTest::mouseClick(window.view().canvas(), Qt::LeftButton, {}, at);
  QVERIFY(window.tools().region().count() > 20);
  press(window, "regionRefill");
  QVERIFY(wait_until([&] { return document.patches().size() == 1; }));
  QVERIFY(wait_idle(window));
  QCOMPARE(open_loops(window), 0);
  QVERIFY2(farthest(window) < 1.02, qPrintable(QString::number(farthest(window))));
  QVERIFY(!document.patches().front().state->recipe.runs.empty());
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(document.scans(), std::vector<int>{0});
  QVERIFY(document.patches().empty());
}

void PartsTest::the_brush_trims_a_boundary() {
  Shown window({file("trimmed.ply", two_holes())});
  const Document& document = window.document();
  window.selection().select({1});
  QVERIFY(press_and_wait(window, "fill"));
  QVERIFY(fly(window, 0));
  key(window, Qt::Key_R);
  part<QSlider>(window, "regionRadius")->setValue(40);
  settle();  // the dock takes its place
  const int end = extreme_point(window, 0, {1, 0, 0});
  const Vec3 place = document.scan(0)->model->soup.points[end];
  QTest::mouseClick(window.view().canvas(), Qt::LeftButton, {}, on_canvas(window, place));
  QVERIFY(window.tools().region().count() > 0);
  const std::size_t faces = document.scan(0)->model->soup.triangles.size(),
                    points = document.scan(0)->model->soup.points.size();
  const double length = document.loop(0).diameter;
  QVERIFY(press_and_wait(window, "regionEraseFaces"));
  QCOMPARE(document.scans(), std::vector<int>{1});
  QVERIFY(last_scan(window).model->soup.triangles.size() < faces);
  QVERIFY(last_scan(window).model->soup.points.size() < points);  // no vertex without a face is left behind
  QCOMPARE(last_scan(window).model->repairs.unreferenced_vertices, std::size_t(0));
  QVERIFY(last_scan(window).loops.front().diameter > length);
  // The wall behind the hole, which is seen through it, was not painted.
  QCOMPARE(last_scan(window).loops.size(), std::size_t(2));
  QCOMPARE(document.patches().size(), std::size_t(1));  // that of the other hole is what it was
  QCOMPARE(open_loops(window), 1);
  // It fits its new scan: what is exported is closed there.
  QCOMPARE(document.loop(document.patches().front().loops.front()).number, 2);
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  QCOMPARE(open_loops(window), 0);
  const QString path = folder_.filePath(QStringLiteral("trimmed-filled.ply"));
  window.controller().export_to(path);
  QVERIFY(wait_idle(window));
  Shown exported({path});
  QVERIFY(exported.ready);
  QCOMPARE(exported.document().loop_count(), 0);
}

void PartsTest::erasing_takes_in_the_patch_that_it_meets() {
  Shown window({file("meets.ply", two_holes())});
  const Document& document = window.document();
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  QCOMPARE(document.patches().size(), std::size_t(2));
  QVERIFY(fly(window, 1));
  key(window, Qt::Key_R);
  const Vec3 middle = document.loop(1).center.normalized();
  QTest::mouseClick(window.view().canvas(), Qt::LeftButton, {}, on_canvas(window, middle));
  QVERIFY(window.tools().region().count() > 0);
  QVERIFY(press_and_wait(window, "regionEraseFaces"));
  // The rest of that patch is a part of the scan; the other patch stays one.
  QCOMPARE(document.patches().size(), std::size_t(1));
  QCOMPARE(open_loops(window), 1);
  QVERIFY(part<QLabel>(window, "bannerText")->isHidden() ||
          !part<QLabel>(window, "bannerText")->text().contains(QStringLiteral("removed")));
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(document.patches().size(), std::size_t(2));
}

void PartsTest::a_boundary_is_parted_where_it_touches_itself() {
  TriangleSoup ball = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; });
  const SurfaceModel open = make_surface_model(ball);
  const BoundaryLoop loop = find_boundary_loops(open).front();
  const int held = open.soup_vertex[loop.vertices.front()];
  // A flap that hangs at one vertex of the boundary, towards the middle of the hole.
  const Vec3 from = ball.points[held], way = loop.center - from;
  const Vec3 side = way.cross(Vec3::UnitZ()).normalized() * 0.1;
  const int first = static_cast<int>(ball.points.size());
  ball.points.push_back(from + 0.4 * way + side);
  ball.points.push_back(from + 0.4 * way - side);
  ball.points.push_back(from + 0.6 * way);
  ball.triangles.push_back({held, first, first + 1});
  ball.triangles.push_back({first, first + 2, first + 1});
  Shown window({file("touching.ply", ball)});
  const Document& document = window.document();
  QCOMPARE(document.loop_count(), 1);
  QAction* action = window.findChild<QAction*>(QStringLiteral("partAction"));
  QVERIFY(!action->isEnabled());
  window.selection().select({0});
  QVERIFY(action->isEnabled());
  action->trigger();
  QVERIFY(wait_idle(window));
  QCOMPARE(document.scans(), std::vector<int>{1});
  QCOMPARE(last_scan(window).loops.size(), std::size_t(2));
  QCOMPARE(last_scan(window).pieces.list.size(), std::size_t(2));
  for (const BoundaryLoop& now : last_scan(window).loops) QVERIFY(now.edges() == 4 || now.edges() == loop.edges());
  window.selection().select({document.first_loop_of(1)});
  QVERIFY(!action->isEnabled());
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(document.scans(), std::vector<int>{0});
}

/// With three rings of ragged faces gone, the patch meets the bunny below 8 degrees; without, at 16.
void PartsTest::a_ragged_bunny_hole_is_trimmed_and_filled() {
  const QString path = QStringLiteral(LOOPMEND_SHARED_DIR "/data/bunny.ply");
  if (!QFile::exists(path)) QSKIP("the shared scans are not here");
  for (int hole : {2, 3}) {
    Shown window({path});
    window.selection().select({hole});
    for (int ring = 0; ring < 3; ++ring) {
      trigger(window, "eraseRingAction");
      QVERIFY(wait_idle(window));
      QCOMPARE(window.selection().selected().size(), std::size_t(1));  // the widened hole
    }
    QVERIFY(press_and_wait(window, "fillAndSmooth", 240));
    QCOMPARE(window.document().patches().size(), std::size_t(1));
    const SeamReport& seam = window.document().patches().front().state->seams.front();
    qInfo("hole %d: %.2f degrees rms, %.2f at most", hole + 1, seam.g1_rms_deg, seam.g1_max_deg);
    QVERIFY(seam.g1_rms_deg < 8);
    for (int step = 0; step < 4; ++step) trigger(window, "undo");
    QCOMPARE(window.document().scans(), std::vector<int>{0});
  }
}

void PartsTest::the_label_under_the_mouse_tells_the_state_of_now() {
  Shown window({sample_file(folder_)});
  const int hole = first_hole(window.document());
  const auto* overlay = window.findChild<ViewOverlay*>();
  window.selection().select({hole});
  window.selection().hover(hole);
  QVERIFY2(overlay->caption().endsWith(QStringLiteral("open")), qPrintable(overlay->caption()));
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  QVERIFY2(overlay->caption().endsWith(QStringLiteral("good")), qPrintable(overlay->caption()));  // as the table says
  press(window, "accept");
  QVERIFY2(overlay->caption().endsWith(QStringLiteral("accepted")), qPrintable(overlay->caption()));
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<PartsTest>(); }

#include "parts_test.moc"
