// SPDX-License-Identifier: GPL-3.0-or-later
// What is hidden and shown: pieces by menu, key and list; what follows them; and that nothing but the picture changes.
#include "driver.h"
#include "test_main.h"

#include "dialogs/export_dialog.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "panels/banner.h"
#include "samples/analytic_surfaces.h"
#include "views/tool_controller.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

TriangleSoup shifted(TriangleSoup soup, const Vec3& way, double scale) {
  for (Vec3& p : soup.points) p = scale * p + way;
  return soup;
}

/// A large ball on the left and a small one on the right, each with a hole towards z.
QString write_two_balls(const QString& path) {
  const TriangleSoup open = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.85; });
  const TriangleSoup small = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.85; });
  write_mesh(path.toStdString(), joined({shifted(small, {3, 0, 0}, 0.5), open}));
  return path;
}

QMenu* open_menu(MainWindow& window, const char* name) {
  for (QMenu* menu : window.findChildren<QMenu*>(QLatin1String(name)))
    if (menu->isVisible()) return menu;
  return nullptr;
}

/// @returns whether the menu opened and had it.
bool choose(MainWindow& window, const char* menu, const char* entry) {
  if (!wait_until([&] { return open_menu(window, menu) != nullptr; })) return false;
  for (QAction* action : open_menu(window, menu)->actions())
    if (action->objectName() == QLatin1String(entry) && action->isEnabled()) {
      QTest::mouseClick(open_menu(window, menu), Qt::LeftButton, {},
                        open_menu(window, menu)->actionGeometry(action).center());
      return wait_until([&] { return open_menu(window, menu) == nullptr; });
    }
  return false;
}

/// Where the picture shows a point, in pixels of the canvas.
QPoint on_canvas(MainWindow& window, const Vec3& point) {
  const ViewSpace space = window.view().space();
  const Eigen::Vector3d at = space.to_screen(point - window.document().origin());
  return QPointF(at.x() / space.ratio, at.y() / space.ratio).toPoint();
}

/// The point of a ball that looks at the eye.
Vec3 nearest_to_eye(MainWindow& window, const Vec3& center, double radius) {
  const Viewpoint from = window.view().viewpoint();
  return center + radius * (from.eye - center).normalized();
}

QTreeWidget* tree(MainWindow& window) { return part<QTreeWidget>(window, "sceneTree"); }

QTreeWidgetItem* row(MainWindow& window, const QString& beginning) {
  const auto found = tree(window)->findItems(beginning, Qt::MatchStartsWith | Qt::MatchRecursive);
  return found.isEmpty() ? nullptr : found.first();
}

void click_check(MainWindow& window, QTreeWidgetItem* item) {
  tree(window)->scrollToItem(item);
  const QRect place = tree(window)->visualItemRect(item);
  QTest::mouseClick(tree(window)->viewport(), Qt::LeftButton, {}, QPoint(place.left() + 8, place.center().y()));
}

const Vec3 large_center = Vec3::Zero(), small_center(3, 0, 0);

}  // namespace

class SceneTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void a_piece_is_hidden_and_isolated_by_menu();
  void a_piece_is_hidden_by_key();
  void the_list_has_scans_pieces_and_patches();
  void what_is_hidden_cannot_be_picked_or_painted();
  void hidden_pieces_are_exported_and_stay_hidden();
  void flying_to_a_hidden_hole_shows_it();
  void faces_that_look_inward_are_turned_around();
  void turning_around_leaves_what_is_right();
  void bodies_inside_out_are_told();

 private:
  QTemporaryDir folder_;
  QString balls_;
};

void SceneTest::init() { balls_ = write_two_balls(folder_.filePath(QStringLiteral("balls.ply"))); }

void SceneTest::a_piece_is_hidden_and_isolated_by_menu() {
  Shown window({balls_});
  QVERIFY(count_colors(window.view().picture()) >= 40);
  window.view().look_from(NamedView::top);
  settle();
  QCOMPARE(window.visibility().piece_count(0), 2);
  const QImage whole = window.view().picture();
  QWidget* canvas = window.view().canvas();
  const auto* note = part<QPushButton>(window, "hiddenNote");
  QVERIFY(!note->isVisible());

  QTest::mouseClick(canvas, Qt::RightButton, {}, on_canvas(window, nearest_to_eye(window, small_center, 0.5)));
  QVERIFY(choose(window, "pieceMenu", "hideThis"));
  QVERIFY(window.visibility().is_hidden(PieceId{0, 1}));  // the smaller one is the second
  QVERIFY(picture_changes(window, whole, 0.005));
  QVERIFY(note->isVisible());
  // Frame goes by what is shown: the large ball alone fills the picture.
  const double far = (window.view().viewpoint().eye - window.view().viewpoint().focus).norm();
  trigger(window, "frame");
  const Viewpoint framed = window.view().viewpoint();
  const double near = (framed.eye - framed.focus).norm();
  QVERIFY2(near < 0.75 * far, qPrintable(QStringLiteral("%1 of %2").arg(near).arg(far)));
  QVERIFY((framed.focus - large_center).norm() < 0.2);

  QTest::mouseClick(window.findChild<QPushButton*>(QStringLiteral("hiddenNote")), Qt::LeftButton);
  QCOMPARE(window.visibility().hidden_count(), 0);
  window.view().look_from(NamedView::top);
  QVERIFY(picture_returns(window, whole));

  QTest::mouseClick(canvas, Qt::RightButton, {}, on_canvas(window, nearest_to_eye(window, small_center, 0.5)));
  QVERIFY(choose(window, "pieceMenu", "isolateThis"));
  QVERIFY(window.visibility().is_hidden(PieceId{0, 0}) && !window.visibility().is_hidden(PieceId{0, 1}));
  trigger(window, "showPieces");
  QVERIFY(picture_returns(window, whole));
}

void SceneTest::a_piece_is_hidden_by_key() {
  Shown window({balls_});
  window.view().look_from(NamedView::top);
  settle();
  QWidget* canvas = window.view().canvas();
  QTest::mouseMove(canvas, on_canvas(window, nearest_to_eye(window, large_center, 1)));
  settle();
  QTest::keyClick(&window, Qt::Key_H);
  QVERIFY(window.visibility().is_hidden(PieceId{0, 0}) && !window.visibility().is_hidden(PieceId{0, 1}));
  QTest::keyClick(&window, Qt::Key_H, Qt::ControlModifier);
  QCOMPARE(window.visibility().hidden_count(), 0);
  settle();
  // Without a surface under the mouse: the piece of the selected hole; without one, it is said what to do.
  QTest::mouseMove(canvas, QPoint(3, 3));
  settle();
  QTest::keyClick(&window, Qt::Key_H);
  QCOMPARE(window.visibility().hidden_count(), 0);
  QVERIFY(part<QLabel>(window, "bannerText")->text().contains(QStringLiteral("Move the mouse over")));
  window.selection().select({1});
  const PieceId meant = window.visibility().piece_of_loop(1);
  QTest::keyClick(&window, Qt::Key_H, Qt::ShiftModifier);
  QCOMPARE(window.visibility().hidden_count(), 1);
  QVERIFY(!window.visibility().is_hidden(meant));
}

void SceneTest::the_list_has_scans_pieces_and_patches() {
  Shown window({balls_});
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  part<QDockWidget>(window, "sceneDock")->raise();
  QVERIFY(wait_until([&] { return row(window, QStringLiteral("2 patches")) != nullptr; }));
  QTreeWidgetItem* scan = row(window, QStringLiteral("balls.ply"));
  QVERIFY(scan && row(window, QStringLiteral("Component 2,")));
  QCOMPARE(scan->childCount(), 3);
  // By falling size.
  QVERIFY(scan->child(0)->text(0).startsWith(QStringLiteral("Component 1,")));
  QVERIFY(scan->child(0)->text(1).remove(QLatin1Char(',')).toInt() >
          scan->child(1)->text(1).remove(QLatin1Char(',')).toInt());

  const QImage before = window.view().picture();
  QTreeWidgetItem* patches = row(window, QStringLiteral("2 patches"));
  patches->setExpanded(true);
  click_check(window, patches->child(0));
  QCOMPARE(window.visibility().hidden_count(), 1);
  QCOMPARE(patches->checkState(0), Qt::PartiallyChecked);
  QVERIFY(picture_changes(window, before, 0.0005));
  click_check(window, patches->child(0));
  QCOMPARE(patches->checkState(0), Qt::Checked);

  // A piece takes its patch along; the scan's box is half, then full again.
  click_check(window, scan->child(1));
  QVERIFY(window.visibility().is_hidden(PieceId{0, 1}));
  QCOMPARE(scan->checkState(0), Qt::PartiallyChecked);
  int hidden = 0;
  for (const OpenPatch& patch : window.document().patches()) hidden += window.visibility().is_hidden_patch(patch);
  QCOMPARE(hidden, 1);
  tree(window)->setCurrentItem(scan->child(1));
  press(window, "sceneIsolate");
  QVERIFY(window.visibility().is_hidden(PieceId{0, 0}) && !window.visibility().is_hidden(PieceId{0, 1}));
  press(window, "sceneShowAll");
  QCOMPARE(scan->checkState(0), Qt::Checked);
  QVERIFY(!part<QPushButton>(window, "sceneShowAll")->isEnabled());
}

void SceneTest::what_is_hidden_cannot_be_picked_or_painted() {
  Shown window({balls_});
  window.view().look_from(NamedView::top);
  settle();
  const int small_hole = window.visibility().piece_of_loop(0).piece == 1 ? 0 : 1;
  const QPoint on_hole = visible_point(window, small_hole);
  QVERIFY(on_hole.x() >= 0);
  const QPoint on_ball = on_canvas(window, nearest_to_eye(window, small_center, 0.5));
  window.visibility().set_pieces({PieceId{0, 1}}, SceneVisibility::Visible::hidden);
  settle();
  QWidget* canvas = window.view().canvas();
  QCOMPARE(window.selection().hovered(), no_loop);
  QTest::mouseMove(canvas, on_hole + QPoint(1, 0));
  settle();
  QCOMPARE(window.selection().hovered(), no_loop);
  QTest::mouseClick(canvas, Qt::LeftButton, {}, on_hole);
  QVERIFY(window.selection().selected().empty());
  // Painting over the place where it was takes nothing.
  trigger(window, "toolRegionAction");
  QTest::mouseClick(canvas, Qt::LeftButton, {}, on_ball);
  QCOMPARE(window.tools().region().count(), 0);
  window.visibility().show_all();
  settle();
  QTest::mouseClick(canvas, Qt::LeftButton, {}, on_ball);
  QVERIFY(window.tools().region().count() > 0);
}

void SceneTest::hidden_pieces_are_exported_and_stay_hidden() {
  Shown window({balls_});
  window.visibility().set_pieces({PieceId{0, 1}}, SceneVisibility::Visible::hidden);
  const std::size_t triangles = window.document().scan(0)->model->soup.triangles.size();
  const QString path = folder_.filePath(QStringLiteral("exported.ply"));
  window.controller().export_to(path);
  QVERIFY(wait_idle(window));
  QCOMPARE(read_mesh(path.toStdString()).soup.triangles.size(), triangles);
  ExportDialog dialog(window.print_check(), path, {QStringLiteral("PLY (*.ply)")}, QStringLiteral("PLY (*.ply)"));
  auto* words = dialog.findChild<QLabel*>(QStringLiteral("exportHidden"));
  QVERIFY(!words->isVisibleTo(&dialog));
  dialog.tell_of_hidden(window.visibility().hidden_count());
  QVERIFY(words->isVisibleTo(&dialog) && words->text().startsWith(QStringLiteral("1 hidden")));
  // A scan that comes in the place of another keeps what is hidden, and undo brings back how it was.
  const int large_hole = window.visibility().piece_of_loop(0).piece == 0 ? 0 : 1;
  const std::vector<int>& vertices = window.document().loop(large_hole).vertices;
  const std::vector<int>& soup = window.document().scan(0)->model->soup_vertex;
  window.controller().bridge(0, soup[vertices[0]], soup[vertices[vertices.size() / 2]]);
  QVERIFY(wait_idle(window));
  const int bridged = window.document().scans().front();
  QVERIFY(bridged != 0);
  QVERIFY(window.visibility().is_hidden(PieceId{bridged, 1}) && !window.visibility().is_hidden(PieceId{bridged, 0}));
  window.undo().undo();
  QVERIFY(window.visibility().is_hidden(PieceId{0, 1}));
  QCOMPARE(window.visibility().hidden_count(), 1);
  // Another scene begins whole.
  window.open(balls_);  // nothing is unsaved: the bridge was undone
  QVERIFY(wait_idle(window));
  QCOMPARE(window.visibility().hidden_count(), 0);
}

void SceneTest::flying_to_a_hidden_hole_shows_it() {
  Shown window({balls_});
  const PieceId piece = window.visibility().piece_of_loop(1);
  window.visibility().set_pieces({piece}, SceneVisibility::Visible::hidden);
  window.view().fly_to(1);
  QVERIFY(!window.visibility().is_hidden(piece));
}

namespace {

/// A ball that is open at the top, with its faces looking inward.
TriangleSoup inward_ball(double open_above) {
  TriangleSoup ball = cut(make_icosphere(4), [=](const Vec3& p) { return p.z() > open_above; });
  for (Triangle& t : ball.triangles) std::swap(t[1], t[2]);
  return ball;
}

bool looks_outward(const OpenedScan& scan) {
  const TriangleSoup& soup = scan.model->soup;
  const auto [a, b, c] = soup.triangles.front();
  return (soup.points[b] - soup.points[a]).cross(soup.points[c] - soup.points[a]).dot(soup.points[a]) > 0;
}

}  // namespace

void SceneTest::faces_that_look_inward_are_turned_around() {
  Shown window({scan_file(folder_, QStringLiteral("inward.ply"), inward_ball(0.3))});
  const Document& document = window.document();
  auto* banner = window.findChild<Banner*>();
  QVERIFY(wait_until([&] { return banner->text().startsWith(QStringLiteral("inward.ply: the faces look inward")); }));
  window.view().look_from(NamedView::bottom);
  trigger(window, "plain");
  settle();
  // The back is as readable as the front, and of another colour: brown, where the front is nearly grey.
  const auto middle = [&] {
    const QImage picture = window.view().picture();
    return picture.pixelColor(picture.rect().center());
  };
  const QColor back = middle();
  QVERIFY2(back.lightness() > 100, qPrintable(back.name()));
  QVERIFY2(back.red() > 1.15 * back.blue(), qPrintable(back.name()));
  QVERIFY(!looks_outward(document.first_scan()));
  press(window, "answerTurnAround");
  QVERIFY(wait_idle(window));
  QVERIFY(looks_outward(document.first_scan()));
  settle();
  const QColor front = middle();
  QVERIFY2(front.lightness() > back.lightness() + 20, qPrintable(front.name()));
  window.undo().undo();
  QVERIFY(!looks_outward(document.first_scan()));
  window.undo().redo();
  QVERIFY(looks_outward(document.first_scan()));
  trigger(window, "turnAroundAction");
  QVERIFY(wait_idle(window));
  QVERIFY(!looks_outward(document.first_scan()));
}

/// The notice after it offers nothing more: small bodies beside the main one stay as they are.
void SceneTest::turning_around_leaves_what_is_right() {
  TriangleSoup small = make_icosphere(2);
  for (Vec3& p : small.points) p = 0.2 * p + Vec3(3, 0, 0);
  const TriangleSoup bowl = inward_ball(0.3), both = joined({bowl, small});
  Shown window({scan_file(folder_, QStringLiteral("beside.ply"), both)});
  const Document& document = window.document();
  auto* banner = window.findChild<Banner*>();
  QVERIFY(wait_until([&] { return banner->text().startsWith(QStringLiteral("beside.ply: the faces look inward")); }));
  press(window, "answerTurnAround");
  QVERIFY(wait_idle(window));
  QVERIFY(looks_outward(document.first_scan()));
  const TriangleSoup& now = document.scan(document.scans().front())->model->soup;
  for (std::size_t f = 0; f < both.triangles.size(); ++f)
    QCOMPARE(now.triangles[f] == both.triangles[f], f >= bowl.triangles.size());
  const QString said = QStringLiteral("beside.ply: %1 faces were turned around; Ctrl+Z takes it back.")
                           .arg(QLocale().toString(static_cast<int>(bowl.triangles.size())));
  QCOMPARE(banner->text(), said);
  linger(1500);  // as long as the sides are looked at
  QVERIFY(settle());
  QVERIFY(!banner->text().contains(QStringLiteral("inside out")));
}

void SceneTest::bodies_inside_out_are_told() {
  TriangleSoup other = make_icosphere(2);  // alone, a body with a hole may be a room
  for (Vec3& p : other.points) p += Vec3(3, 0, 0);
  Shown window({scan_file(folder_, QStringLiteral("inside_out.ply"), joined({inward_ball(0.97), other}))});
  auto* banner = window.findChild<Banner*>();
  const QString said = QStringLiteral("inside_out.ply: 1 body or cavity is inside out. Repair turns it.");
  QVERIFY2(wait_until([&] { return banner->text() == said; }), qPrintable(banner->text()));
  press(window, "answerRepair");
  QVERIFY(part<QPushButton>(window, "fixNonManifold")->isVisible());
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<SceneTest>(); }

#include "scene_test.moc"
