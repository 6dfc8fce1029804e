// SPDX-License-Identifier: GPL-3.0-or-later
// The tool for sharp edges across holes, by mouse and keyboard, with the command line as its witness.
#include "driver.h"
#include "test_main.h"

#include "io/read_mesh.h"
#include "samples/analytic_surfaces.h"
#include "support/sharp_surfaces.h"
#include "views/tool_controller.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using namespace loopmend;
using namespace loopmend::testing;

class EdgesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void edges_are_seen_removed_and_drawn();

 private:
  QTemporaryDir folder_;
};

/// The command that the window copies makes the same patch.
void EdgesTest::edges_are_seen_removed_and_drawn() {
  const TriangleSoup cube = test::make_cube(16);
  const QString path = scan_file(folder_, QStringLiteral("cube.ply"),
                                 cut(cube, [](const Vec3& p) { return (p - Vec3(1, 1, 0.5)).norm() < 0.3; }));
  Shown shown({path});
  MainWindow& window = shown.window;
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
  const QString by_hand = folder_.filePath(QStringLiteral("by_hand.ply"));
  window.controller().export_to(by_hand);
  QVERIFY(wait_idle(window));
  press(window, "copyCommand");
  QString command = QGuiApplication::clipboard()->text();
  QVERIFY2(command.contains(QStringLiteral("--stop-edge")), qPrintable(command));
  QProcess shell;
  shell.setWorkingDirectory(folder_.path());
  shell.start(QStringLiteral("sh"),
              {QStringLiteral("-c"),
               command.replace(QStringLiteral("loopmend fill"), QStringLiteral(LOOPMEND_PROGRAM " fill"))});
  QVERIFY(shell.waitForFinished(240000));
  QCOMPARE(shell.exitCode(), 0);
  const auto soup_of = [](const QString& file) { return read_mesh(file.toStdString()).soup; };
  const TriangleSoup made = soup_of(by_hand), of_command = soup_of(folder_.filePath(QStringLiteral("cube-filled.ply")));
  QVERIFY(made.points == of_command.points && made.triangles == of_command.triangles);
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

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<EdgesTest>(); }

#include "edges_test.moc"
