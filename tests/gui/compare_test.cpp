// SPDX-License-Identifier: GPL-3.0-or-later
// The comparison of flows, driven by mouse and keyboard, with `loopmend compare` as its witness.
#include "compare_driver.h"
#include "test_main.h"

#include "analysis/surface_distance.h"
#include "compare/flow_canvas.h"
#include "compare/flow_view.h"
#include "dialogs/picture_dialog.h"
#include "io/write_mesh.h"
#include "panels/banner.h"
#include "panels/plot.h"
#include "panels/plot_library.h"
#include "samples/analytic_surfaces.h"

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QOpenGLWidget>
#include <QProcess>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

#include <cstdio>
#include <cstdlib>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

QByteArray content(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void drag(QWidget* widget, const QPoint& from, const QPoint& to) {
  QTest::mousePress(widget, Qt::LeftButton, {}, from);
  for (int step = 1; step <= 4; ++step) {
    const QPoint at = from + (to - from) * step / 4;
    QMouseEvent move(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, Qt::LeftButton, {});
    QApplication::sendEvent(widget, &move);
    settle();
  }
  QTest::mouseRelease(widget, Qt::LeftButton, {}, to);
}

/// The share of pixels that differ clearly, not by rounding.
double share_apart(const QImage& a, const QImage& b) {
  int apart = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) apart += std::abs(qGray(a.pixel(x, y)) - qGray(b.pixel(x, y))) > 40;
  return static_cast<double>(apart) / (a.width() * a.height());
}

}  // namespace

class CompareTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void numbers_are_those_of_the_command_line();
  void views_are_linked_until_unlinked();
  void the_line_wipes();
  void pictures_of_any_size();
  void the_command_in_the_clipboard_does_the_same();
  void pictures_move_between_states_and_end_at_them();
  void the_winner_comes_into_the_document();
  void what_a_fill_made_is_compared();
  void two_views_and_other_flows();
  void distances_between_flows_and_from_a_mesh();
  void stop_comes_back_at_once();
  void headings_are_whole_figures_in_any_width();
  void says_why_it_cannot();

 private:
  QTemporaryDir folder_;
};

void CompareTest::numbers_are_those_of_the_command_line() {
  const QString ball = ball_file(folder_);
  Shown shown({ball});
  key(shown, Qt::Key_C);
  CompareWindow* window = compare_window(shown);
  QVERIFY(window && QTest::qWaitForWindowExposed(window));
  QVERIFY(run_all(*window));
  const QString table = folder_.filePath(QStringLiteral("figures.csv"));
  window->save_numbers(table);

  QProcess program;
  const QString out = folder_.filePath(QStringLiteral("flows"));
  program.start(QStringLiteral(LOOPMEND_PROGRAM), {QStringLiteral("compare"), ball, QStringLiteral("-o"), out});
  QVERIFY(program.waitForFinished(240000));
  QCOMPARE(program.exitCode(), 0);
  QVERIFY(!content(table).isEmpty());
  QCOMPARE(content(table), content(out + QStringLiteral("/table.csv")));
  QCOMPARE(content(folder_.filePath(QStringLiteral("figures-profile.csv"))),
           content(out + QStringLiteral("/profile.csv")));
  QVERIFY(content(folder_.filePath(QStringLiteral("figures-energies.csv"))).count("MMCVF") > 1);

  // The same is on the screen.
  auto* seen = in<QTableWidget>(*window, "compareTable");
  QCOMPARE(seen->rowCount(), 5);
  const QList<QByteArray> last = content(table).trimmed().split('\n').last().split(',');
  QCOMPARE(seen->item(4, 0)->text(), QStringLiteral("MMCVF"));
  QCOMPARE(seen->item(4, 3)->text(), QString::fromLatin1(last[3]));
  QCOMPARE(seen->item(4, 7)->text(), QString::fromLatin1(last[7]));
  QVERIFY(in<QLabel>(*window, "paneFigures3")->text().contains(QStringLiteral("converged")));
  for (int r = 0; r < seen->rowCount(); ++r)
    for (int c = 0; c < seen->columnCount(); ++c) {
      const QString text = seen->item(r, c)->text();
      if (seen->isColumnHidden(c)) {
        QCOMPARE(text, QStringLiteral("0"));
        continue;
      }
      QVERIFY2(seen->fontMetrics().horizontalAdvance(text) < seen->columnWidth(c), qPrintable(text));
    }
  const auto named = [&](const char* plot, const QString& side, const QString& below) {
    const auto* drawn = in<Plot>(*window, plot)->findChild<QCustomPlot*>();
    return drawn && drawn->legend->visible() && drawn->yAxis->label() == side && drawn->xAxis->label() == below;
  };
  QVERIFY(named("compareEnergies", QStringLiteral("1/length\u00b2"), QStringLiteral("Step")));
  QVERIFY(named("compareProfiles", QStringLiteral("H, 1/length"), QStringLiteral("Distance, length")));
  for (const char* plot : {"compareEnergies", "compareProfiles"})
    for (int graph = 0; graph < 4; ++graph) QVERIFY(in<Plot>(*window, plot)->values(graph).size() > 1);
}

void CompareTest::views_are_linked_until_unlinked() {
  Shown shown({ball_file(folder_)});
  CompareWindow* window = shown.comparisons().compare_holes({});
  QVERIFY(QTest::qWaitForWindowExposed(window));
  QVERIFY(wait_until([&] { return in<QPushButton>(*window, "compareRun")->isEnabled(); }));
  settle();
  for (int k = 0; k < 4; ++k) QVERIFY(count_colors(window->flow_view(k).canvas().picture(QSize(320, 240))) >= 40);
  const auto position = [&](int k) { return window->flow_view(k).canvas().pose().position; };
  // The seam is a line in each, as long as it is wanted.
  const auto seen = [&](int k) { return window->flow_view(k).canvas().picture(QSize(320, 240)); };
  const std::vector<QImage> with{seen(0), seen(1), seen(2), seen(3)};
  auto* lines = in<QCheckBox>(*window, "compareSeams");
  QVERIFY(lines->isChecked());
  lines->setChecked(false);
  settle();
  for (int k = 0; k < 4; ++k) QVERIFY(share_apart(with[k], seen(k)) > 0.002);
  lines->setChecked(true);
  settle();
  QVERIFY((position(0) - position(3)).norm() < 1e-9);
  const auto before = position(3);
  QWidget* canvas = window->flow_view(0).canvas().canvas();
  drag(canvas, canvas->rect().center(), canvas->rect().center() + QPoint(60, 20));
  QVERIFY(wait_until([&] { return (position(3) - before).norm() > 0.05; }));
  settle();
  QVERIFY((position(0) - position(3)).norm() < 1e-6);
  QTest::mouseClick(in<QCheckBox>(*window, "compareLinked"), Qt::LeftButton, {}, QPoint(8, 8));
  const auto held = position(3);
  drag(canvas, canvas->rect().center(), canvas->rect().center() + QPoint(-80, 30));
  settle();
  QVERIFY((position(3) - held).norm() < 1e-9);
  QVERIFY((position(0) - held).norm() > 0.05);
}

void CompareTest::the_line_wipes() {
  Shown shown({ball_file(folder_)});
  CompareWindow* window = shown.comparisons().compare_holes({});
  QVERIFY(QTest::qWaitForWindowExposed(window));
  QVERIFY(run_all(*window));
  in<QComboBox>(*window, "compareShading")->setCurrentIndex(3);  // zebra: the start's kink shows
  QTest::mouseClick(in<QCheckBox>(*window, "compareWipe"), Qt::LeftButton, {}, QPoint(8, 8));
  settle();
  QWidget* canvas = window->wipe().canvas();
  const QSize size(600, 400);
  const auto wiped_to = [&](double share) {
    const QPoint from(static_cast<int>(window->wipe().line() * canvas->width()), canvas->height() / 3);
    drag(canvas, from, QPoint(static_cast<int>(share * canvas->width()), canvas->height() / 3));
    settle();
    return window->wipe().picture(size);
  };
  const auto eye = window->wipe().pose().position;
  const QImage right = wiped_to(0.02), left = wiped_to(0.98), middle = wiped_to(0.5);
  QVERIFY((window->wipe().pose().position - eye).norm() < 1e-9);  // the line was drawn, not the picture turned
  QVERIFY(share_apart(left, right) > 0.03);
  // Left of the line it is the one, right of it the other, at the very same place.
  const QRect left_half(12, 0, 270, 400), right_half(318, 0, 270, 400);
  QVERIFY(share_apart(middle.copy(left_half), left.copy(left_half)) < 0.01);
  QVERIFY(share_apart(middle.copy(right_half), right.copy(right_half)) < 0.01);
  QVERIFY(share_apart(middle.copy(left_half), right.copy(left_half)) > 0.03);
}

void CompareTest::pictures_of_any_size() {
  Shown shown({ball_file(folder_)});
  CompareWindow* window = shown.comparisons().compare_holes({});
  QVERIFY(QTest::qWaitForWindowExposed(window));
  QVERIFY(wait_until([&] { return in<QPushButton>(*window, "comparePicture")->isEnabled(); }));
  settle();
  const QImage picture = window->picture({QSize(1600, 1000)});
  QCOMPARE(picture.size(), QSize(1600, 1000));
  QVERIFY(count_colors(picture) >= 64);
  // The same by mouse, without ground and without words.
  QTest::mouseClick(in<QPushButton>(*window, "comparePicture"), Qt::LeftButton);
  auto* dialog = window->findChild<PictureDialog*>(QStringLiteral("pictureDialog"));
  QVERIFY(dialog);
  dialog->findChild<QComboBox*>(QStringLiteral("pictureGround"))->setCurrentIndex(1);
  auto* with = dialog->findChild<QComboBox*>(QStringLiteral("pictureExtras"));
  QCOMPARE(with->count(), 2);
  const QString path = folder_.filePath(QStringLiteral("panel.png"));
  QVERIFY(dialog->save(path));
  const QImage words(path);
  const auto opaque = [](const QImage& image, const QRect& part) {
    int count = 0;
    for (int y = part.top(); y <= part.bottom(); ++y)
      for (int x = part.left(); x <= part.right(); ++x) count += qAlpha(image.pixel(x, y)) == 255;
    return count;
  };
  const QRect strip(words.width() - 20, words.height() / 3, 20, words.height() / 3),
      heading(0, 0, words.width() / 2, 16);
  QCOMPARE(qAlpha(words.pixel(2, words.height() - 8)), 0);
  QVERIFY(opaque(words, words.rect()) > words.width() * words.height() / 20);
  QVERIFY(opaque(words, heading) > 0);
  with->setCurrentIndex(1);
  QVERIFY(dialog->save(path));
  const QImage bare(path);
  QCOMPARE(bare.size(), words.size());
  QCOMPARE(opaque(bare, QRect(0, 0, 60, 16)), 0);
  QVERIFY(opaque(bare, strip) >= 0 && opaque(bare, bare.rect()) > bare.width() * bare.height() / 20);
}

void CompareTest::the_command_in_the_clipboard_does_the_same() {
  Shown shown({ball_file(folder_)});
  CompareWindow* window = shown.comparisons().compare_holes({});
  QVERIFY(QTest::qWaitForWindowExposed(window));
  QVERIFY(run_all(*window));
  const QString table = folder_.filePath(QStringLiteral("copied.csv"));
  window->save_numbers(table);
  QTest::mouseClick(in<QPushButton>(*window, "compareCopy"), Qt::LeftButton);
  QString command = QGuiApplication::clipboard()->text();
  const QString folder = QFileInfo(ball_file(folder_)).dir().filePath(QStringLiteral("ball-flows"));
  QCOMPARE(command, QStringLiteral("loopmend compare %1 -o %2").arg(ball_file(folder_), folder));
  QProcess shell;
  shell.start(QStringLiteral("sh"),
              {QStringLiteral("-c"),
               command.replace(QStringLiteral("loopmend compare"), QStringLiteral(LOOPMEND_PROGRAM " compare"))});
  QVERIFY(shell.waitForFinished(240000));
  QCOMPARE(shell.exitCode(), 0);
  QCOMPARE(content(table), content(folder + QStringLiteral("/table.csv")));
  // What the command cannot do is said.
  in<QComboBox>(*window, "compareMode")->setCurrentIndex(1);
  in<QComboBox>(*window, "compareCount")->setCurrentIndex(0);
  QTest::mouseClick(in<QPushButton>(*window, "compareCopy"), Qt::LeftButton);
  QVERIFY(QGuiApplication::clipboard()->text().endsWith(QStringLiteral(" --mode steps --sigma 10")));
  QVERIFY(in<QLabel>(*window, "bannerText")->text().contains(QStringLiteral("all four flows")));
}

/// Between two states more than one picture is drawn, none of them by drawing the neighborhood again; the last one is
/// what a fresh drawing of the last state gives.
void CompareTest::pictures_move_between_states_and_end_at_them() {
  Shown shown({ball_file(folder_)});
  CompareWindow* window = shown.comparisons().compare_holes({});
  QVERIFY(QTest::qWaitForWindowExposed(window));
  QVERIFY(wait_until([&] { return in<QPushButton>(*window, "compareRun")->isEnabled(); }));
  settle();
  FlowCanvas& canvas = window->flow_view(0).canvas();
  const auto start = window->flow_comparison().start()->shape;
  auto other = std::make_shared<SurfaceShape>(*start);
  for (std::size_t i = 2; i < other->points.size(); i += 3) other->points[i] += 0.3F;
  const auto seen = [&] { return static_cast<QOpenGLWidget*>(canvas.canvas())->grabFramebuffer(); };
  const QImage before = seen();
  canvas.show_patch(0, other, Arrival::with_the_next);
  const int frames = canvas.frames();
  bool moved = false;
  QVERIFY(wait_until([&] {
    moved = moved || canvas.is_moving();
    return canvas.frames() >= frames + 2 && !canvas.is_moving();
  }));
  QVERIFY(moved);
  settle();
  QVERIFY(canvas.neighborhood_drawn() > 0);
  const QImage after = seen();
  QVERIFY(share_apart(before, after) > 0.01);
  canvas.show_patch(0, start);
  settle();
  QVERIFY(share_apart(seen(), before) < 1e-3);  // 3e-4: pixels of the seam line, whose depth was rounded
  const int drawn = canvas.neighborhood_drawn();
  canvas.show_patch(0, std::make_shared<SurfaceShape>(*other));
  settle();
  QVERIFY(share_apart(seen(), after) < 1e-4);
  QCOMPARE(canvas.neighborhood_drawn(), drawn);  // kept, since the camera rests
  const CameraPose pose = canvas.pose();
  CameraPose nearer = pose;
  nearer.position = 0.9 * pose.position + 0.1 * pose.focus;
  for (const CameraPose& to : {nearer, pose}) {
    canvas.set_pose(to);
    settle();
  }
  QVERIFY(share_apart(seen(), after) < 1e-4);  // everything drawn again
}

void CompareTest::the_winner_comes_into_the_document() {
  Shown main({ball_file(folder_)});
  QVERIFY(press_and_wait(main, "fill"));
  const int loop = first_hole(main.document());
  const PatchStatePtr initial_patch = main.document().patch_of(loop)->state;
  press(main, "compareFlows");
  CompareWindow* window = compare_window(main);
  QVERIFY(window && QTest::qWaitForWindowExposed(window));
  QVERIFY(!in<QPushButton>(*window, "paneAccept2")->isEnabled());  // nothing has run yet
  QVERIFY(run_all(*window));
  QTest::mouseClick(in<QPushButton>(*window, "paneAccept2"), Qt::LeftButton);
  QVERIFY(wait_idle(main));
  const OpenPatch* patch = main.document().patch_of(loop);
  QVERIFY(patch && patch->state != initial_patch);
  QVERIFY(patch->state->flow == FlowKind::wf);
  QVERIFY(patch->state->status == PatchStatus::converged);
  QCOMPARE(main.document().patches().size(), std::size_t(1));
  key(main, Qt::Key_Z, Qt::ControlModifier);
  QVERIFY(main.document().patch_of(loop)->state == initial_patch);
}

/// In the last row of the table, and on one side of the line that wipes.
void CompareTest::what_a_fill_made_is_compared() {
  Shown main({ball_file(folder_)});
  QVERIFY(press_and_wait(main, "fillAndSmooth"));
  CompareWindow* window = main.comparisons().compare_holes({});
  QVERIFY(QTest::qWaitForWindowExposed(window));
  QVERIFY(run_all(*window));
  auto* table = in<QTableWidget>(*window, "compareTable");
  QCOMPARE(table->rowCount(), 6);
  QCOMPARE(table->item(5, 0)->text(), QStringLiteral("As filled"));
  const PatchStatePtr filled = main.document().patch_of(first_hole(main.document()))->state;
  QCOMPARE(table->item(5, 2)->text(), QString::number(filled->steps));
  QVERIFY(table->visualItemRect(table->item(5, 0)).bottom() < table->viewport()->height());
  auto* right = in<QComboBox>(*window, "compareWipeRight");
  in<QCheckBox>(*window, "compareWipe")->setChecked(true);
  QCOMPARE(right->currentText(), QStringLiteral("MMCVF"));
  const auto picture_with = [&](const char* words) {
    right->setCurrentIndex(right->findText(QLatin1String(words)));
    settle();
    return window->wipe().picture({400, 300});
  };
  QVERIFY(share_changed(picture_with("Start"), picture_with("As filled")) > 0.01);
}

void CompareTest::two_views_and_other_flows() {
  Shown shown({ball_file(folder_)});
  CompareWindow* window = shown.comparisons().compare_holes({});
  QVERIFY(QTest::qWaitForWindowExposed(window));
  QVERIFY(wait_until([&] { return in<QPushButton>(*window, "compareRun")->isEnabled(); }));
  in<QComboBox>(*window, "compareCount")->setCurrentIndex(0);
  QVERIFY(window->flow_view(1).isVisible() && !window->flow_view(2).isVisible());
  const auto flow = [&](const char* flow_view) { return in<QComboBox>(*window, flow_view)->currentText(); };
  QCOMPARE(flow("paneFlow0"), QStringLiteral("WF"));
  QCOMPARE(flow("paneFlow1"), QStringLiteral("MMCVF"));
  in<QComboBox>(*window, "paneFlow0")->setCurrentIndex(3);  // MMCVF: the two change places
  QCOMPARE(flow("paneFlow0"), QStringLiteral("MMCVF"));
  QCOMPARE(flow("paneFlow1"), QStringLiteral("WF"));
  QVERIFY(run_all(*window));
  QCOMPARE(in<QTableWidget>(*window, "compareTable")->rowCount(), 3);
}

void CompareTest::distances_between_flows_and_from_a_mesh() {
  const QString whole = folder_.filePath(QStringLiteral("whole.ply"));
  write_mesh(whole.toStdString(), make_icosphere(4));
  Shown shown({ball_file(folder_)});
  CompareWindow* window = shown.comparisons().compare_holes({});
  QVERIFY(QTest::qWaitForWindowExposed(window));
  QVERIFY(run_all(*window));
  auto* shading = in<QComboBox>(*window, "compareShading");
  auto* from = in<QComboBox>(*window, "compareFrom");
  QVERIFY(!from->isVisible());
  shading->setCurrentIndex(shading->findText(QStringLiteral("Distance")));
  QVERIFY(from->isVisible());
  const ComparisonController& flows = window->flow_comparison();
  const auto off = [&](int run) { return summary_of(flows.flow_run(run)->distances); };
  constexpr int mcf = 0, mmcvf = 3;
  QVERIFY(wait_until([&] { return !flows.is_measuring() && !flows.flow_run(mmcvf)->distances.empty(); }));
  QVERIFY(off(mmcvf).largest < 1e-12);
  QVERIFY(off(mcf).rms > 0.02);  // the soap film lies below the cap
  QVERIFY(off(mcf).mean < 0);
  QVERIFY(in<QLabel>(*window, "paneFigures0")->text().contains(QStringLiteral("off")));
  QVERIFY(count_colors(window->picture({QSize(800, 600)})) >= 64);
  QVERIFY(in<Plot>(*window, "compareProfiles")->values(mmcvf).isEmpty());  // it would hide the others
  double all = 0;
  for (double share : in<Plot>(*window, "compareProfiles")->values(mcf)) all += share;
  QVERIFY(std::abs(all - 100) < 1e-6);

  // A chord of the icosphere is 0.0035 below the unit sphere.
  window->measure_from_mesh(whole);
  QVERIFY(wait_until([&] { return !flows.is_measuring(); }));
  QVERIFY(off(mmcvf).largest < 0.005);
  QVERIFY(off(mcf).mean < -0.02);

  window->measure_from_mesh(folder_.filePath(QStringLiteral("none.ply")));
  QVERIFY(wait_until([&] { return !flows.is_measuring(); }));
  QVERIFY(wait_until([&] { return window->findChild<Banner*>()->isVisible(); }));
  QVERIFY(flows.flow_run(mcf)->distances.empty());  // not those from the mesh before

  from->setCurrentIndex(from->findText(QStringLiteral("from the start")));
  Q_EMIT from->activated(from->currentIndex());
  QVERIFY(wait_until([&] { return !flows.is_measuring(); }));
  QVERIFY(off(mmcvf).largest > 0.02);
  QVERIFY(summary_of(flows.start()->distances).largest < 1e-12);
}

void CompareTest::stop_comes_back_at_once() {
  Shown shown({sample_file(folder_)});
  CompareWindow* window = shown.comparisons().compare_holes({});
  QVERIFY(QTest::qWaitForWindowExposed(window));
  auto* run = in<QPushButton>(*window, "compareRun");
  QVERIFY(wait_until([&] { return run->isEnabled(); }));
  QTest::mouseClick(run, Qt::LeftButton);
  QVERIFY(!run->isEnabled());
  QElapsedTimer clock;
  clock.start();
  QTest::mouseClick(in<QPushButton>(*window, "compareStop"), Qt::LeftButton);
  QVERIFY(run->isEnabled());
  std::printf("stop: %lld ms\n", static_cast<long long>(clock.elapsed()));
  window->close();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  QVERIFY(compare_window(shown) == nullptr);
  QVERIFY(shown.comparisons().shut_down(std::chrono::minutes(4)));
}

/// As many figures as there is room for, none of them cut; the tooltip has all.
void CompareTest::headings_are_whole_figures_in_any_width() {
  Shown shown({ball_file(folder_)});
  key(shown, Qt::Key_C);
  CompareWindow* window = compare_window(shown);
  QVERIFY(window && QTest::qWaitForWindowExposed(window));
  QVERIFY(run_all(*window));
  auto* heading = in<QLabel>(*window, "paneFigures3");
  int shortened = 0;
  for (const QSize size : {QSize(1360, 860), QSize(1240, 680), QSize(900, 600)}) {
    window->resize(size);
    QVERIFY(settle());
    const QString text = heading->text();
    QVERIFY2(heading->fontMetrics().horizontalAdvance(text) <= heading->width(), qPrintable(text));
    QVERIFY2(text.startsWith(QStringLiteral("converged")), qPrintable(text));
    const bool whole = text.contains(QStringLiteral("\u0394H"));
    QVERIFY2(whole || text.endsWith(QStringLiteral("\u2026")), qPrintable(text));
    shortened += !whole;
    QVERIFY(heading->toolTip().contains(QStringLiteral("jump of H")));
  }
  QVERIFY(shortened > 0);
}

void CompareTest::says_why_it_cannot() {
  const QString closed = folder_.filePath(QStringLiteral("closed.ply"));
  write_mesh(closed.toStdString(), make_icosphere(2));
  Shown shown({closed});
  key(shown, Qt::Key_C);
  QVERIFY(compare_window(shown) == nullptr);
  QVERIFY(part<QLabel>(shown, "bannerText")->text().contains(QStringLiteral("no hole")));
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<CompareTest>(); }

#include "compare_test.moc"
