// SPDX-License-Identifier: GPL-3.0-or-later
// Run and Fill and smooth end at the same surface, on the sample and, at length, on every shared scan with a hole of moderate size.
#include "document/run_curves.h"
#include "driver.h"
#include "test_main.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

constexpr qint64 largest_file = 6'000'000;  // bytes: opening larger ones takes longer than all the rest
constexpr int fewest_edges = 8, most_edges = 200;
constexpr std::size_t holes_of_a_scan = 2;

/// The largest holes of moderate size.
std::set<int> chosen_holes(const Document& document) {
  std::vector<int> holes;
  for (int loop = 0; loop < document.loop_count(); ++loop)
    if (const int edges = document.loop(loop).edges();
        document.fillable(loop) && edges >= fewest_edges && edges <= most_edges)
      holes.push_back(loop);
  std::stable_sort(holes.begin(), holes.end(),
                   [&](int a, int b) { return document.loop(a).edges() > document.loop(b).edges(); });
  std::set<int> chosen;
  for (int hole : holes)
    if (chosen.size() < holes_of_a_scan) chosen.insert(hole);
  return chosen;
}

/// @returns the first rise of what the energy plot draws as lowered; empty where there is none.
QString rise_of(const OpenPatch& patch) {
  const RunCurves curves(patch);
  if (patch.state->steps > 0 && curves.residual.isEmpty()) return QStringLiteral("the plot is empty");
  const QVector<double> lowered = curves.lowered;
  for (int i = 1; i < lowered.size(); ++i)
    if (lowered[i] > lowered[i - 1])
      return QStringLiteral("point %1 of the energy plot: %2 after %3").arg(i).arg(lowered[i]).arg(lowered[i - 1]);
  return {};
}

}  // namespace

class SameEndTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void run_ends_where_fill_and_smooth_ends_data();
  void run_ends_where_fill_and_smooth_ends();

 private:
  QTemporaryDir folder_;
};

void SameEndTest::run_ends_where_fill_and_smooth_ends_data() {
  QTest::addColumn<QString>("path");
  QTest::newRow("sample") << sample_file(folder_);
  if (!at_length()) return;
  const QDir shared(QStringLiteral(LOOPMEND_SHARED_DIR));
  for (const char* name : {"data", "scans2"})
    for (const QFileInfo& scan : QDir(shared.filePath(QLatin1String(name)))
                                     .entryInfoList({QStringLiteral("*.ply"), QStringLiteral("*.obj")}, QDir::Files))
      if (scan.size() <= largest_file) QTest::newRow(qPrintable(scan.fileName())) << scan.filePath();
}

/// Run grew noses and socks when it took the boundary literally.
void SameEndTest::run_ends_where_fill_and_smooth_ends() {
  QFETCH(QString, path);
  Shown window({path});
  const Document& document = window.document();
  const std::set<int> holes = chosen_holes(document);
  if (holes.empty()) QSKIP("no hole of moderate size");
  window.selection().select(holes);
  QVERIFY(press_and_wait(window, "fillAndSmooth", 240));
  std::map<int, PatchStatePtr> whole;
  for (int hole : holes)
    if (const OpenPatch* patch = document.patch_of(hole)) whole[hole] = patch->state;
  window.findChild<QAction*>(QStringLiteral("undo"), Qt::FindDirectChildrenOnly)->trigger();
  QVERIFY2(document.patches().empty(), "one press is undone by one");
  QVERIFY(press_and_wait(window, "fill", 240));
  QVERIFY(press_and_wait(window, "run", 240));
  int steps = 0;
  for (int hole : holes) {
    const OpenPatch* patch = document.patch_of(hole);
    QCOMPARE(patch != nullptr, whole.contains(hole));  // what cannot be filled cannot be filled by either
    if (!patch) continue;
    const PatchState &run = *patch->state, &once = *whole[hole];
    QCOMPARE(run.status, once.status);
    QCOMPARE(run.steps, once.steps);
    QVERIFY2(run.patch.positions == once.patch.positions,
             qPrintable(QStringLiteral("hole %1: Run and Fill and smooth end in different surfaces")
                            .arg(document.loop(hole).number)));
    const QString rise = rise_of(*patch);
    QVERIFY2(rise.isEmpty(), qPrintable(rise));
    steps += run.steps;
  }
  qInfo("%zu holes, %d steps", whole.size(), steps);
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<SameEndTest>(); }

#include "same_end_test.moc"
