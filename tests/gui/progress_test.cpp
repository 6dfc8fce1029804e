// SPDX-License-Identifier: GPL-3.0-or-later
// What runs, how far it is, and how long it will still take.
#include "driver.h"
#include "test_main.h"

#include "dialogs/repair_dialog.h"
#include "document/labels.h"
#include "jobs/remaining_time.h"
#include "panels/progress_bar.h"
#include "panels/progress_box.h"
#include "samples/analytic_surfaces.h"

#include <QLabel>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

/// A face twice, one without area, and a fragment of one face beside the ball.
TriangleSoup damaged_ball() {
  TriangleSoup soup = make_icosphere(3);
  soup.triangles.push_back(soup.triangles.front());
  soup.triangles.push_back({3, 3, 4});
  const int first = static_cast<int>(soup.points.size());
  for (const Vec3& p : {Vec3(0, 0, 1.3), Vec3(0.04, 0, 1.3), Vec3(0, 0.04, 1.3)}) soup.points.push_back(p);
  soup.triangles.push_back({first, first + 1, first + 2});
  return soup;
}

/// The share of a bar's pixels that are filled.
double filled_part(QProgressBar& bar) {
  const QImage picture = bar.grab().toImage();
  const QColor color = bar.palette().color(QPalette::Highlight);
  const int row = picture.height() / 2;
  int filled = 0;
  for (int x = 0; x < picture.width(); ++x) {
    const QColor at = picture.pixelColor(x, row);
    filled +=
        std::abs(at.red() - color.red()) + std::abs(at.green() - color.green()) + std::abs(at.blue() - color.blue()) <
        60;
  }
  return static_cast<double>(filled) / picture.width();
}

}  // namespace

class ProgressTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void each_repair_at_work_is_named();
  void preparing_names_what_is_at_work();
  void a_bar_of_unknown_length_is_never_full();
  void a_busy_bar_is_painted_a_few_times_a_second();
  void time_left_is_shown_after_three_seconds();

 private:
  QTemporaryDir folder_;
};

void ProgressTest::each_repair_at_work_is_named() {
  Shown window({scan_file(folder_, QStringLiteral("damaged.ply"), damaged_ball())});
  press(window, "repair");
  auto* dialog = window.findChild<RepairDialog*>();
  auto* all = dialog->findChild<QPushButton*>(QStringLiteral("repairAll"));
  QVERIFY(wait_until([&] { return all->isEnabled(); }));
  const auto* box = window.findChild<QLabel*>(QStringLiteral("stage"));
  const auto* bar = window.findChild<QProgressBar*>(QStringLiteral("progress"));
  const auto* summary = dialog->findChild<QLabel*>(QStringLiteral("repairSummary"));
  QStringList in_box, in_dialog;
  QVector<double> shares;
  const auto listening = connect(&window.controller(), &FillController::share_done, this, [&] {
    in_box << box->text();
    in_dialog << summary->text();
    shares << static_cast<double>(bar->value()) / bar->maximum();
  });
  all->click();
  QVERIFY(wait_idle(window));
  disconnect(listening);
  const QStringList doing{QStringLiteral("joining vertices at the same place (1 of 6)"),
                          QStringLiteral("removing degenerate faces (2 of 6)"),
                          QStringLiteral("removing duplicate faces (3 of 6)"),
                          QStringLiteral("cutting out faces that intersect others (4 of 6)"),
                          QStringLiteral("separating non-manifold edges and vertices (5 of 6)"),
                          QStringLiteral("turning around what looks inward (5 of 6)"),
                          QStringLiteral("removing loose fragments and fins (6 of 6)"),
                          QStringLiteral("looking for holes, computing curvature")};
  QCOMPARE(in_box.size(), doing.size());
  for (int k = 0; k < doing.size(); ++k) {
    QCOMPARE(in_box[k], QStringLiteral("Repairing the scan: ") + doing[k]);
    QVERIFY2(in_dialog[k].startsWith(in_box[k]), qPrintable(in_dialog[k]));
    if (k > 0) QVERIFY2(shares[k] >= shares[k - 1], qPrintable(in_box[k]));
  }
  QCOMPARE(shares.front(), 0.0);
  QVERIFY(shares.back() > 0.5 && shares.back() < 1);
  const QString counts = in_dialog.back();
  for (const char* done : {"1 degenerate face removed", "1 duplicate face removed", "1 loose fragment removed"})
    QVERIFY2(counts.contains(QLatin1String(done)), qPrintable(counts));
  QVERIFY2(!in_dialog[1].contains(QStringLiteral("So far")), qPrintable(in_dialog[1]));
  dialog->close();
}

void ProgressTest::preparing_names_what_is_at_work() {
  Shown window({scan_file(folder_, QStringLiteral("prepared.ply"), damaged_ball())});
  const auto* box = window.findChild<QLabel*>(QStringLiteral("stage"));
  QStringList seen;
  const auto listening = connect(&window.controller(), &FillController::stage_changed, this, [&](const QString& words) {
    if (!words.isEmpty()) seen << words;
    if (!words.isEmpty()) QCOMPARE(box->text(), words);
  });
  QVector<double> shares;
  const auto counting =
      connect(&window.controller(), &FillController::share_done, this, [&](double share) { shares << share; });
  trigger(window, "prepareAction");
  QVERIFY(wait_idle(window));
  disconnect(listening);
  disconnect(counting);
  QCOMPARE(shares.size(), 8);  // one with each stage
  QVERIFY(std::is_sorted(shares.begin(), shares.end()));
  QVERIFY(shares.front() == 0 && shares.back() > 0.5 && shares.back() < 0.9);
  QCOMPARE(seen, QStringList({QStringLiteral("Preparing the scan"),
                              QStringLiteral("Preparing the scan: looking for what it needs"),
                              QStringLiteral("Preparing the scan: looking for what it needs"),
                              QStringLiteral("Preparing the scan: removing duplicate faces (1 of 3)"),
                              QStringLiteral("Preparing the scan: separating non-manifold edges and vertices (2 of 3)"),
                              QStringLiteral("Preparing the scan: turning around what looks inward (2 of 3)"),
                              QStringLiteral("Preparing the scan: removing loose fragments and fins (3 of 3)"),
                              QStringLiteral("Preparing the scan: removing triangles that cross at holes"),
                              QStringLiteral("Preparing the scan: looking for holes, computing curvature")}));
}

void ProgressTest::a_bar_of_unknown_length_is_never_full() {
  Shown window({sample_file(folder_)});
  auto* bar = window.findChild<QProgressBar*>(QStringLiteral("progress"));
  QVector<double> filled;
  const auto listening = connect(&window.controller(), &FillController::progress_changed, this, [&](int, int total) {
    if (total > 0) return;
    QCOMPARE(bar->maximum(), 0);
    QVERIFY(bar->isVisible());
    filled << filled_part(*bar);
  });
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  disconnect(listening);
  QVERIFY(!filled.isEmpty());
  for (const double part : filled) QVERIFY2(part > 0.1 && part < 0.5, qPrintable(QString::number(part)));
}

/// Each time the whole window is composed again.
void ProgressTest::a_busy_bar_is_painted_a_few_times_a_second() {
  struct : QObject {
    int count = 0;
    bool eventFilter(QObject*, QEvent* event) override {
      count += event->type() == QEvent::Paint;
      return false;
    }
  } paints;
  ProgressBar bar;
  bar.setRange(0, 0);
  bar.resize(300, 8);
  bar.show();
  QVERIFY(QTest::qWaitForWindowExposed(&bar));
  const QImage first = bar.grab().toImage();
  bar.installEventFilter(&paints);
  QTest::qWait(1000);
  QVERIFY2(paints.count >= 1 && paints.count <= 8, qPrintable(QString::number(paints.count)));
  QVERIFY(bar.grab().toImage() != first);
}

/// The clock is the test's: a second for each hole.
void ProgressTest::time_left_is_shown_after_three_seconds() {
  constexpr int holes = 8;
  std::vector<TriangleSoup> balls;
  for (int k = 0; k < holes; ++k) {
    balls.push_back(cut(make_icosphere(2), [](const Vec3& p) { return p.z() > 0.7; }));
    for (Vec3& p : balls.back().points) p.x() += 3 * k;
  }
  Shown window({scan_file(folder_, QStringLiteral("balls.ply"), joined(balls))});
  double now = 0;
  window.findChild<ProgressBox*>()->measure_by([&] { return now; });
  const auto* shown = window.findChild<QLabel*>(QStringLiteral("timeLeft"));
  QStringList texts, expected;
  // The box hears of each share before the test does.
  const auto listening = connect(&window.controller(), &FillController::share_done, this, [&](double share) {
    texts << shown->text();
    expected << (now < 3 || share >= 1 ? QString() : labels::time_left(now * (1 - share) / share));
    ++now;
  });
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  disconnect(listening);
  QCOMPARE(texts, expected);
  QCOMPARE(texts.size(), holes);
  QVERIFY2(texts.contains(QStringLiteral("about 3 s left")), qPrintable(texts.join(QLatin1Char(','))));
  QVERIFY(shown->text().isEmpty());
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<ProgressTest>(); }

#include "progress_test.moc"
