// SPDX-License-Identifier: GPL-3.0-or-later
// What a person meets beside the stories: looks, probes, pictures, filters, help, words on every control; and how long
// the window stands still.
#include "driver.h"
#include "test_main.h"

#include "dialogs/help_window.h"
#include "document/hole_table.h"
#include "dialogs/picture_dialog.h"
#include "document/language.h"
#include "io/write_mesh.h"
#include "samples/analytic_surfaces.h"
#include "samples/sample_scan.h"

#include <QAction>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <malloc.h>

#include <cstdio>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

const QString bunny = QStringLiteral(LOOPMEND_SHARED_DIR "/data/bunny.ply");

}  // namespace

class FeatureTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void every_look_draws_another_picture();
  void a_scan_with_colors_is_shown_in_them();
  void likely_error_colors_the_patches();
  void a_kept_picture_is_the_whole_picture();
  void a_point_tells_its_values();
  void pictures_of_any_size();
  void filter_and_groups();
  void help_is_complete();
  void every_control_has_a_name_and_words();
  void a_german_window_is_german_throughout();
  void a_large_scan_is_filled_before_its_curvature_is_known();
  void no_long_gaps_on_the_bunny();
  void undo_keeps_within_its_memory();
  void memory_is_given_back();

 private:
  QTemporaryDir folder_;
};

void FeatureTest::every_look_draws_another_picture() {
  Shown window({sample_file(folder_)});
  QList<QImage> pictures;
  const auto shoot = [&] {
    settle();
    if (!pictures.isEmpty()) QVERIFY(picture_changes(window, pictures.last(), 0.001));
    pictures << window.view().picture();
    QVERIFY(count_colors(pictures.last()) >= 40);
  };
  for (Qt::Key digit : {Qt::Key_1, Qt::Key_2, Qt::Key_3, Qt::Key_4, Qt::Key_5}) {
    key(window, digit);
    shoot();
  }
  key(window, Qt::Key_W);
  shoot();
  key(window, Qt::Key_W);
  key(window, Qt::Key_M);
  shoot();
  key(window, Qt::Key_M);
  key(window, Qt::Key_1);
  part<QComboBox>(window, "colorMap")->setCurrentIndex(1);
  shoot();
  part<QComboBox>(window, "rangeRule")->setCurrentIndex(2);
  const double range = window.view().range();
  part<QDoubleSpinBox>(window, "ownRange")->setValue(range / 4);
  QCOMPARE(window.view().range(), part<QDoubleSpinBox>(window, "ownRange")->value());
  shoot();
  // Edges can be seen in every shading.
  for (Qt::Key digit : {Qt::Key_1, Qt::Key_3, Qt::Key_4}) {
    key(window, digit);
    settle();
    const QImage bare = window.view().picture();
    key(window, Qt::Key_W);
    QVERIFY2(picture_changes(window, bare, 0.05), "no edges");
    key(window, Qt::Key_W);
    QVERIFY(picture_returns(window, bare));
  }
  for (int i = 0; i < pictures.size(); ++i)
    for (int k = i + 1; k < pictures.size(); ++k)
      QVERIFY2(share_changed(pictures[i], pictures[k]) > 0.001, qPrintable(QStringLiteral("%1 and %2").arg(i).arg(k)));
}

/// While a flow runs only the patch is drawn again, over what was kept; boundaries and the rest must not get lost.
void FeatureTest::a_scan_with_colors_is_shown_in_them() {
  TriangleSoup soup = make_sample_scan();
  soup.colors.assign(soup.points.size(), Color{20, 200, 30, 255});
  const QString path = folder_.filePath(QStringLiteral("green.ply"));
  write_mesh(path.toStdString(), soup);
  const auto green_share = [](const QImage& picture) {
    int green = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) {
        const QColor color = picture.pixelColor(x, y);
        green += color.green() > 80 && color.green() > 2 * color.red() && color.green() > 2 * color.blue();
      }
    return static_cast<double>(green) / (picture.width() * picture.height());
  };
  Shown window({path});
  QCOMPARE(window.view().look().shading, Shading::scan);
  settle();
  const double open = green_share(window.view().picture());
  QVERIFY2(open > 0.1, qPrintable(QString::number(open)));
  QVERIFY(press_and_wait(window, "fillAndSmooth", 120));
  settle();
  const double filled = green_share(window.view().picture());
  QVERIFY2(filled > open, "the patches do not have the colour of the scan");
  const auto& patch = *window.document().patches().front().state->shape;
  QCOMPARE(patch.colors.size(), patch.points.size());
  // Another scene without colours is shown by curvature again.
  window.undo().mark_saved();
  window.open_sample();
  QVERIFY(wait_until([&] { return window.view().look().shading == Shading::curvature; }));
  QVERIFY(wait_idle(window));
  QVERIFY(!part<QAction>(window, "scanColors")->isEnabled());
}

/// A saved session keeps the values, and undo takes them away.
void FeatureTest::likely_error_colors_the_patches() {
  Shown window({sample_file(folder_)});
  const auto* action = part<QAction>(window, "deviation");
  QVERIFY2(!action->isEnabled(), "there are no patches");
  QVERIFY(press_and_wait(window, "fillAndSmooth", 120));
  QVERIFY(action->isEnabled());
  settle();
  const QImage curvature = window.view().picture();
  trigger(window, "deviation");
  settle();
  QVERIFY(share_changed(curvature, window.view().picture()) > 0.01);
  double widest = 0;
  for (const OpenPatch& patch : window.document().patches()) {
    const Patch& p = patch.state->patch;
    const std::vector<float>& values = patch.state->shape->deviation;
    QCOMPARE(values.size(), p.positions.size());
    QVERIFY(std::all_of(values.begin(), values.begin() + p.free_count, [](float value) { return value > 0; }));
    QVERIFY(std::all_of(values.begin() + p.free_count, values.end(), [](float value) { return value == 0; }));
    widest = std::max(widest, static_cast<double>(*std::max_element(values.begin(), values.end())));
  }
  QVERIFY(window.view().range() > 0.3 * widest && window.view().range() <= 1.05 * widest);
  const QString session = folder_.filePath(QStringLiteral("likely.loopmend"));
  window.controller().save_session(session);
  QVERIFY(wait_idle(window));
  const std::vector<float> before = window.document().patches().front().state->shape->deviation;
  window.controller().open({session}, OpenMode::replace);
  QVERIFY(wait_idle(window, 60));
  QCOMPARE(window.view().look().shading, Shading::deviation);
  QVERIFY(window.document().patches().front().state->shape->deviation == before);
}

void FeatureTest::a_kept_picture_is_the_whole_picture() {
  Shown window({sample_file(folder_)});
  const int hole = first_hole(window.document());
  QVERIFY(fly(window, hole));
  QVERIFY(press_and_wait(window, "fill"));
  window.selection().select({hole});
  press(window, "run");
  QVERIFY(wait_until([&] { return window.document().patch_of(hole)->state->steps >= 3; }));
  key(window, Qt::Key_Escape);
  QVERIFY(wait_idle(window));
  QVERIFY(settle());  // it has come to where it was going
  const QImage kept = window.view().picture();
  key(window, Qt::Key_3);
  QVERIFY(picture_changes(window, kept, 0.01));
  key(window, Qt::Key_1);
  QVERIFY(picture_returns(window, kept));
}

void FeatureTest::a_point_tells_its_values() {
  Shown window({sample_file(folder_)});
  window.selection().select({0});
  QTest::mouseClick(window.view().canvas(), Qt::LeftButton, {}, window.view().canvas()->rect().center());
  const QString words = part<QLabel>(window, "statusFigures")->text();
  QVERIFY2(words.contains(QStringLiteral("vertex")) && words.contains(QStringLiteral("H ")), qPrintable(words));
  QCOMPARE(window.selection().selected(), std::set<int>{0});
  // Beside everything: the selection goes.
  QTest::mouseClick(window.view().canvas(), Qt::LeftButton, {}, QPoint(3, 3));
  QVERIFY(window.selection().selected().empty());
}

void FeatureTest::pictures_of_any_size() {
  Shown shown({sample_file(folder_)});
  PictureDialog dialog(shown.view(), &shown);
  dialog.show();
  const auto combo = [&](const char* name) { return dialog.findChild<QComboBox*>(QLatin1String(name)); };
  combo("pictureSize")->setCurrentIndex(1);
  const QString path = folder_.filePath(QStringLiteral("twice.png"));
  QVERIFY(dialog.save(path));
  const QImage twice(path);
  QCOMPARE(twice.size(), shown.view().size() * 2);
  QVERIFY(count_colors(twice) >= 64);
  combo("pictureGround")->setCurrentIndex(1);
  combo("pictureExtras")->setCurrentIndex(2);
  QVERIFY(dialog.save(path));
  const QImage cut_out(path);
  QCOMPARE(qAlpha(cut_out.pixel(2, 2)), 0);
  QCOMPARE(qAlpha(cut_out.pixel(cut_out.rect().center())), 255);
  QVERIFY(!dialog.save(QStringLiteral("/nonexistent-folder/x.png")));
  QVERIFY(dialog.findChild<QLabel*>(QStringLiteral("pictureTrouble"))->isVisible());
  settle();
  QVERIFY2(count_colors(shown.view().picture()) >= 64, "the window's own picture is spoilt");
}

void FeatureTest::filter_and_groups() {
  Shown window({sample_file(folder_)});
  const auto rows = [&] { return part<QTableView>(window, "holesTable")->model()->rowCount(); };
  const int all = rows();
  key(window, Qt::Key_L, Qt::ControlModifier);
  QTest::keyClicks(part<QLineEdit>(window, "holesFilter"), QStringLiteral("rim"));
  QVERIFY(rows() >= 1 && rows() < all);
  part<QLineEdit>(window, "holesFilter")->clear();
  const int hole = first_hole(window.document());
  window.selection().select({hole});
  QVERIFY(press_and_wait(window, "fill"));
  part<QComboBox>(window, "holesGroup")->setCurrentIndex(2);
  QCOMPARE(rows(), 1);
  QVERIFY2(window.selection().selected() == std::set<int>{hole}, "narrowing the table must not change the selection");
  part<QComboBox>(window, "holesGroup")->setCurrentIndex(0);
  // A click on State sorts open and doubtful holes to the top, and those left out to the end.
  auto* table = part<QTableView>(window, "holesTable");
  table->sortByColumn(HoleTable::state, Qt::AscendingOrder);
  const auto states = [&](int row) { return table->model()->index(row, HoleTable::state).data().toString(); };
  QCOMPARE(states(0), QStringLiteral("open"));
  QCOMPARE(states(all - 2), QStringLiteral("filled"));
  QCOMPARE(states(all - 1), QStringLiteral("outer rim"));
  // The rule about outer rims can be seen and changed.
  auto* boundaries = part<QCheckBox>(window, "includeRims");
  const int before = open_holes(window.document());
  QVERIFY(boundaries->isEnabled());
  boundaries->setChecked(true);
  QVERIFY(open_holes(window.document()) > before);
}

void FeatureTest::help_is_complete() {
  HelpWindow help;
  auto* pages = help.findChild<QListWidget*>();
  QVERIFY(pages->count() >= 6);
  for (int row = 0; row < pages->count(); ++row) {
    pages->setCurrentRow(row);
    QVERIFY2(help.shown_text().size() > 200, qPrintable(pages->item(row)->text()));
    QVERIFY(!help.shown_text().contains(QStringLiteral("never changed")));  // Trim, Stitch and Repair do change a scan
  }
}

void FeatureTest::every_control_has_a_name_and_words() {
  Shown shown({sample_file(folder_)});
  QStringList nameless;
  for (QWidget* widget : shown.findChildren<QWidget*>()) {
    const bool control = widget->inherits("QAbstractButton") || widget->inherits("QComboBox") ||
                         widget->inherits("QAbstractSpinBox") || widget->inherits("QAbstractSlider") ||
                         widget->inherits("QTableView");
    // Qt's own inner parts: dock title buttons, scroll bars, the line edit within a spin box.
    const bool inner = widget->objectName().startsWith(QStringLiteral("qt_")) || widget->objectName().isEmpty() ||
                       widget->inherits("QScrollBar") || widget->parentWidget()->inherits("QTabBar");
    if (!control || inner) continue;
    const bool named = !widget->accessibleName().isEmpty();
    const bool explained = !widget->toolTip().isEmpty() || !widget->accessibleDescription().isEmpty();
    if (!named || !explained) nameless << widget->objectName();
  }
  QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(QStringLiteral(", "))));
  for (QAction* action : shown.findChildren<QAction*>(QString(), Qt::FindDirectChildrenOnly))
    if (!action->objectName().isEmpty()) QVERIFY2(!action->toolTip().isEmpty(), qPrintable(action->objectName()));
}

/// Every text of a widget that can be read at once.
QStringList words_on(const QWidget& widget) {
  QStringList words = {widget.toolTip(), widget.accessibleName(), widget.property("text").toString(),
                       widget.property("title").toString(), widget.property("windowTitle").toString()};
  if (const auto* box = qobject_cast<const QComboBox*>(&widget))
    for (int k = 0; k < box->count(); ++k) words << box->itemText(k) << box->itemData(k, Qt::ToolTipRole).toString();
  return words;
}

/// Strings that are looked for in another context than they are filed under stay English.
void FeatureTest::a_german_window_is_german_throughout() {
  QFile file(QStringLiteral(LOOPMEND_SOURCE_DIR "/resources/translations/german.json"));
  QVERIFY(file.open(QIODevice::ReadOnly));
  const QJsonObject german = QJsonDocument::fromJson(file.readAll())[QStringLiteral("words")].toObject();
  QVERIFY(german.size() > 500);
  install_language(QStringLiteral("de"));
  QStringList english;
  {
    Shown shown({sample_file(folder_)});
    press_and_wait(shown, "fill");
    for (QAction* action : shown.findChildren<QAction*>())
      if (german.value(action->text()).toString(action->text()) != action->text()) english << action->text();
    for (QWidget* widget : shown.findChildren<QWidget*>())
      for (const QString& words : words_on(*widget))
        if (german.value(words).toString(words) != words) english << words;
  }
  install_language(QStringLiteral("en"));
  QVERIFY2(english.isEmpty(), qPrintable(english.join(QStringLiteral(" | "))));
}

void FeatureTest::a_large_scan_is_filled_before_its_curvature_is_known() {
  Shown window;
  const Document& document = window.document();
  const TriangleSoup ball = cut(make_icosphere(7), [](const Vec3& p) { return p.z() > 0.999; });  // 327 000 triangles
  window.open(scan_file(folder_, QStringLiteral("ball.ply"), ball));
  QVERIFY(wait_until([&] { return document.has_scan() && !window.controller().busy(); }));
  const auto plain = document.scan(0)->shape;
  QVERIFY(plain->reduced && plain->H.empty());
  // A job that takes long is still at work, or what it found has not been taken in yet: this function has not waited since.
  QVERIFY(window.controller().computing_curvature());
  QCOMPARE(part<QLabel>(window, "stage")->text(), QStringLiteral("Computing curvature"));
  press(window, "fillAndSmooth");
  QVERIFY(wait_until([&] { return !window.controller().busy(); }));
  QCOMPARE(document.patches().size(), std::size_t(1));
  QVERIFY(wait_idle(window));
  const auto colored = document.scan(0)->shape;
  QCOMPARE(colored->H.size(), plain->points.size() / 3);
  QVERIFY(std::abs(colored->H.front() + 1) < 1e-3);
  QVERIFY(colored->triangles.data() == plain->triangles.data());
  QCOMPARE(part<QLabel>(window, "stage")->text(), QStringLiteral("Nothing is running."));

  // Another scan takes the place of one whose curvature is not known.
  window.controller().open({folder_.filePath(QStringLiteral("ball.ply"))}, OpenMode::replace);
  QVERIFY(wait_until([&] { return window.controller().computing_curvature(); }));
  window.controller().open({sample_file(folder_)}, OpenMode::replace);
  QVERIFY(wait_idle(window));
  settle();
  QCOMPARE(document.scans().size(), std::size_t(1));
  QVERIFY(!document.scan(document.scans().front())->shape->reduced);
}

void FeatureTest::no_long_gaps_on_the_bunny() {
  if (!at_length()) QSKIP(for_the_night);
  if (!QFile::exists(bunny)) QSKIP("bunny.ply is not in the shared folder");
  GapMeter gaps;
  Shown window;
  settle();
  gaps.report("bunny: the window appears");
  QElapsedTimer clock;
  clock.start();
  window.open(bunny);
  wait_until([&] { return !part<QWidget>(window, "welcome")->isVisible(); });
  std::printf("bunny: first picture after %lld ms\n", static_cast<long long>(clock.elapsed()));
  wait_idle(window);
  settle();
  gaps.report("bunny: open");
  key(window, Qt::Key_N);
  settle();
  gaps.report("bunny: fly");
  for (int x = 100; x < 500; x += 20) {
    QTest::mouseMove(window.view().canvas(), QPoint(x, 200));
    QCoreApplication::processEvents();
  }
  settle();
  gaps.report("bunny: hover");
  key(window, Qt::Key_Escape);
  press_and_wait(window, "fill");
  settle();
  gaps.report("bunny: fill");
  press(window, "run");
  wait_until([&] { return window.document().patches().front().state->steps >= 3 || !window.controller().busy(); });
  gaps.report("bunny: run");
  key(window, Qt::Key_Escape);
  settle();
  gaps.report("bunny: cancel");
  press_and_wait(window, "fillAndSmooth", 300);
  settle();
  gaps.report("bunny: to steady state");
  for (Qt::Key digit : {Qt::Key_2, Qt::Key_3, Qt::Key_4, Qt::Key_5, Qt::Key_1}) {
    key(window, digit);
    settle();
  }
  gaps.report("bunny: shadings");
  key(window, Qt::Key_W);
  settle();
  key(window, Qt::Key_W);
  settle();
  gaps.report("bunny: wireframe");
  for (int i = 0; i < 3; ++i) key(window, Qt::Key_Z, Qt::ControlModifier);
  settle();
  gaps.report("bunny: undo");
}

void FeatureTest::undo_keeps_within_its_memory() {
  Shown window({sample_file(folder_)});
  window.undo().set_budget(1);
  const int first = first_hole(window.document());
  for (int loop : {first, first + 1}) {
    window.selection().select({loop});
    QVERIFY(press_and_wait(window, "fill"));
  }
  QCOMPARE(window.document().patches().size(), std::size_t(2));
  // The latest change can always be taken back; the one before it has been forgotten.
  QVERIFY(part<QAction>(window, "undo")->isEnabled());
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(window.document().patches().size(), std::size_t(1));
  QVERIFY(!part<QAction>(window, "undo")->isEnabled());
  key(window, Qt::Key_Y, Qt::ControlModifier);
  QCOMPARE(window.document().patches().size(), std::size_t(2));
}

/// Reported: what the allocator keeps for itself is not the window's.
void FeatureTest::memory_is_given_back() {
  if (!at_length()) QSKIP(for_the_night);
  // What is allocated, not what is resident: how much of what is free goes back to the system differs from run to run.
  const auto megabytes = [] {
    const auto memory = mallinfo2();
    return (memory.uordblks + memory.hblkhd) >> 20;
  };
  Shown window({sample_file(folder_)});
  // Many points in the scan and its shape, and patches with timelines.
  const QString ball = scan_file(folder_, QStringLiteral("much.ply"),
                                 cut(make_icosphere(6), [](const Vec3& p) { return p.z() > 0.999; }));
  const QString sheet = write_sheet_with_holes(folder_.filePath(QStringLiteral("sheet.ply")), 4);
  const auto checked = [&] { return wait_until([&] { return window.print_check().result().has_value(); }, 200); };
  const auto fill_much = [&] {
    window.open({ball, sheet});
    return wait_idle(window) && (press(window, "fill"), wait_idle(window, 200)) &&
           (press(window, "fillAndSmooth"), wait_idle(window, 200)) && checked();
  };
  const auto back_to_sample = [&] {
    window.controller().open({sample_file(folder_)}, OpenMode::replace);
    const bool idle = wait_idle(window) && checked();
    settle();
    return idle;
  };
  // The first time some memory stays for good: threads, graphics programs, letters, and as many buffers as holes of this number
  // need at once.
  QVERIFY(fill_much() && back_to_sample());
  const std::size_t before = megabytes();
  QVERIFY(fill_much());
  const std::size_t full = megabytes();
  QVERIFY(back_to_sample());
  const std::size_t after = megabytes();
  std::printf("allocated: sample %zu MB, a larger scan and 16 filled holes %zu MB, sample again %zu MB\n", before, full,
              after);
  QVERIFY(full > before + 5);
  QVERIFY2(4 * after < full + 3 * before, "three quarters of the memory should be back");
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<FeatureTest>(); }

#include "feature_test.moc"
