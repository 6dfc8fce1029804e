// SPDX-License-Identifier: GPL-3.0-or-later
// Whole stories, told to the real window by mouse and keyboard: fill one hole by eye; fill all small holes of a scan;
// crash and recover; the same by a script; another day; several scans.
#include "driver.h"
#include "test_main.h"

#include "document/targets.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "panels/banner.h"
#include "samples/analytic_surfaces.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QSlider>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <csignal>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

const QString plane_holes = QStringLiteral(LOOPMEND_SHARED_DIR "/data/plane_holes.obj");

int filled(const Document& document) {
  int count = 0;
  for (int loop = 0; loop < document.loop_count(); ++loop) count += document.patch_of(loop) != nullptr;
  return count;
}

}  // namespace

class StoryTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void one_hole_by_eye();
  void all_small_holes_and_undo();
  void many_holes();
  void one_large_hole_tells_the_time_left();
  void crash_and_recover();
  void command_line_repeats_the_window();
  void session_keeps_everything();
  void a_session_without_its_scan_is_told_where_it_is();
  void several_scans_are_one_scene();

 private:
  QTemporaryDir folder_;
};

void StoryTest::one_hole_by_eye() {
  Shown window({sample_file(folder_)});
  QVERIFY(window.exposed && window.ready);
  const Document& document = window.document();
  QVERIFY(count_colors(window.view().picture()) >= 64);

  // Find a hole by eye: N flies to the first one; hover it, click it.
  key(window, Qt::Key_N);
  QVERIFY(settle());
  const int loop = *window.selection().selected().begin();
  key(window, Qt::Key_Escape);
  QVERIFY(window.selection().selected().empty());
  const QPoint at = visible_point(window, loop);
  QVERIFY2(at.x() >= 0, "the rim cannot be hovered");
  QTest::mouseClick(window.view().canvas(), Qt::LeftButton, {}, at);
  QCOMPARE(window.selection().selected(), std::set<int>{loop});
  QTest::mouseMove(window.view().canvas(), QPoint(3, 3));

  // Preview another density: the picture changes, the document does not.
  settle();
  const QImage bare = window.view().picture();
  QTest::mouseClick(part<QCheckBox>(window, "preview"), Qt::LeftButton, {}, QPoint(8, 8));
  part<QDoubleSpinBox>(window, "density")->setValue(1.5);
  QVERIFY(picture_changes(window, bare, 0.003));
  QVERIFY(document.patches().empty());

  // Fill, step twice, run and pause, by keys.
  key(window, Qt::Key_F, Qt::ControlModifier | Qt::ShiftModifier);
  QVERIFY(wait_idle(window));
  QCOMPARE(document.patches().size(), std::size_t(1));
  QVERIFY(document.patch_of(loop)->state->recipe.density == 1.5);
  part<QSlider>(window, "sigma")->setValue(-15);
  for (int step = 1; step <= 2; ++step) {
    key(window, Qt::Key_S);
    QVERIFY(wait_idle(window));
    QCOMPARE(document.patch_of(loop)->state->steps, step);
  }
  key(window, Qt::Key_Space);
  QVERIFY(wait_until([&] { return document.patch_of(loop)->state->steps >= 4; }));
  key(window, Qt::Key_Space);
  QVERIFY(wait_idle(window));
  const PatchStatePtr reached = document.patch_of(loop)->state;
  QVERIFY(document.patch_of(loop)->timeline->size() >= 3);

  // Back along the timeline by keys, then undone.
  auto* timeline = part<QSlider>(window, "timeline");
  timeline->setFocus();
  QTest::keyClick(timeline, Qt::Key_Home);
  QCOMPARE(document.patch_of(loop)->state->steps, 0);
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(document.patch_of(loop)->state == reached);

  // To rest; the seam is better than the initial patch's; accept.
  key(window, Qt::Key_T);
  QVERIFY(wait_idle(window, 240));
  const OpenPatch& done = *document.patch_of(loop);
  QVERIFY(is_at_end(done.state->status));
  QVERIFY(done.state->seams.front().h_jump_rms < done.state->seams_before.front().h_jump_rms);
  key(window, Qt::Key_A);
  QVERIFY(document.state(loop) == HoleState::accepted);
  QVERIFY(!part<QPushButton>(window, "run")->isEnabled());
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(document.state(loop) != HoleState::accepted);
  key(window, Qt::Key_Delete);
  QVERIFY(document.patch_of(loop) == nullptr);
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(document.patch_of(loop) != nullptr);
}

void StoryTest::all_small_holes_and_undo() {
  if (!QFile::exists(plane_holes)) QSKIP("plane_holes.obj is not in the shared folder");
  Shown window({plane_holes});
  const Document& document = window.document();
  const int all = open_holes(document);
  QVERIFY(all >= 20);
  settle();
  const QImage before = window.view().picture();
  const Viewpoint from = window.view().viewpoint();

  // All but the largest: one edge less than it has.
  int largest = 0;
  for (const BoundaryLoop& loop : document.loops())
    if (loop.kind == LoopKind::hole) largest = std::max(largest, loop.edges());
  part<QDoubleSpinBox>(window, "sizeLimit")->setValue(largest - 1);
  const int meant = static_cast<int>(loops_up_to(document, SizeMeasure::edges, largest - 1).size());
  QVERIFY(meant > 0 && meant < all);
  QVERIFY(part<QPushButton>(window, "fillUpTo")->text().contains(QString::number(meant)));
  QVERIFY(press_and_wait(window, "fillUpTo", 240));
  QCOMPARE(filled(document), meant);
  QCOMPARE(open_holes(document), all - meant);
  QVERIFY(picture_changes(window, before, 0.003));
  window.controller().export_to(folder_.filePath(QStringLiteral("most.ply")));
  QVERIFY(wait_idle(window));
  const SurfaceModel written =
      make_surface_model(read_mesh(folder_.filePath(QStringLiteral("most.ply")).toStdString()).soup);
  QCOMPARE(find_boundary_loops(written).size(), document.loops().size() - static_cast<std::size_t>(meant));

  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(filled(document), 0);
  QCOMPARE(open_holes(document), all);
  window.view().set_viewpoint(from);  // the fill may have turned the view to a filled hole
  QVERIFY2(picture_returns(window, before), "the holes are not open again");
  QVERIFY(!part<QAction>(window, "undo")->isEnabled());
}

void StoryTest::many_holes() {
  const int across = at_length() ? 32 : 10;  // 1024 holes, or 100
  Shown window({write_sheet_with_holes(folder_.filePath(QStringLiteral("sheet.ply")), across)});
  const Document& document = window.document();
  QCOMPARE(document.loop_count(), across * across + 1);
  QCOMPARE(open_holes(document), across * across);  // the boundary is left out
  GapMeter gaps;
  key(window, Qt::Key_A, Qt::ControlModifier);
  QCOMPARE(static_cast<int>(window.selection().selected().size()), across * across);
  settle();
  gaps.report("many holes: select all");
  QTest::mouseMove(window.view().canvas(), window.view().position_of(across * across - 24, 0));
  settle();
  gaps.report("many holes: hover");
  QStringList left;
  const auto* time_left = window.findChild<QLabel*>(QStringLiteral("timeLeft"));
  const auto listening = connect(&window.controller(), &FillController::share_done, this, [&](double share) {
    if (share < 1 && !time_left->text().isEmpty()) left << time_left->text();
  });
  QVERIFY(press_and_wait(window, "fill", 300));
  disconnect(listening);
  QVERIFY(time_left->text().isEmpty());
  const QRegularExpression pattern(QStringLiteral("^about \\d+ (s|min) left$"));
  QVERIFY2(std::all_of(left.begin(), left.end(), [&](const QString& text) { return pattern.match(text).hasMatch(); }),
           qPrintable(left.join(QLatin1Char('\n'))));
  if (at_length()) QVERIFY(!left.isEmpty());
  settle();
  gaps.report("many holes: fill");
  key(window, Qt::Key_Escape);
  QCOMPARE(filled(document), across * across);
  part<QLineEdit>(window, "holesFilter")->setText(QStringLiteral("77"));
  settle();
  gaps.report("many holes: filter");
  QCOMPARE(part<QTableView>(window, "holesTable")->model()->rowCount(), 1);
  part<QLineEdit>(window, "holesFilter")->clear();
  part<QTableView>(window, "holesTable")->sortByColumn(1, Qt::DescendingOrder);
  settle();
  gaps.report("many holes: sort");
  key(window, Qt::Key_Z, Qt::ControlModifier);
  settle();
  gaps.report("many holes: undo");
  QCOMPARE(filled(document), 0);
}

/// By the vertices at first, then by the time that the initial patch and the steps took.
void StoryTest::one_large_hole_tells_the_time_left() {
  const int level = at_length() ? 7 : 5;
  Shown window({scan_file(folder_, QStringLiteral("half.ply"),
                          cut(make_icosphere(level), [](const Vec3& p) { return p.z() > 0.5; }))});
  std::vector<double> expected;
  QStringList left;
  const auto* time_left = window.findChild<QLabel*>(QStringLiteral("timeLeft"));
  const auto listening = connect(&window.controller(), &FillController::seconds_left, this, [&](double seconds) {
    expected.push_back(seconds);
    if (!time_left->text().isEmpty()) left << time_left->text();
  });
  QVERIFY(press_and_wait(window, "fillAndSmooth", 800));
  disconnect(listening);
  QVERIFY(expected.size() >= 3);  // at the start, with the initial patch, at each step
  QVERIFY(std::all_of(expected.begin(), expected.end(), [](double seconds) { return seconds > 0; }));
  const QRegularExpression pattern(QStringLiteral("^about \\d+ (s|min) left$"));
  QVERIFY2(std::all_of(left.begin(), left.end(), [&](const QString& text) { return pattern.match(text).hasMatch(); }),
           qPrintable(left.join(QLatin1Char('\n'))));
  QVERIFY(time_left->text().isEmpty());
}

void StoryTest::crash_and_recover() {
  const QString scan = sample_file(folder_);
  QProcess victim;
  victim.setProcessChannelMode(QProcess::SeparateChannels);
  victim.start(QCoreApplication::applicationFilePath(), {QStringLiteral("--victim"), scan});
  QVERIFY(victim.waitForStarted());
  QVERIFY(wait_until([&] { return victim.readAllStandardOutput().contains("saved"); }));
  QCOMPARE(::kill(static_cast<pid_t>(victim.processId()), SIGKILL), 0);
  QVERIFY(victim.waitForFinished());

  Shown window;
  window.offer_recovery();
  auto* banner = part<Banner>(window, "banner");
  QVERIFY(banner->isVisible());
  QVERIFY2(banner->text().contains(QStringLiteral("sample.ply")), qPrintable(banner->text()));
  // As when the program is started with a file: the offer stays.
  window.open(scan);
  QVERIFY(wait_idle(window));
  QVERIFY2(banner->isVisible() && banner->text().contains(QStringLiteral("sample.ply")), qPrintable(banner->text()));
  QVERIFY(press_and_wait(window, "answerRecover"));
  QCOMPARE(window.document().patches().size(), std::size_t(1));
  const int hole = first_hole(window.document());
  QVERIFY(window.document().patch_of(hole) != nullptr);
  QVERIFY2(window.isWindowModified(), "recovered work is in no file yet");
  settle();
  QVERIFY(count_colors(window.view().picture()) >= 64);
  QVERIFY2(wait_until([] { return Autosave::leftovers().empty(); }), "what was recovered must not be offered again");
  QVERIFY2(QFile::exists(window.autosave().path()), "recovered work must be safe from the next crash at once");
  // It can be worked on.
  window.selection().select({hole});
  QVERIFY(press_and_wait(window, "fillAndSmooth", 240));
  QVERIFY(window.document().patch_of(hole)->state->steps > 0);
}

void StoryTest::command_line_repeats_the_window() {
  const QString scan = sample_file(folder_);
  Shown window({scan});
  QVERIFY(press_and_wait(window, "fill"));
  QVERIFY(press_and_wait(window, "fillAndSmooth", 300));
  // One of them by another flow, in steps.
  window.selection().select({1});
  press(window, "reject");
  QVERIFY(press_and_wait(window, "fill"));
  part<QComboBox>(window, "flow")->setCurrentIndex(1);
  part<QSlider>(window, "sigma")->setValue(0);
  for (int step = 0; step < 3; ++step) {
    QVERIFY(press_and_wait(window, "step"));
  }
  window.selection().select({});
  const QString by_hand = folder_.filePath(QStringLiteral("by-hand.ply"));
  window.controller().export_to(by_hand);
  QVERIFY(wait_idle(window));
  press(window, "copyCommand");
  const QString command = QGuiApplication::clipboard()->text();
  QVERIFY2(command.contains(QStringLiteral("--flow wf --mode steps")), qPrintable(command));
  QProcess shell;
  QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
  environment.insert(QStringLiteral("PATH"), QFileInfo(QStringLiteral(LOOPMEND_PROGRAM)).path() + QLatin1Char(':') +
                                                 environment.value(QStringLiteral("PATH")));
  shell.setProcessEnvironment(environment);
  shell.start(QStringLiteral("sh"), {QStringLiteral("-e"), QStringLiteral("-c"), command});
  QVERIFY(shell.waitForFinished(300000));
  QVERIFY2(shell.exitCode() == 0, shell.readAllStandardError().constData());
  const TriangleSoup ours = read_mesh(by_hand.toStdString()).soup;
  const TriangleSoup theirs = read_mesh(folder_.filePath(QStringLiteral("sample-filled.ply")).toStdString()).soup;
  QCOMPARE(ours.points.size(), theirs.points.size());
  QCOMPARE(ours.triangles.size(), theirs.triangles.size());
  // Patches may come in another order; every vertex must be there, to the last bit.
  const auto sorted = [](Points points) {
    std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    });
    return points;
  };
  QVERIFY2(sorted(ours.points) == sorted(theirs.points), "window and command line do not give the same vertices");
}

void StoryTest::session_keeps_everything() {
  const QString path = folder_.filePath(QStringLiteral("work.loopmend"));
  constexpr int one = 4, other = 5;  // small ones
  Points positions;
  {
    Shown window({sample_file(folder_)});
    QCOMPARE(window.document().loop_count(), 6);
    window.selection().select({one, other});
    QVERIFY(press_and_wait(window, "fill"));
    window.selection().select({one});
    press(window, "accept");
    QVERIFY(window.isWindowModified());
    window.controller().save_session(path);
    QVERIFY(wait_idle(window));
    QVERIFY(!window.isWindowModified());
    positions = window.document().patch_of(other)->state->patch.positions;
    QVERIFY(window.close());
  }
  Shown shown({path});
  const Document& document = shown.document();
  QVERIFY(shown.ready);
  QVERIFY(document.state(one) == HoleState::accepted);
  QVERIFY(document.state(other) == HoleState::filled);
  QVERIFY2(document.patch_of(other)->state->patch.positions == positions, "the patch came back with other bits");
  QVERIFY(!shown.isWindowModified());
  // A damaged session is refused in words, and nothing that is open is lost.
  QFile file(path);
  QVERIFY(file.open(QIODevice::ReadOnly));
  const QByteArray bytes = file.readAll();
  const QString broken = folder_.filePath(QStringLiteral("broken.loopmend"));
  for (int size : {0, 10, 200, static_cast<int>(bytes.size()) / 2, static_cast<int>(bytes.size()) - 1}) {
    QFile part_of(broken);
    QVERIFY(part_of.open(QIODevice::WriteOnly));
    part_of.write(bytes.left(size));
    part_of.close();
    shown.open(broken);
    QVERIFY(wait_idle(shown));
    QVERIFY(part<Banner>(shown, "banner")->text().contains(QStringLiteral("broken.loopmend")));
    QCOMPARE(document.patches().size(), std::size_t(2));
  }
}

void StoryTest::a_session_without_its_scan_is_told_where_it_is() {
  QTemporaryDir before, now;
  const QString path = folder_.filePath(QStringLiteral("moved.loopmend"));
  const QString one = write_sheet_with_holes(before.filePath(QStringLiteral("one.ply")), 1);
  const QString two = write_sheet_with_holes(before.filePath(QStringLiteral("two.ply")), 2);
  {
    Shown shown({one, two});
    shown.selection().select({first_hole(shown.document())});
    QVERIFY(press_and_wait(shown, "fill"));
    shown.controller().save_session(path);
    QVERIFY(wait_idle(shown));
    QVERIFY(shown.close());
  }
  for (const char* name : {"one.ply", "two.ply"})
    QVERIFY(QFile::rename(before.filePath(QLatin1String(name)), now.filePath(QLatin1String(name))));
  Shown window({sample_file(folder_)});
  window.open(path);
  QVERIFY(wait_idle(window));
  QVERIFY(part<Banner>(window, "banner")->text().contains(one));
  QCOMPARE(window.document().patches().size(), std::size_t(0));  // what was open still is
  const WhenAsked asked([&](QDialog& dialog) {
    auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    name->setText(now.filePath(QStringLiteral("one.ply")));
    QTest::keyClick(name, Qt::Key_Return);
  });
  press(window, "answerLocate");  // the other scan is found beside it
  QVERIFY(wait_idle(window));
  QCOMPARE(window.document().scans().size(), std::size_t(2));
  QCOMPARE(window.document().patches().size(), std::size_t(1));

  // Scans that lie beside the session are found, wherever they were when it was saved.
  const QString beside = now.filePath(QStringLiteral("moved.loopmend"));
  QVERIFY(QFile::copy(path, beside));
  Shown other;
  other.open(beside);
  QVERIFY(wait_idle(other));
  QCOMPARE(other.document().scans().size(), std::size_t(2));
  QCOMPARE(other.document().patches().size(), std::size_t(1));
}

void StoryTest::several_scans_are_one_scene() {
  const QString first = sample_file(folder_);
  const QString second = write_sheet_with_holes(folder_.filePath(QStringLiteral("small.ply")), 2);
  Shown window({first});
  const Document& document = window.document();
  const int loops = document.loop_count();
  // Dropped onto the window.
  QMimeData files;
  files.setUrls({QUrl::fromLocalFile(second)});
  QDragEnterEvent enter(QPoint(200, 200), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &enter);
  QVERIFY(enter.isAccepted());
  QDropEvent drop(QPointF(200, 200), Qt::CopyAction, &files, Qt::LeftButton, Qt::NoModifier);
  QApplication::sendEvent(&window, &drop);
  QVERIFY(wait_idle(window));
  QCOMPARE(document.scans().size(), std::size_t(2));
  QCOMPARE(document.loop_count(), loops + 5);
  QVERIFY(!part<QTableView>(window, "holesTable")->isColumnHidden(7));
  window.selection().select({loops - 1, document.first_loop_of(1) + 1});
  QVERIFY(press_and_wait(window, "fill"));
  QCOMPARE(filled(document), 2);
  const QString out = folder_.filePath(QStringLiteral("both.ply"));
  window.controller().export_to(out);
  QVERIFY(wait_idle(window));
  const std::size_t vertices =
      document.scan(0)->model->soup.points.size() + document.scan(1)->model->soup.points.size();
  QVERIFY(read_mesh(out.toStdString()).soup.points.size() > vertices);
  // Close the second one, and take that back.
  window.controller().close_scan(1);
  QCOMPARE(document.scans().size(), std::size_t(1));
  QCOMPARE(filled(document), 1);
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(document.scans().size(), std::size_t(2));
  QCOMPARE(filled(document), 2);
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<StoryTest>(); }

#include "story_test.moc"
