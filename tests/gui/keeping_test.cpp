// SPDX-License-Identifier: GPL-3.0-or-later
// What outlasts the moment: preferences, recent files, saving before the window closes, how a session was looked at; and
// what becomes of a fill where the flow must give way.
#include "driver.h"
#include "test_main.h"

#include "dialogs/help_window.h"
#include "document/labels.h"
#include "document/preferences.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "panels/banner.h"
#include "samples/analytic_surfaces.h"
#include "views/file_desk.h"

#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QListWidget>
#include <QMenu>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QSpinBox>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <map>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

void trigger(MainWindow& window, const char* action) {
  window.findChild<QAction*>(QLatin1String(action), Qt::FindDirectChildrenOnly)->trigger();
}

QList<QAction*> recent_entries(MainWindow& window) {
  for (QMenu* menu : window.findChildren<QMenu*>())
    if (menu->title().contains(QStringLiteral("recent"))) {
      Q_EMIT menu->aboutToShow();
      return menu->actions();
    }
  return {};
}

bool near(const Vec3& a, const Vec3& b) { return (a - b).norm() < 1e-9 * (1 + b.norm()); }

/// A unit sphere with two neighbouring holes; a plate stands where the patch of the larger one wants to go.
QString write_obstructed_sphere(const QString& path) {
  const Vec3 large = Vec3::UnitZ(), small = Vec3(std::sin(1.05), 0, std::cos(1.05));
  const auto within = [](const Vec3& p, const Vec3& middle, double angle) { return p.dot(middle) > std::cos(angle); };
  const TriangleSoup sphere =
      cut(make_icosphere(4), [&](const Vec3& p) { return within(p, large, 0.5) || within(p, small, 0.3); });
  TriangleSoup plate;
  for (double x : {-0.1, 0.1})
    for (double z : {0.95, 1.2}) plate.points.emplace_back(x, 0, z);
  plate.triangles = {{0, 2, 1}, {1, 2, 3}};
  write_mesh(path.toStdString(), joined({sphere, plate}));
  return path;
}

Points sorted(Points points) {
  std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  return points;
}

}  // namespace

class KeepingTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void preferences_count_at_once_and_stay();
  void recent_files_are_listed_opened_and_forgotten();
  void closing_saves_first_if_wanted();
  void closing_a_scan_asks_before_its_patches_go();
  void export_offers_to_smooth_initial_patches();
  void a_session_is_looked_at_as_before();
  void a_session_of_the_first_version_opens();
  void where_the_flow_must_give_way();
  void window_and_command_line_give_the_same_bits_data();
  void window_and_command_line_give_the_same_bits();
  void help_is_there_in_german();
  void everything_can_be_reached_by_keys();
  void the_picture_is_moved_and_asked_by_keys();
  void a_right_click_on_a_hole_offers_what_applies();
  void the_layout_is_kept_and_fits_a_small_screen();
  void sides_projection_and_zoom_to_the_cursor();
  void what_will_not_be_saved_is_told_on_opening();

 private:
  QTemporaryDir folder_;
};

void KeepingTest::preferences_count_at_once_and_stay() {
  Shown shown({sample_file(folder_)});
  MainWindow& window = shown.window;
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
  Shown shown({first});
  MainWindow& window = shown.window;
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
}

void KeepingTest::closing_saves_first_if_wanted() {
  const QString path = folder_.filePath(QStringLiteral("closing.loopmend"));
  {
    Shown shown({sample_file(folder_)});
    MainWindow& window = shown.window;
    const int hole = first_hole(window.document());
    window.selection().select({hole});
    press(window, "fill");
    QVERIFY(wait_idle(window));
    window.controller().save_session(path);
    QVERIFY(wait_idle(window));
    window.selection().select({hole + 1});
    press(window, "fill");
    QVERIFY(wait_idle(window));
    QVERIFY2(!window.close(), "unsaved work: it should ask");
    press(window, "answerCancel");
    settle(100);
    QVERIFY(window.isVisible());
    QVERIFY(!window.close());
    press(window, "answerSave");
    QVERIFY2(wait_until([&] { return !window.isVisible(); }, 20), "it should save, then close");
  }
  Shown shown({path});
  QVERIFY(shown.ready);
  QCOMPARE(shown.window.document().patches().size(), std::size_t(2));
}

void KeepingTest::closing_a_scan_asks_before_its_patches_go() {
  Shown shown({sample_file(folder_)});
  MainWindow& window = shown.window;
  auto* files = window.findChild<FileDesk*>();
  window.selection().select({first_hole(window.document())});
  press(window, "fill");
  QVERIFY(wait_idle(window));
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
  Shown shown({sample_file(folder_)});
  MainWindow& window = shown.window;
  auto* files = window.findChild<FileDesk*>();
  window.selection().select({first_hole(window.document())});
  press(window, "fill");
  QVERIFY(wait_idle(window));
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
  QVERIFY(wait_until([&] { return QFile::exists(path); }, 60));
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
    Shown shown({sample_file(folder_)});
    MainWindow& window = shown.window;
    const int hole = first_hole(window.document());
    window.selection().select({hole});
    press(window, "fill");
    QVERIFY(wait_idle(window));
    key(window, Qt::Key_4);
    key(window, Qt::Key_W);
    key(window, Qt::Key_M);
    window.view().fly_to(hole);
    settle(900);
    window.controller().save_session(path);
    QVERIFY(wait_idle(window));
    from = window.view().viewpoint();
    picture = window.view().picture();
    QVERIFY(window.close());
  }
  Shown shown({path});
  MainWindow& window = shown.window;
  QVERIFY(shown.ready);
  const Viewpoint now = window.view().viewpoint();
  QVERIFY(near(now.eye, from.eye) && near(now.focus, from.focus) && near(now.up, from.up));
  QCOMPARE(window.view().look().shading, Shading::zebra);
  QCOMPARE(window.view().look().edges, Edges::shown);
  QCOMPARE(window.view().look().seams, Seams::hidden);
  QVERIFY(part<QAction>(window, "zebra")->isChecked());
  QVERIFY2(wait_until([&] { return share_changed(picture, window.view().picture()) < 0.01; }, 15),
           "the picture is another one");
}

void KeepingTest::a_session_of_the_first_version_opens() {
  // Without a view and without patches, the sixth version ends so: four bytes that say that the scan has a file of its own,
  // eight that count the patches, four that say that there is no view, four of a unit without letters. The first had the eight
  // alone.
  Session session;
  session.scans.push_back({sample_file(folder_), 0, {}, nullptr, {}, nullptr});
  {
    Shown shown({sample_file(folder_)});
    session = session_of(shown.window.document(), {});
  }
  QByteArray bytes = to_bytes(session, folder_.path());
  constexpr int version_at = 17;  // behind "Loopmend session\n"
  QCOMPARE(bytes[version_at], '\6');
  bytes[version_at] = '\1';
  bytes.chop(8);
  bytes.remove(bytes.size() - 12, 4);
  QFile file(folder_.filePath(QStringLiteral("old.loopmend")));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(bytes);
  file.close();
  Shown shown({file.fileName()});
  QVERIFY(shown.ready);
  QVERIFY(count_colors(shown.window.view().picture()) >= 64);
}

void KeepingTest::where_the_flow_must_give_way() {
  const QString scan = write_obstructed_sphere(folder_.filePath(QStringLiteral("obstructed.ply")));
  Shown shown({scan});
  MainWindow& window = shown.window;
  const Document& document = window.document();
  press(window, "fill");
  QVERIFY(wait_idle(window));
  QCOMPARE(document.patches().size(), std::size_t(1));  // neighbours: one problem
  press(window, "fillAndSmooth");
  QVERIFY(wait_idle(window, 240));
  // Together they would cut the plate: each by itself, and the large one stays as it was filled.
  QCOMPARE(document.patches().size(), std::size_t(2));
  const PatchState &large = *document.patch_of(0)->state, &small = *document.patch_of(1)->state;
  QVERIFY2(large.status == PatchStatus::filled, large.message.c_str());
  QVERIFY2(QString::fromStdString(large.message).contains(QStringLiteral("kept")), large.message.c_str());
  QVERIFY2(small.status == PatchStatus::converged, small.message.c_str());
  const QString by_hand = folder_.filePath(QStringLiteral("by-hand.ply"));
  window.controller().export_to(by_hand);
  QVERIFY(wait_idle(window));
  const QString by_script = folder_.filePath(QStringLiteral("by-script.ply"));
  QProcess program;
  program.start(QStringLiteral(LOOPMEND_PROGRAM), {QStringLiteral("fill"), scan, QStringLiteral("-o"), by_script});
  QVERIFY(program.waitForFinished(120000));
  QCOMPARE(program.exitCode(), 0);
  QVERIFY2(
      sorted(read_mesh(by_hand.toStdString()).soup.points) == sorted(read_mesh(by_script.toStdString()).soup.points),
      "window and command line do not give the same vertices");
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(document.patches().size(), std::size_t(1));
}

namespace {

/// A sphere with a hole, a fin, and a crack along part of its equator.
TriangleSoup to_be_mended() {
  TriangleSoup soup = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; });
  const std::size_t before = soup.points.size();
  std::map<int, int> twin;
  for (std::size_t v = 0; v < before; ++v)
    if (const Vec3 p = soup.points[v]; std::abs(p.z()) < 1e-12 && p.x() > 0.3) {
      twin[static_cast<int>(v)] = static_cast<int>(soup.points.size());
      soup.points.push_back(p);
    }
  for (Triangle& t : soup.triangles) {
    double z = 0;
    for (int v : t) z += soup.points[static_cast<std::size_t>(v)].z();
    for (int& v : t)
      if (z > 0 && twin.contains(v)) v = twin[v];
  }
  const auto lowest = std::min_element(soup.triangles.begin(), soup.triangles.end(), [&](const auto& s, const auto& t) {
    return soup.points[static_cast<std::size_t>(s[0])].z() < soup.points[static_cast<std::size_t>(t[0])].z();
  });
  const Triangle fin{(*lowest)[0], (*lowest)[1], static_cast<int>(soup.points.size())};
  soup.points.emplace_back(0, 0, -2);
  soup.triangles.push_back(fin);
  return soup;
}

}  // namespace

void KeepingTest::window_and_command_line_give_the_same_bits_data() {
  QTest::addColumn<QString>("scan");
  QTest::addColumn<QStringList>("options");
  QTest::newRow("sample") << sample_file(folder_) << QStringList();
  for (const char* name : {"bunny.ply", "head_holes.ply", "plane_holes.obj"})
    QTest::newRow(name) << QStringLiteral(LOOPMEND_SHARED_DIR "/data/") + QLatin1String(name) << QStringList();
  QTest::newRow("relief") << sample_file(folder_) << QStringList{QStringLiteral("--relief"), QStringLiteral("continued")};
  const QString island = folder_.filePath(QStringLiteral("island.ply"));
  write_mesh(island.toStdString(), cut(make_icosphere(5), [](const Vec3& p) {
               return p.z() > 0.7 && (p - Vec3(0.2, 0, 0.98).normalized()).norm() > 0.15;
             }));
  QTest::newRow("island") << island << QStringList();
  QTest::newRow("island covered") << island << QStringList{QStringLiteral("--islands"), QStringLiteral("cover")};
  const QString mend = folder_.filePath(QStringLiteral("mend.ply"));
  write_mesh(mend.toStdString(), to_be_mended());
  for (const char* option : {"--stitch", "--repair"})
    QTest::newRow(option) << mend << QStringList{QLatin1String(option)};
  const QString ragged = folder_.filePath(QStringLiteral("ragged.ply"));
  TriangleSoup dangling = cut(make_icosphere(4), [](const Vec3& p) { return p.z() + 0.1 * p.x() > 0.8; });
  const SurfaceModel open = make_surface_model(dangling);
  const BoundaryLoop loop = find_boundary_loops(open).front();
  const int a = open.soup_vertex[static_cast<std::size_t>(loop.vertices[0])];
  const int b = open.soup_vertex[static_cast<std::size_t>(loop.vertices[1])];
  // A triangle on one edge of the boundary, beyond the surface.
  const Vec3 &from = dangling.points[static_cast<std::size_t>(a)], &to = dangling.points[static_cast<std::size_t>(b)];
  dangling.points.push_back((from + to) / 2 + (loop.center - (from + to) / 2) * 0.1);
  dangling.triangles.push_back({a, b, static_cast<int>(dangling.points.size()) - 1});
  write_mesh(ragged.toStdString(), dangling);
  QTest::newRow("ragged boundary") << ragged << QStringList{QStringLiteral("--trim-boundary"), QStringLiteral("3")};
}

/// Everything that a person gets who fills all holes, runs the flow and exports, against the command's file.
void KeepingTest::window_and_command_line_give_the_same_bits() {
  QFETCH(QString, scan);
  QFETCH(QStringList, options);
  if (!QFile::exists(scan)) QSKIP("the shared scans are not here");
  Shown shown({scan});
  MainWindow& window = shown.window;
  if (options.contains(QStringLiteral("--trim-boundary"))) {
    const std::size_t before = window.document().scan(0)->model->soup.triangles.size();
    press(window, "trim");
    QVERIFY(wait_idle(window));
    const int trimmed = window.document().scans().front();
    QVERIFY(window.document().scan(trimmed)->model->soup.triangles.size() < before);
  }
  const auto mended = [&](const std::function<void()>& act) {
    const int before = window.document().scans().front();
    act();
    return wait_idle(window) && window.document().scans().front() != before;  // another one came in its place
  };
  if (options.contains(QStringLiteral("--stitch"))) QVERIFY(mended([&] { press(window, "stitch"); }));
  if (options.contains(QStringLiteral("--repair")))
    QVERIFY(mended([&] { window.controller().repair(harmless_repairs); }));
  part<QCheckBox>(window, "islands")->setChecked(!options.contains(QStringLiteral("--islands")));
  part<QCheckBox>(window, "relief")->setChecked(options.contains(QStringLiteral("--relief")));
  press(window, "fill");
  QVERIFY(wait_idle(window));
  press(window, "fillAndSmooth");
  QVERIFY(wait_idle(window, 240));
  const QString by_hand = folder_.filePath(QStringLiteral("window.ply"));
  const QString by_script = folder_.filePath(QStringLiteral("command.ply"));
  window.controller().export_to(by_hand);
  QVERIFY(wait_idle(window));
  QProcess program;
  program.start(QStringLiteral(LOOPMEND_PROGRAM),
                QStringList{QStringLiteral("fill"), scan, QStringLiteral("-o"), by_script} + options);
  QVERIFY(program.waitForFinished(240000));
  QFile ours(by_hand), theirs(by_script);
  QVERIFY(ours.open(QIODevice::ReadOnly) && theirs.open(QIODevice::ReadOnly));
  const QByteArray expected = theirs.readAll();
  QVERIFY(expected.size() > 1000);
  QVERIFY2(ours.readAll() == expected, "the window's file is not the command's");
}

void KeepingTest::help_is_there_in_german() {
  const QLocale before;
  QLocale::setDefault(QLocale(QStringLiteral("de")));
  HelpWindow help;
  auto* pages = help.findChild<QListWidget*>();
  QSet<QString> names, links;
  for (int row = 0; row < pages->count(); ++row) {
    const QString name = pages->item(row)->data(Qt::UserRole).toString();
    names << name;
    pages->setCurrentRow(row);
    QVERIFY2(help.shown_text().contains(QStringLiteral(" der ")), qPrintable(name));
    // The same links and pictures as in English, and all of them there.
    QStringList found[2];
    for (int german : {0, 1}) {
      QFile page((german ? QStringLiteral(":/help/de/%1.md") : QStringLiteral(":/help/%1.md")).arg(name));
      QVERIFY(page.open(QIODevice::ReadOnly));
      auto matches =
          QRegularExpression(QStringLiteral("\\]\\(([^)]+)\\)")).globalMatch(QString::fromUtf8(page.readAll()));
      while (matches.hasNext()) found[german] << matches.next().captured(1).remove(QStringLiteral("../"));
    }
    QCOMPARE(found[1], found[0]);
    for (const QString& link : found[1]) QVERIFY2(QFile::exists(QStringLiteral(":/help/") + link), qPrintable(link));
  }
  QLocale::setDefault(before);
}

void KeepingTest::everything_can_be_reached_by_keys() {
  Shown shown({sample_file(folder_)});
  MainWindow& window = shown.window;
  press(window, "fill");
  QVERIFY(wait_idle(window));
  window.view().canvas()->setFocus();
  QSet<QWidget*> reached;
  for (int i = 0; i < 200; ++i) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    reached << QApplication::focusWidget();
  }
  QStringList missed;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    const bool control = widget->inherits("QAbstractButton") || widget->inherits("QComboBox") ||
                         widget->inherits("QAbstractSpinBox") || widget->inherits("QAbstractSlider") ||
                         widget->inherits("QAbstractItemView") || widget->inherits("QLineEdit");
    const bool inner = widget->objectName().isEmpty() || widget->objectName().startsWith(QStringLiteral("qt_")) ||
                       widget->inherits("QScrollBar") || qobject_cast<QAbstractSpinBox*>(widget->parentWidget());
    if (control && !inner && widget->isVisible() && widget->isEnabled() && !reached.contains(widget))
      missed << widget->objectName();
  }
  QVERIFY2(missed.isEmpty(), qPrintable(missed.join(QStringLiteral(", "))));
  // Every action has a key or stands in a menu, which keys open.
  QSet<QAction*> in_menus;
  for (QMenu* menu : window.findChildren<QMenu*>())
    for (QAction* action : menu->actions()) in_menus << action;
  for (QAction* action : window.findChildren<QAction*>(QString(), Qt::FindDirectChildrenOnly))
    if (!action->objectName().isEmpty())
      QVERIFY2(in_menus.contains(action) || !action->shortcut().isEmpty(), qPrintable(action->objectName()));
}

void KeepingTest::the_picture_is_moved_and_asked_by_keys() {
  Shown shown({sample_file(folder_)});
  MainWindow& window = shown.window;
  QWidget* canvas = window.view().canvas();
  canvas->setFocus();
  const Viewpoint first = window.view().viewpoint();
  QTest::keyClick(canvas, Qt::Key_Left);
  const Viewpoint turned = window.view().viewpoint();
  QVERIFY(near(turned.focus, first.focus) && !near(turned.eye, first.eye));
  QTest::keyClick(canvas, Qt::Key_Right, Qt::ShiftModifier);
  const Viewpoint slid = window.view().viewpoint();
  QVERIFY(near(slid.eye - turned.eye, slid.focus - turned.focus) && !near(slid.eye, turned.eye));
  QTest::keyClick(canvas, Qt::Key_Left, Qt::ShiftModifier);
  QVERIFY((window.view().viewpoint().eye - turned.eye).norm() < 1e-6 * turned.eye.norm());
  key(window, Qt::Key_P);
  const QString words = part<QLabel>(window, "statusFigures")->text();
  QVERIFY2(words.contains(QStringLiteral("vertex")), qPrintable(words));
}

void KeepingTest::a_right_click_on_a_hole_offers_what_applies() {
  Shown shown({sample_file(folder_)});
  MainWindow& window = shown.window;
  const int hole = first_hole(window.document());
  window.view().fly_to(hole);
  settle(900);
  const QPoint at = visible_point(window, hole);
  QTest::mouseClick(window.view().canvas(), Qt::RightButton, {}, at);
  // One that was closed is deleted a little later.
  const auto open_menu = [&]() -> QMenu* {
    for (QMenu* menu : window.findChildren<QMenu*>(QStringLiteral("holeMenu")))
      if (menu->isVisible()) return menu;
    return nullptr;
  };
  QVERIFY(wait_until([&] { return open_menu() != nullptr; }, 5));
  QCOMPARE(window.selection().selected(), std::set<int>{hole});
  QMenu* menu = open_menu();
  const QList<QAction*> offered = menu->actions();
  const auto is_offered = [&](const char* name) {
    const auto* action = part<QAction>(window, name);
    return offered.contains(const_cast<QAction*>(action)) && action->isEnabled();
  };
  QVERIFY(is_offered("fillAction") && is_offered("trimAction"));
  QVERIFY(!is_offered("acceptAction"));
  menu->close();
  trigger(window, "initialAction");
  QVERIFY(wait_idle(window));
  QVERIFY(part<QAction>(window, "acceptAction")->isEnabled());
  // The same menu in the table; the header keeps the columns.
  auto* table = part<QTableView>(window, "holesTable");
  Q_EMIT table->customContextMenuRequested(table->visualRect(table->model()->index(0, 1)).center());
  QVERIFY(wait_until([&] { return open_menu() != nullptr; }, 5));
  open_menu()->close();
}

void KeepingTest::the_layout_is_kept_and_fits_a_small_screen() {
  {
    Shown shown({sample_file(folder_)});
    const QSize least = shown.window.minimumSizeHint();
    QVERIFY2(least.width() <= 1260 && least.height() <= 670,
             qPrintable(QStringLiteral("%1 x %2").arg(least.width()).arg(least.height())));
    shown.window.resize(1200, 700);
    part<QDockWidget>(shown.window, "inspectDock")->hide();
    trigger(shown.window, "zebra");
    trigger(shown.window, "wireframe");
    settle(200);
    shown.window.keep_layout();
  }
  MainWindow next;
  next.restore_layout();
  next.show();
  settle(200);
  QCOMPARE(next.size(), QSize(1200, 700));
  QVERIFY(part<QDockWidget>(next, "inspectDock")->isHidden());
  QVERIFY(next.findChild<QAction*>(QStringLiteral("zebra"), Qt::FindDirectChildrenOnly)->isChecked());
  QVERIFY(next.findChild<QAction*>(QStringLiteral("wireframe"), Qt::FindDirectChildrenOnly)->isChecked());
}

void KeepingTest::sides_projection_and_zoom_to_the_cursor() {
  Shown shown({sample_file(folder_)});
  MainWindow& window = shown.window;
  const auto direction = [&] {
    const Viewpoint from = window.view().viewpoint();
    return Vec3((from.eye - from.focus).normalized());
  };
  trigger(window, "lookRight");
  const Vec3 right = direction();
  trigger(window, "lookLeft");
  QVERIFY((right + direction()).norm() < 1e-9);
  trigger(window, "lookTop");
  QVERIFY(std::abs(right.dot(direction())) < 1e-9);

  trigger(window, "lookFront");
  settle(400);
  const QImage perspective = window.view().picture();
  trigger(window, "orthographic");
  QVERIFY(picture_changes(window, perspective, 0.001));
  trigger(window, "orthographic");
  QVERIFY(picture_returns(window, perspective));

  // What lies under the cursor stays there: only exactly so in the focal plane, which runs through the middle of the scan.
  for (const bool orthographic : {false, true}) {
    if (orthographic) trigger(window, "orthographic");
    trigger(window, "lookFront");
    settle(300);
    QWidget* canvas = window.view().canvas();
    const QPoint at(canvas->width() / 4, canvas->height() / 3);
    const Viewpoint before = window.view().viewpoint();
    QWheelEvent wheel(at, canvas->mapToGlobal(at), {}, {0, 120}, Qt::NoButton, {}, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(canvas, &wheel);
    settle(300);
    const Viewpoint after = window.view().viewpoint();
    const double closer = (before.eye - before.focus).norm() / (after.eye - after.focus).norm();
    QVERIFY2(closer > 1.05, qPrintable(QString::number(closer)));
    // The focus moves towards the cursor: up and to the left of the picture.
    const Vec3 side = (before.focus - before.eye).cross(before.up).normalized();
    const Vec3 way = after.focus - before.focus;
    QVERIFY(way.dot(side) < 0 && way.dot(before.up) > 0);
    const double aspect = static_cast<double>(canvas->width()) / canvas->height();
    QVERIFY(std::abs(way.dot(side) / way.dot(before.up) + 0.5 * aspect / (1.0 / 3)) < 0.05);
  }
}

void KeepingTest::what_will_not_be_saved_is_told_on_opening() {
  const QString path = folder_.filePath(QStringLiteral("normals.obj"));
  write_mesh(path.toStdString(), cut(make_icosphere(2), [](const Vec3& p) { return p.z() > 0.8; }));
  const auto told = [&] {
    Shown shown({path});
    return labels::import_summary(*shown.window.document().scan(shown.window.document().scans().front()));
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
