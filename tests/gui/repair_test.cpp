// SPDX-License-Identifier: GPL-3.0-or-later
// Defects of a scan, repaired one by one until it could be printed; and exports with that verdict.
#include "driver.h"
#include "test_main.h"

#include "dialogs/export_dialog.h"
#include "dialogs/repair_dialog.h"
#include "document/fill_report.h"
#include "document/hole_table.h"
#include "document/labels.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/scan_attributes.h"
#include "pipeline/scan_job.h"
#include "samples/analytic_surfaces.h"
#include "views/file_controller.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <functional>
#include <random>

using namespace loopmend;
using namespace loopmend::testing;

namespace {
const double minutes = 60;

bool verdict_is_known(MainWindow& window) {
  return wait_until([&] { return window.print_check().result().has_value(); }, 3 * minutes);
}

QString verdict(MainWindow& window) { return part<QLabel>(window, "statusWatertight")->text(); }

RepairDialog* repair_dialog(MainWindow& window) {
  press(window, "repair");
  return window.findChild<RepairDialog*>();
}

QString counted(RepairDialog* dialog, const char* what) {
  return dialog->findChild<QLabel*>(QStringLiteral("count") + QLatin1String(what))->text();
}

bool has_counted(RepairDialog* dialog) {
  return wait_until([&] { return counted(dialog, "Fragments") != QStringLiteral("\u2026"); }, 3 * minutes);
}

/// Where many new holes, or lost patches, are asked about.
void apply_repair(QDialog& question) {
  if (auto* apply = question.findChild<QPushButton*>(QStringLiteral("repairApply"))) apply->click();
}

void fix(RepairDialog* dialog, const char* button) { dialog->findChild<QPushButton*>(QLatin1String(button))->click(); }

/// Fills the first hole and exports into the file what the dialog offers. @param choose  sets what a person would
bool export_filled(MainWindow& window, const QString& path, const std::function<void(QDialog&, QLineEdit&)>& choose) {
  window.selection().select({first_hole(window.document())});
  press(window, "fillAndSmooth");
  if (!wait_idle(window)) return false;
  const WhenAsked asked([&](QDialog& dialog) {
    auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
    choose(dialog, *name);
    name->setText(path);
    QTest::keyClick(name, Qt::Key_Return);
  });
  window.findChild<FileController*>()->ask_export();
  return wait_until([&] { return QFile::exists(path); }) && wait_idle(window);
}

QString write_open_sphere(const QString& path) {
  write_mesh(path.toStdString(), cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.9; }));
  return path;
}

/// A third of a sphere, rough: who has its boundary taken literally gets a bubble.
QString write_rough_bowl(const QString& path) {
  TriangleSoup bowl = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > std::cos(2.2); });
  std::mt19937 random(1);
  std::normal_distribution<double> roughness(0, 0.01);
  for (Vec3& p : bowl.points) p *= 1 + roughness(random);
  write_mesh(path.toStdString(), bowl);
  return path;
}

/// How many pixels of a cell have about this colour.
int pixels_of(QTableView* table, const QModelIndex& cell, const QColor& color) {
  const QImage picture = table->viewport()->grab(table->visualRect(cell)).toImage();
  const auto near = [](int a, int b) { return std::abs(a - b) < 40; };
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor at = picture.pixelColor(x, y);
      count += near(at.red(), color.red()) && near(at.green(), color.green()) && near(at.blue(), color.blue());
    }
  return count;
}

}  // namespace

class RepairTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void verdict_follows_the_scene();
  void export_dialog_tells_the_verdict();
  void patches_are_exported_by_themselves();
  void what_is_new_is_labelled();
  void defects_are_listed_and_repaired_one_by_one();
  void defects_are_marked_in_the_view();
  void bodies_become_one_data();
  void bodies_become_one();
  void preparing_does_what_the_command_line_does_with_auto();
  void fix_all_leaves_nothing_to_fix_data();
  void fix_all_leaves_nothing_to_fix();
  void doll_becomes_printable();
  void dragon_is_stitched_watertight();
  void a_dome_over_a_flat_loop_is_red();

 private:
  void the_report_begins_with(Shown& window, int loop);
  QTemporaryDir folder_;
};

void RepairTest::verdict_follows_the_scene() {
  Shown window({write_open_sphere(folder_.filePath(QStringLiteral("open.ply")))});
  QVERIFY(verdict_is_known(window));
  QCOMPARE(verdict(window), QStringLiteral("Not watertight: 1 open boundary loop"));
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  QVERIFY(verdict_is_known(window));
  QCOMPARE(verdict(window), QStringLiteral("Watertight, ready to print"));
  window.undo().undo();
  QVERIFY(!window.print_check().result());
  QVERIFY(verdict_is_known(window));
  QCOMPARE(verdict(window), QStringLiteral("Not watertight: 1 open boundary loop"));
}

void RepairTest::export_dialog_tells_the_verdict() {
  Shown shown({write_open_sphere(folder_.filePath(QStringLiteral("asked.ply")))});
  ExportDialog dialog(shown.print_check(), folder_.filePath(QStringLiteral("asked-filled.ply")),
                      {QStringLiteral("PLY (*.ply *.ply.gz)"), QStringLiteral("STL (*.stl)")},
                      QStringLiteral("STL (*.stl)"));
  dialog.show();
  auto* words = dialog.findChild<QLabel*>(QStringLiteral("exportVerdict"));
  QVERIFY(wait_until([&] { return words->text().startsWith(QStringLiteral("Not watertight: 1 open boundary loop")); }));
  QCOMPARE(dialog.path(), folder_.filePath(QStringLiteral("asked-filled.ply")));
  dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"))->setText(QStringLiteral("without"));
  QCOMPARE(dialog.path(), folder_.filePath(QStringLiteral("without.stl")));
}

void RepairTest::patches_are_exported_by_themselves() {
  Shown window({sample_file(folder_)});
  const QString path = folder_.filePath(QStringLiteral("patches.ply"));
  QVERIFY(export_filled(window, path, [](QDialog& dialog, QLineEdit&) {
    dialog.findChild<QComboBox*>(QStringLiteral("exportContent"))->setCurrentIndex(1);
  }));
  const Patch& patch = window.document().patches().front().state->patch;
  const TriangleSoup written = read_mesh(path.toStdString()).soup;
  QCOMPARE(written.triangles.size(), static_cast<std::size_t>(patch.patch_triangles));
  QVERIFY(written.points.size() > static_cast<std::size_t>(patch.free_count));
  QVERIFY(window.isWindowModified());  // the scan with its patches is in no file yet
}

void RepairTest::what_is_new_is_labelled() {
  Shown window({sample_file(folder_)});
  const QString path = folder_.filePath(QStringLiteral("labelled.ply"));
  QVERIFY(export_filled(window, path, [&](QDialog& dialog, QLineEdit& name) {
    auto* labels = dialog.findChild<QCheckBox*>(QStringLiteral("exportNewFaces"));
    auto* deviations = dialog.findChild<QCheckBox*>(QStringLiteral("exportDeviations"));
    name.setText(folder_.filePath(QStringLiteral("labelled.stl")));
    QVERIFY(!labels->isEnabled() && !deviations->isEnabled());
    name.setText(folder_.filePath(QStringLiteral("labelled.obj")));
    QVERIFY(labels->isEnabled() && !deviations->isEnabled());
    name.setText(path);
    labels->click();
    deviations->click();
  }));
  const PatchState& state = *window.document().patches().front().state;
  const TriangleSoup written = read_mesh(path.toStdString()).soup;
  const AttributeColumn* is_new = find_column(written.attributes->faces, "patch");
  const AttributeColumn* deviation = find_column(written.attributes->points, "expected_deviation");
  QVERIFY(is_new && deviation);
  const std::size_t old_faces = written.triangles.size() - static_cast<std::size_t>(state.patch.patch_triangles);
  for (std::size_t f = 0; f < written.triangles.size(); ++f) QCOMPARE(is_new->value(f), f < old_faces ? 0.0 : 1.0);
  const std::size_t old_points = written.points.size() - state.deviation.vertices.size();
  QVERIFY(!state.deviation.vertices.empty());
  for (std::size_t v = 0; v < written.points.size(); ++v)
    QCOMPARE(deviation->value(v),
             v < old_points ? 0.0 : static_cast<double>(static_cast<float>(state.deviation.vertices[v - old_points])));
}

void RepairTest::defects_are_listed_and_repaired_one_by_one() {
  TriangleSoup soup = make_icosphere(3);
  soup.triangles.push_back({3, 3, 4});
  soup.triangles.push_back(soup.triangles.front());
  const QString path = folder_.filePath(QStringLiteral("defects.ply"));
  write_mesh(path.toStdString(), soup);
  Shown window({path});
  RepairDialog* dialog = repair_dialog(window);
  QVERIFY(dialog && has_counted(dialog));
  QCOMPARE(counted(dialog, "Degenerate"), QStringLiteral("1"));
  QCOMPARE(counted(dialog, "Duplicate"), QStringLiteral("1"));
  QCOMPARE(counted(dialog, "Intersecting"), QStringLiteral("1"));
  QCOMPARE(counted(dialog, "Fragments"), QStringLiteral("none"));
  QVERIFY(!dialog->findChild<QPushButton*>(QStringLiteral("fixFragments"))->isEnabled());
  fix(dialog, "fixDuplicate");
  QVERIFY(wait_idle(window) && has_counted(dialog));
  QCOMPARE(counted(dialog, "Duplicate"), QStringLiteral("none"));
  QCOMPARE(counted(dialog, "Intersecting"), QStringLiteral("none"));
  QCOMPARE(counted(dialog, "Degenerate"), QStringLiteral("1"));
  fix(dialog, "repairAll");
  QVERIFY(wait_idle(window) && has_counted(dialog));
  QCOMPARE(counted(dialog, "Degenerate"), QStringLiteral("none"));
  QVERIFY(!dialog->findChild<QPushButton*>(QStringLiteral("repairAll"))->isEnabled());
  QVERIFY(verdict_is_known(window));
  QCOMPARE(verdict(window), QStringLiteral("Watertight, ready to print"));
  window.undo().undo();
  QVERIFY(has_counted(dialog));
  QCOMPARE(counted(dialog, "Degenerate"), QStringLiteral("1"));
  dialog->close();
}

void RepairTest::defects_are_marked_in_the_view() {
  TriangleSoup soup = make_icosphere(3);
  const int first = static_cast<int>(soup.points.size());
  for (const Vec3& p : {Vec3(0, 0, 1.3), Vec3(0.04, 0, 1.3), Vec3(0, 0.04, 1.3)}) soup.points.push_back(p);
  soup.triangles.push_back({first, first + 1, first + 2});
  Shown window({scan_file(folder_, QStringLiteral("fragment.ply"), soup)});
  const auto is_red_in_the_middle = [&] {
    const QImage picture = window.view().picture();
    const QColor color = picture.pixelColor(picture.rect().center());
    return color.red() > 130 && color.red() > 2 * color.green();
  };
  RepairDialog* dialog = repair_dialog(window);
  QVERIFY(dialog && has_counted(dialog));
  QVERIFY(!dialog->findChild<QPushButton*>(QStringLiteral("showDuplicate"))->isEnabled());
  fix(dialog, "showFragments");
  QVERIFY(wait_until(is_red_in_the_middle));
  const QWidget* canvas = window.view().canvas();
  QVERIFY(!dialog->frameGeometry().contains(canvas->mapToGlobal(canvas->rect().center())));  // and it is seen
  const QString said = dialog->findChild<QLabel*>(QStringLiteral("repairSummary"))->text();
  QVERIFY2(said.contains(QStringLiteral("Faces: 1, places: 1.")), qPrintable(said));
  fix(dialog, "fixFragments");
  QVERIFY(wait_idle(window) && has_counted(dialog));
  QCOMPARE(dialog->findChild<QLabel*>(QStringLiteral("beforeFragments"))->text(), QStringLiteral("was 1"));
  QCOMPARE(counted(dialog, "Fragments"), QStringLiteral("none"));
  QVERIFY(wait_until([&] { return !is_red_in_the_middle(); }));
}

void RepairTest::bodies_become_one_data() {
  QTest::addColumn<double>("radius");
  QTest::addColumn<double>("distance");
  QTest::addColumn<int>("bodies");
  QTest::newRow("overlapping") << 1.0 << 1.0 << 2;
  QTest::newRow("one within the other") << 0.5 << 0.0 << 2;
  QTest::newRow("touching at a vertex") << 0.5 << 1.5 << 0;
}

/// A unit ball, and another one: the bodies to be united are counted, and no others.
void RepairTest::bodies_become_one() {
  QFETCH(double, radius);
  QFETCH(double, distance);
  QFETCH(int, bodies);
  const TriangleSoup ball = make_icosphere(3);
  TriangleSoup other = ball;
  for (Vec3& p : other.points) p = radius * p + Vec3(0, 0, distance);  // the ball has vertices at both poles
  const QString path = folder_.filePath(QStringLiteral("two_balls.ply"));
  write_mesh(path.toStdString(), joined({ball, other}));
  Shown window({path});
  RepairDialog* dialog = repair_dialog(window);
  QVERIFY(dialog && has_counted(dialog));
  const QString count = bodies > 0 ? QString::number(bodies) : QStringLiteral("none");
  QCOMPARE(counted(dialog, "Overlapping"), count);
  QCOMPARE(counted(dialog, "Intersecting"), QStringLiteral("none"));
  QVERIFY(!dialog->findChild<QPushButton*>(QStringLiteral("repairAll"))->isEnabled());
  QCOMPARE(dialog->findChild<QPushButton*>(QStringLiteral("fixOverlapping"))->isEnabled(), bodies > 0);
  if (bodies == 0) return;
  fix(dialog, "fixOverlapping");
  QVERIFY(wait_idle(window) && has_counted(dialog));
  QCOMPARE(counted(dialog, "Overlapping"), QStringLiteral("none"));
  QVERIFY(verdict_is_known(window));
  QCOMPARE(verdict(window), QStringLiteral("Watertight, ready to print"));
  window.undo().undo();
  QVERIFY(has_counted(dialog));
  QCOMPARE(counted(dialog, "Overlapping"), count);
}

/// A ball with a hole, and a fin that stands on an edge of it: both run along an edge of three faces.
void RepairTest::preparing_does_what_the_command_line_does_with_auto() {
  TriangleSoup soup = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.9; });
  const Triangle t = soup.triangles[soup.triangles.size() / 2];
  soup.points.push_back(1.5 * soup.points[t[0]]);
  soup.triangles.push_back({t[0], t[1], static_cast<int>(soup.points.size()) - 1});
  const QString path = folder_.filePath(QStringLiteral("fin.ply"));
  write_mesh(path.toStdString(), soup);
  Shown window({path});
  trigger(window, "prepareAction");
  QVERIFY(apply_proposal(window));
  const OpenedScan& prepared = *window.document().scan(window.document().scans().front());
  const auto is_cut = [](const BoundaryLoop& loop) { return loop.kind == LoopKind::cut; };
  QVERIFY(std::none_of(prepared.loops.begin(), prepared.loops.end(), is_cut));
  ScanJob job;
  job.prepare.extent = PrepareOptions::Extent::where_needed;
  const ScanPlan plan = plan_scan(record_of(soup), make_surface_model(soup), job);
  QCOMPARE(prepared.model->soup.points, plan.model.soup.points);
  QCOMPARE(prepared.model->soup.triangles, plan.model.soup.triangles);
  trigger(window, "prepareAction");  // finds nothing to do and adds no step of undo
  QVERIFY(wait_idle(window));
  window.undo().undo();
  const OpenedScan& back = *window.document().scan(window.document().scans().front());
  QVERIFY(std::any_of(back.loops.begin(), back.loops.end(), is_cut));
}

void RepairTest::fix_all_leaves_nothing_to_fix_data() {
  QTest::addColumn<QString>("name");
  QTest::addColumn<bool>("has_handles");
  QTest::newRow("snowden_bust.obj") << QStringLiteral("snowden_bust.obj") << false;
  QTest::newRow("skull_scp1.ply") << QStringLiteral("skull_scp1.ply") << true;
}

/// Separating edges may make points in one place, of which none was found before.
void RepairTest::fix_all_leaves_nothing_to_fix() {
  QFETCH(QString, name);
  QFETCH(bool, has_handles);
  const QString scan = QStringLiteral(LOOPMEND_SHARED_DIR "/scans2/") + name;
  if (!at_length()) QSKIP(for_the_night);
  if (!QFile::exists(scan)) QSKIP("the shared scans are not here");
  Shown window({scan});
  RepairDialog* dialog = repair_dialog(window);
  QVERIFY(dialog && has_counted(dialog));
  const int before = window.document().scans().front();
  const auto is_replaced = [&] { return window.document().scans().front() != before; };
  {
    const WhenAsked asked(apply_repair);
    fix(dialog, "repairAll");
    QVERIFY(wait_until(is_replaced, 3 * minutes) && wait_idle(window) && has_counted(dialog));
  }
  for (const char* kind : {"Coincident", "Degenerate", "Duplicate", "Intersecting", "NonManifold", "Fragments"})
    QCOMPARE(counted(dialog, kind), QStringLiteral("none"));
  QVERIFY(!dialog->findChild<QPushButton*>(QStringLiteral("repairAll"))->isEnabled());
  QCOMPARE(counted(dialog, "Handles").toInt() > 0, has_handles);  // they may be real
  const WhenAsked asked(apply_repair);
  if (has_handles) fix(dialog, "fixHandles");
  QVERIFY(wait_idle(window) && settle() && has_counted(dialog));
  QCOMPARE(counted(dialog, "Handles"), QStringLiteral("none"));
  dialog->close();
}

void RepairTest::doll_becomes_printable() {
  const QString scan = QStringLiteral(LOOPMEND_SHARED_DIR "/data/doll.obj");
  if (!at_length()) QSKIP(for_the_night);
  if (!QFile::exists(scan)) QSKIP("the shared scans are not here");
  QElapsedTimer clock;
  clock.start();
  Shown window({scan});
  QVERIFY(verdict_is_known(window));
  QVERIFY(verdict(window).startsWith(QStringLiteral("Not watertight")));
  RepairDialog* dialog = repair_dialog(window);
  QVERIFY(dialog && has_counted(dialog));
  {
    const WhenAsked asked(apply_repair);
    fix(dialog, "repairAll");
    QVERIFY(wait_idle(window) && settle());
  }
  dialog->close();
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  QVERIFY(verdict_is_known(window));
  qInfo("doll: %s after %lld ms", qPrintable(verdict(window)), clock.elapsed());
  QCOMPARE(verdict(window), QStringLiteral("Watertight, ready to print"));
  const QString path = folder_.filePath(QStringLiteral("doll.stl"));
  window.controller().export_to(path);
  QVERIFY(wait_idle(window));
  QVERIFY(watertightness(read_mesh(path.toStdString()).soup).encloses());
}

void RepairTest::dragon_is_stitched_watertight() {
  const QString scan = QStringLiteral(LOOPMEND_SHARED_DIR "/data/dragon.ply");
  if (!at_length()) QSKIP(for_the_night);
  if (!QFile::exists(scan)) QSKIP("the shared scans are not here");
  QElapsedTimer clock;
  clock.start();
  Shown window({scan});
  const auto loops_that_are = [&](LoopKind kind) {
    int count = 0;
    for (int loop = 0; loop < window.document().loop_count(); ++loop)
      count += window.document().present(loop) && window.document().loop(loop).kind == kind;
    return count;
  };
  QCOMPARE(loops_that_are(LoopKind::crack), 407);
  QCOMPARE(part<QLabel>(window, "fillEstimate")->text(), QStringLiteral("407 cracks: press Stitch."));
  QCOMPARE(part<QAction>(window, "stitchAction")->text(), QStringLiteral("Stitc&h 407 cracks"));
  QVERIFY(verdict_is_known(window));
  QCOMPARE(verdict(window), QStringLiteral("Watertight but for 407 cracks: press Stitch"));
  QVERIFY(press_and_apply(window, "stitch"));
  // Files are proposed beside it.
  QCOMPARE(window.document().first_scan().repaired_from, QFileInfo(scan).canonicalFilePath());
  QCOMPARE(loops_that_are(LoopKind::crack), 0);
  QCOMPARE(loops_that_are(LoopKind::hole), 0);
  QCOMPARE(part<QLabel>(window, "fillEstimate")->text(), QStringLiteral("16 cuts: press Repair\u2026"));
  QVERIFY(verdict_is_known(window));
  qInfo("dragon: %s after %lld ms", qPrintable(verdict(window)), clock.elapsed());
  QVERIFY(window.print_check().result()->encloses());
  QVERIFY(verdict(window).startsWith(QStringLiteral("Watertight")));
}

TriangleSoup big_icosphere() {
  TriangleSoup sphere = make_icosphere(3);
  for (Vec3& p : sphere.points) p *= 100;
  return sphere;
}

/// Whatever larger holes there are.
void RepairTest::the_report_begins_with(Shown& window, int loop) {
  const Document& document = window.document();
  window.open({scan_file(folder_, QStringLiteral("two_holes.ply"),
                         cut(big_icosphere(), [](const Vec3& p) { return p.z() > 80 || p.z() < -95; }))},
              OpenMode::add);
  QVERIFY(wait_until([&] { return document.scans().size() == 2 && !window.controller().busy(); }));
  std::set<int> added;
  for (int other = 1; other < document.loop_count(); ++other)
    if (document.fillable(other)) added.insert(other);
  QCOMPARE(added.size(), std::size_t{2});
  window.selection().select(added);
  QVERIFY(press_and_wait(window, "fillAndSmooth", 2 * minutes));
  const FillReport report = fill_report(document);
  QCOMPARE(report.holes.size(), std::size_t{3});
  QCOMPARE(report.holes[0].loop, loop);
  const auto size = [&](std::size_t k) { return document.loop(report.holes[k].loop).diameter; };
  QVERIFY2(size(1) > size(2) && size(2) > size(0),
           qPrintable(QStringLiteral("%1 %2 %3").arg(size(0)).arg(size(1)).arg(size(2))));
  for (int k = 0; k < 2; ++k) window.undo().undo();  // the fill, the scan
  QCOMPARE(document.scans().size(), std::size_t{1});
  window.selection().select({});
}

void RepairTest::a_dome_over_a_flat_loop_is_red() {
  Shown window({write_rough_bowl(folder_.filePath(QStringLiteral("bowl.ply")))});
  auto* table = part<QTableView>(window, "holesTable");
  const QModelIndex state = table->model()->index(0, HoleTable::state);
  const QColor red(190, 50, 30);
  window.selection().select({0});
  auto* boundary = part<QComboBox>(window, "boundary");
  boundary->setCurrentIndex(boundary->findData(static_cast<int>(BoundaryTrust::exact)));
  QVERIFY(press_and_wait(window, "fillAndSmooth", 2 * minutes));
  QVERIFY2(window.document().state(0) == HoleState::bad,
           qPrintable(labels::state(window.document().state(0)) +
                      QString::fromStdString(window.document().message(0).english())));
  const QString said = QStringLiteral("diameters high over a flat loop");
  const auto sentence = [&] { return part<QLabel>(window, "seamSentence")->text(); };
  QVERIFY2(wait_until([&] { return sentence().contains(said); }), qPrintable(sentence()));
  QVERIFY2(!sentence().contains(QStringLiteral("smaller")), qPrintable(sentence()));
  const QString tip = state.data(Qt::ToolTipRole).toString();
  QVERIFY2(tip.contains(said), qPrintable(tip));
  auto* verdict = window.findChild<QLabel*>(QStringLiteral("holeVerdict"));
  QVERIFY2(verdict->text().startsWith(QStringLiteral("Hole 1: bad. A dome ")), qPrintable(verdict->text()));
  QVERIFY2(verdict->text().contains(QStringLiteral("Trim crossing triangles")), qPrintable(verdict->text()));
  window.selection().select({});
  settle();
  QVERIFY2(pixels_of(table, state, red) > 5, "the sign in the table is not red");
  auto* group = part<QComboBox>(window, "holesGroup");
  group->setCurrentIndex(group->findText(QStringLiteral("To look at")));
  QCOMPARE(table->model()->rowCount(), 1);
  group->setCurrentIndex(0);
  key(window, Qt::Key_L);
  QCOMPARE(window.selection().selected(), std::set<int>{0});
  window.selection().select({});
  trigger(window, "lookBottom");
  press(window, "nextToLookAtButton");
  QCOMPARE(window.selection().selected(), std::set<int>{0});
  QVERIFY(wait_until([&] { return !window.view().is_flying(); }));
  const BoundaryLoop& boundary_loop = window.document().loop(0);
  QVERIFY((window.view().viewpoint().focus - boundary_loop.center).norm() < boundary_loop.diameter / 4);  // it flew there
  window.selection().select({});
  the_report_begins_with(window, 0);
  // The flat cap that is made by default is marked by nothing.
  key(window, Qt::Key_Z, Qt::ControlModifier);
  window.selection().select({0});
  boundary->setCurrentIndex(boundary->findData(static_cast<int>(BoundaryTrust::automatic)));
  QVERIFY(press_and_wait(window, "fillAndSmooth", 2 * minutes));
  QVERIFY(window.document().state(0) != HoleState::bad);
  window.selection().select({});
  settle();
  QCOMPARE(pixels_of(table, table->model()->index(0, HoleTable::state), red), 0);
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<RepairTest>(); }

#include "repair_test.moc"
