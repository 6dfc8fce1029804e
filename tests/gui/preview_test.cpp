// SPDX-License-Identifier: GPL-3.0-or-later
// Prepare, Trim and Stitch show what they would change before they do it.
#include "driver.h"
#include "test_main.h"

#include "document/fill_report.h"
#include "document/labels.h"
#include "mesh/scan_attributes.h"
#include "panels/banner.h"
#include "samples/analytic_surfaces.h"
#include "views/view_overlay.h"

#include <QLineF>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <map>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

/// A ball with a hole, and triangles that stand on one edge of its boundary, a third of the way round from each other.
TriangleSoup ragged_ball(int triangles) {
  TriangleSoup soup = cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.8; });
  const SurfaceModel open = make_surface_model(soup);
  const BoundaryLoop loop = find_boundary_loops(open).front();
  for (int k = 0; k < triangles; ++k) {
    const std::size_t at = loop.vertices.size() * static_cast<std::size_t>(k) / 3;
    const int a = open.soup_vertex[loop.vertices[at]];
    const int b = open.soup_vertex[loop.vertices[(at + 1) % loop.vertices.size()]];
    const Vec3 middle = (soup.points[a] + soup.points[b]) / 2;
    soup.points.push_back(middle + (loop.center - middle) * 0.1);
    soup.triangles.push_back({a, b, static_cast<int>(soup.points.size()) - 1});
  }
  return soup;
}

/// Two halves that meet along a zigzag of boundary edges, the mesh split there.
TriangleSoup split_ball() {
  const TriangleSoup ball = make_icosphere(3);
  const auto half = [&](double side) {
    TriangleSoup soup;
    std::map<int, int> own;
    for (const Triangle& t : ball.triangles) {
      if (side * (ball.points[t[0]] + ball.points[t[1]] + ball.points[t[2]]).dot(Vec3(0.1, 0.2, 1)) < 0) continue;
      Triangle mine;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto [at, is_new] = own.try_emplace(t[k], static_cast<int>(soup.points.size()));
        if (is_new) soup.points.push_back(ball.points[t[k]]);
        mine[k] = at->second;
      }
      soup.triangles.push_back(mine);
    }
    return soup;
  };
  return joined({half(1), half(-1)});
}

std::size_t triangles_of(MainWindow& window) {
  return window.document().scan(window.document().scans().front())->model->soup.triangles.size();
}

int red_pixels(MainWindow& window) {
  const QImage picture = window.view().picture();
  int count = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) {
      const QColor color = picture.pixelColor(x, y);
      // Lines of boundaries have more blue.
      count += color.red() > 130 && color.red() > 3 * color.green() && color.red() > 3 * color.blue();
    }
  return count;
}

QPushButton* answer(MainWindow& window, const char* name) {
  const QList<QPushButton*> found = window.findChildren<QPushButton*>(QLatin1String(name));
  const auto shown = std::find_if(found.begin(), found.end(), [](const auto* button) { return button->isVisible(); });
  return shown == found.end() ? nullptr : *shown;
}

QString proposed(MainWindow& window) {
  if (!wait_until([&] { return answer(window, "proposalApply") != nullptr; })) return {};
  settle();
  return window.findChild<Banner*>()->text();
}

void give(MainWindow& window, const char* name) { QTest::mouseClick(answer(window, name), Qt::LeftButton); }

}  // namespace

class PreviewTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_trim_is_shown_and_left();
  void a_trim_is_shown_and_done();
  void each_place_is_shown();
  void a_stitch_is_shown_and_done();
  void preparing_is_shown_and_done();
  void a_place_too_small_to_be_seen_is_marked();
  void tiles_that_overlap_are_joined();
  void other_work_takes_the_question_away();

 private:
  QTemporaryDir folder_;
};

void PreviewTest::a_trim_is_shown_and_left() {
  Shown window({scan_file(folder_, QStringLiteral("ragged.ply"), ragged_ball(1))});
  window.selection().select({});
  QVERIFY(settle());
  const std::size_t before = triangles_of(window);
  QCOMPARE(red_pixels(window), 0);
  press(window, "trim");
  const QString words = proposed(window);
  QVERIFY2(words.startsWith(QStringLiteral("ragged.ply: 1 bad triangle would be removed at the boundaries.")),
           qPrintable(words));
  QVERIFY2(words.endsWith(QStringLiteral("Red: what would change, place 1 of 1.")), qPrintable(words));
  QCOMPARE(triangles_of(window), before);
  QVERIFY(red_pixels(window) > 20);  // in the view, and flown to
  QVERIFY(!window.undo().can_undo());
  QVERIFY(!answer(window, "proposalNext"));
  give(window, "proposalKeep");
  QVERIFY(settle());
  QCOMPARE(red_pixels(window), 0);
  QVERIFY(!window.findChild<Banner*>()->isVisible());
  QCOMPARE(triangles_of(window), before);
  QVERIFY(!window.undo().can_undo());
  // Escape does the same.
  press(window, "trim");
  QVERIFY(!proposed(window).isEmpty());
  key(window, Qt::Key_Escape);
  QVERIFY(settle());
  QCOMPARE(red_pixels(window), 0);
  QCOMPARE(triangles_of(window), before);
}

void PreviewTest::a_trim_is_shown_and_done() {
  Shown window({scan_file(folder_, QStringLiteral("ragged.ply"), ragged_ball(1))});
  const std::size_t before = triangles_of(window);
  QVERIFY(press_and_apply(window, "trim"));
  QCOMPARE(triangles_of(window), before - 1);
  QVERIFY(settle());
  const QString said = window.findChild<Banner*>()->text();
  QVERIFY2(said.contains(QStringLiteral("removed at the boundaries; Ctrl+Z")), qPrintable(said));
  window.undo().undo();
  QCOMPARE(triangles_of(window), before);
}

void PreviewTest::each_place_is_shown() {
  Shown window({scan_file(folder_, QStringLiteral("three.ply"), ragged_ball(3))});
  press(window, "trim");
  QVERIFY(proposed(window).endsWith(QStringLiteral("place 1 of 3.")));
  std::vector<Vec3> seen;
  for (int place = 1; place <= 3; ++place) {
    seen.push_back(window.view().viewpoint().focus);
    give(window, "proposalNext");
    const QString words = proposed(window);
    const QString at = QStringLiteral("place %1 of 3.").arg(place % 3 + 1);
    QVERIFY2(words.endsWith(at), qPrintable(words));
  }
  QVERIFY((seen[0] - seen[1]).norm() > 0.1 && (seen[1] - seen[2]).norm() > 0.1);
  QVERIFY((window.view().viewpoint().focus - seen[0]).norm() < 1e-6);  // the first again
  give(window, "proposalApply");
  QVERIFY(wait_idle(window));
  QVERIFY(!window.view().is_flying() || settle());
}

void PreviewTest::a_stitch_is_shown_and_done() {
  const TriangleSoup soup = split_ball();
  Shown window({scan_file(folder_, QStringLiteral("split.ply"), soup)});
  const SurfaceModel model = make_surface_model(soup);
  const std::size_t edges = find_boundary_loops(model).front().vertices.size();
  press(window, "stitch");
  const QString words = proposed(window);
  const QString counts = QStringLiteral(
                             "split.ply: %1 vertices would be joined to others and 0 faces split; %2 boundary "
                             "edges would close. Boundary loops: 0 in place of 2.")
                             .arg(edges)
                             .arg(2 * edges);
  QVERIFY2(words.startsWith(counts), qPrintable(words + QLatin1Char('\n') + counts));
  QVERIFY(red_pixels(window) > 20);  // the triangles along the crack, though no vertex would move
  give(window, "proposalApply");
  QVERIFY(wait_idle(window));
  QVERIFY(settle());
  const Document& document = window.document();
  QVERIFY(document.scan(document.scans().front())->loops.empty());
}

/// A ball with two holes, and a fin on one of its edges, by the button of the panel.
void PreviewTest::preparing_is_shown_and_done() {
  TriangleSoup soup = cut(make_icosphere(3), [](const Vec3& p) { return std::abs(p.z()) > 0.9; });
  const Triangle t = soup.triangles[soup.triangles.size() / 2];
  soup.points.push_back(1.5 * soup.points[t[0]]);
  soup.triangles.push_back({t[0], t[1], static_cast<int>(soup.points.size()) - 1});
  Shown window({scan_file(folder_, QStringLiteral("fin.ply"), soup)});
  press(window, "prepare");
  const QString words = proposed(window);
  QVERIFY2(words.startsWith(QStringLiteral("fin.ply would be prepared: ")), qPrintable(words));
  QVERIFY(red_pixels(window) > 20);
  QCOMPARE(triangles_of(window), soup.triangles.size());
  give(window, "proposalKeep");
  QVERIFY(settle());
  QVERIFY(!window.undo().can_undo());
  press(window, "prepare");
  QVERIFY(!proposed(window).isEmpty());
  give(window, "proposalApply");
  QVERIFY(wait_idle(window));
  QVERIFY(triangles_of(window) < soup.triangles.size());
  QVERIFY(press_and_wait(window, "fill"));
  QCOMPARE(window.document().patches().size(), std::size_t{2});
  const QStringList remarks = fill_report(window.document()).remarks;  // that the command does not prepare
  QVERIFY2(remarks.size() == 1, qPrintable(remarks.join(QLatin1Char('\n'))));
}

/// A loose triangle of less than a thousandth of a pixel, beside a ball: corners stand around it.
void PreviewTest::a_place_too_small_to_be_seen_is_marked() {
  TriangleSoup soup = cut(make_icosphere(3), [](const Vec3& p) { return p.z() > 0.9; });
  const int first = static_cast<int>(soup.points.size());
  const Vec3 at(1.02, 0, 0);
  for (const Vec3& p : {at, Vec3(at + Vec3(0, 1e-7, 0)), Vec3(at + Vec3(0, 0, 1e-7))}) soup.points.push_back(p);
  soup.triangles.push_back({first, first + 1, first + 2});
  Shown window({scan_file(folder_, QStringLiteral("speck.ply"), soup)});
  auto* overlay = part<ViewOverlay>(window, "viewOverlay");
  press(window, "prepare");
  QVERIFY(!proposed(window).isEmpty());
  QVERIFY(wait_until([&] { return !window.view().is_flying(); }));
  QVERIFY(settle());
  QCOMPARE(overlay->marks().size(), std::size_t(1));
  const QRectF box = overlay->marks().front().box;
  QVERIFY(box.width() >= 12 && box.width() < 20);
  QVERIFY(QLineF(box.center(), QRectF(overlay->rect()).center()).length() < 4);
  give(window, "proposalKeep");
  QVERIFY(settle());
  QVERIFY(overlay->marks().empty());
}

void PreviewTest::tiles_that_overlap_are_joined() {
  TriangleSoup second = make_graph([](double, double) { return 0.005; }, 1, 17);
  for (Vec3& p : second.points) p.x() += 1.6;
  const TriangleSoup first = make_graph([](double, double) { return 0.0; }, 1, 20);
  Shown window({scan_file(folder_, QStringLiteral("tiles.ply"), joined({first, second}))});
  const std::size_t before = triangles_of(window);
  press(window, "stitch");
  const QString words = proposed(window);
  QVERIFY2(words.contains(QStringLiteral("tiles overlap")), qPrintable(words));
  QVERIFY(red_pixels(window) > 20);
  give(window, "proposalApply");
  QVERIFY(wait_idle(window));
  QVERIFY(settle());
  const Document& document = window.document();
  const std::vector<BoundaryLoop>& loops = document.scan(document.scans().front())->loops;
  QCOMPARE(loops.size(), 2U);
  QVERIFY(loops[0].kind == LoopKind::outer_rim && loops[1].kind == LoopKind::hole);
  QVERIFY(triangles_of(window) < before);
  window.undo().undo();
  QCOMPARE(triangles_of(window), before);
}

void PreviewTest::other_work_takes_the_question_away() {
  Shown window({scan_file(folder_, QStringLiteral("ragged.ply"), ragged_ball(1))});
  press(window, "trim");
  QVERIFY(!proposed(window).isEmpty());
  press(window, "fill");
  QVERIFY(wait_idle(window));
  QVERIFY(settle());
  QVERIFY(!answer(window, "proposalApply"));  // it was computed without the patch
  press(window, "trim");
  QVERIFY(wait_idle(window));
  settle();
  if (answer(window, "proposalApply")) {
    const QString words = window.findChild<Banner*>()->text();
    QVERIFY2(words.contains(QStringLiteral("1 patch of this scan would go.")) ||
                 words.contains(QStringLiteral("would be removed")),
             qPrintable(words));
  }
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<PreviewTest>(); }

#include "preview_test.moc"
