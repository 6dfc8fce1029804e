// SPDX-License-Identifier: GPL-3.0-or-later
// What outlasts the moment: preferences, recent files, saving before the window closes, how a session was looked at.
#include "driver.h"
#include "test_main.h"

#include "document/hole_table.h"
#include "document/labels.h"
#include "document/language.h"
#include "document/preferences.h"
#include "document/recent_pictures.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "samples/analytic_surfaces.h"
#include "views/file_controller.h"

#include <QAction>
#include <QComboBox>
#include <QCommandLinkButton>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QFile>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLabel>
#include <QMenu>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <map>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

QList<QAction*> recent_entries(MainWindow& window) {
  for (QMenu* menu : window.findChildren<QMenu*>())
    if (menu->title().contains(QStringLiteral("recent"))) {
      Q_EMIT menu->aboutToShow();
      return menu->actions();
    }
  return {};
}

bool near(const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-9 * (1 + b.norm()); }

}  // namespace

class KeepingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_patch_at_its_end_stays_as_it_is();
  void preferences_count_at_once_and_stay();
  void recent_files_are_listed_opened_and_forgotten();
  void closing_saves_first_if_wanted();
  void closing_a_scan_asks_before_its_patches_go();
  void export_offers_to_smooth_initial_patches();
  void a_session_is_looked_at_as_before();
  void the_layout_is_kept_and_fits_a_small_screen();
  void a_window_that_was_elsewhere_comes_back_data();
  void a_window_that_was_elsewhere_comes_back();
  void no_button_moves_under_the_mouse_data();
  void no_button_moves_under_the_mouse();
  void hints_fit_a_low_window_data();
  void hints_fit_a_low_window();
  void the_table_has_the_room_that_is_there();
  void states_are_whole_with_every_column();
  void what_will_not_be_saved_is_told_on_opening();

 private:
  QTemporaryDir folder_;
};

void KeepingTest::preferences_count_at_once_and_stay() {
  Shown window({sample_file(folder_)});
  const QImage light = window.view().picture();
  trigger(window, "preferences");
  auto* dialog = window.findChild<QDialog*>(QStringLiteral("preferencesDialog"));
  QVERIFY(dialog && dialog->isVisible());
  const auto combo = [&](const char* name) { return dialog->findChild<QComboBox*>(QLatin1String(name)); };
  const auto number = [&](const char* name) { return dialog->findChild<QSpinBox*>(QLatin1String(name)); };
  combo("theme")->setCurrentIndex(2);
  QVERIFY(window.palette().color(QPalette::Window).lightness() < 128);
  QVERIFY2(picture_changes(window, light, 0.3), "the ground of the picture did not turn dark");
  combo("defaultMap")->setCurrentIndex(1);
  QCOMPARE(window.view().look().map, all_color_maps[1]);
  number("undoMemory")->setValue(100);
  QCOMPARE(window.undo().budget(), std::size_t{100} << 20);
  number("timelineMemory")->setValue(64);
  number("autosaveDelay")->setValue(33);
  combo("language")->setCurrentIndex(combo("language")->findData(QStringLiteral("de")));
  dialog->close();

  const Preferences kept = load_preferences();
  QCOMPARE(kept.theme, Theme::dark);
  QCOMPARE(kept.undo_megabytes, 100);
  QCOMPARE(kept.timeline_megabytes, 64);
  QCOMPARE(kept.autosave_seconds, 33);
  QCOMPARE(kept.language, QStringLiteral("de"));
  MainWindow next;
  QCOMPARE(next.undo().budget(), std::size_t{100} << 20);
  QCOMPARE(next.view().look().map, all_color_maps[1]);

  // What the file does not make sense of is brought into range, not believed.
  Preferences wrong = kept;
  wrong.undo_megabytes = -5;
  save_preferences(wrong);
  QCOMPARE(load_preferences().undo_megabytes, 64);

  trigger(window, "preferences");
  dialog = nullptr;
  for (QDialog* found : window.findChildren<QDialog*>(QStringLiteral("preferencesDialog")))
    if (found->isVisible()) dialog = found;
  QVERIFY(dialog);
  auto* buttons = dialog->findChild<QDialogButtonBox*>();
  QTest::mouseClick(buttons->button(QDialogButtonBox::RestoreDefaults), Qt::LeftButton);
  QCOMPARE(load_preferences().undo_megabytes, Preferences().undo_megabytes);
  QCOMPARE(load_preferences().theme, Theme::system);
  QVERIFY(window.palette().color(QPalette::Window).lightness() > 128);
  dialog->close();
}

void KeepingTest::recent_files_are_listed_opened_and_forgotten() {
  clear_recent_files();
  const QString first = sample_file(folder_);
  const QString second = write_sheet_with_holes(folder_.filePath(QStringLiteral("sheet.ply")), 2);
  Shown window({first});
  window.open(second);
  QVERIFY(wait_idle(window));
  QCOMPARE(recent_files(), (QStringList{second, first}));
  QList<QAction*> entries = recent_entries(window);
  QVERIFY(entries.size() >= 2);
  QVERIFY2(entries[0]->text().contains(QStringLiteral("sheet.ply")), qPrintable(entries[0]->text()));
  entries[1]->trigger();
  QVERIFY(wait_idle(window));
  QCOMPARE(window.document().first_scan().path, first);
  QCOMPARE(recent_files(), (QStringList{first, second}));
  QVERIFY(wait_until([&] { return !recent_picture(first).isNull(); }));
  const QImage pictured = recent_picture(first);
  QCOMPARE(pictured.size(), QSize(144, 96));
  QVERIFY(count_colors(pictured) >= 40);
  {
    Shown later;
    const auto links = later.findChild<QWidget*>(QStringLiteral("welcome"))->findChildren<QCommandLinkButton*>();
    const auto link = std::find_if(links.begin(), links.end(), [&](auto* l) { return first.endsWith(l->text()); });
    QVERIFY(link != links.end());
    QCOMPARE((*link)->iconSize(), QSize(72, 48));
  }
  QFile::remove(second);
  QCOMPARE(recent_files(), QStringList{first});  // what is gone is not offered
  for (int i = 0; i < 15; ++i) {
    const QString path = folder_.filePath(QStringLiteral("file%1.ply").arg(i));
    QVERIFY(QFile::copy(first, path));
    add_recent_file(path);
  }
  QCOMPARE(recent_files().size(), 10);
  recent_entries(window).last()->trigger();  // Forget these
  QVERIFY(recent_files().isEmpty());
  QVERIFY(recent_picture(first).isNull());
}

void KeepingTest::closing_saves_first_if_wanted() {
  const QString path = folder_.filePath(QStringLiteral("closing.loopmend"));
  {
    Shown window({sample_file(folder_)});
    const int hole = first_hole(window.document());
    window.selection().select({hole});
    QVERIFY(press_and_wait(window, "fill"));
    window.controller().save_session(path);
    QVERIFY(wait_idle(window));
    window.selection().select({hole + 1});
    QVERIFY(press_and_wait(window, "fill"));
    QVERIFY2(!window.close(), "unsaved work: it should ask");
    press(window, "answerCancel");
    settle();
    QVERIFY(window.isVisible());
    QVERIFY(!window.close());
    press(window, "answerSave");
    QVERIFY2(wait_until([&] { return !window.isVisible(); }), "it should save, then close");
  }
  Shown shown({path});
  QVERIFY(shown.ready);
  QCOMPARE(shown.document().patches().size(), std::size_t(2));
}

void KeepingTest::closing_a_scan_asks_before_its_patches_go() {
  Shown window({sample_file(folder_)});
  auto* files = window.findChild<FileController*>();
  window.selection().select({first_hole(window.document())});
  QVERIFY(press_and_wait(window, "fill"));
  files->close_scan(0);
  QVERIFY2(window.document().has_scan(), "unsaved work: it should ask");
  press(window, "answerCancel");
  QVERIFY(window.document().has_scan());
  QVERIFY2(!window.close(), "the work is still unsaved");
  press(window, "answerCancel");
  files->close_scan(0);
  press(window, "answerLose");
  QVERIFY(!window.document().has_scan());
  QVERIFY2(window.close(), "what was given up by name is not asked for again");
}

void KeepingTest::export_offers_to_smooth_initial_patches() {
  Shown window({sample_file(folder_)});
  auto* files = window.findChild<FileController*>();
  window.selection().select({first_hole(window.document())});
  QVERIFY(press_and_wait(window, "fill"));
  const QString path = folder_.filePath(QStringLiteral("smoothed.ply"));
  files->export_to(path);
  QVERIFY(!window.controller().busy() && !QFile::exists(path));
  press(window, "answerSmooth");
  QVERIFY(wait_until([&] { return QFile::exists(path); }, 120));
  QVERIFY(wait_idle(window));
  QVERIFY(window.document().patches().front().state->steps > 0);
  // Smooth patches are exported without a question.
  QFile::remove(path);
  files->export_to(path);
  QVERIFY(wait_until([&] { return QFile::exists(path); }));
  QVERIFY(wait_idle(window));
  // The status bar counts what is written, and says what is still open: four holes and the outline.
  const TriangleSoup written = read_mesh(path.toStdString()).soup;
  QCOMPARE(part<QLabel>(window, "statusScan")->text(),
           QStringLiteral("%1 triangles \u00b7 %2 vertices")
               .arg(labels::count(written.triangles.size()), labels::count(written.points.size())));
  QCOMPARE(part<QLabel>(window, "statusWatertight")->text(), QStringLiteral("Not watertight: 5 open boundary loops"));
  // Delete is for what is selected.
  window.selection().select({});
  key(window, Qt::Key_Delete);
  QCOMPARE(window.document().patches().size(), std::size_t(1));
  window.selection().select({first_hole(window.document())});
  key(window, Qt::Key_Delete);
  QVERIFY(window.document().patches().empty());
}

void KeepingTest::a_session_is_looked_at_as_before() {
  const QString path = folder_.filePath(QStringLiteral("looked.loopmend"));
  Viewpoint from;
  QImage picture;
  {
    Shown window({sample_file(folder_)});
    const int hole = first_hole(window.document());
    window.selection().select({hole});
    QVERIFY(press_and_wait(window, "fill"));
    key(window, Qt::Key_4);
    key(window, Qt::Key_W);
    key(window, Qt::Key_M);
    QVERIFY(fly(window, hole));
    window.controller().save_session(path);
    QVERIFY(wait_idle(window));
    from = window.view().viewpoint();
    picture = window.view().picture();
    QVERIFY(window.close());
  }
  Shown window({path});
  QVERIFY(window.ready);
  const Viewpoint now = window.view().viewpoint();
  QVERIFY(near(now.eye, from.eye) && near(now.focus, from.focus) && near(now.up, from.up));
  QCOMPARE(window.view().look().shading, Shading::zebra);
  QCOMPARE(window.view().look().edges, Edges::shown);
  QCOMPARE(window.view().look().seams, Seams::hidden);
  QVERIFY(part<QAction>(window, "zebra")->isChecked());
  QVERIFY2(wait_until([&] { return share_changed(picture, window.view().picture()) < 0.01; }),
           "the picture is another one");
}

void KeepingTest::the_layout_is_kept_and_fits_a_small_screen() {
  {
    Shown shown({sample_file(folder_)});
    const QSize least = shown.minimumSizeHint();
    QVERIFY2(least.width() <= 1260 && least.height() <= 670,
             qPrintable(QStringLiteral("%1 x %2").arg(least.width()).arg(least.height())));
    shown.resize(1200, 700);
    part<QDockWidget>(shown, "inspectDock")->show();
    part<QDockWidget>(shown, "sceneDock")->hide();
    trigger(shown, "zebra");
    trigger(shown, "wireframe");
    settle();
    shown.keep_layout();
  }
  MainWindow next;
  next.restore_layout();
  next.show();
  next.open(sample_file(folder_));  // docks come with a scan
  QVERIFY(wait_idle(next));
  settle();
  QCOMPARE(next.size(), QSize(1200, 700));
  QVERIFY(!part<QDockWidget>(next, "inspectDock")->isHidden());
  QVERIFY(part<QDockWidget>(next, "sceneDock")->isHidden());
  QVERIFY(next.findChild<QAction*>(QStringLiteral("zebra"), Qt::FindDirectChildrenOnly)->isChecked());
  QVERIFY(next.findChild<QAction*>(QStringLiteral("wireframe"), Qt::FindDirectChildrenOnly)->isChecked());
}

void KeepingTest::a_window_that_was_elsewhere_comes_back_data() {
  QTest::addColumn<QRect>("was");
  const QSize screen = QGuiApplication::primaryScreen()->availableSize();
  QTest::newRow("beside the screen") << QRect(screen.width() + 900, 100, 1200, 700);
  QTest::newRow("above and left of it") << QRect(-2000, -1500, 1200, 700);
  QTest::newRow("all but a corner outside") << QRect(screen.width() - 8, screen.height() - 8, 1200, 700);
  QTest::newRow("title bar outside") << QRect(100, -300, 1200, 700);
  QTest::newRow("larger than the screen") << QRect(50, 50, 2 * screen.width(), 2 * screen.height());
}

/// On a screen that is not there now, or was larger: kept as Qt writes it, brought onto the screen that is there.
void KeepingTest::a_window_that_was_elsewhere_comes_back() {
  QFETCH(QRect, was);
  {
    MainWindow window;
    window.setGeometry(was);
    save_window_layout({window.saveGeometry(), window.saveState()});
  }
  MainWindow window;
  window.restore_layout();
  window.show();
  QVERIFY(QTest::qWaitForWindowExposed(&window));
  const QRect screen = QGuiApplication::primaryScreen()->availableGeometry();
  wait_until([&] { return settle() && screen.contains(window.frameGeometry()); }, 10);
  const QRect now = window.frameGeometry();
  const QString words = QStringLiteral("%1 x %2 at %3, %4 on %5 x %6")
                            .arg(now.width())
                            .arg(now.height())
                            .arg(now.x())
                            .arg(now.y())
                            .arg(screen.width())
                            .arg(screen.height());
  QVERIFY2(screen.contains(now), qPrintable(words));
}

void KeepingTest::no_button_moves_under_the_mouse_data() {
  QTest::addColumn<QString>("language");
  QTest::addColumn<QSize>("size");
  QTest::newRow("English") << QStringLiteral("en") << QSize(1380, 860);
  QTest::newRow("German, small") << QStringLiteral("de") << QSize(1260, 680);
}

/// Whatever is filled, selected, left out or at work.
void KeepingTest::no_button_moves_under_the_mouse() {
  QFETCH(QString, language);
  QFETCH(QSize, size);
  install_language(language);
  const auto back = qScopeGuard([] { install_language(QStringLiteral("en")); });
  Shown window({sample_file(folder_)});
  window.resize(size);
  QStringList moved;
  std::map<QByteArray, QPoint> first;
  const auto names = {"fillAndSmooth",  "fill",       "trim",      "stitch",      "repair",       "run",
                      "step",           "accept",     "reject",    "cancel",      "compareFlows", "sigma",
                      "selectAllHoles", "holesTable", "seamTable", "inspectTabs", "meshCanvas"};
  for (const char* name : names) part<QWidget>(window, name);  // opens what is folded
  const auto look = [&](const char* when) {
    for (auto* panel : window.findChildren<QScrollArea*>()) panel->verticalScrollBar()->setValue(0);
    settle();
    for (const char* name : names) {
      const auto* widget = window.findChild<QWidget*>(QLatin1String(name));
      if (!widget) {
        moved << QStringLiteral("no widget %1").arg(QLatin1String(name));
        continue;
      }
      if (!widget->isVisible()) continue;  // controls for patches appear with the first one
      const QPoint at = widget->mapTo(&window, QPoint(0, 0));
      const auto [before, is_new] = first.try_emplace(name, at);
      if (before->second != at)
        moved << QStringLiteral("%1, %2: by %3, %4")
                     .arg(QLatin1String(name), QLatin1String(when))
                     .arg(at.x() - before->second.x())
                     .arg(at.y() - before->second.y());
    }
  };
  look("opened");
  auto* flow = part<QComboBox>(window, "flow");
  for (int k = flow->count() - 1; k >= 0; --k) {
    flow->setCurrentIndex(k);
    look(qPrintable(flow->currentText()));
  }
  const int hole = first_hole(window.document());
  window.selection().select({hole});
  look("one selected");
  press(window, "fillAndSmooth");
  look("at work");
  QVERIFY(wait_idle(window));
  look("one filled");
  window.selection().select({});
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  look("all filled");
  window.selection().select({0});
  look("the outer rim selected");
  window.selection().select({hole});
  press(window, "accept");
  look("accepted");
  QVERIFY2(moved.isEmpty(), qPrintable(moved.join(QLatin1Char('\n'))));
}

void KeepingTest::hints_fit_a_low_window_data() {
  QTest::addColumn<QString>("language");
  QTest::newRow("English") << QStringLiteral("en");
  QTest::newRow("German") << QStringLiteral("de");
}

/// What stands in the place of a verdict while there is none to read, and each verdict itself.
void KeepingTest::hints_fit_a_low_window() {
  QFETCH(QString, language);
  install_language(language);
  const auto back = qScopeGuard([] { install_language(QStringLiteral("en")); });
  Shown window({sample_file(folder_)});
  window.resize(1260, 680);
  const auto fits = [&] {
    settle();
    const auto* hint = part<QLabel>(window, "holeVerdict");
    const auto* box = part<QScrollArea>(window, "verdictBox");
    return hint->heightForWidth(box->viewport()->width()) <= box->viewport()->height();
  };
  QVERIFY2(fits(), qPrintable(part<QLabel>(window, "holeVerdict")->text()));
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  window.selection().select({});
  QVERIFY2(fits(), qPrintable(part<QLabel>(window, "holeVerdict")->text()));
  for (int loop = 0; loop < window.document().loop_count(); ++loop) {
    window.selection().select({loop});
    QVERIFY2(fits(), qPrintable(part<QLabel>(window, "holeVerdict")->text()));
  }
}

/// All of the sample's six loops before there is a verdict to read, and most of them after.
void KeepingTest::the_table_has_the_room_that_is_there() {
  Shown window({sample_file(folder_)}, Shown::Extent::usual);
  window.resize(1360, 860);
  const auto* table = part<QTableView>(window, "holesTable");
  const auto rows = [&] {
    settle();
    return table->viewport()->height() / table->rowHeight(0);
  };
  QVERIFY2(rows() >= 6, qPrintable(QString::number(rows())));
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  QVERIFY2(rows() >= 4, qPrintable(QString::number(rows())));
}

void KeepingTest::states_are_whole_with_every_column() {
  Shown window({sample_file(folder_)});
  auto* table = part<QTableView>(window, "holesTable");
  for (int column = 0; column < HoleTable::column_count; ++column) table->setColumnHidden(column, false);
  window.resize(1260, 680);
  settle();
  QVERIFY(table->horizontalHeader()->length() > table->viewport()->width());
  const auto all_are_whole = [&] {
    for (int loop = 0; loop < window.document().loop_count(); ++loop)
      if (table->columnWidth(HoleTable::state) <=
          table->fontMetrics().horizontalAdvance(labels::verdict_or_state(window.document(), loop)) + 16)
        return false;
    return true;
  };
  QVERIFY(all_are_whole());
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  QVERIFY(all_are_whole());
}

void KeepingTest::a_patch_at_its_end_stays_as_it_is() {
  Shown window({sample_file(folder_)});
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  const auto states = [&] {
    std::vector<PatchStatePtr> result;
    for (const OpenPatch& patch : window.document().patches()) result.push_back(patch.state);
    return result;
  };
  const auto first = states();
  press(window, "fillAndSmooth");
  QVERIFY(wait_idle(window));
  QVERIFY(states() == first);
  QVERIFY(part<QLabel>(window, "bannerText")->text().contains(QStringLiteral("at the end of this flow")));
  part<QComboBox>(window, "continuity")->setCurrentIndex(1);  // another choice counts
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  QVERIFY(states() != first);
}

void KeepingTest::what_will_not_be_saved_is_told_on_opening() {
  const QString path = folder_.filePath(QStringLiteral("normals.obj"));
  write_mesh(path.toStdString(), cut(make_icosphere(2), [](const Vec3& p) { return p.z() > 0.8; }));
  const auto told = [&] {
    Shown shown({path});
    return labels::import_summary(*shown.document().scan(shown.document().scans().front()));
  };
  QVERIFY(!told().contains(QStringLiteral("saved")));
  QFile file(path);
  QVERIFY(file.open(QIODevice::Append));
  file.write("vn 0 0 1\nvt 0 0\nl 1 2\nl 2 3\nl 3 4\nusemtl skin\n");
  file.close();
  QVERIFY(told().endsWith(QStringLiteral("Will not be saved: names of no face (1), lines (3).")));
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<KeepingTest>(); }

#include "keeping_test.moc"
