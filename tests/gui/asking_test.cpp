// SPDX-License-Identifier: GPL-3.0-or-later
// Nothing is lost without a question, and no fact stays on the screen that is true no more.
#include "driver.h"
#include "test_main.h"

#include "compare/compare_controller.h"
#include "compare/compare_window.h"
#include "dialogs/repair_dialog.h"
#include "document/fill_report.h"
#include "document/labels.h"
#include "io/write_mesh.h"
#include "panels/banner.h"
#include "panels/candidate_card.h"
#include "panels/candidates_panel.h"
#include "repair/watertight.h"
#include "samples/analytic_surfaces.h"
#include "tools/region_tool.h"
#include "views/file_controller.h"
#include "views/tool_controller.h"

#include <QApplication>
#include <QDockWidget>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSignalSpy>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include <cmath>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

/// As the system sends it: to the widget under the mouse, then to its parents.
void turn_wheel(QWidget* over) {
  const QPointF at = over->rect().center();
  QWheelEvent wheel(at, over->mapToGlobal(at.toPoint()), {}, {0, -360}, {}, {}, Qt::NoScrollPhase, false);
  QApplication::sendEvent(over, &wheel);
}

/// With a hole, and a face that is there twice.
TriangleSoup ball_with_a_defect() {
  TriangleSoup soup = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.9; });
  soup.triangles.push_back(soup.triangles.back());
  return soup;
}

QString text_of(MainWindow& window, const char* label) {
  return window.findChild<QLabel*>(QLatin1String(label))->text();
}

QString words_of(QDialog& question) {
  const auto& box = static_cast<QMessageBox&>(question);
  return box.text() + QLatin1Char(' ') + box.informativeText();
}

/// What was closed or answered is gone.
void bury() { QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); }

bool is_asked(MainWindow& window, const char* answer) {
  auto* button = window.findChild<QPushButton*>(QLatin1String(answer));
  return button && button->isVisible();
}

}  // namespace

class AskingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void the_wheel_scrolls_panels_at_once();
  void what_decides_on_a_patch_is_seen_at_once();
  void a_low_window_shows_the_step_of_the_selection();
  void patches_do_not_go_without_a_question();
  void many_new_holes_are_asked_about();
  void facts_of_the_former_scan_go_with_its_picture();
  void a_session_is_no_title_of_another_scan();
  void the_result_of_a_tool_is_not_dropped_without_a_question();
  void what_was_painted_does_not_go_in_silence();
  void nothing_is_said_of_what_was_not_judged();
  void what_could_not_be_filled_is_told_while_it_is_true();
  void the_eye_goes_to_the_largest_hole();
  void flows_are_compared_in_one_window();
  void one_truth_about_faces_that_touch();
  void the_mirror_speaks_of_the_selection();
  void loops_that_are_left_out_are_counted_alike();

 private:
  QTemporaryDir folder_;
};

void AskingTest::the_wheel_scrolls_panels_at_once() {
  Shown window({write_sheet_with_holes(folder_.filePath(QStringLiteral("sheet.ply")), 6)});
  window.resize(1300, 600);
  QVERIFY(press_and_wait(window, "fill"));
  window.tools().take(Tool::blend);
  for (const auto& [dock, panel] : {std::pair{"toolsDock", "toolsPanel"}, {"patchDock", "patchPanel"}}) {
    window.findChild<QDockWidget*>(QLatin1String(dock))->raise();
    settle();
    auto* part = window.findChild<QWidget*>(QLatin1String(panel));
    auto* area = qobject_cast<QScrollArea*>(part);
    if (!area) area = part->findChild<QScrollArea*>();
    QVERIFY2(area->verticalScrollBar()->maximum() > 0, panel);
    turn_wheel(area->viewport());
    QVERIFY2(area->verticalScrollBar()->value() > 0, panel);
  }
  auto* table = window.findChild<QTableView*>(QStringLiteral("holesTable"));
  turn_wheel(table->viewport());
  QVERIFY(table->verticalScrollBar()->value() > 0);
}

bool is_seen_whole(const QWidget& widget) {
  return QRegion(widget.rect()).subtracted(widget.visibleRegion()).isEmpty();
}

void AskingTest::what_decides_on_a_patch_is_seen_at_once() {
  Shown window({sample_file(folder_)}, Shown::Extent::usual);
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  for (const QSize size : {QSize(1360, 860), QSize(1260, 680)}) {
    window.resize(size);
    settle();
    for (const char* name : {"accept", "reject", "otherPatches"}) {
      auto* button = window.findChild<QWidget*>(QLatin1String(name));
      QVERIFY2(is_seen_whole(*button), name);
    }
  }
}

void AskingTest::a_low_window_shows_the_step_of_the_selection() {
  Shown window({sample_file(folder_)}, Shown::Extent::usual);
  window.resize(1260, 680);
  QTest::mouseMove(window.view().canvas(), QPoint(5, 5));
  const auto is_seen = [&](const char* name) {
    auto* button = window.findChild<QWidget*>(QLatin1String(name));
    return is_seen_whole(*button);
  };
  constexpr int filled = 1, open = 2;
  window.selection().select({filled});
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  for (int height = 680; height < 760; height += 6) {
    window.resize(1260, height);
    window.selection().select({});
    window.selection().select({filled});
    settle();
    for (const char* name : {"accept", "otherPatches", "run", "moreOfFlow"}) QVERIFY2(is_seen(name), name);
    const auto* area = window.findChild<QWidget*>(QStringLiteral("patchPanel"))->findChild<QScrollArea*>();
    QVERIFY(area->verticalScrollBar()->value() > 0);
    for (const auto* button : area->widget()->findChildren<QPushButton*>())  // above the others, none is seen in part
      if (button->isVisible() && !button->visibleRegion().isEmpty())
        QVERIFY2(is_seen(qPrintable(button->objectName())), qPrintable(button->objectName()));
  }
  window.selection().select({open});
  settle();
  for (const char* name : {"moreOfFill", "fillAndSmooth", "trim"}) QVERIFY2(is_seen(name), name);
}

void AskingTest::patches_do_not_go_without_a_question() {
  Shown window({scan_file(folder_, QStringLiteral("twice.ply"), ball_with_a_defect())});
  const Document& document = window.document();
  press(window, "fill");
  QVERIFY(wait_idle(window));
  QCOMPARE(document.patches().size(), std::size_t{1});
  QString question;
  {
    const WhenAsked asked([&](QDialog& dialog) {
      question = words_of(dialog);
      dialog.findChild<QPushButton*>(QStringLiteral("repairKeep"))->click();
    });
    window.controller().repair({Defect::duplicate_faces});
    QVERIFY(wait_until([&] { return !question.isEmpty(); }));
    settle();
  }
  QVERIFY2(question.contains(QStringLiteral("1 patch of this scan would go")), qPrintable(question));
  QVERIFY2(question.contains(QStringLiteral("1 duplicate faces removed")) ||
               question.contains(QStringLiteral("1 duplicate face removed")),
           qPrintable(question));
  QCOMPARE(document.patches().size(), std::size_t{1});
  QCOMPARE(document.scans(), std::vector<int>{0});
  {
    const WhenAsked asked(
        [](QDialog& dialog) { dialog.findChild<QPushButton*>(QStringLiteral("repairApply"))->click(); });
    window.controller().repair({Defect::duplicate_faces});
    QVERIFY(wait_until([&] { return document.scans() == std::vector<int>{1}; }));
    settle();
  }
  QVERIFY(document.patches().empty());
  QVERIFY(window.findChild<Banner*>()->text().contains(QStringLiteral("1 triangle fewer")));
  window.undo().undo();
  QCOMPARE(document.patches().size(), std::size_t{1});
}

/// Two sheets, of which one dips through the other at sixteen places.
void AskingTest::many_new_holes_are_asked_about() {
  TriangleSoup sheet;
  constexpr int across = 40;
  for (const bool dips : {false, true}) {
    const int first = static_cast<int>(sheet.points.size());
    for (int j = 0; j <= across; ++j)
      for (int i = 0; i <= across; ++i) {
        const double x = i + (dips ? 0.03 : 0), y = j + (dips ? 0.04 : 0);
        const double dx = std::fmod(x, 10) - 5.2, dy = std::fmod(y, 10) - 5.3;
        sheet.points.emplace_back(x, y, dips ? 1 - 2 * std::exp(-(dx * dx + dy * dy) / 3) : 0);
      }
    const auto at = [&](int i, int j) { return first + j * (across + 1) + i; };
    for (int j = 0; j < across; ++j)
      for (int i = 0; i < across; ++i) {
        sheet.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
        sheet.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
      }
  }
  Shown window({scan_file(folder_, QStringLiteral("dips.ply"), sheet)});
  press(window, "repair");
  auto* dialog = window.findChild<RepairDialog*>();
  auto* cut_out = dialog->findChild<QPushButton*>(QStringLiteral("fixIntersecting"));
  QVERIFY(wait_until([&] { return cut_out->isEnabled(); }));
  const std::size_t triangles = window.document().first_scan().model->soup.triangles.size();
  QString question;
  {
    const WhenAsked asked([&](QDialog& asking) {
      if (asking.objectName() != QStringLiteral("repairQuestion")) return;
      question = words_of(asking);
      asking.findChild<QPushButton*>(QStringLiteral("repairKeep"))->click();
    });
    cut_out->click();
    QVERIFY(wait_until([&] { return !question.isEmpty(); }));
    settle();
  }
  QVERIFY2(question.contains(QStringLiteral("boundary loops in place of")), qPrintable(question));
  QCOMPARE(window.document().first_scan().model->soup.triangles.size(), triangles);
  dialog->close();
}

void AskingTest::facts_of_the_former_scan_go_with_its_picture() {
  Shown window({sample_file(folder_)});
  const Document& document = window.document();
  press(window, "fill");
  QVERIFY(wait_idle(window));
  const std::size_t patches = document.patches().size();
  const QString title = window.windowTitle(), figures = text_of(window, "statusScan");
  const Vec3 eye = window.view().viewpoint().eye;
  auto* table = window.findChild<QTableView*>(QStringLiteral("holesTable"));
  const int rows = table->model()->rowCount();
  QVERIFY(patches > 0 && rows > 0 && !figures.isEmpty());
  QStringList seen;
  const auto look = QObject::connect(&window.controller(), &FillController::preview_ready, [&] {
    seen << text_of(window, "statusScan") << text_of(window, "statusWatertight")
         << QString::number(table->model()->rowCount()) << window.windowTitle();
    window.controller().cancel();
  });
  const QString other = scan_file(folder_, QStringLiteral("other.ply"), make_icosphere(5));
  window.controller().open({other}, OpenMode::replace);
  QVERIFY(wait_until([&] { return !seen.isEmpty() && !window.controller().busy(); }));
  QObject::disconnect(look);
  QCOMPARE(seen, (QStringList{{}, {}, QStringLiteral("0"), QStringLiteral("Loopmend")}));
  settle();
  // Given up, the former scan is there as it was.
  QCOMPARE(document.patches().size(), patches);
  QCOMPARE(table->model()->rowCount(), rows);
  QCOMPARE(window.windowTitle(), title);
  QCOMPARE(text_of(window, "statusScan"), figures);
  QVERIFY((window.view().viewpoint().eye - eye).norm() < 1e-9 * (1 + eye.norm()));
  window.undo().undo();
  QVERIFY(document.patches().empty());
  window.controller().open({other}, OpenMode::replace);
  QVERIFY(wait_idle(window));
  QVERIFY(window.windowTitle().contains(QStringLiteral("other.ply")));
  QVERIFY(!window.undo().can_undo());
}

void AskingTest::a_session_is_no_title_of_another_scan() {
  Shown window({sample_file(folder_)});
  press(window, "fill");
  QVERIFY(wait_idle(window));
  window.controller().save_session(folder_.filePath(QStringLiteral("mine.loopmend")));
  QVERIFY(wait_idle(window));
  QVERIFY(window.windowTitle().startsWith(QStringLiteral("mine.loopmend")));
  window.open_sample();
  QVERIFY(wait_idle(window));
  QVERIFY2(!window.windowTitle().contains(QStringLiteral("mine")), qPrintable(window.windowTitle()));
}

void AskingTest::the_result_of_a_tool_is_not_dropped_without_a_question() {
  Shown window({scan_file(folder_, QStringLiteral("bumps.ply"), make_icosphere(3))});
  key(window, Qt::Key_R);
  std::vector<int> top;
  const Points& points = window.document().first_scan().model->soup.points;
  for (std::size_t p = 0; p < points.size(); ++p)
    if (points[p].z() > 0.8) top.push_back(static_cast<int>(p));
  window.tools().region().set_vertices(0, top);
  press(window, "trialEvolve");
  const auto solved = [&] { return window.tools().trial().stage() == ProblemController::Stage::solved; };
  QVERIFY(wait_until(solved));
  QVERIFY(window.isWindowModified());
  key(window, Qt::Key_G);
  QVERIFY(is_asked(window, "answerAccept"));
  QVERIFY(solved() && window.tools().panel()->tool() == Tool::region);
  QVERIFY(window.findChild<QPushButton*>(QStringLiteral("toolRegion"))->isChecked());
  press(window, "answerCancel");
  bury();
  QVERIFY(solved());
  key(window, Qt::Key_Escape);
  QVERIFY(is_asked(window, "answerAccept") && solved());
  press(window, "answerAccept");
  QCOMPARE(window.document().scans(), std::vector<int>{1});
  QVERIFY(window.undo().can_undo());
}

void AskingTest::what_was_painted_does_not_go_in_silence() {
  Shown window({scan_file(folder_, QStringLiteral("painted.ply"), make_icosphere(3)), sample_file(folder_)});
  auto* banner = window.findChild<Banner*>();
  key(window, Qt::Key_R);
  const auto paint = [&](double above) {
    std::vector<int> top;
    const Points& points = window.document().scan(0)->model->soup.points;
    for (std::size_t p = 0; p < points.size(); ++p)
      if (points[p].z() > above) top.push_back(static_cast<int>(p));
    window.tools().region().set_vertices(0, top);
  };
  paint(0.8);
  press(window, "trialEvolve");
  const auto stage = [&] { return window.tools().trial().stage(); };
  QVERIFY(wait_until([&] { return stage() == ProblemController::Stage::solved; }));
  paint(0.7);
  QVERIFY(stage() == ProblemController::Stage::none);
  QVERIFY2(banner->text().startsWith(QStringLiteral("The result was discarded")), qPrintable(banner->text()));
  QVERIFY(window.tools().region().count() > 0);
  press_and_wait(window, "fillAndSmooth");
  QCOMPARE(window.tools().region().count(), 0);
  QVERIFY2(banner->text().startsWith(QStringLiteral("What was painted is gone")), qPrintable(banner->text()));
  // Accepted, it has become a part of the surface: nothing is said.
  banner->hide();
  paint(0.8);
  press(window, "trialEvolve");
  QVERIFY(wait_until([&] { return stage() == ProblemController::Stage::solved; }));
  press(window, "trialAccept");
  QVERIFY2(!banner->text().startsWith(QStringLiteral("What was painted is gone")) || banner->isHidden(),
           qPrintable(banner->text()));
}

void AskingTest::nothing_is_said_of_what_was_not_judged() {
  Shown window({sample_file(folder_)});
  const int hole = first_hole(window.document());
  window.selection().select({hole});
  press(window, "fill");
  QVERIFY(wait_idle(window));
  press(window, "otherPatches");
  auto* panel = window.findChild<CandidatesPanel*>();
  CandidateCard* card = panel->card(CandidateKind::as_it_is);
  QVERIFY(card);
  QVERIFY2(card->accessibleName().endsWith(QStringLiteral("not judged")), qPrintable(card->accessibleName()));
  key(window, Qt::Key_Escape);
  QVERIFY(!window.candidates().busy());
  QVERIFY(window.candidates().candidates().size() != 1);  // one card, or a white one, is nothing to choose from
}

void AskingTest::what_could_not_be_filled_is_told_while_it_is_true() {
  Shown window({sample_file(folder_)});
  auto* banner = window.findChild<Banner*>();
  press(window, "fill");
  QVERIFY(wait_idle(window));
  Q_EMIT window.controller().left_open(QStringLiteral("Hole 3 could not be filled"));
  QVERIFY(banner->isVisible());
  window.undo().undo();
  QVERIFY(!banner->isVisible());
  Q_EMIT window.controller().left_open(QStringLiteral("Hole 3 could not be filled"));
  press(window, "fill");
  QVERIFY(!banner->isVisible());
  QVERIFY(wait_idle(window));
}

/// The small hole is filled first.
void AskingTest::the_eye_goes_to_the_largest_hole() {
  const TriangleSoup soup =
      cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8 || (p - Vec3(0, 0, -1)).norm() < 0.1; });
  Shown window({scan_file(folder_, QStringLiteral("two_holes.ply"), soup)});
  const Document& document = window.document();
  QCOMPARE(document.loop_count(), 2);
  const int large = document.loop(0).diameter > document.loop(1).diameter ? 0 : 1;
  QSignalSpy filled(&window.controller(), &FillController::filled);
  std::set<int> first;
  const auto remember =
      QObject::connect(&window.controller(), &FillController::filled, [&](const std::set<int>& loops) {
        if (first.empty()) first = loops;
      });
  press(window, "fillAndSmooth");
  QVERIFY(wait_idle(window));
  QObject::disconnect(remember);
  QVERIFY(first.contains(large));
}

void AskingTest::flows_are_compared_in_one_window() {
  Shown window({sample_file(folder_)});
  window.selection().select({first_hole(window.document())});
  CompareWindow* first = window.comparisons().compare_holes({});
  QVERIFY(first);
  QCOMPARE(window.comparisons().compare_holes({}), first);
  first->close();
  bury();
  QVERIFY(window.findChildren<CompareWindow*>().isEmpty());
  CompareWindow* again = window.comparisons().compare_holes({});
  QVERIFY(again);
  again->close();
}

void AskingTest::one_truth_about_faces_that_touch() {
  Watertightness surface;
  surface.volume = 1;
  surface.intersections = 5;
  QCOMPARE(labels::verdict(surface), QStringLiteral("Watertight, not ready to print: 5 pairs of faces that intersect"));
  surface.touching_edges = 6;  // `loopmend info` calls them edges of more than two faces
  QCOMPARE(labels::verdict(surface), QStringLiteral("Not ready to print: 5 pairs of faces that intersect and more"));
  QVERIFY(labels::verdict_in_full(surface).contains(QStringLiteral("6 edges along which it touches itself")));
}

void AskingTest::the_mirror_speaks_of_the_selection() {
  Shown window({sample_file(folder_)});
  const int hole = first_hole(window.document());
  window.selection().select({hole});
  press(window, "fill");
  QVERIFY(wait_idle(window));
  window.tools().take(Tool::mirror);
  const MirrorGuide& guide = window.tools().mirror_guide();
  QVERIFY(wait_until([&] { return !guide.busy() && guide.plane(); }));
  QCOMPARE(text_of(window, "mirrorFits"), QStringLiteral("No selected hole of this scan is open."));
}

/// A ball with a hole, and a fin on an edge of it: holes, cuts and rims.
void AskingTest::loops_that_are_left_out_are_counted_alike() {
  TriangleSoup soup = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.9; });
  const Triangle t = soup.triangles[soup.triangles.size() / 2];
  soup.points.push_back(1.5 * soup.points[static_cast<std::size_t>(t[0])]);
  soup.triangles.push_back({t[0], t[1], static_cast<int>(soup.points.size()) - 1});
  Shown window({scan_file(folder_, QStringLiteral("fin.ply"), soup)});
  const Document& document = window.document();
  press(window, "fill");
  QVERIFY(wait_idle(window));
  int left = 0;
  for (int loop = 0; loop < document.loop_count(); ++loop) left += document.state(loop) == HoleState::left_out;
  QVERIFY(left > 0);
  QVERIFY2(text_of(window, "holesSummary").contains(QStringLiteral("%1 left out").arg(left)),
           qPrintable(text_of(window, "holesSummary")));
  const QString facts = fill_report(document).facts.join(QLatin1Char(' '));
  QVERIFY2(facts.contains(QStringLiteral("Open: 0. Left out: %1.").arg(left)), qPrintable(facts));
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<AskingTest>(); }
#include "asking_test.moc"
