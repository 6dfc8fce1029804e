// SPDX-License-Identifier: GPL-3.0-or-later
// The window and the command line give the same vertices: for everything that a person can choose, and where the flow must
// give way.
#include "driver.h"
#include "test_main.h"

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "samples/analytic_surfaces.h"
#include "support/sharp_surfaces.h"

#include <QCheckBox>
#include <QFile>
#include <QProcess>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

/// A unit sphere with two neighbouring holes; a plate stands where the patch of the larger one wants to go.
QString write_obstructed_sphere(const QString& path) {
  const Vec3 large = Vec3::UnitZ(), small = Vec3(std::sin(1.05), 0, std::cos(1.05));
  const auto within = [](const Vec3& p, const Vec3& middle, double angle) { return p.dot(middle) > std::cos(angle); };
  const TriangleSoup sphere =
      cut(make_icosphere(4), [&](const Vec3& p) { return within(p, large, 0.5) || within(p, small, 0.3); });
  TriangleSoup plate;
  for (double x : {-0.1, 0.1})
    for (double z : {0.95, 1.8}) plate.points.emplace_back(x, 0, z);  // too large for a fragment
  plate.triangles = {{0, 2, 1}, {1, 2, 3}};
  write_mesh(path.toStdString(), joined({sphere, plate}));
  return path;
}

/// A noisy unit sphere with two neighbouring holes: one problem whose holes the engine solves apart.
QString write_noisy_sphere(const QString& path) {
  const Vec3 one = Vec3::UnitZ(), other = Vec3(std::sin(0.95), 0, std::cos(0.95));
  TriangleSoup sphere = cut(make_icosphere(4),
                            [&](const Vec3& p) { return p.dot(one) > std::cos(0.4) || p.dot(other) > std::cos(0.35); });
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.004);
  for (Vec3& p : sphere.points) p *= 1 + noise(random);
  write_mesh(path.toStdString(), sphere);
  return path;
}

Points sorted(Points points) {
  std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) {
    return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
  });
  return points;
}

/// A sphere with a hole, a fin, and a crack along part of its equator.
TriangleSoup to_be_repaired() {
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
    for (int v : t) z += soup.points[v].z();
    for (int& v : t)
      if (z > 0 && twin.contains(v)) v = twin[v];
  }
  const auto lowest = std::min_element(soup.triangles.begin(), soup.triangles.end(), [&](const auto& s, const auto& t) {
    return soup.points[s[0]].z() < soup.points[t[0]].z();
  });
  const Triangle fin{(*lowest)[0], (*lowest)[1], static_cast<int>(soup.points.size())};
  soup.points.emplace_back(0, 0, -2);
  soup.triangles.push_back(fin);
  return soup;
}

/// A sphere with a hole, and two triangles that stand on an edge of it: the second runs through the surface.
TriangleSoup pierced_sphere() {
  TriangleSoup soup = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; });
  const SurfaceModel model = make_surface_model(soup);
  const BoundaryLoop loop = find_boundary_loops(model).front();
  const auto at = [&](std::size_t k) { return model.soup_vertex[loop.vertices[k]]; };
  const int a = at(0), b = at(1), tip = static_cast<int>(soup.points.size());
  const Vec3 middle = (soup.points[a] + soup.points[b]) / 2;
  const Vec3 outward = (middle - loop.center).normalized();
  soup.points.push_back(1.05 * middle);
  soup.points.push_back(0.9 * (middle + 0.12 * outward));
  soup.triangles.push_back({a, b, tip});
  soup.triangles.push_back({a, tip, tip + 1});
  return soup;
}

/// @returns whether the command filled every hole.
bool fill_by_command(const QString& scan, const QString& output, const QStringList& options = {}) {
  QProcess program;
  program.start(QStringLiteral(LOOPMEND_PROGRAM),
                QStringList{QStringLiteral("fill"), scan, QStringLiteral("-o"), output} + options);
  return program.waitForFinished(240000) && program.exitCode() == 0;
}

}  // namespace

class SameBitsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void where_the_flow_must_give_way();
  void holes_solved_apart_are_watched();
  void window_and_command_line_give_the_same_bits_data();
  void window_and_command_line_give_the_same_bits();

 private:
  QTemporaryDir folder_;
};

void SameBitsTest::where_the_flow_must_give_way() {
  const QString scan = write_obstructed_sphere(folder_.filePath(QStringLiteral("obstructed.ply")));
  Shown window({scan});
  const Document& document = window.document();
  QVERIFY(press_and_wait(window, "fill"));
  QCOMPARE(document.patches().size(), std::size_t(1));  // neighbours: one problem
  QVERIFY(press_and_wait(window, "fillAndSmooth", 240));
  // Together they would cut the plate: each by itself, and the large one takes a candidate that does not.
  QCOMPARE(document.patches().size(), std::size_t(2));
  const PatchState &large = *document.patch_of(0)->state, &small = *document.patch_of(1)->state;
  QVERIFY2(is_filled(large.status) && large.status != PatchStatus::converged, large.message.english().c_str());
  QVERIFY2(small.status == PatchStatus::converged, small.message.english().c_str());
  const QString by_hand = folder_.filePath(QStringLiteral("by-hand.ply"));
  window.controller().export_to(by_hand);
  QVERIFY(wait_idle(window));
  const QString by_script = folder_.filePath(QStringLiteral("by-script.ply"));
  QVERIFY(fill_by_command(scan, by_script));
  QVERIFY2(
      sorted(read_mesh(by_hand.toStdString()).soup.points) == sorted(read_mesh(by_script.toStdString()).soup.points),
      "window and command line do not give the same vertices");
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(document.patches().size(), std::size_t(1));
}

/// Holes of one patch that the engine solves apart are patches of their own from the first step on.
void SameBitsTest::holes_solved_apart_are_watched() {
  const QString scan = write_noisy_sphere(folder_.filePath(QStringLiteral("noisy.ply")));
  Shown window({scan});
  const Document& document = window.document();
  QVERIFY(press_and_wait(window, "fill"));
  QCOMPARE(document.patches().size(), std::size_t(1));
  const PatchStatePtr together = document.patches().front().state;
  press(window, "run");
  QVERIFY(wait_until([&] { return document.patch_of(0)->state->steps >= 2; }));
  QVERIFY(window.controller().busy());
  QCOMPARE(document.patches().size(), std::size_t(2));
  QVERIFY(document.patch_of(0)->timeline->size() >= 3);
  press(window, "run");  // again: pause
  QVERIFY(wait_idle(window));
  QCOMPARE(document.patches().size(), std::size_t(2));
  QVERIFY(document.patch_of(0)->state->steps >= 2);
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(document.patches().size(), std::size_t(1));
  QCOMPARE(document.patches().front().state, together);
  // Given up before the first step: nothing is divided.
  press(window, "run");
  QVERIFY(window.controller().busy());
  window.controller().cancel();
  QCOMPARE(document.patches().size(), std::size_t(1));
  QCOMPARE(document.patches().front().state, together);

  QVERIFY(press_and_wait(window, "fillAndSmooth", 240));
  QCOMPARE(document.patches().size(), std::size_t(2));
  for (const OpenPatch& patch : document.patches()) {
    QVERIFY(is_filled(patch.state->status));
    QCOMPARE(patch.timeline->back(), patch.state);
    QVERIFY(patch.timeline->size() > 2);
  }
  const QString by_hand = folder_.filePath(QStringLiteral("apart-by-hand.ply"));
  window.controller().export_to(by_hand);
  QVERIFY(wait_idle(window));
  const QString by_script = folder_.filePath(QStringLiteral("apart-by-script.ply"));
  QVERIFY(fill_by_command(scan, by_script));
  QFile ours(by_hand), theirs(by_script);
  QVERIFY(ours.open(QIODevice::ReadOnly) && theirs.open(QIODevice::ReadOnly));
  QVERIFY2(ours.readAll() == theirs.readAll(), "the window's file is not the command's");
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(document.patches().size(), std::size_t(1));
  key(window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  QCOMPARE(document.patches().size(), std::size_t(2));
}

void SameBitsTest::window_and_command_line_give_the_same_bits_data() {
  QTest::addColumn<QString>("scan");
  QTest::addColumn<QStringList>("options");
  QTest::addColumn<bool>("at_once");  // or from initial patches
  QTest::newRow("sample") << sample_file(folder_) << QStringList() << true;
  for (const char* name : {"bunny.ply", "head_holes.ply", "plane_holes.obj"})
    if (at_length() || name[0] == 'h')
      QTest::newRow(name) << QStringLiteral(LOOPMEND_SHARED_DIR "/data/") + QLatin1String(name) << QStringList()
                        << (name[0] != 'b');
  QTest::newRow("relief") << write_noisy_sphere(folder_.filePath(QStringLiteral("relief.ply")))
                          << QStringList{QStringLiteral("--relief"), QStringLiteral("continued")} << false;
  const QString edge = folder_.filePath(QStringLiteral("edge.ply"));
  write_mesh(edge.toStdString(),
             cut(test::make_cube(16), [](const Vec3& p) { return (p - Vec3(1, 1, 0.5)).norm() < 0.2; }));
  QTest::newRow("sharp edge") << edge << QStringList() << true;
  QTest::newRow("rounded edge") << edge << QStringList{QStringLiteral("--edges"), QStringLiteral("round")} << true;
  const QString island = folder_.filePath(QStringLiteral("island.ply"));
  write_mesh(island.toStdString(), cut(make_icosphere(4), [](const Vec3& p) {
               return p.z() > 0.7 && (p - Vec3(0.2, 0, 0.98).normalized()).norm() > 0.15;
             }));
  QTest::newRow("island") << island << QStringList() << false;
  QTest::newRow("island at once") << island << QStringList() << true;
  QTest::newRow("island covered") << island << QStringList{QStringLiteral("--islands"), QStringLiteral("cover")}
                                  << false;
  const QString damaged = folder_.filePath(QStringLiteral("damaged.ply"));
  write_mesh(damaged.toStdString(), to_be_repaired());
  for (const char* option : {"--stitch", "--repair"})
    QTest::newRow(option) << damaged << QStringList{QLatin1String(option)} << true;
  const QString ragged = folder_.filePath(QStringLiteral("ragged.ply"));
  TriangleSoup dangling = cut(make_icosphere(4), [](const Vec3& p) { return p.z() + 0.1 * p.x() > 0.8; });
  const SurfaceModel open = make_surface_model(dangling);
  const BoundaryLoop loop = find_boundary_loops(open).front();
  const int a = open.soup_vertex[loop.vertices[0]];
  const int b = open.soup_vertex[loop.vertices[1]];
  // A triangle on one edge of the boundary, beyond the surface.
  const Vec3 &from = dangling.points[a], &to = dangling.points[b];
  dangling.points.push_back((from + to) / 2 + (loop.center - (from + to) / 2) * 0.1);
  dangling.triangles.push_back({a, b, static_cast<int>(dangling.points.size()) - 1});
  write_mesh(ragged.toStdString(), dangling);
  const QString crossing = folder_.filePath(QStringLiteral("crossing.ply"));
  write_mesh(crossing.toStdString(), pierced_sphere());
  QTest::newRow("crossing boundary") << crossing << QStringList{QStringLiteral("--trim-crossing")} << true;
  QTest::newRow("ragged boundary") << ragged << QStringList{QStringLiteral("--trim-boundary"), QStringLiteral("3")}
                                   << true;
}

/// Everything that a person gets who fills all holes, runs the flow and exports, against the command's file.
void SameBitsTest::window_and_command_line_give_the_same_bits() {
  QFETCH(QString, scan);
  QFETCH(QStringList, options);
  if (!QFile::exists(scan)) QSKIP("the shared scans are not here");
  Shown window({scan});
  if (options.contains(QStringLiteral("--trim-boundary"))) {
    const std::size_t before = window.document().scan(0)->model->soup.triangles.size();
    QVERIFY(press_and_apply(window, "trim"));
    const int trimmed = window.document().scans().front();
    QVERIFY(window.document().scan(trimmed)->model->soup.triangles.size() < before);
  }
  if (options.contains(QStringLiteral("--trim-crossing"))) {
    const std::size_t before = window.document().scan(0)->model->soup.triangles.size();
    trigger(window, "trimCrossingAction");
    QVERIFY(apply_proposal(window));
    const int trimmed = window.document().scans().front();
    QCOMPARE(window.document().scan(trimmed)->model->soup.triangles.size(), before - 1);
  }
  const auto repaired = [&](const std::function<void()>& act) {
    const int before = window.document().scans().front();
    act();
    return wait_idle(window) && window.document().scans().front() != before;  // another one came in its place
  };
  if (options.contains(QStringLiteral("--stitch"))) QVERIFY(repaired([&] { press_and_apply(window, "stitch"); }));
  if (options.contains(QStringLiteral("--repair")))
    QVERIFY(repaired([&] { window.controller().repair(harmless_repairs); }));
  part<QCheckBox>(window, "islands")->setChecked(!options.contains(QStringLiteral("--islands")));
  part<QCheckBox>(window, "relief")->setChecked(options.contains(QStringLiteral("--relief")));
  part<QCheckBox>(window, "edges")->setChecked(!options.contains(QStringLiteral("--edges")));
  const auto expect_file_of_command = [&](const QStringList& of_fill) {
    const QString by_hand = folder_.filePath(QStringLiteral("window.ply"));
    const QString by_script = folder_.filePath(QStringLiteral("command.ply"));
    window.controller().export_to(by_hand);
    QVERIFY(wait_idle(window));
    QVERIFY(fill_by_command(scan, by_script, of_fill));
    QFile ours(by_hand), theirs(by_script);
    QVERIFY(ours.open(QIODevice::ReadOnly) && theirs.open(QIODevice::ReadOnly));
    const QByteArray expected = theirs.readAll();
    QVERIFY(expected.size() > 1000);
    QVERIFY2(ours.readAll() == expected, "the window's file is not the command's");
  };
  QVERIFY(press_and_wait(window, "fill"));
  if (!options.contains(QStringLiteral("--relief")) && !options.contains(QStringLiteral("--edges")))
    expect_file_of_command(options + QStringList{QStringLiteral("--flow"), QStringLiteral("none")});
  if (QTest::currentTestFailed()) return;
  QFETCH(bool, at_once);
  if (at_once) key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(window.document().patches().empty(), at_once);
  QVERIFY(press_and_wait(window, "fillAndSmooth", 240));
  expect_file_of_command(options);
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<SameBitsTest>(); }

#include "same_bits_test.moc"
