// SPDX-License-Identifier: GPL-3.0-or-later
// What the window says of its state: messages and figures are whole, messages name their file, the status bar and the timeline
// tell the same step, and whatever cannot be done has a next thing to press.
#include "driver.h"
#include "test_main.h"

#include "dialogs/repair_dialog.h"
#include "document/language.h"
#include "document/run_curves.h"
#include "panels/banner.h"
#include "panels/plot_library.h"
#include "samples/analytic_surfaces.h"
#include "views/file_controller.h"

#include <QAction>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QRegularExpression>
#include <QSlider>
#include <QStyle>
#include <QTableView>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

QAction* action(MainWindow& window, const char* name) {
  return window.findChild<QAction*>(QLatin1String(name), Qt::FindDirectChildrenOnly);
}

/// Empty, or which part of the message is not seen whole.
QString hidden_part(MainWindow& window) {
  auto* banner = part<Banner>(window, "banner");
  auto* words = part<QLabel>(window, "bannerText");
  if (!banner->isVisible()) return QStringLiteral("no message");
  const QRect room = banner->rect();
  if (banner->height() > window.view().height() || banner->width() > window.view().width())
    return QStringLiteral("the banner is too large");
  QList<QWidget*> parts = {words, part<QWidget>(window, "bannerClose")};
  for (QPushButton* button : banner->findChildren<QPushButton*>())
    if (button->isVisible()) {
      parts << button;
      if (button->width() < button->sizeHint().width())
        return QStringLiteral("button %1: %2 of %3")
            .arg(button->text())
            .arg(button->width())
            .arg(button->sizeHint().width());
    }
  for (const QWidget* one : parts)
    for (const QWidget* other : parts)
      if (one != other && one->geometry().intersects(other->geometry()) && one->parent() == other->parent())
        return QStringLiteral("%1 lies over %2").arg(one->objectName(), other->objectName());
  for (const QWidget* one : parts)
    if (!room.contains(QRect(one->mapTo(banner, QPoint()), one->size()))) return one->objectName();
  const QRect needed =
      words->fontMetrics().boundingRect(QRect(0, 0, words->width(), 10000), Qt::TextWordWrap, words->text());
  if (needed.width() > words->width() || needed.height() > words->height())
    return QStringLiteral("%1 x %2 of %3 x %4: %5")
        .arg(words->width())
        .arg(words->height())
        .arg(needed.width())
        .arg(needed.height())
        .arg(words->text());
  if (words->text() != banner->text() && words->toolTip() != banner->text()) return QStringLiteral("no tooltip");
  return {};
}

/// The number of steps that these words tell; 0 where they tell none.
int steps_in(const QString& words) {
  return QRegularExpression(QStringLiteral("step (\\d+)")).match(words).captured(1).toInt();
}

int steps_of_timeline(MainWindow& window) { return steps_in(part<QLabel>(window, "timelinePlace")->text()); }
int steps_of_status(MainWindow& window) { return steps_in(part<QLabel>(window, "statusFigures")->text()); }

/// Where the plot's marker stands; 0 where there is no run to draw.
int steps_of_plot(MainWindow& window) {
  const auto* marker = part<QWidget>(window, "energyPlot")->findChild<QCPItemStraightLine*>(QStringLiteral("marker"));
  return marker->visible() ? qRound(marker->point1->coords().x()) : 0;
}

/// Waits for the plot, which follows a little later. @returns empty, or what the three say.
QString disagreement(MainWindow& window, int steps) {
  const auto agree = [&] {
    return steps_of_timeline(window) == steps && steps_of_status(window) == steps && steps_of_plot(window) == steps;
  };
  if (wait_until(agree)) return {};
  return QStringLiteral("expected %1, timeline %2, status bar %3, plot %4")
      .arg(steps)
      .arg(steps_of_timeline(window))
      .arg(steps_of_status(window))
      .arg(steps_of_plot(window));
}

bool says_ready(MainWindow& window) { return part<QLabel>(window, "statusStage")->text() == QStringLiteral("Ready"); }

int steps_of(MainWindow& window, int loop) { return window.document().patch_of(loop)->state->steps; }

}  // namespace

class MessagesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_repair_that_does_nothing_says_so_in_its_dialog();
  void a_message_is_seen_whole_data();
  void a_message_is_seen_whole();
  void messages_name_their_file();
  void status_bar_timeline_and_plot_tell_the_same_step();
  void the_plot_draws_what_the_steps_lower_data();
  void the_plot_draws_what_the_steps_lower();
  void whatever_cannot_be_filled_leads_on_data();
  void whatever_cannot_be_filled_leads_on();
  void a_patch_that_cuts_the_surface_leads_on();
  void the_seam_table_shows_its_values_whole_data();
  void the_seam_table_shows_its_values_whole();

 private:
  QString file(const QString& name, const TriangleSoup& soup) { return scan_file(folder_, name, soup); }
  QTemporaryDir folder_;
};

void MessagesTest::a_message_is_seen_whole_data() {
  QTest::addColumn<QString>("language");
  QTest::addColumn<QSize>("size");
  QTest::newRow("1280x720") << QStringLiteral("en") << QSize(1280, 720);
  QTest::newRow("1280x720, German") << QStringLiteral("de") << QSize(1280, 720);
  QTest::newRow("as small as it goes") << QStringLiteral("en") << QSize(1, 1);
  QTest::newRow("as small as it goes, German") << QStringLiteral("de") << QSize(1, 1);
}

/// Of a file with a name of 200 letters, without a place where a line could be broken.
void MessagesTest::a_message_is_seen_whole() {
  QFETCH(QString, language);
  QFETCH(QSize, size);
  install_language(language);
  const QString name = QString(190, QLatin1Char('x')) + QStringLiteral("_scan.ply");
  const QString path = file(name, cut(make_icosphere(2), [](const Vec3& p) { return p.z() > 0.8; }));
  QString error, question;
  bool error_names_it = false, question_names_it = false, still_whole = false;
  {
    Shown window({path});
    window.resize(size.expandedTo(window.minimumSizeHint()));
    window.resizeDocks({part<QDockWidget>(window, "holesDock"), part<QDockWidget>(window, "patchDock")}, {480, 320},
                       Qt::Horizontal);
    settle();
    const QString bad = folder_.filePath(QString(190, QLatin1Char('y')) + QStringLiteral("_bad.ply"));
    QFile broken(bad);
    QVERIFY(broken.open(QIODevice::WriteOnly));
    broken.write("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nend_header\n0 0 nonsense\n");
    broken.close();
    window.open(bad);
    wait_idle(window);
    settle();
    error = hidden_part(window);
    error_names_it = part<Banner>(window, "banner")->text().contains(QStringLiteral("yy_bad.ply"));
    window.resize(window.width() + 60, window.height());
    settle();
    still_whole = hidden_part(window).isEmpty();
    window.resize(window.width() - 60, window.height());
    window.selection().select({first_hole(window.document())});
    press_and_wait(window, "fill");
    window.findChild<FileController*>()->close_scan(window.document().scans().front());
    settle();
    question = hidden_part(window);
    question_names_it = part<Banner>(window, "banner")->text().contains(name);
    press(window, "answerCancel");
  }
  install_language(QStringLiteral("en"));
  QVERIFY2(error.isEmpty(), qPrintable(error));
  QVERIFY(error_names_it);
  QVERIFY(still_whole);
  QVERIFY2(question.isEmpty(), qPrintable(question));
  QVERIFY(question_names_it);
}

void MessagesTest::messages_name_their_file() {
  const auto said_of = [this](const QString& path) {
    Shown shown({sample_file(folder_)});
    shown.open(QStringList(path), OpenMode::add);
    wait_idle(shown);
    settle();
    auto* banner = part<Banner>(shown, "banner");
    return banner->isVisible() ? banner->text() : QString();
  };
  const QString closed = said_of(file(QStringLiteral("closed.ply"), make_icosphere(2)));
  QVERIFY2(closed.contains(QStringLiteral("closed.ply")), qPrintable(closed));
  const QString missing = said_of(folder_.filePath(QStringLiteral("missing.ply")));
  QVERIFY2(missing.contains(QStringLiteral("missing.ply")), qPrintable(missing));
  Shown window({sample_file(folder_)});
  window.controller().export_to(QStringLiteral("/nonexistent-folder/out.ply"));
  QVERIFY(wait_idle(window));
  const QString unwritable = part<Banner>(window, "banner")->text();
  QVERIFY2(unwritable.contains(QStringLiteral("out.ply")), qPrintable(unwritable));
  window.controller().save_session(QStringLiteral("/nonexistent-folder/work.loopmend"));
  QVERIFY(wait_idle(window));
  const QString unsaved = part<Banner>(window, "banner")->text();
  QVERIFY2(unsaved.contains(QStringLiteral("work.loopmend")), qPrintable(unsaved));
}

void MessagesTest::status_bar_timeline_and_plot_tell_the_same_step() {
  Shown window({sample_file(folder_)});
  const int hole = first_hole(window.document());
  const auto same = [&](int steps) {
    const QString wrong = disagreement(window, steps);
    if (!wrong.isEmpty()) qWarning("%s", qPrintable(wrong));
    return wrong.isEmpty();
  };
  QVERIFY(press_and_wait(window, "fill"));
  QVERIFY(same(0));
  window.selection().select({hole});
  QVERIFY(press_and_wait(window, "step"));
  QCOMPARE(steps_of(window, hole), 1);
  QVERIFY(same(1));
  QVERIFY(says_ready(window));

  // In steps so short that the flow is still at work whenever this thread comes round.
  part<QSlider>(window, "sigma")->setValue(-15);
  press(window, "run");
  QVERIFY(wait_until([&] {
    const int steps = steps_of(window, hole);
    return steps > 1 && steps_of_status(window) == steps && steps_of_timeline(window) == steps;
  }));
  QVERIFY(window.controller().busy());
  QVERIFY(!says_ready(window));
  QVERIFY(!part<QSlider>(window, "timeline")->isEnabled());
  QCOMPARE(part<QPushButton>(window, "run")->text().remove(QLatin1Char('&')), QStringLiteral("Pause"));
  QVERIFY(press_and_wait(window, "run"));
  const int paused = steps_of(window, hole);
  QVERIFY(paused > 1);
  QVERIFY(same(paused));
  QVERIFY(says_ready(window));
  QVERIFY(part<QSlider>(window, "timeline")->isEnabled());
  QCOMPARE(part<QPushButton>(window, "run")->text().remove(QLatin1Char('&')), QStringLiteral("Run"));

  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(steps_of(window, hole), 1);
  QVERIFY(same(1));
  key(window, Qt::Key_Y, Qt::ControlModifier);
  QVERIFY(same(paused));
  QVERIFY(press_and_wait(window, "step"));
  QVERIFY(same(paused + 1));

  // Another hole, none, and then the one that has run.
  window.selection().select({hole + 1});
  QVERIFY(same(0));
  window.selection().select({});
  QVERIFY(same(paused + 1));
  // What was said in between does not take the step away.
  window.selection().select({hole});
  QVERIFY(same(paused + 1));
  auto* timeline = part<QSlider>(window, "timeline");
  timeline->setFocus();
  QTest::keyClick(timeline, Qt::Key_Home);
  QVERIFY(same(0));
  QTest::keyClick(timeline, Qt::Key_End);
  QVERIFY(same(paused + 1));

  // Several at once: the longest run is told, by all three.
  window.selection().select({});
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  QVERIFY(steps_of_timeline(window) > 0);
  QVERIFY(same(steps_of_timeline(window)));
}

void MessagesTest::the_plot_draws_what_the_steps_lower_data() {
  QTest::addColumn<int>("boundary");
  QTest::addColumn<QString>("legend");
  QTest::newRow("split flow") << 0 << QStringLiteral("J");
  QTest::newRow("flow") << 1 << QStringLiteral("|\u2207H|");
  QTest::newRow("robust fairing lowers no energy") << 2 << QString();
}

void MessagesTest::the_plot_draws_what_the_steps_lower() {
  QFETCH(int, boundary);
  QFETCH(QString, legend);
  Shown window({sample_file(folder_)}, Shown::Extent::usual);
  const int hole = first_hole(window.document());
  window.selection().select({hole});
  part<QComboBox>(window, "boundary")->setCurrentIndex(boundary);
  QVERIFY(press_and_wait(window, "fillAndSmooth", 120));
  const RunCurves run(*window.document().patch_of(hole));
  QCOMPARE(run.fairing, legend.isEmpty());
  QCOMPARE(run.lowered.empty(), legend.isEmpty());
  auto* drawn = part<QWidget>(window, "energyPlot")->findChild<QCustomPlot*>();
  const auto named = [&] {
    const QCPGraph* graph = drawn->graph(0);
    return legend.isEmpty() ? graph->name().isEmpty() && graph->data()->isEmpty()
                            : graph->name().contains(legend) && !graph->data()->isEmpty();
  };
  QVERIFY(wait_until(named));
  QVERIFY(!drawn->graph(1)->data()->isEmpty());
  QCOMPARE(drawn->yAxis->visible(), !legend.isEmpty());
  QVERIFY(drawn->legend->minimumOuterSizeHint().width() <= drawn->width());
  QCOMPARE(part<QLabel>(window, "curveHole")->text(),
           QStringLiteral("Hole %1").arg(window.document().loop(hole).number));
}

void MessagesTest::whatever_cannot_be_filled_leads_on_data() {
  QTest::addColumn<QString>("path");
  QTest::addColumn<int>("kind");
  QTest::addColumn<QString>("next");   // the action
  QTest::addColumn<QString>("named");  // in the words of the Patch tab
  const TriangleSoup ball = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.8; });
  const auto with_triangle = [&](Triangle more, const std::vector<Vec3>& points) {
    TriangleSoup soup = ball;
    soup.points.insert(soup.points.end(), points.begin(), points.end());
    soup.triangles.push_back(more);
    return soup;
  };
  const int n = static_cast<int>(ball.points.size());
  const Triangle some = ball.triangles.front();
  QTest::newRow("outer rim") << file(QStringLiteral("sheet.ply"),
                                     make_graph([](double x, double) { return 0.1 * x * x; }, 1, 8))
                             << static_cast<int>(LoopKind::outer_rim) << QStringLiteral("fillAction") << QString();
  QTest::newRow("crack") << QStringLiteral(LOOPMEND_SOURCE_DIR "/tests/data/crack.obj")
                         << static_cast<int>(LoopKind::crack) << QStringLiteral("stitchAction")
                         << QStringLiteral("Stitch");
  QTest::newRow("cut") << file(QStringLiteral("fin.ply"), with_triangle({some[0], some[1], n}, {Vec3(0, 0, -3)}))
                       << static_cast<int>(LoopKind::cut) << QStringLiteral("repairAction") << QStringLiteral("Repair");
  QTest::newRow("failed") << file(QStringLiteral("fragment.ply"),
                                  with_triangle({n, n + 1, n + 2}, {Vec3(3, 0, 0), Vec3(4, 0, 0), Vec3(3, 1, 0)}))
                          << static_cast<int>(LoopKind::outer_rim) << QStringLiteral("trimAction")
                          << QStringLiteral("Trim");
}

void MessagesTest::whatever_cannot_be_filled_leads_on() {
  QFETCH(QString, path);
  QFETCH(int, kind);
  QFETCH(QString, next);
  QFETCH(QString, named);
  Shown window({path});
  const Document& document = window.document();
  int loop = document.loop_count() - 1;
  while (loop >= 0 && static_cast<int>(document.loop(loop).kind) != kind) --loop;
  QVERIFY2(loop >= 0, "the file has no such loop");
  window.selection().select({loop});
  if (next == QStringLiteral("trimAction")) {
    QVERIFY(press_and_wait(window, "fill"));
    QCOMPARE(document.state(loop), HoleState::failed);
    const QString said = part<Banner>(window, "banner")->text();
    QVERIFY2(said.contains(QStringLiteral("what may help")), qPrintable(said));
  }
  settle();
  const QString words =
      part<QLabel>(window, "fillTarget")->text() + QLatin1Char(' ') + part<QLabel>(window, "fillEstimate")->text();
  QVERIFY2(words.contains(named) && !words.contains(QStringLiteral("filled already")), qPrintable(words));
  auto* note = part<QLabel>(window, "fillEstimate");
  QVERIFY2(note->fontMetrics().horizontalAdvance(note->text()) <= note->width(), qPrintable(note->text()));
  QAction* lead = action(window, next.toLatin1().constData());
  QVERIFY(lead->isEnabled());
  auto* table = part<QTableView>(window, "holesTable");
  Q_EMIT table->customContextMenuRequested(table->visualRect(table->model()->index(0, 1)).center());
  bool offered = false;
  for (QMenu* menu : window.findChildren<QMenu*>(QStringLiteral("holeMenu"))) {
    offered = offered || (menu->isVisible() && menu->actions().contains(lead));
    menu->close();
  }
  QVERIFY2(offered, "not in the menu of the hole");
}

/// A needle through the hole: any patch cuts it.
void MessagesTest::a_patch_that_cuts_the_surface_leads_on() {
  TriangleSoup soup = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.8; });
  const int first = static_cast<int>(soup.points.size());
  const TriangleSoup needle = make_icosphere(1);
  for (const Vec3& p : needle.points) soup.points.emplace_back(0.1 * p.x(), 0.1 * p.y(), 0.9 + p.z());
  for (const Triangle& t : needle.triangles) soup.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  Shown window({file(QStringLiteral("needle.ply"), soup)});
  window.selection().select({0});
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  const HoleState state = window.document().state(0);
  QVERIFY2(state == HoleState::cutting || state == HoleState::failed,
           qPrintable(QString::number(static_cast<int>(state))));
  const QString words = part<QLabel>(window, "fillEstimate")->text();
  QVERIFY2(words.contains(QStringLiteral("Trim")), qPrintable(words));
  if (state == HoleState::cutting) {
    QVERIFY2(words.contains(QStringLiteral("Discard")), qPrintable(words));
    QVERIFY(part<QPushButton>(window, "reject")->isEnabled());
    // An export leaves it out, so that it is in no file yet.
    const QString out = folder_.filePath(QStringLiteral("needle-filled.ply"));
    window.findChild<FileController*>()->export_to(out);
    QVERIFY(wait_until([&] { return QFile::exists(out) && !window.controller().busy(); }));
    QVERIFY2(!window.close(), "the patch that was left out would be lost");
    press(window, "answerCancel");
    press(window, "reject");
  }
  QVERIFY(part<QPushButton>(window, "trim")->isEnabled());
  QVERIFY(action(window, "eraseRingAction")->isEnabled());
}

void MessagesTest::the_seam_table_shows_its_values_whole_data() {
  QTest::addColumn<QString>("language");
  QTest::newRow("English") << QStringLiteral("en");
  QTest::newRow("German") << QStringLiteral("de");
}

/// As the docks lie at first, on a screen of 1280 by 720 too.
void MessagesTest::the_seam_table_shows_its_values_whole() {
  QFETCH(QString, language);
  install_language(language);
  QStringList cut_off;
  int cells = 0, changed = 0;
  {
    Shown window({sample_file(folder_)});
    press_and_wait(window, "fillAndSmooth");
    const auto* table = part<QTableWidget>(window, "seamTable");
    wait_until([&] { return table->rowCount() == static_cast<int>(window.document().patches().size()); });
    for (const QSize& size : {window.size(), QSize(1280, 720)}) {
      window.resize(size);
      settle();
      for (int row = 0; row < table->rowCount(); ++row)
        for (int column = 0; column < table->columnCount(); ++column) {
          const QModelIndex at = table->model()->index(row, column);
          const QString text = at.data().toString();
          const int room = table->visualRect(at).width(),
                    margin = 2 * (table->style()->pixelMetric(QStyle::PM_FocusFrameHMargin) + 1);
          ++cells;
          changed += text.contains(QChar(0x2192));
          if (table->fontMetrics().horizontalAdvance(text) + margin > room)
            cut_off << QStringLiteral("%1: %2 of %3 px")
                           .arg(text)
                           .arg(room)
                           .arg(table->fontMetrics().horizontalAdvance(text) + margin);
        }
    }
  }
  install_language(QStringLiteral("en"));
  QVERIFY(cells > 20 && changed > 10);
  QVERIFY2(cut_off.isEmpty(), qPrintable(cut_off.join(QLatin1Char('\n'))));
}

/// A ball, and one with a hole that runs through it: they cannot be united.
void MessagesTest::a_repair_that_does_nothing_says_so_in_its_dialog() {
  const QTemporaryDir folder;
  const TriangleSoup ball = make_icosphere(3);
  TriangleSoup other = cut(ball, [](const Vec3& p) { return p.z() > 0.9; });
  for (Vec3& p : other.points) p += Vec3(0.011, 0.017, 1.013);
  TriangleSoup both = joined({ball, other});
  both.triangles.push_back({3, 3, 4});
  Shown window({scan_file(folder, QStringLiteral("crossing.ply"), both)});
  press(window, "repair");
  auto* dialog = window.findChild<RepairDialog*>();
  QVERIFY(dialog);
  const auto summary = [&] { return dialog->findChild<QLabel*>(QStringLiteral("repairSummary"))->text(); };
  const auto fix = [&](const char* name) {
    auto* button = dialog->findChild<QPushButton*>(QLatin1String(name));
    if (!wait_until([&] { return button->isEnabled(); })) return false;
    QTest::mouseClick(button, Qt::LeftButton);
    return wait_idle(window) && wait_until([&] { return !summary().contains(QChar(0x2026)); });
  };
  QVERIFY(fix("fixDegenerate"));
  const QString former = QStringLiteral("Ctrl+Z takes it back.");
  QVERIFY2(summary().contains(former), qPrintable(summary()));
  QVERIFY(fix("fixOverlapping"));
  QVERIFY2(summary().contains(QStringLiteral("fill the holes, then unite.")), qPrintable(summary()));
  QVERIFY2(!summary().contains(former), qPrintable(summary()));
  QCOMPARE(summary().split(QLatin1Char('\n')).first(), part<Banner>(window, "banner")->text());
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<MessagesTest>(); }

#include "messages_test.moc"
