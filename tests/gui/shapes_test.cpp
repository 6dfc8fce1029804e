// SPDX-License-Identifier: GPL-3.0-or-later
// How each hole is closed: chosen in the table, filled so, undone, saved and copied as a command; and a base for prints.
#include "driver.h"
#include "test_main.h"

#include "document/command_line.h"
#include "document/hole_table.h"
#include "io/read_mesh.h"
#include "repair/watertight.h"
#include "samples/analytic_surfaces.h"
#include "views/tool_controller.h"

#include <QAction>
#include <QApplication>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QInputDialog>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QProcess>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

/// A sphere without its two poles.
TriangleSoup open_at_both_poles() {
  return cut(make_icosphere(4), [](const Vec3& p) { return std::abs(p.z()) > 0.8; });
}

Points sorted_points(const QString& file) {
  Points points = read_mesh(file.toStdString()).soup.points;
  std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  return points;
}

QString state_of(MainWindow& window, int loop, int role = Qt::DisplayRole) {
  const auto* model = part<QTableView>(window, "holesTable")->model();
  for (int row = 0; row < model->rowCount(); ++row)
    if (model->index(row, HoleTable::number).data().toInt() == loop + 1)
      return model->index(row, HoleTable::state).data(role).toString();
  return {};
}

/// The entry of the menu that a right click on the row of a loop opens.
QAction* entry(MainWindow& window, int loop, const char* name) {
  auto* table = part<QTableView>(window, "holesTable");
  for (int row = 0; row < table->model()->rowCount(); ++row)
    if (table->model()->index(row, HoleTable::number).data().toInt() == loop + 1) {
      const QPoint at = table->visualRect(table->model()->index(row, HoleTable::state)).center();
      QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, at);
      Q_EMIT table->customContextMenuRequested(at);
    }
  QAction* found = nullptr;
  for (QMenu* menu : window.findChildren<QMenu*>(QStringLiteral("holeMenu")))
    if (auto* close_as = menu->findChild<QMenu*>(QStringLiteral("closeAsMenu")))
      for (QAction* action : close_as->actions())
        if (action->objectName() == QLatin1String(name)) found = action;
  return found;
}

void close_menus(MainWindow& window) {
  for (QMenu* menu : window.findChildren<QMenu*>(QStringLiteral("holeMenu"))) menu->close();
}

void choose(MainWindow& window, int loop, const char* name) {
  QAction* action = entry(window, loop, name);
  QVERIFY(action && action->isEnabled());
  action->trigger();
  close_menus(window);
}

void run_command(const QStringList& words) {
  QProcess program;
  program.start(QStringLiteral(LOOPMEND_PROGRAM), words);
  QVERIFY(program.waitForFinished(240000));
  QCOMPARE(program.exitCode(), 0);
}

}  // namespace

class ShapesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void holes_are_closed_as_the_table_says();
  void a_base_is_built_as_by_the_command();
  void a_plane_cuts_as_the_command_does();

 private:
  QTemporaryDir folder_;
};

void ShapesTest::holes_are_closed_as_the_table_says() {
  const QString scan = scan_file(folder_, QStringLiteral("ball.ply"), open_at_both_poles());
  const QString session = folder_.filePath(QStringLiteral("ball.loopmend"));
  const QString by_hand = folder_.filePath(QStringLiteral("by-hand.ply"));
  const QString by_script = folder_.filePath(QStringLiteral("by-script.ply"));
  {
    Shown window({scan});
    QCOMPARE(state_of(window, 0), QStringLiteral("open"));
    choose(window, 0, "closeAsFlat");
    QCOMPARE(state_of(window, 0), QStringLiteral("open, flat"));
    QVERIFY(state_of(window, 0, Qt::ToolTipRole).contains(QStringLiteral("Closed flat")));
    QVERIFY(entry(window, 0, "closeAsFlat")->isChecked());
    QVERIFY(!entry(window, 0, "closeAsAutomatic")->isChecked());
    QVERIFY(entry(window, 1, "closeAsAutomatic")->isChecked());
    close_menus(window);
    key(window, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(state_of(window, 0), QStringLiteral("open"));
    key(window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(state_of(window, 0), QStringLiteral("open, flat"));
    window.controller().save_session(session);
    QVERIFY(wait_idle(window));
  }
  Shown window({session});
  QVERIFY(wait_idle(window));
  const Document& document = window.document();
  QCOMPARE(state_of(window, 0), QStringLiteral("open, flat"));
  trigger(window, "cancelAction");  // nothing is selected
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  QCOMPARE(document.patches().size(), std::size_t(2));
  window.controller().export_to(by_hand);
  QVERIFY(wait_idle(window));
  const auto reach = [&](int loop) {
    const double up = document.loop(loop).center.z() > 0 ? 1 : -1;
    double most = 0;
    for (const Vec3& p : read_mesh(by_hand.toStdString()).soup.points) most = std::max(most, up * p.z());
    return most;
  };
  QVERIFY2(reach(0) < 0.83, "the first pole is flat");
  QVERIFY2(std::abs(reach(1) - 1) < 0.02, "the other one is a dome");
  run_command({QStringLiteral("fill"), scan, QStringLiteral("-o"), by_script, QStringLiteral("--loops"),
               QStringLiteral("1:flat,2")});
  QVERIFY2(sorted_points(by_hand) == sorted_points(by_script), "the window's vertices are not the command's");
  QVERIFY(command_line(document, {document.patches()[0].id, document.patches()[1].id})
              .text.contains(QStringLiteral("--loops 1:flat,2 ")));

  // Another choice makes the patch afresh, not from where it is.
  choose(window, 1, "closeAsTangent");
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  QCOMPARE(document.patch_of(1)->state->recipe.runs.size(), std::size_t(1));
  window.controller().export_to(by_hand);
  QVERIFY(wait_idle(window));
  run_command({QStringLiteral("fill"), scan, QStringLiteral("-o"), by_script, QStringLiteral("--loops"),
               QStringLiteral("1:flat,2:tangent")});
  QVERIFY2(sorted_points(by_hand) == sorted_points(by_script), "the window's vertices are not the command's");
}

void ShapesTest::a_base_is_built_as_by_the_command() {
  const QString scan = scan_file(folder_, QStringLiteral("bust.ply"),
                                 cut(make_icosphere(4), [](const Vec3& p) { return p.z() < -0.3 || p.z() > 0.95; }));
  Shown window({scan});
  const Document& document = window.document();
  choose(window, 1, "closeAsFlat");
  QVERIFY(entry(window, 0, "closeAsBase") != nullptr);
  close_menus(window);
  trigger(window, "closeAsBase");
  auto* dialog = window.findChild<QInputDialog*>(QStringLiteral("baseDialog"));
  QVERIFY(dialog);
  QVERIFY(std::abs(dialog->doubleValue() - 0.05 * document.loop(0).diameter) < 0.01);
  dialog->setDoubleValue(0.25);
  dialog->accept();
  QVERIFY(wait_idle(window));
  QVERIFY(!document.scan(0));
  QCOMPARE(document.scans().size(), std::size_t(1));
  const int left = document.first_loop_of(document.scans().front());
  QCOMPARE(document.loop_count(), left + 1);
  QVERIFY2(document.chosen_shape(left) == SeamContinuity::position, "the other loop keeps its shape");
  trigger(window, "selectAll");
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  const QString by_hand = folder_.filePath(QStringLiteral("base.ply"));
  const QString by_script = folder_.filePath(QStringLiteral("base-script.ply"));
  window.controller().export_to(by_hand);
  QVERIFY(wait_idle(window));
  QCOMPARE(watertightness(read_mesh(by_hand.toStdString()).soup).open_edges, std::size_t(0));
  run_command({QStringLiteral("fill"), scan, QStringLiteral("-o"), by_script, QStringLiteral("--base"),
               QStringLiteral("1:0.25"), QStringLiteral("--loops"), QStringLiteral("all:flat")});
  QFile ours(by_hand), theirs(by_script);
  QVERIFY(ours.open(QIODevice::ReadOnly) && theirs.open(QIODevice::ReadOnly));
  QVERIFY2(ours.readAll() == theirs.readAll(), "the window's file is not the command's");
  key(window, Qt::Key_Z, Qt::ControlModifier);
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QVERIFY2(document.scan(0) != nullptr, "undo brings the open scan back");
  QCOMPARE(document.chosen_shape(1), std::optional(SeamContinuity::position));
}

void ShapesTest::a_plane_cuts_as_the_command_does() {
  const QString scan = scan_file(folder_, QStringLiteral("ball.ply"), open_at_both_poles());
  Shown window({scan});
  const Document& document = window.document();
  trigger(window, "toolCutAction");
  QVERIFY(window.tools().panel()->tool() == Tool::cut);
  press(window, "cutZ");
  CutGuide& guide = window.tools().cut_guide();
  QVERIFY((guide.plane()->normal - Vec3::UnitZ()).norm() < 1e-12);
  press(window, "cutTurn");
  QVERIFY((guide.plane()->normal + Vec3::UnitZ()).norm() < 1e-12);
  // By hand: the blue dot moves the plane along its normal.
  press(window, "cutX");
  window.view().look_from(NamedView::front);
  QVERIFY(wait_until([&] { return !window.view().is_flying(); }));
  QVERIFY(settle());
  const Vec3 before = guide.plane()->point;
  const QPoint from = window.tools().cut().grip(PlaneTool::Handle::move, window.view().space()).toPoint();
  QWidget* canvas = window.view().canvas();
  QTest::mousePress(canvas, Qt::LeftButton, {}, from);
  for (int step = 1; step <= 4; ++step) {
    const QPoint at = from + QPoint(10 * step, 0);
    QMouseEvent move(QEvent::MouseMove, at, canvas->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(canvas, &move);
  }
  QTest::mouseRelease(canvas, Qt::LeftButton, {}, from + QPoint(40, 0));
  QVERIFY(guide.plane()->point.x() > before.x() + 0.05);
  MirrorPlane plane;
  plane.point = {0.1, 0, 0.2};
  plane.normal = Vec3(0, 1, 2).normalized();
  guide.move_plane(plane);
  press(window, "cutApply");
  QVERIFY(wait_idle(window));
  QVERIFY(!document.scan(0));
  trigger(window, "selectAll");
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  const QString by_hand = folder_.filePath(QStringLiteral("cut.ply"));
  const QString by_script = folder_.filePath(QStringLiteral("cut-script.ply"));
  window.controller().export_to(by_hand);
  QVERIFY(wait_idle(window));
  QStringList numbers;
  for (const Vec3* v : {&plane.point, &plane.normal})
    for (double x : *v) numbers << QString::number(x, 'g', 17);
  run_command({QStringLiteral("fill"), scan, QStringLiteral("-o"), by_script, QStringLiteral("--cut-plane"),
               numbers.join(QLatin1Char(','))});
  QFile ours(by_hand), theirs(by_script);
  QVERIFY(ours.open(QIODevice::ReadOnly) && theirs.open(QIODevice::ReadOnly));
  QVERIFY2(ours.readAll() == theirs.readAll(), "the window's file is not the command's");
  QCOMPARE(watertightness(read_mesh(by_hand.toStdString()).soup).open_edges, std::size_t(0));
  // What is cut with patches keeps them; each step is taken back by itself.
  plane.point.z() = -0.1;
  guide.move_plane(plane);
  press(window, "cutApply");
  QVERIFY(wait_idle(window));
  QVERIFY(document.patches().empty());
  const SurfaceModel& cut = *document.scan(document.scans().front())->model;
  QCOMPARE(watertightness(cut.soup).open_edges, std::size_t(0));
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(document.patches().size(), std::size_t(1));
  key(window, Qt::Key_Z, Qt::ControlModifier);
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(document.scan(0) != nullptr);
  // A plane beside the scan changes nothing, and says why.
  plane.point.z() = 9;
  guide.move_plane(plane);
  press(window, "cutApply");
  QVERIFY(wait_idle(window));
  QVERIFY(document.scan(0) != nullptr);
  QVERIFY(part<QLabel>(window, "bannerText")->text().contains(QStringLiteral("misses the surface")));
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<ShapesTest>(); }

#include "shapes_test.moc"
