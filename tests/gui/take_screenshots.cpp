// SPDX-License-Identifier: GPL-3.0-or-later
// Takes pictures of the real window, for people to judge and for the help pages: take_screenshots FILE FOLDER [light|dark [de]]
// Twice the size: QT_SCALE_FACTOR=2. See docs/user/window/make_pictures.sh.
#include "driver.h"

#include "compare/compare_controller.h"
#include "dialogs/repair_dialog.h"
#include "document/language.h"
#include "document/preferences.h"
#include "jobs/load_scan.h"
#include "samples/analytic_surfaces.h"
#include "samples/paper_inputs.h"
#include "support/mirror_models.h"
#include "support/sharp_surfaces.h"
#include "views/file_controller.h"
#include "views/tool_controller.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSlider>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QToolButton>

#include <algorithm>
#include <cstdio>
#include <cstring>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

QDir folder;

void save(const QPixmap& picture, const char* name) {
  picture.save(folder.filePath(QLatin1String(name) + QStringLiteral(".png")));
}

/// What the person would see: from the screen, composed.
void shoot(MainWindow& window, const char* name) {
  linger(350);
  window.view().canvas()->repaint();  // a slow renderer may not have drawn what was asked for
  save(window.screen()->grabWindow(0, window.x(), window.y(), window.width(), window.height()), name);
}

void shoot_part(MainWindow& window, QWidget* part, const char* name) {
  linger(350);
  const QPoint at = part->mapToGlobal(QPoint(0, 0));
  save(window.screen()->grabWindow(0, at.x(), at.y(), part->width(), part->height()), name);
}

void shoot_dialog(MainWindow& window, const char* action, const char* dialog, const char* name) {
  window.findChild<QAction*>(QLatin1String(action))->trigger();
  linger(400);
  auto* shown = window.findChild<QWidget*>(QLatin1String(dialog));
  if (!shown) return;
  shown->move(10, 10);
  linger(300);
  save(shown->grab(), name);
  shown->close();
  linger(100);
}

void trigger(MainWindow& window, const char* action) {
  window.findChild<QAction*>(QLatin1String(action), Qt::FindDirectChildrenOnly)->trigger();
}

void show_story(MainWindow& window, const QString& file) {
  shoot(window, "welcome");
  window.open(file);
  wait_idle(window);
  shoot(window, "opened");
  const int hole = first_hole(window.document());
  const QPoint at = visible_point(window, hole);
  if (at.x() >= 0) {
    shoot(window, "hover");
    QTest::mouseClick(window.view().canvas(), Qt::LeftButton, {}, at);
    QTest::mouseMove(window.view().canvas(), QPoint(20, 20));
    shoot(window, "selected");
  }
  window.selection().select({});
  press_and_wait(window, "fill");
  shoot(window, "filled");
  window.view().fly_to(hole);
  linger(800);
  window.selection().select({hole});
  part<QSlider>(window, "sigma")->setValue(-10);
  press(window, "run");
  constexpr int worth_seeing = 2;  // steps
  wait_until([&] { return window.document().patch_of(hole)->state->steps >= worth_seeing; });
  shoot(window, "running");
  window.controller().cancel();
  linger(200);
  window.selection().select({});
  while (window.undo().can_undo()) window.undo().undo();
  press_and_wait(window, "fillAndSmooth", 300);
  window.selection().select({hole});
  for (const char* fold : {"moreOfFill", "moreOfFlow"}) part<QToolButton>(window, fold)->setChecked(false);
  window.view().fly_to(hole);
  key(window, Qt::Key_T, Qt::ShiftModifier);  // no line shows where the patch is
  linger(1000);
  shoot(window, "window");
  key(window, Qt::Key_T, Qt::ShiftModifier);
  shoot_part(window, part<QDockWidget>(window, "holesDock"), "holes");
  auto* patch = part<QDockWidget>(window, "patchDock");
  for (QScrollArea* area : patch->findChildren<QScrollArea*>()) area->verticalScrollBar()->setValue(0);
  shoot_part(window, patch, "patch");
  press(window, "otherPatches");
  wait_until([&] { return !window.candidates().busy(); }, 300);
  shoot(window, "candidates");
  part<QDockWidget>(window, "candidatesDock")->close();
  auto* tabs = part<QTabWidget>(window, "inspectTabs");
  tabs->setCurrentIndex(1);
  shoot_part(window, part<QDockWidget>(window, "inspectDock"), "inspect");
  tabs->setCurrentIndex(2);
  shoot(window, "log");
  tabs->setCurrentIndex(0);
  press_and_wait(window, "fillAndSmooth", 300);
  shoot_part(window, part<QDockWidget>(window, "inspectDock"), "energy");
}

void show_looks(MainWindow& window) {
  part<QDockWidget>(window, "lookDock")->raise();
  shoot_part(window, part<QDockWidget>(window, "lookDock"), "display");
  trigger(window, "zebra");
  shoot(window, "zebra");
  trigger(window, "isophotes");
  shoot(window, "isophotes");
  trigger(window, "gaussian");
  QTest::mouseClick(window.view().canvas(), Qt::LeftButton, {}, window.view().canvas()->rect().center());
  shoot(window, "gaussian");
  trigger(window, "deviation");
  shoot(window, "likely_error");
  trigger(window, "plain");
  trigger(window, "wireframe");
  linger(1500);  // the graphics take their time over edges, the first time
  shoot(window, "wireframe");
  trigger(window, "wireframe");
  trigger(window, "clip");
  shoot(window, "clipped");
  trigger(window, "clip");
  trigger(window, "curvature");
  part<QDockWidget>(window, "patchDock")->raise();
}

void show_the_rest(MainWindow& window) {
  shoot_dialog(window, "shortcuts", "shortcutSheet", "shortcuts");
  shoot_dialog(window, "preferences", "preferencesDialog", "preferences");
  shoot_dialog(window, "screenshot", "pictureDialog", "picture");
  shoot_dialog(window, "help", "helpWindow", "help");
  window.close();  // asks in place
  shoot(window, "unsaved");
  window.controller().open({QStringLiteral("/nonexistent/scan.ply")}, OpenMode::replace);
  wait_idle(window);
  shoot(window, "error");
}

/// Any window of the program, from the screen.
void shoot_window(MainWindow& main, QWidget* window, const char* name) {
  linger(500);
  save(main.screen()->grabWindow(0, window->x(), window->y(), window->width(), window->height()), name);
}

void show_example(MainWindow& window, const TriangleSoup& soup, const QString& name) {
  window.controller().open_made({made_scan(soup, name, scene_origin(soup))});
  wait_idle(window);
  linger(300);
}

/// A hole on the side of a bump, where H is not the same all round.
TriangleSoup hole_beside_a_bump() {
  const Vec3 middle = Vec3(0.3, -0.5, 0.8).normalized();
  constexpr double radius = 0.3;
  return trim_boundaries(cut(test::BumpyEllipsoid().mesh(6), [&](const Vec3& p) {
    return ((test::BumpyEllipsoid::motion().inverse() * p).normalized() - middle).norm() < radius;
  }));
}

/// On a smooth surface: on the sample, with its relief, H jumps at every seam by as much as the relief itself.
void show_compare(MainWindow& window) {
  show_example(window, hole_beside_a_bump(), QStringLiteral("bumps"));
  window.selection().select({first_hole(window.document())});
  press_and_wait(window, "fillAndSmooth");
  trigger(window, "compare");
  auto* compare = window.findChild<CompareWindow*>(QStringLiteral("compareWindow"));
  if (!compare) return;
  compare->move(0, 0);
  compare->resize(window.screen()->size());
  auto* run = compare->findChild<QPushButton*>(QStringLiteral("compareRun"));
  wait_until([&] { return run->isEnabled(); });
  shoot_window(window, compare, "compare_start");
  compare->run();
  wait_until([&] { return run->isEnabled(); }, 300);
  shoot_window(window, compare, "compare");
  compare->findChild<QComboBox*>(QStringLiteral("compareShading"))->setCurrentIndex(3);
  compare->findChild<QCheckBox*>(QStringLiteral("compareWipe"))->setChecked(true);
  shoot_window(window, compare, "wipe");
  compare->close();
  linger(200);
}

void show_tools(MainWindow& window) {
  trigger(window, "toolRegionAction");
  QWidget* canvas = window.view().canvas();
  const QPoint middle = canvas->rect().center() + QPoint(-40, -30);
  QTest::mousePress(canvas, Qt::LeftButton, {}, middle);
  for (int step = 1; step <= 12; ++step) {
    const QPoint at = middle + QPoint(9 * step, 3 * (step % 5));
    QMouseEvent move(QEvent::MouseMove, at, canvas->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(canvas, &move);
  }
  QTest::mouseRelease(canvas, Qt::LeftButton, {}, middle + QPoint(108, 0));
  linger(1500);  // the graphics take their time over edges, the first time
  shoot(window, "region");
  press(window, "trialEvolve");
  wait_until([&] { return window.tools().trial().stage() == ProblemController::Stage::solved; }, 120);
  shoot(window, "region_done");
  trigger(window, "toolMeasureAction");
  for (const QPoint& at : {middle, middle + QPoint(120, 60)}) QTest::mouseClick(canvas, Qt::LeftButton, {}, at);
  shoot(window, "distance");
  window.tools().take(Tool::none);
}

void show_points(MainWindow& window) {
  show_example(window, make_dodecahedron(), QStringLiteral("dodecahedron"));
  trigger(window, "toolPointsAction");
  shoot(window, "points");
  press(window, "trialEvolve");
  wait_until([&] { return window.tools().trial().stage() == ProblemController::Stage::solved; }, 120);
  shoot(window, "points_done");
  window.tools().take(Tool::none);
}

void show_blend(MainWindow& window) {
  std::vector<OpenedScanPtr> parts;
  for (const TubeShape& tube : tee_tubes())
    parts.push_back(made_scan(make_tube(tube), QStringLiteral("tube %1").arg(parts.size() + 1), Vec3::Zero()));
  window.controller().open_made(parts);
  window.view().frame();
  trigger(window, "toolBlendAction");
  press(window, "blendFacing");
  auto* part = window.findChild<QComboBox*>(QStringLiteral("blendPart"));
  part->setCurrentIndex(2);
  Q_EMIT part->activated(2);
  shoot(window, "blend");
  press(window, "trialPreview");
  wait_until([&] { return window.tools().trial().stage() == ProblemController::Stage::posed; }, 60);
  shoot(window, "blend_preview");
  press(window, "trialEvolve");
  wait_until([&] { return window.tools().trial().stage() == ProblemController::Stage::solved; }, 120);
  shoot(window, "blend_done");
  window.tools().take(Tool::none);
}

/// The mouse between the two clicks.
void show_bridge(MainWindow& window) {
  TriangleSoup ball = make_icosphere(5);
  std::erase_if(ball.triangles, [&](const auto& triangle) {
    const auto cut_away = [&](int v) {
      const Vec3& p = ball.points[v];
      return p.z() > 0.75 && std::abs(p.y()) < 0.2 + 0.25 * p.x() * p.x();
    };
    return std::all_of(triangle.begin(), triangle.end(), cut_away);
  });
  show_example(window, ball, QStringLiteral("ball"));
  trigger(window, "toolBridgeAction");
  BridgeTool& tool = window.tools().bridge();
  const int last = window.document().loop_count() - 1, scan = window.document().scan_of(last);
  const BoundaryLoop loop = window.document().loop(last);
  const std::vector<int>& soup = window.document().scan(scan)->model->soup_vertex;
  QWidget* canvas = window.view().canvas();
  const auto position = [&](std::size_t k) {
    const int v = loop.vertices[k % loop.vertices.size()];
    return tool.position_of(scan, soup[v], window.view().space()).toPoint();
  };
  QTest::mouseClick(canvas, Qt::LeftButton, {}, position(0));
  const QPoint at = position(loop.vertices.size() / 4);
  QMouseEvent move(QEvent::MouseMove, at, canvas->mapToGlobal(at), Qt::NoButton, Qt::NoButton, {});
  QCoreApplication::sendEvent(canvas, &move);
  shoot(window, "bridge");
  trigger(window, "toolFillPartAction");
  QTest::mouseClick(canvas, Qt::LeftButton, {}, position(0));
  QCoreApplication::sendEvent(canvas, &move);
  shoot(window, "fill_part");
  QTest::mouseClick(canvas, Qt::LeftButton, {}, at);
  wait_until([&] { return !window.document().patches().empty() && !window.controller().busy(); }, 60);
  shoot(window, "fill_part_done");
  window.tools().take(Tool::none);
}

/// Two balls, filled; one of them hidden.
void show_guides(MainWindow& window) {
  show_example(window, cut(test::make_cube(16), [](const Vec3& p) { return (p - Vec3(1, 1, 0.5)).norm() < 0.3; }),
               QStringLiteral("cube"));
  window.selection().select({});
  fly(window, first_hole(window.document()));
  trigger(window, "toolEdgesAction");
  wait_until([&] { return !window.tools().edge_guide().busy(); });
  linger(500);
  shoot(window, "edges");
  show_example(window, test::BumpyEllipsoid().open_mesh(4), QStringLiteral("bumps"));
  trigger(window, "toolMirrorAction");
  wait_until([&] { return !window.tools().mirror_guide().busy() && !window.tools().mirror_guide().fits().empty(); });
  linger(1000);
  shoot(window, "mirror");
  window.tools().take(Tool::none);
}

void show_scene(MainWindow& window) {
  TriangleSoup small = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.85; });
  for (Vec3& p : small.points) p = 0.5 * p + Vec3(2, 0, 0.3);
  const TriangleSoup large = cut(make_icosphere(5), [](const Vec3& p) { return p.z() > 0.85 || p.y() < -0.93; });
  show_example(window, joined({large, small}), QStringLiteral("balls"));
  press_and_wait(window, "fillAndSmooth");
  part<QDockWidget>(window, "sceneDock")->raise();
  window.view().frame();
  shoot(window, "scene");
  window.visibility().set_pieces({PieceId{window.document().scans().front(), 1}}, SceneVisibility::Visible::hidden);
  shoot(window, "scene_hidden");
  shoot_part(window, part<QDockWidget>(window, "sceneDock"), "scene_list");
  const QPoint middle = window.view().canvas()->rect().center() + QPoint(-60, 0);
  QTest::mouseClick(window.view().canvas(), Qt::RightButton, {}, middle);
  shoot(window, "piece_menu");
  for (QMenu* menu : window.findChildren<QMenu*>(QStringLiteral("pieceMenu"))) menu->close();
  window.visibility().show_all();
  part<QDockWidget>(window, "holesDock")->raise();
}

/// A ball with a duplicate triangle, a fragment beside it, and a spike through its other side.
TriangleSoup faulty_ball() {
  TriangleSoup ball = make_icosphere(4);
  ball.triangles.push_back(ball.triangles.front());
  *std::max_element(ball.points.begin(), ball.points.end(),
                    [](const Vec3& a, const Vec3& b) { return a.z() < b.z(); }) = {0.02, 0.03, -1.3};
  const int fragment = static_cast<int>(ball.points.size());
  for (const Vec3& at : {Vec3(1.3, 0, 0), Vec3(1.31, 0, 0), Vec3(1.3, 0.01, 0)}) ball.points.push_back(at);
  ball.triangles.push_back({fragment, fragment + 1, fragment + 2});
  return ball;
}

void show_repair(MainWindow& window) {
  show_example(window, faulty_ball(), QStringLiteral("ball"));
  wait_until([&] { return window.print_check().result().has_value(); }, 60);
  shoot(window, "verdict");
  press(window, "repair");
  auto* repair = window.findChild<RepairDialog*>();
  if (!repair) return;
  wait_until([&] { return repair->findChild<QPushButton*>(QStringLiteral("repairAll"))->isEnabled(); }, 60);
  linger(300);
  save(repair->grab(), "repair");
  repair->close();
  QTimer::singleShot(1500, &window, [] {
    QWidget* dialog = QApplication::activeModalWidget();
    if (!dialog) return;
    save(dialog->grab(), "export");
    dialog->close();
  });
  window.findChild<FileController*>()->ask_export();
  linger(200);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("usage: take_screenshots FILE FOLDER [light|dark [de]]\n", stderr);
    return 2;
  }
  const QTemporaryDir home;
  use_own_home(home.path());
  prepare_application();
  QApplication application(argc, argv);
  settle_application();
  Preferences preferences;
  preferences.theme = argc > 3 && std::strcmp(argv[3], "dark") == 0 ? Theme::dark : Theme::light;
  save_preferences(preferences);
  if (argc > 4) install_language(QString::fromLatin1(argv[4]));
  folder = QDir(QString::fromLocal8Bit(argv[2]));
  folder.mkpath(QStringLiteral("."));
  MainWindow window;
  window.move(0, 0);
  window.show();
  if (!QTest::qWaitForWindowExposed(&window)) return 1;
  QApplication::setActiveWindow(&window);
  if (qEnvironmentVariableIsSet("LOOPMEND_SCENE_ONLY")) {
    show_scene(window);
    window.autosave().finish();
    return window.shut_down(std::chrono::seconds(20)) ? 0 : 1;
  }
  if (qEnvironmentVariableIsSet("LOOPMEND_TOOLS_ONLY")) {
    shoot(window, "welcome");
    window.open(QFileInfo(QString::fromLocal8Bit(argv[1])).absoluteFilePath());
    wait_idle(window);
    show_tools(window);
    show_compare(window);
    show_points(window);
    show_blend(window);
    show_bridge(window);
    show_guides(window);
    show_repair(window);
    window.autosave().finish();
    return window.shut_down(std::chrono::seconds(20)) ? 0 : 1;
  }
  show_story(window, QFileInfo(QString::fromLocal8Bit(argv[1])).absoluteFilePath());
  show_looks(window);
  show_tools(window);
  show_the_rest(window);
  show_compare(window);
  show_points(window);
  show_blend(window);
  show_bridge(window);
  show_guides(window);
  show_repair(window);
  show_scene(window);
  window.autosave().finish();
  return window.shut_down(std::chrono::seconds(20)) ? 0 : 1;
}
