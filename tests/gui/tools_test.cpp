// SPDX-License-Identifier: GPL-3.0-or-later
// Region, points and blend by mouse and keyboard, with the command line as their witness.
#include "driver.h"
#include "test_main.h"

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "jobs/load_scan.h"
#include "pipeline/hand_bridge.h"
#include "problems/paper_examples.h"
#include "samples/analytic_surfaces.h"
#include "samples/paper_inputs.h"
#include "views/tool_controller.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QFile>
#include <QLabel>
#include <QMouseEvent>
#include <QProcess>
#include <QPushButton>
#include <QRadioButton>
#include <QSpinBox>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <algorithm>
#include <cstdio>
#include <fstream>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

void drag(QWidget* widget, const QVector<QPoint>& way, Qt::KeyboardModifiers with = {}) {
  QTest::mousePress(widget, Qt::LeftButton, with, way.first());
  for (int k = 1; k < way.size(); ++k)
    for (int step = 1; step <= 3; ++step) {
      const QPoint at = way[k - 1] + (way[k] - way[k - 1]) * step / 3;
      QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, with);
      QApplication::sendEvent(widget, &move);
    }
  QTest::mouseRelease(widget, Qt::LeftButton, with, way.last());
  settle();
}

bool reach(MainWindow& window, ProblemController::Stage stage) {
  return wait_until([&] { return window.tools().trial().stage() == stage; }, 120);
}

bool run_program(const QStringList& arguments) {
  QProcess program;
  program.start(QStringLiteral(LOOPMEND_PROGRAM), arguments);
  return program.waitForFinished(240000) && program.exitCode() == 0;
}

TriangleSoup soup_of(const QString& path) { return read_mesh(path.toStdString()).soup; }

bool same(const TriangleSoup& a, const TriangleSoup& b) { return a.points == b.points && a.triangles == b.triangles; }

double farthest(const TriangleSoup& a, const TriangleSoup& b) {
  double most = a.points.size() == b.points.size() ? 0 : 1e300;
  for (std::size_t i = 0; i < std::min(a.points.size(), b.points.size()); ++i)
    most = std::max(most, (a.points[i] - b.points[i]).norm());
  return most;
}

const TriangleSoup& made(const MainWindow& window) {
  return window.document().scan(window.document().scans().back())->model->soup;
}

/// Runs what "Copy command line" leaves in the clipboard. @returns whether it succeeds.
bool run_copied(MainWindow& window) {
  press(window, "trialCopy");
  QString command = QGuiApplication::clipboard()->text();
  for (const char* verb : {"evolve", "interpolate", "blend"})
    command.replace(QStringLiteral("loopmend ") + QLatin1String(verb),
                    QStringLiteral(LOOPMEND_PROGRAM " ") + QLatin1String(verb));
  QProcess shell;
  shell.start(QStringLiteral("sh"), {QStringLiteral("-c"), command});
  return shell.waitForFinished(240000) && shell.exitCode() == 0;
}

QString banner_text(MainWindow& window) { return part<QLabel>(window, "bannerText")->text(); }

}  // namespace

class ToolsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_painted_region_is_that_of_the_command_line();
  void lasso_erase_grow_and_turning();
  void a_region_takes_patches_along();
  void points_of_a_polyhedron();
  void picked_points_and_a_box();
  void a_bridge_parts_a_hole_in_two();
  void boundaries_of_three_parts_are_joined();
  void a_part_is_placed_by_its_handle();
  void made_surfaces_survive_a_session();
  void the_gallery_opens_and_runs();
  void errors_are_said_in_place();
  void cancel_comes_back_at_once();

 private:
  QString file(const char* name, const TriangleSoup& soup) {
    const QString path = folder_.filePath(QLatin1String(name));
    if (!QFile::exists(path)) write_mesh(path.toStdString(), soup);
    return path;
  }
  QTemporaryDir folder_;
};

void ToolsTest::a_painted_region_is_that_of_the_command_line() {
  const QString bumps = file("bumps.ply", make_bumps());
  Shown window({bumps});
  const Document& document = window.document();
  key(window, Qt::Key_R);
  QVERIFY(!part<QPushButton>(window, "trialEvolve")->isEnabled());
  QWidget* canvas = window.view().canvas();
  const QImage bare = window.view().picture();
  const QPoint middle = canvas->rect().center();
  drag(canvas, {middle + QPoint(-60, 0), middle, middle + QPoint(60, 10)});
  const std::vector<int> painted = window.tools().region().vertices();
  QVERIFY2(painted.size() > 30, qPrintable(QString::number(painted.size())));
  QVERIFY(painted.size() < 3000);
  QVERIFY(picture_changes(window, bare, 0.002));

  press(window, "trialEvolve");
  QVERIFY(reach(window, ProblemController::Stage::solved));
  QVERIFY2(!window.close(), "the result is not accepted yet");
  press(window, "answerCancel");
  QVERIFY(document.scan(0) != nullptr);  // nothing has come into the document yet
  QVERIFY(run_copied(window));
  press(window, "trialAccept");
  QCOMPARE(document.scans(), std::vector<int>{1});
  QCOMPARE(window.isWindowModified(), true);
  QVERIFY(same(made(window), soup_of(folder_.filePath(QStringLiteral("bumps-fair.ply")))));

  const QString numbers = folder_.filePath(QStringLiteral("region.txt")),
                out = folder_.filePath(QStringLiteral("fair.ply"));
  {
    std::ofstream list(numbers.toStdString());
    for (int v : painted) list << v << '\n';
  }
  QVERIFY(
      run_program({QStringLiteral("evolve"), bumps, QStringLiteral("-o"), out, QStringLiteral("--region"), numbers}));
  QVERIFY(same(made(window), soup_of(out)));

  // The eye stays where it was; undo brings the old surface back.
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(document.scans(), std::vector<int>{0});
  key(window, Qt::Key_Y, Qt::ControlModifier);
  QCOMPARE(document.scans(), std::vector<int>{1});
}

void ToolsTest::lasso_erase_grow_and_turning() {
  Shown window({file("bumps.ply", make_bumps())});
  RegionTool& tool = window.tools().region();
  key(window, Qt::Key_R);
  QWidget* canvas = window.view().canvas();
  const QPoint m = canvas->rect().center();
  QTest::mouseClick(part<QRadioButton>(window, "regionLasso"), Qt::LeftButton);
  drag(canvas, {m + QPoint(-70, -50), m + QPoint(70, -50), m + QPoint(70, 50), m + QPoint(-70, 50)});
  const int inside = tool.count();
  QVERIFY(inside > 50);
  press(window, "regionGrow");
  QVERIFY(tool.count() > inside);
  const int grown = tool.count();
  press(window, "regionShrink");
  QVERIFY(tool.count() >= inside && tool.count() < grown);
  drag(canvas, {m + QPoint(-70, -50), m + QPoint(0, -50), m + QPoint(0, 50), m + QPoint(-70, 50)}, Qt::ControlModifier);
  const int half = tool.count();
  QVERIFY(half < 0.8 * inside && half > 0.2 * inside);
  const QImage before = window.view().picture();
  drag(canvas, {m, m + QPoint(60, 10)}, Qt::ShiftModifier);  // turns
  QCOMPARE(tool.count(), half);
  QVERIFY(picture_changes(window, before, 0.01));
  press(window, "regionClear");
  QCOMPARE(tool.count(), 0);
  key(window, Qt::Key_Escape);
  QVERIFY(window.tools().panel()->tool() == Tool::none);
}

void ToolsTest::a_region_takes_patches_along() {
  Shown window({file("ball.ply", cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.85; }))});
  QVERIFY(press_and_wait(window, "fill"));
  const std::size_t scan_points = window.document().scan(0)->model->soup.points.size();
  const Patch& patch = window.document().patches().front().state->patch;
  key(window, Qt::Key_R);
  std::vector<int> own;  // every new vertex of the patch
  for (int i = 0; i < patch.free_count; ++i) own.push_back(static_cast<int>(scan_points) + i);
  window.tools().region().set_vertices(0, own);
  QCOMPARE(window.tools().region().count(), patch.free_count);
  press(window, "trialEvolve");
  QVERIFY(reach(window, ProblemController::Stage::solved));
  press(window, "trialAccept");
  QVERIFY(window.document().patches().empty());
  QVERIFY(window.document().loops().size() == 1 && !window.document().present(0));
  for (const Vec3& p : made(window).points) QVERIFY(std::abs(p.norm() - 1) < 2e-3);  // the sphere is whole
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(window.document().patches().size(), std::size_t(1));
}

void ToolsTest::points_of_a_polyhedron() {
  const QString path = file("dodecahedron.ply", make_dodecahedron());
  Shown window({path});
  key(window, Qt::Key_I);
  press(window, "trialPreview");
  QVERIFY(reach(window, ProblemController::Stage::posed));
  QCOMPARE(window.tools().trial().free_vertices(), 1134);
  press(window, "trialEvolve");
  QVERIFY(reach(window, ProblemController::Stage::solved));
  QVERIFY(run_copied(window));
  press(window, "trialAccept");
  QVERIFY(same(made(window), soup_of(folder_.filePath(QStringLiteral("dodecahedron-smooth.ply")))));
  const QString out = folder_.filePath(QStringLiteral("ball_out.ply"));
  QVERIFY(run_program({QStringLiteral("interpolate"), path, QStringLiteral("-o"), out}));
  QVERIFY(same(made(window), soup_of(out)));
  for (const Vec3& p : made(window).points) QVERIFY(std::abs(p.norm() - 1) < 1e-3);
}

void ToolsTest::picked_points_and_a_box() {
  Shown window({file("dodecahedron.ply", make_dodecahedron())});
  key(window, Qt::Key_I);
  part<QRadioButton>(window, "pointsPicked")->click();
  PointsTool& tool = window.tools().points();
  QVERIFY(!part<QPushButton>(window, "trialEvolve")->isEnabled());
  QWidget* canvas = window.view().canvas();
  int clicked = -1;
  for (int v = 0; v < 20 && tool.count() == 0; ++v) {
    QTest::mouseClick(canvas, Qt::LeftButton, {}, tool.position_of(v, window.view().space()).toPoint());
    if (tool.count() == 1) clicked = v;
  }
  QVERIFY(clicked >= 0);
  QCOMPARE(tool.fixed(), std::vector<int>{clicked});
  const QPoint corner(2, 2);
  drag(canvas, {corner, QPoint(canvas->width() - 3, canvas->height() - 3)});
  QCOMPARE(tool.count(), 20);
  QTest::mouseClick(canvas, Qt::LeftButton, {}, tool.position_of(clicked, window.view().space()).toPoint());
  QCOMPARE(tool.count(), 19);
  QVERIFY(part<QPushButton>(window, "trialEvolve")->isEnabled());
  part<QSpinBox>(window, "pointsSubdivide")->setValue(2);
  press(window, "trialEvolve");
  QVERIFY(reach(window, ProblemController::Stage::solved));
}

void ToolsTest::a_bridge_parts_a_hole_in_two() {
  const QString path = file("ball.ply", cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; }));
  Shown window({path});
  window.view().frame();
  settle();
  key(window, Qt::Key_G);
  QVERIFY(window.tools().panel()->tool() == Tool::bridge);
  QVERIFY(!part<QPushButton>(window, "trialEvolve")->isVisible());
  const BoundaryLoop loop = window.document().loop(0);
  const SurfaceModel before = *window.document().scan(0)->model;
  const std::vector<int>& soup = before.soup_vertex;
  BridgeTool& tool = window.tools().bridge();
  QWidget* canvas = window.view().canvas();
  const auto click = [&](int vertex) {
    const QPointF at = tool.position_of(0, soup[vertex], window.view().space());
    QTest::mouseMove(canvas, at.toPoint());
    QTest::mouseClick(canvas, Qt::LeftButton, {}, at.toPoint());
  };
  // Esc forgets the first vertex, and then the tool. A click at a vertex behind the surface may take a visible one
  // beside it.
  const auto begun_at = [&](int vertex) { return tool.begun_point() == soup[vertex]; };
  const auto visible = [&](int vertex) {
    click(vertex);
    const bool taken = begun_at(vertex);
    if (tool.is_begun()) key(window, Qt::Key_Escape);
    return taken;
  };
  std::vector<int> seen;
  for (int v : loop.vertices)
    if (visible(v)) seen.push_back(v);
  QVERIFY(window.tools().panel()->tool() == Tool::bridge);
  QVERIFY(seen.size() > 8);
  const int a = seen.front(), b = seen[seen.size() / 2];
  click(a);
  QVERIFY(begun_at(a));
  click(b);
  QVERIFY(wait_idle(window));
  QCOMPARE(window.document().scans(), std::vector<int>{1});
  QCOMPARE(window.document().loop_count() - window.document().first_loop_of(1), 2);

  QVERIFY(same(made(window), with_bridge(before, soup[a], soup[b])));

  // One of the two holes alone can be filled.
  window.selection().select({window.document().first_loop_of(1)});
  QVERIFY(press_and_wait(window, "fill"));
  QCOMPARE(window.document().patches().size(), std::size_t(1));
  key(window, Qt::Key_Z, Qt::ControlModifier);
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(window.document().scans(), std::vector<int>{0});
  key(window, Qt::Key_Escape);
  QVERIFY(window.tools().panel()->tool() == Tool::none);
}

void ToolsTest::boundaries_of_three_parts_are_joined() {
  const std::vector<TubeShape> tubes = three_tubes();
  QStringList files;
  for (std::size_t k = 0; k < tubes.size(); ++k)
    files << file(qPrintable(QStringLiteral("tube%1.ply").arg(k + 1)), make_tube(tubes[k]));
  Shown window(files);
  key(window, Qt::Key_B);
  QVERIFY(!part<QPushButton>(window, "trialEvolve")->isEnabled());
  press(window, "blendFacing");
  QCOMPARE(window.selection().selected().size(), std::size_t(3));
  press(window, "trialPreview");
  QVERIFY(reach(window, ProblemController::Stage::posed));
  press(window, "trialEvolve");
  QVERIFY(reach(window, ProblemController::Stage::solved));
  QVERIFY(run_copied(window));
  press(window, "trialAccept");
  QCOMPARE(window.document().scans(), std::vector<int>{3});
  QVERIFY(same(made(window), soup_of(folder_.filePath(QStringLiteral("tube1-joined.ply")))));
  const QString out = folder_.filePath(QStringLiteral("joined.ply"));
  QVERIFY(run_program(QStringList{QStringLiteral("blend")} << files << QStringLiteral("-o") << out));
  QCOMPARE(made(window).triangles, soup_of(out).triangles);
  QCOMPARE(farthest(made(window), soup_of(out)), 0.0);
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(window.document().scans(), (std::vector<int>{0, 1, 2}));
}

void ToolsTest::a_part_is_placed_by_its_handle() {
  const std::vector<TubeShape> tubes = tee_tubes();
  Shown window({file("tee1.ply", make_tube(tubes[0])), file("tee2.ply", make_tube(tubes[1]))});
  window.view().frame();
  settle();
  key(window, Qt::Key_B);
  press(window, "blendFacing");
  const std::size_t chosen = window.selection().selected().size();
  auto* parts = part<QComboBox>(window, "blendPart");
  parts->setCurrentIndex(2);
  Q_EMIT parts->activated(2);
  PartTool& tool = window.tools().part();
  QCOMPARE(tool.scan(), 1);
  const auto middle = [&] {
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : made(window).points) sum += p;
    return Vec3(sum / static_cast<double>(made(window).points.size()));
  };
  QWidget* canvas = window.view().canvas();
  const auto pull = [&](PartTool::Handle handle, const QPoint& by) {
    const QPoint from = tool.grip(handle, window.view().space()).toPoint();
    const std::size_t scans = window.document().scans().size();
    const int newest = window.document().scans().back();
    drag(canvas, {from, from + by});
    return wait_until([&] { return window.document().scans().back() != newest; }) &&
           window.document().scans().size() == scans;
  };
  const Vec3 before = middle();
  QVERIFY(pull(PartTool::Handle::slide, QPoint(30, 12)));
  QVERIFY((middle() - before).norm() > 0.05);
  QCOMPARE(window.selection().selected().size(), chosen);  // the boundaries are still selected
  const Vec3 slid = middle();
  const double across = (made(window).points.front() - slid).norm();
  QVERIFY(pull(PartTool::Handle::scale, QPoint(30, -30)));
  QVERIFY((made(window).points.front() - middle()).norm() > 1.1 * across);
  const Vec3 arm = made(window).points.front() - middle();
  const QPointF about = tool.grip(PartTool::Handle::slide, window.view().space());
  const QPointF at = tool.grip(PartTool::Handle::turn_z, window.view().space()) - about;
  QVERIFY(pull(PartTool::Handle::turn_z, QPoint(qRound(-0.5 * at.y()), qRound(0.5 * at.x()))));  // square to its arm
  const Vec3 turned = made(window).points.front() - middle();
  QVERIFY(std::abs(turned.norm() - arm.norm()) < 1e-6 * arm.norm());
  QVERIFY((turned - arm).norm() > 0.02 * arm.norm());
  QVERIFY(std::abs(turned.z() - arm.z()) < 1e-6 * arm.norm());
  for (int k = 0; k < 3; ++k) key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(window.document().scans(), (std::vector<int>{0, 1}));
}

void ToolsTest::made_surfaces_survive_a_session() {
  const QString session = folder_.filePath(QStringLiteral("work.loopmend"));
  TriangleSoup kept;
  {
    Shown shown({file("dodecahedron.ply", make_dodecahedron())});
    key(shown, Qt::Key_I);
    part<QSpinBox>(shown, "pointsSubdivide")->setValue(2);
    press(shown, "trialEvolve");
    QVERIFY(reach(shown, ProblemController::Stage::solved));
    press(shown, "trialAccept");
    kept = made(shown);
    shown.controller().save_session(session);
    QVERIFY(wait_idle(shown));
    QVERIFY(!shown.isWindowModified());
  }
  Shown shown({session});
  QCOMPARE(shown.document().scans().size(), std::size_t(1));
  QVERIFY(same(made(shown), kept));
  QVERIFY(count_colors(shown.view().picture()) >= 40);
}

void ToolsTest::the_gallery_opens_and_runs() {
  Shown window;
  for (const PaperExample& example : paper_examples()) {
    auto* button = part<QToolButton>(window, qPrintable(QStringLiteral("example_") + QLatin1String(example.id)));
    QVERIFY2(button && !button->icon().isNull() && !button->toolTip().isEmpty(), example.id);
  }
  // One click opens, a second runs: a surface through points, ...
  QTest::mouseClick(part<QToolButton>(window, "example_fig5.4"), Qt::LeftButton);
  QVERIFY(wait_until([&] { return window.document().has_scan(); }));
  QVERIFY(!window.isWindowModified());
  settle();
  press(window, "exampleRun");
  QVERIFY(reach(window, ProblemController::Stage::solved));
  press(window, "trialAccept");
  QVERIFY(window.isWindowModified());
  // ... and holes, by the paper's scheme.
  Shown other;
  QTest::mouseClick(part<QToolButton>(other, "example_fig5.1a"), Qt::LeftButton);
  QVERIFY(wait_until([&] { return other.document().has_scan(); }));
  settle();
  press(other, "exampleRun");
  QVERIFY(wait_until(
      [&] {
        const auto& patches = other.document().patches();
        return patches.size() == 3 && std::all_of(patches.begin(), patches.end(), [](const OpenPatch& patch) {
                 return patch.state->status == PatchStatus::converged;
               });
      },
      120));
}

void ToolsTest::errors_are_said_in_place() {
  Shown window({file("closed.ply", make_icosphere(2))});
  key(window, Qt::Key_R);
  std::vector<int> all;
  for (std::size_t v = 0; v < made(window).points.size(); ++v) all.push_back(static_cast<int>(v));
  window.tools().region().set_vertices(0, all);
  press(window, "trialEvolve");
  QVERIFY(reach(window, ProblemController::Stage::none));
  QVERIFY2(banner_text(window).contains(QStringLiteral("whole piece")), qPrintable(banner_text(window)));
  key(window, Qt::Key_Escape);
  key(window, Qt::Key_B);
  QVERIFY(!part<QPushButton>(window, "trialEvolve")->isEnabled());
  QVERIFY(part<QLabel>(window, "trialWords")->text().contains(QStringLiteral("two boundaries")));
}

void ToolsTest::cancel_comes_back_at_once() {
  Shown window({file("bumps.ply", make_bumps())});
  key(window, Qt::Key_R);
  std::vector<int> high;
  for (std::size_t v = 0; v < made(window).points.size(); ++v)
    if (made(window).points[v].z() > 0.2) high.push_back(static_cast<int>(v));
  window.tools().region().set_vertices(0, high);
  press(window, "trialEvolve");
  QVERIFY(reach(window, ProblemController::Stage::evolving));
  QElapsedTimer clock;
  clock.start();
  window.tools().trial().cancel();
  QVERIFY(window.tools().trial().stage() == ProblemController::Stage::posed);
  std::printf("cancel: %lld ms\n", static_cast<long long>(clock.elapsed()));
  press(window, "trialDiscard");
  QVERIFY(window.tools().trial().stage() == ProblemController::Stage::none);
  QVERIFY(window.tools().shut_down(std::chrono::minutes(4)));
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<ToolsTest>(); }

#include "tools_test.moc"
