// SPDX-License-Identifier: GPL-3.0-or-later
// The tools for sharp edges across holes and for the mirror image, by mouse and keyboard, with the command line as their witness.
#include "driver.h"
#include "test_main.h"

#include "io/read_mesh.h"
#include "samples/analytic_surfaces.h"
#include "support/mirror_models.h"
#include "support/sharp_surfaces.h"
#include "views/tool_controller.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QMouseEvent>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace loopmend;
using namespace loopmend::testing;

class GuidesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void edges_are_seen_removed_and_drawn();
  void a_mirror_image_is_seen_and_copied();

 private:
  /// Runs the command that the window copies. @returns whether what it writes is what the window exports.
  bool command_makes_the_same(MainWindow& window, const QString& option, const QString& written);
  QTemporaryDir folder_;
};

bool GuidesTest::command_makes_the_same(MainWindow& window, const QString& option, const QString& written) {
  const QString by_hand = folder_.filePath(QStringLiteral("by_hand.ply"));
  window.controller().export_to(by_hand);
  if (!wait_idle(window)) return false;
  press(window, "copyCommand");
  QString command = QGuiApplication::clipboard()->text();
  QProcess shell;
  shell.setWorkingDirectory(folder_.path());
  shell.start(QStringLiteral("sh"), {QStringLiteral("-c"), command.replace(QStringLiteral("loopmend fill"),
                                                                           QStringLiteral(LOOPMEND_PROGRAM " fill"))});
  if (!shell.waitForFinished(240000) || shell.exitCode() != 0) return false;
  const auto soup_of = [](const QString& file) { return read_mesh(file.toStdString()).soup; };
  const TriangleSoup made = soup_of(by_hand), of_command = soup_of(folder_.filePath(written));
  return command.contains(option) && made.points == of_command.points && made.triangles == of_command.triangles;
}

/// The command that the window copies makes the same patch.
void GuidesTest::edges_are_seen_removed_and_drawn() {
  const TriangleSoup cube = test::make_cube(16);
  const QString path = scan_file(folder_, QStringLiteral("cube.ply"),
                                 cut(cube, [](const Vec3& p) { return (p - Vec3(1, 1, 0.5)).norm() < 0.3; }));
  Shown window({path});
  QVERIFY(fly(window, 0));
  key(window, Qt::Key_E, Qt::ShiftModifier);
  QVERIFY(window.tools().panel()->tool() == Tool::edges);
  const EdgeGuide& guide = window.tools().edge_guide();
  using Kind = EdgeGuide::Edge::Kind;
  QVERIFY(wait_until([&] { return !guide.busy() && guide.edges().size() == 1; }));
  for (const Vec3& p : guide.edges()[0].line) {
    const Vec3 at = p + window.document().origin();
    QVERIFY(std::abs(at.x() - 1) < 1e-9 && std::abs(at.y() - 1) < 1e-9);
  }
  const int begin = guide.edges()[0].begin, end = guide.edges()[0].end;
  EdgesTool& tool = window.tools().edges();
  QWidget* canvas = window.view().canvas();
  const auto click = [&](const QPointF& at) {
    QTest::mouseMove(canvas, at.toPoint());
    QTest::mouseClick(canvas, Qt::LeftButton, {}, at.toPoint());
  };
  const auto fill = [&] {
    window.selection().select({0});
    press(window, "fillAndSmooth");
    return wait_idle(window);
  };
  const auto by_edges = [&] { return window.document().patches().front().state->method == Method::sharp_edges; };

  // Removed: the command stops the edge, too.
  click(tool.middle_of(0, window.view().space()));
  QVERIFY(wait_until([&] { return !guide.busy() && guide.edges().empty(); }));
  QVERIFY(fill());
  QVERIFY(!by_edges());
  QVERIFY(command_makes_the_same(window, QStringLiteral("--stop-edge"), QStringLiteral("cube-filled.ply")));
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(window.document().patches().empty());

  // Drawn again between its ends.
  for (int soup_point : {begin, end}) click(tool.position_of(0, soup_point, window.view().space()));
  QVERIFY(wait_until([&] { return !guide.busy() && guide.edges().size() == 1; }));
  QVERIFY(guide.edges()[0].kind == Kind::drawn);
  QVERIFY(fill());
  QVERIFY(by_edges());
  key(window, Qt::Key_Z, Qt::ControlModifier);

  press(window, "edgesRestore");
  QVERIFY(wait_until([&] { return !guide.busy() && guide.edges().size() == 1; }));
  QVERIFY(guide.edges()[0].kind == Kind::continued);
}

void GuidesTest::a_mirror_image_is_seen_and_copied() {
  const test::BumpyEllipsoid model;
  Shown window({scan_file(folder_, QStringLiteral("bumps.ply"), model.open_mesh(4))});
  key(window, Qt::Key_M, Qt::ShiftModifier);
  QVERIFY(window.tools().panel()->tool() == Tool::mirror);
  const MirrorGuide& guide = window.tools().mirror_guide();
  QVERIFY(wait_until([&] { return !guide.busy() && guide.fits().size() == 1; }));
  QVERIFY(std::abs(guide.plane()->normal.dot(model.plane_normal())) > 0.9999);
  QVERIFY(guide.fits()[0].fit.is_proposed());
  QVERIFY(guide.fits()[0].ghost);

  // It can be dragged; planes that were found come back, and only the best one has something to copy.
  const MirrorPlane found = *guide.plane();
  PlaneTool& tool = window.tools().mirror();
  QWidget* canvas = window.view().canvas();
  const QPoint from = tool.grip(PlaneTool::Handle::turn_first, window.view().space()).toPoint();
  QTest::mousePress(canvas, Qt::LeftButton, {}, from);
  for (int step = 1; step <= 4; ++step) {
    const QPoint at = from + QPoint(15 * step, 9 * step);
    QMouseEvent move(QEvent::MouseMove, at, canvas->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(canvas, &move);
  }
  QTest::mouseRelease(canvas, Qt::LeftButton, {}, from + QPoint(60, 36));
  QVERIFY(guide.plane()->normal.dot(found.normal) < 0.999);
  QVERIFY(wait_until([&] { return !guide.busy() && guide.fits().size() == 1; }));
  auto* planes = part<QComboBox>(window, "mirrorPlane");
  QCOMPARE(planes->count(), static_cast<int>(guide.planes().size()) + 1);
  QVERIFY(guide.planes().size() > 1);
  Q_EMIT planes->activated(1);
  QVERIFY(wait_until([&] { return !guide.busy() && guide.fits().size() == 1; }));
  QVERIFY(!guide.fits()[0].fit.is_proposed() && !guide.fits()[0].ghost);
  Q_EMIT planes->activated(0);
  QVERIFY(wait_until([&] { return !guide.busy() && guide.fits().size() == 1 && guide.fits()[0].fit.is_proposed(); }));
  QCOMPARE(guide.plane()->normal, found.normal);

  part<QCheckBox>(window, "mirrorUse")->setChecked(true);
  window.selection().select({0});
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  QVERIFY(window.document().patches().front().state->method == Method::mirror_image);
  QVERIFY(command_makes_the_same(window, QStringLiteral("--mirror-plane"), QStringLiteral("bumps-filled.ply")));
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<GuidesTest>(); }

#include "guides_test.moc"
