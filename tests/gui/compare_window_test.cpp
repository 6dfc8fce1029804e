// SPDX-License-Identifier: GPL-3.0-or-later
// Where the comparison window lies, and what can be read in it.
#include "compare_driver.h"
#include "test_main.h"

#include "document/preferences.h"
#include "panels/plot.h"
#include "panels/plot_library.h"
#include "panels/window_place.h"

#include <QComboBox>
#include <QScreen>
#include <QTableView>
#include <QTemporaryDir>

#include <algorithm>
#include <set>

using namespace loopmend;
using namespace loopmend::testing;

class CompareWindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void it_fits_the_screen_and_keeps_its_place();
  void it_lies_beside_the_holes_where_there_is_room();
  void the_table_of_holes_stays_in_sight();
  void distances_and_their_histogram_have_the_unit();
  void marks_of_nearly_equal_values_differ();

 private:
  QTemporaryDir folder_;
};

void CompareWindowTest::it_fits_the_screen_and_keeps_its_place() {
  Shown shown({ball_file(folder_)});
  const auto opened = [&] {
    key(shown, Qt::Key_C);
    CompareWindow* window = compare_window(shown);
    return window && QTest::qWaitForWindowExposed(window) && settle() ? window : nullptr;
  };
  CompareWindow* window = opened();
  QVERIFY(window);
  const QRect room = shown.screen()->availableGeometry();
  QVERIFY2(room.contains(window->geometry()), qPrintable(QVariant(window->geometry()).toString()));
  QVERIFY(window->pos() != room.topLeft());
  const QSize small(1272, 762);  // of a screen of 1280 x 800, without a frame
  window->resize(small);
  QVERIFY(settle());
  QCOMPARE(window->size(), small);
  for (const char* name : {"compareEnergies", "compareProfiles"}) {
    const auto* plot = in<Plot>(*window, name);
    QVERIFY2(plot->width() >= 320 && plot->height() >= 190, name);
    QVERIFY2(window->rect().contains(QRect(plot->mapTo(window, QPoint(0, 0)), plot->size())), name);
  }
  const QRect chosen(40, 60, 1300, 780);
  window->setGeometry(chosen);
  QVERIFY(settle());
  window->close();
  QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
  window = opened();
  QVERIFY(window);
  QCOMPARE(window->geometry(), chosen);
}

void CompareWindowTest::it_lies_beside_the_holes_where_there_is_room() {
  const QSize size(1000, 800);
  constexpr int least = 900;
  const QRect holes(1200, 200, 300, 400), main(500, 100, 1000, 700);
  const auto placed = [&](int main_at, const QRect& room) {
    return place_beside(main.translated(main_at, 0), holes.translated(main_at, 0), size, least, room);
  };
  const QRect right = placed(0, QRect(0, 0, 2600, 1000)), left = placed(600, QRect(0, 0, 2200, 1000)),
              over = placed(0, QRect(0, 0, 1600, 1000)), narrow = placed(-250, QRect(0, 0, 1400, 1000));
  QVERIFY(right.left() > main.right());
  QVERIFY(left.right() < main.left() + 600 && left.left() >= 0);
  QVERIFY(over.right() < holes.left() && over.left() >= 0);
  for (const QRect& place : {right, left, over}) QCOMPARE(place.size(), size);
  QVERIFY(narrow.right() < holes.left() - 250 && narrow.left() >= 0 && narrow.width() >= least);
  const QRect room(4, 30, 1272, 762);
  QVERIFY(room.contains(place_beside(QRect(0, 0, 1280, 800), holes, size, least, room)));
}

/// On a screen of 1400x900, before and after the flows have run.
void CompareWindowTest::the_table_of_holes_stays_in_sight() {
  save_compare_place({});  // of another comparison
  Shown shown({sample_file(folder_)}, Shown::Extent::usual);
  shown.move(20, 30);  // where a window manager puts it
  QVERIFY(press_and_wait(shown, "fillAndSmooth"));
  shown.selection().select({2});
  key(shown, Qt::Key_C);
  CompareWindow* window = compare_window(shown);
  QVERIFY(window && QTest::qWaitForWindowExposed(window));
  const auto* table = part<QTableView>(shown, "holesTable");
  const QRect needed(table->mapToGlobal(QPoint(0, 0)), table->size());
  const auto covered = [&] {
    settle();
    return std::max(0, window->geometry().right() + 1 - needed.left());
  };
  QCOMPARE(covered(), 0);
  const auto* run = in<QPushButton>(*window, "compareRun");
  QVERIFY(wait_until([&] { return run->isEnabled(); }));
  QVERIFY(window->focusWidget() == run);  // for Space
  QVERIFY(run_all(*window));
  QCOMPARE(covered(), 0);
}

void CompareWindowTest::distances_and_their_histogram_have_the_unit() {
  Shown shown({ball_file(folder_)});
  shown.controller().choose_unit("millimeter");
  key(shown, Qt::Key_C);
  CompareWindow* window = compare_window(shown);
  QVERIFY(window && QTest::qWaitForWindowExposed(window));
  QVERIFY(run_all(*window));
  const auto axis = [&](const char* plot, QCPAxis* QCustomPlot::*which) {
    return (in<Plot>(*window, plot)->findChild<QCustomPlot*>()->*which)->label();
  };
  QCOMPARE(axis("compareEnergies", &QCustomPlot::yAxis), QStringLiteral("1/mm\u00b2"));
  QCOMPARE(axis("compareProfiles", &QCustomPlot::yAxis), QStringLiteral("H, 1/mm"));
  auto* shading = in<QComboBox>(*window, "compareShading");
  shading->setCurrentIndex(shading->findText(QStringLiteral("Distance")));
  QVERIFY(wait_until([&] { return !window->flow_comparison().is_measuring(); }));
  QCOMPARE(axis("compareProfiles", &QCustomPlot::xAxis), QStringLiteral("Distance, mm"));
  const QString legend = in<QWidget>(*window, "compareLegend")->accessibleDescription();
  QCOMPARE(legend, QStringLiteral("From MMCVF, in mm"));
}

void CompareWindowTest::marks_of_nearly_equal_values_differ() {
  Plot plot("marks", QStringLiteral("Marks"));
  plot.set_axis(Plot::Side::left, Plot::Scale::linear);
  plot.set_data(plot.add_graph(Plot::Side::left, QStringLiteral("H"), Plot::Line::solid, 0), {0, 1, 2},
                {-1, -1.00001, -0.9998});
  plot.resize(300, 300);
  plot.show();
  plot.redraw();
  QVERIFY(settle());
  auto* axis = plot.findChild<QCustomPlot*>()->yAxis;
  QVector<double> ticks;
  QVector<QString> marks;
  axis->ticker()->generate(axis->range(), plot.locale(), QLatin1Char('g'), axis->numberPrecision(), ticks, nullptr,
                           &marks);
  QVERIFY(marks.size() >= 3);
  QCOMPARE(std::set<QString>(marks.begin(), marks.end()).size(), static_cast<std::size_t>(marks.size()));
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<CompareWindowTest>(); }

#include "compare_window_test.moc"
