// SPDX-License-Identifier: GPL-3.0-or-later
// What the view shows: the legend that Frame keeps clear, ranges of colours, patches that are marked, the clipping plane and distances.
#include "driver.h"
#include "test_main.h"

#include "io/write_mesh.h"
#include "samples/analytic_surfaces.h"
#include "views/tool_controller.h"
#include "views/view_overlay.h"

#include <QAction>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <optional>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

bool near(const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-9 * (1 + b.norm()); }

TriangleSoup scaled(TriangleSoup soup, const Vec3& factors, const Vec3& shift = Vec3::Zero()) {
  for (Vec3& p : soup.points) p = p.cwiseProduct(factors) + shift;
  return soup;
}

/// Where a point of the scene appears, logical pixels; nothing where something else is drawn before it.
std::optional<QPoint> seen_at(const ViewSpace& space, const Vec3& point) {
  const Eigen::Vector3d at = space.to_screen(point);
  const bool inside = at.z() > 0 && at.x() >= 0 && at.y() >= 0 && at.x() < space.width && at.y() < space.height;
  if (!inside || std::abs(space.depth_at(static_cast<int>(at.x()), static_cast<int>(at.y())) - at.z()) > 1e-3)
    return std::nullopt;
  return (QPointF(at.x(), at.y()) / space.ratio).toPoint();
}

/// How near, in pixels, a vertex of the scan comes to a pixel that the legend draws.
double nearest_to_legend(MainWindow& window) {
  PictureOptions options;
  options.size = window.view().canvas()->size() * window.view().canvas()->devicePixelRatioF();
  options.extras = PictureOptions::Extras::legend;
  const QImage with = window.view().picture(options);
  options.extras = PictureOptions::Extras::none;
  const QImage without = window.view().picture(options);
  std::vector<QPoint> legend;
  for (int y = 0; y < with.height(); y += 2)
    for (int x = 0; x < with.width(); x += 2)
      if (with.pixel(x, y) != without.pixel(x, y)) legend.emplace_back(x, y);
  if (legend.size() < 100) return -1;  // there is no legend
  const ViewSpace space = window.view().space();
  double least = 1e300;
  for (int scan : window.document().scans())
    for (const Vec3& p : window.document().scan(scan)->model->soup.points) {
      const Eigen::Vector3d at = space.to_screen(p - window.document().origin());
      for (const QPoint& pixel : legend) least = std::min(least, std::hypot(pixel.x() - at.x(), pixel.y() - at.y()));
    }
  return least;
}

}  // namespace

class ViewTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_first_picture_is_framed();
  void the_legend_is_read_over_a_surface();
  void frame_keeps_clear_of_the_legend_data();
  void frame_keeps_clear_of_the_legend();
  void each_scan_may_have_its_own_range();
  void a_filled_hole_comes_into_view();
  void patches_may_have_a_tint();
  void a_selected_patch_is_marked();
  void no_line_lies_over_the_seam_that_is_judged();
  void a_distance_is_measured();
  void a_plane_cuts_the_picture_open();
  void a_large_scan_is_reduced_at_first();

 private:
  QString file(const char* name, const TriangleSoup& soup) { return scan_file(folder_, QLatin1String(name), soup); }
  QTemporaryDir folder_;
};

/// Seen from behind, the hole is hidden by the ball; seen from its side, the eye stays where it is.
void ViewTest::a_filled_hole_comes_into_view() {
  const auto is_cap = [](const Vec3& p) { return p.z() > 0.9; };
  Shown window({file("ball.ply", cut(make_icosphere(3), is_cap))});
  const auto fill_from = [&](NamedView side) {
    window.view().look_from(side);
    const Viewpoint before = window.view().viewpoint();
    window.selection().select({0});
    press(window, "fill");
    if (!wait_idle(window) || !wait_until([&] { return !window.view().is_flying(); })) return before;
    return window.view().viewpoint();
  };
  const Viewpoint turned = fill_from(NamedView::back);
  QVERIFY2((turned.eye - turned.focus).normalized().z() > 0.5, "the eye is not above the hole");
  window.undo().undo();
  window.view().look_from(NamedView::front);
  const Viewpoint above = window.view().viewpoint();
  const Viewpoint stayed = fill_from(NamedView::front);
  QVERIFY(near(stayed.eye, above.eye) && near(stayed.focus, above.focus));
}

/// Of the patch alone. A map of colours stays one that can be read: a hatching over curvature, nothing over likely errors.
void ViewTest::patches_may_have_a_tint() {
  Shown window({file("ball.ply", cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.9; }))});
  window.view().look_from(NamedView::front);
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  key(window, Qt::Key_M);  // the lines are no part of this
  for (const Qt::Key shading : {Qt::Key_1, Qt::Key_3, Qt::Key_4}) {
    key(window, shading);
    settle();
    const QImage before = window.view().picture();
    key(window, Qt::Key_T, Qt::ShiftModifier);
    QVERIFY(picture_changes(window, before, 0.005));
    const QImage tinted = window.view().picture();
    constexpr int reach = 20;  // within the patch
    const QPoint middle = before.rect().center(), beside(middle.x(), middle.y() + before.height() / 4);
    int greener = 0, same = 0, all = 0;
    for (int y = middle.y() - reach; y < middle.y() + reach; ++y)
      for (int x = middle.x() - reach; x < middle.x() + reach; ++x) {
        const QColor was = before.pixelColor(x, y), now = tinted.pixelColor(x, y);
        greener += now.green() - now.red() > was.green() - was.red() + 20;
        same += was == now;
        ++all;
      }
    const bool is_hatched = shading == Qt::Key_1;
    const QByteArray counts = QByteArray::number(greener) + " " + QByteArray::number(same);
    QVERIFY2(is_hatched ? 10 * greener > all && 10 * same > 7 * all : greener == all, counts.constData());
    QCOMPARE(tinted.pixelColor(beside), before.pixelColor(beside));
    key(window, Qt::Key_T, Qt::ShiftModifier);
    QVERIFY(picture_returns(window, before));
  }
  key(window, Qt::Key_T, Qt::ShiftModifier);
  QVERIFY(load_look().tint == Tint::none);
  window.keep_layout();
  QVERIFY(load_look().tint == Tint::patches);
  save_look({});
  const QAction* action = window.findChild<QAction*>(QStringLiteral("tint"));
  QVERIFY(action->isEnabled());
  key(window, Qt::Key_7);
  settle();
  const QImage with = window.view().picture();
  QVERIFY(!action->isEnabled() && !part<QCheckBox>(window, "showTint")->isEnabled());
  Look look = window.view().look();
  look.tint = Tint::none;
  window.view().set_look(look);
  settle();
  QCOMPARE(share_changed(with, window.view().picture()), 0.0);
}

/// Corners, which leave the seam clear; pale where the hole looks away.
void ViewTest::a_selected_patch_is_marked() {
  Shown window({file("marked.ply", cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.9; }))});
  window.view().look_from(NamedView::front);
  window.selection().select({0});
  auto* overlay = window.findChild<ViewOverlay*>();
  settle();
  QVERIFY(overlay->marks().empty());  // an open hole has its line
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  settle();
  using Side = ViewOverlay::Mark::Side;
  QCOMPARE(overlay->marks().size(), std::size_t(1));
  QVERIFY(overlay->marks().front().side == Side::seen);
  const auto yellow = [&](const QRectF& within) {
    QImage drawn(overlay->size(), QImage::Format_ARGB32);
    drawn.fill(Qt::transparent);
    overlay->render(&drawn);
    int count = 0;
    const QRect box = within.toAlignedRect() & drawn.rect();
    for (int y = box.top(); y <= box.bottom(); ++y)
      for (int x = box.left(); x <= box.right(); ++x) count += drawn.pixelColor(x, y) == QColor(255, 214, 40);
    return count;
  };
  const auto is_round_the_seam = [&] {
    const QRectF box = overlay->marks().front().box.adjusted(-2, -2, 2, 2);
    for (int vertex = 0; vertex < window.document().loop(0).edges(); ++vertex)
      if (!box.contains(window.view().position_of(0, vertex))) return false;
    return true;
  };
  QVERIFY(is_round_the_seam());
  const QSize size = window.size();
  window.resize(size.width() - 300, size.height() - 200);
  settle();
  QVERIFY(is_round_the_seam());
  window.resize(size);
  settle();
  const QRectF seam = overlay->marks().front().box;
  QVERIFY(yellow(overlay->rect()) > 60);
  QCOMPARE(yellow(seam.adjusted(-6, -6, 6, 6)), 0);
  window.view().look_from(NamedView::back);
  settle();
  QVERIFY(overlay->marks().front().side == Side::from_behind);
  window.selection().select({});
  QVERIFY(overlay->marks().empty());
  QCOMPARE(yellow(overlay->rect()), 0);
}

/// Of an open hole that is selected the line stays, and goes when it is filled.
void ViewTest::no_line_lies_over_the_seam_that_is_judged() {
  Shown window({file("seam.ply", cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.9; }))});
  window.view().look_from(NamedView::front);
  window.selection().select({0});
  settle();
  const auto lines = [&] {
    QTest::mouseMove(window.view().canvas(), QPoint(3, 3));
    settle();
    const QImage with = window.view().picture();
    key(window, Qt::Key_M);
    settle();
    const double share = share_changed(with, window.view().picture());
    key(window, Qt::Key_M);
    settle();
    return share;
  };
  QVERIFY(lines() > 0.002);
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  QCOMPARE(window.selection().selected(), std::set<int>{0});
  QCOMPARE(lines(), 0.0);
  window.selection().select({});
  QVERIFY(lines() > 0.002);  // others may be found by theirs
}

/// Zoomed in until the surface is all over the picture, the plate is still nearly as light as without it.
void ViewTest::the_legend_is_read_over_a_surface() {
  Shown window({file("near.ply", cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.9; }))});
  key(window, Qt::Key_1);
  settle();
  Viewpoint near = window.view().viewpoint();
  near.eye = near.focus + 0.4 * (near.eye - near.focus);
  window.view().set_viewpoint(near);
  settle();
  const QImage picture = window.view().picture();
  const double ratio = window.view().canvas()->devicePixelRatioF();
  // Between the title and the end of the bar, left of the numbers, where nothing else is written.
  const QPoint on_plate(picture.width() - static_cast<int>(60 * ratio), static_cast<int>(75 * ratio));
  const QPoint beside(picture.width() - static_cast<int>(250 * ratio), static_cast<int>(300 * ratio));
  QVERIFY2(picture.pixelColor(on_plate).lightness() > 200, qPrintable(picture.pixelColor(on_plate).name()));
  QVERIFY2(picture.pixelColor(beside).lightness() < 235, qPrintable(picture.pixelColor(beside).name()));
}

void ViewTest::frame_keeps_clear_of_the_legend_data() {
  QTest::addColumn<double>("wide");
  QTest::addColumn<double>("high");
  QTest::addColumn<bool>("orthographic");
  QTest::newRow("wide") << 3.0 << 1.0 << false;
  QTest::newRow("wide, orthographic") << 3.0 << 1.0 << true;
  QTest::newRow("as the picture") << 1.6 << 1.0 << false;
  QTest::newRow("square") << 1.0 << 1.0 << false;
  QTest::newRow("high") << 1.0 << 3.0 << false;
}

void ViewTest::frame_keeps_clear_of_the_legend() {
  QFETCH(double, wide);
  QFETCH(double, high);
  QFETCH(bool, orthographic);
  const TriangleSoup ball = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.9; });
  Shown window({file("wide.ply", scaled(ball, {wide, high, 0.5}))});
  key(window, Qt::Key_1);
  if (orthographic) trigger(window, "orthographic");
  for (const char* side : {"lookFront", "lookTop"}) {
    trigger(window, side);
    key(window, Qt::Key_F);
    settle();
    const double least = nearest_to_legend(window);
    QVERIFY2(least > 4, qPrintable(QStringLiteral("%1: %2 pixels").arg(QLatin1String(side)).arg(least)));
    QVERIFY2(count_colors(window.view().picture()) >= 40, "it is not seen at all");
  }
}

/// Two balls of which one is ten times smaller: ten times the curvature.
void ViewTest::each_scan_may_have_its_own_range() {
  const TriangleSoup egg = scaled(cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.9; }), {1.3, 1, 0.8});
  Shown window({file("large.ply", egg), file("small.ply", scaled(egg, {0.1, 0.1, 0.1}, {2, 0, 0}))});
  MeshView& view = window.view();
  key(window, Qt::Key_1);
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  settle();
  const double shared = view.range();
  QCOMPARE(view.range_of(0), shared);
  QCOMPARE(view.range_of(1), shared);
  const QImage before = view.picture();
  auto* rule = part<QComboBox>(window, "rangeRule");
  rule->setCurrentIndex(rule->findText(QStringLiteral("Percentile of each scan")));
  QVERIFY(std::abs(view.range_of(1) / view.range_of(0) - 10) < 0.01);
  QCOMPARE(view.range(), view.range_of(0));  // the legend: of the first, as nothing is selected
  QCOMPARE(view.range_of(1), shared);        // the widest
  QVERIFY2(picture_changes(window, before, 0.05), "the large one shows its shape now");
  // The legend tells the range of the scan whose hole is selected.
  const QImage first = view.picture();
  window.selection().select({window.document().first_loop_of(1)});
  QCOMPARE(view.range(), view.range_of(1));
  QVERIFY(picture_changes(window, first, 0.0005));
  rule->setCurrentIndex(rule->findText(QStringLiteral("Percentile, all scans alike")));
  QCOMPARE(view.range_of(0), shared);
  // A session keeps the choice.
  rule->setCurrentIndex(rule->findText(QStringLiteral("Percentile of each scan")));
  const QString session = folder_.filePath(QStringLiteral("ranges.loopmend"));
  window.controller().save_session(session);
  QVERIFY(wait_idle(window));
  Shown again({session});
  QCOMPARE(part<QComboBox>(again, "rangeRule")->currentText(), QStringLiteral("Percentile of each scan"));
  QVERIFY(std::abs(again.view().range_of(1) / again.view().range_of(0) - 10) < 0.01);
}

void ViewTest::a_distance_is_measured() {
  const QString path = file("ball.ply", cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; }));
  Shown window({path});
  window.view().frame();
  settle();
  key(window, Qt::Key_D);
  QVERIFY(window.tools().panel()->tool() == Tool::measure);
  QVERIFY(!part<QPushButton>(window, "trialEvolve")->isVisible());
  MeasureTool& tool = window.tools().measure();
  QWidget* canvas = window.view().canvas();
  const Points& points = window.document().scan(0)->model->soup.points;
  const Vec3 origin = window.document().origin();
  // Each click takes the vertex that is nearest on the surface, not one behind it.
  std::vector<std::pair<Vec3, QPoint>> seen;
  for (const Vec3& p : points)
    if (const auto at = seen_at(window.view().space(), p - origin)) seen.emplace_back(p, *at);
  QVERIFY(seen.size() > 100);
  const auto& [a, at_a] = seen.front();
  const auto& [b, at_b] = *std::max_element(seen.begin(), seen.end(), [&a = a](const auto& x, const auto& y) {
    return (x.first - a).norm() < (y.first - a).norm();
  });
  QTest::mouseClick(canvas, Qt::LeftButton, {}, at_a);
  QVERIFY(tool.is_begun() && !tool.way());
  QTest::mouseClick(canvas, Qt::LeftButton, {}, at_b);
  QVERIFY(tool.way());
  constexpr double spacing = 0.04;  // of the ball's vertices: a pixel may lie nearer to a neighbour
  QVERIFY2(std::abs(tool.way()->norm() - (b - a).norm()) < 2 * spacing,
           qPrintable(QStringLiteral("%1, not %2").arg(tool.way()->norm()).arg((b - a).norm())));
  const auto is_distance = [&](double length) {
    return part<QLabel>(window, "measureDistance")->text().contains(QLocale().toString(length, 'g', 6));
  };
  QVERIFY(is_distance(tool.way()->norm()));
  press(window, "measureCopy");
  QCOMPARE(QGuiApplication::clipboard()->text().toDouble(), tool.way()->norm());
  QTest::mouseClick(canvas, Qt::LeftButton, {}, at_a);
  QVERIFY(!tool.way());
  key(window, Qt::Key_Escape);
  QVERIFY(!tool.is_begun() && window.tools().panel()->tool() == Tool::measure);
  key(window, Qt::Key_Escape);
  QVERIFY(window.tools().panel()->tool() == Tool::none);
}

void ViewTest::a_plane_cuts_the_picture_open() {
  Shown window({file("whole.ply", make_icosphere(4))});
  window.view().frame();
  settle();
  const auto depth = [&] {
    settle();
    const ViewSpace space = window.view().space();
    return space.depth_at(space.width / 2, space.height / 2);
  };
  const float front = depth();
  QVERIFY(front < 1);
  key(window, Qt::Key_X);
  QVERIFY(window.findChild<QAction*>(QStringLiteral("clip"))->isChecked());
  const float back = depth();
  QVERIFY2(back > front && back < 1, "the inside of the far half is seen");
  part<QCheckBox>(window, "clipNear")->setChecked(true);
  QCOMPARE(depth(), front);
  part<QCheckBox>(window, "clipNear")->setChecked(false);
  part<QSlider>(window, "clipPlace")->setValue(200);
  QCOMPARE(depth(), 1.0F);
  key(window, Qt::Key_X);
  QCOMPARE(depth(), front);
  QVERIFY(!part<QSlider>(window, "clipPlace")->isVisible());
}

void ViewTest::a_large_scan_is_reduced_at_first() {
  Shown window;
  MeshView& view = window.view();
  int drawn = 0, reduced = 0;
  QObject::connect(&view, &MeshView::drawn, this, [&] {
    ++drawn;
    reduced += view.is_rough() ? 1 : 0;
  });
  window.open(file("ball.ply", cut(make_icosphere(7), [](const Vec3& p) { return p.z() > 0.9; })));
  QVERIFY(wait_idle(window));
  QVERIFY(window.document().scan(0)->shape->reduced);
  QVERIFY(reduced > 0);
  const auto finished = [&] {
    settle();
    return wait_until([&] { return !view.is_rough(); });
  };
  QVERIFY(finished());
  const QImage first = view.picture();
  QWidget* canvas = view.canvas();
  canvas->setFocus();
  QTest::keyClick(canvas, Qt::Key_Left);
  QTest::keyClick(canvas, Qt::Key_Up);
  QVERIFY(finished());
  const QImage turned = view.picture();
  QVERIFY(share_changed(first, turned) > 0.05);
  // What it ends with is the whole scan.
  PictureOptions options;
  options.size = turned.size();
  options.extras = PictureOptions::Extras::legend;
  QVERIFY(share_changed(turned, view.picture(options)) < 0.001);

  // A boundary that is chosen is lit without another picture of the scan.
  drawn = 0;
  QVERIFY(wait_until([&] { return drawn > 0; }));
  QVERIFY(finished());
  reduced = 0;
  window.selection().select({first_hole(window.document())});
  QVERIFY(picture_changes(window, turned, 0.0005));
  QCOMPARE(reduced, 0);
}

/// The curvature comes a moment after the scan, and with it the legend, under which nothing should lie.
void ViewTest::the_first_picture_is_framed() {
  Shown window({write_sheet_with_holes(folder_.filePath(QStringLiteral("sheet.ply")), 6)});
  settle();
  const QImage first = window.view().picture();
  key(window, Qt::Key_F);
  settle();
  QVERIFY2(share_changed(first, window.view().picture()) < 0.002, "F frames it in another way");
  window.resize(window.width() - 200, window.height());
  settle();
  const QImage narrow = window.view().picture();
  key(window, Qt::Key_F);
  settle();
  QVERIFY2(share_changed(narrow, window.view().picture()) < 0.002, "a narrower window is not framed again");
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<ViewTest>(); }

#include "view_test.moc"
