// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures without a display. The test is started with DISPLAY unset.
#include "driver.h"

#include "core/error.h"
#include "mesh/boundary_loops.h"
#include "samples/sample_scan.h"
#include "scene/offscreen_render.h"
#include "scene/shape_glide.h"
#include "scene/view_direction.h"
#include "support/sharp_surfaces.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <fstream>
#include <limits>
#include <memory>
#include <vector>

using namespace loopmend;
using namespace loopmend::testing;

class RenderTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    qunsetenv("DISPLAY");
    qunsetenv("WAYLAND_DISPLAY");
    model_ = make_surface_model(make_sample_scan());
  }

  void every_shading_draws_a_picture() {
    QList<QImage> pictures;
    for (Shading shading : {Shading::curvature, Shading::plain, Shading::zebra}) {
      RenderOptions options;
      options.shading = shading;
      options.width = 400;
      options.height = 300;
      keep("one.png", render_surface(model_, options));
      const QImage picture(path("one.png"));
      QCOMPARE(picture.size(), QSize(400, 300));
      QVERIFY(count_colors(picture) >= 64);
      pictures << picture;
    }
    QVERIFY(pictures[0] != pictures[1]);
    QVERIFY(pictures[1] != pictures[2]);
  }

  void captions_can_be_read_on_a_phone() {
    RenderOptions options;
    options.shading = Shading::plain;
    options.width = 1000;
    options.height = 420;
    const QImage picture = QImage::fromData(QByteArray::fromStdString(render_before_after(model_, model_, options)));
    int first = options.height, last = -1;
    for (int y = 0; y < 60; ++y)
      for (int x = 0; x < 120; ++x)
        if (qGray(picture.pixel(x, y)) < 90) {
          first = std::min(first, y);
          last = std::max(last, y);
        }
    const double capitals_at_390 = (last - first + 1) * 390.0 / options.width;
    QVERIFY2(capitals_at_390 >= 7, qPrintable(QString::number(capitals_at_390)));
  }

  /// The faces that are left at such a loop look the other way.
  void the_eye_looks_into_a_cube_without_two_sides() {
    TriangleSoup corner = test::make_cube(6);
    std::erase_if(corner.triangles, [&](const Triangle& t) {
      const auto lies_on = [&](int axis) {
        return std::ranges::all_of(t, [&](int v) { return corner.points[v][axis] > 1 - 1e-9; });
      };
      return lies_on(0) || lies_on(2);
    });
    const SurfaceModel model = make_surface_model(corner);
    BoundaryLoop loop = find_boundary_loops(model).at(0);
    loop.kind = LoopKind::hole;
    QVERIFY(facing(model, loop).dot(Vec3(1, 0, 1).normalized()) > 0.9);
  }

  void the_same_picture_every_time() {
    RenderOptions options;
    options.width = 320;
    options.height = 240;
    keep("a.png", render_surface(model_, options));
    keep("b.png", render_surface(model_, options));
    QCOMPARE(QImage(path("a.png")), QImage(path("b.png")));
  }

  void own_colors_are_drawn() {
    SurfaceModel red = model_;
    red.soup.colors.assign(red.soup.points.size(), Color{220, 20, 20, 255});
    RenderOptions options;
    options.shading = Shading::scan;
    options.width = options.height = 200;
    keep("red.png", render_surface(red, options));
    const QImage picture(path("red.png"));
    int reddish = 0;
    for (int y = 0; y < picture.height(); ++y)
      for (int x = 0; x < picture.width(); ++x) {
        const QColor color = picture.pixelColor(x, y);
        reddish += color.red() > 90 && color.red() > 3 * color.green() && color.red() > 3 * color.blue();
      }
    QVERIFY2(reddish > 8000, qPrintable(QString::number(reddish)));
  }

  void before_and_after_side_by_side() {
    RenderOptions options;
    options.width = 800;
    options.height = 400;
    keep("pair.png", render_before_after(model_, model_, options));
    const QImage picture(path("pair.png"));
    QCOMPARE(picture.size(), QSize(800, 400));
    QVERIFY(count_colors(picture.copy(0, 0, 400, 400)) >= 64);
    QVERIFY(count_colors(picture.copy(400, 0, 400, 400)) >= 64);
  }

  void lines_go_around_what_the_second_has_filled() {
    const std::vector<BoundaryLoop> loops = find_boundary_loops(model_);
    TriangleSoup fan = model_.soup;
    const int tip = static_cast<int>(fan.points.size());
    fan.points.push_back(loops[1].center);
    const std::vector<int>& around = loops[1].vertices;
    for (std::size_t k = 0; k < around.size(); ++k)
      fan.triangles.push_back({around[(k + 1) % around.size()], around[k], tip});
    const SurfaceModel filled = make_surface_model(fan);
    QCOMPARE(find_boundary_loops(filled).size(), loops.size() - 1);
    QCOMPARE(dark_pixels(filled, Seams::hidden), 0);
    QCOMPARE(dark_pixels(model_, Seams::shown), 0);
    QVERIFY(dark_pixels(filled, Seams::shown) > 40);
  }

  void one_loop_fills_the_picture_and_sides_are_chosen() {
    RenderOptions options;
    options.width = options.height = 200;
    options.shading = Shading::plain;
    const auto picture = [&] { return QImage::fromData(QByteArray::fromStdString(render_surface(model_, options))); };
    const QImage whole = picture();
    options.loop = 2;
    const QImage loop = picture();
    // In the corner is ground beside the whole surface, and the loop's neighborhood in its own picture.
    QVERIFY(loop.pixel(0, 0) != whole.pixel(0, 0));
    options.view = NamedView::top;
    QVERIFY(picture() != loop);
    options.loop.reset();
    QList<QImage> sides;
    for (NamedView view : {NamedView::front, NamedView::back, NamedView::left, NamedView::right, NamedView::top,
                           NamedView::bottom, NamedView::iso}) {
      options.view = view;
      sides << picture();
      QVERIFY(sides.count(sides.back()) == 1);
    }
    options.loop = 99;
    QVERIFY_EXCEPTION_THROWN(picture(), InvalidArgument);
  }

  void both_pictures_of_a_pair_are_seen_whole() {
    // After is twice as high as before: fitted to the first alone, its top would be cut off.
    TriangleSoup tall = make_sample_scan();
    for (Vec3& p : tall.points) p.y() *= 2;
    RenderOptions options;
    options.width = 800;
    options.height = 400;
    options.shading = Shading::plain;
    options.view = NamedView::front;
    const SurfaceModel after = make_surface_model(tall);
    const QImage pair = QImage::fromData(QByteArray::fromStdString(render_before_after(model_, after, options)));
    for (int x = 500; x < 800; ++x) QVERIFY2(pair.pixel(x, 1) == pair.pixel(401, 1), "cut off at the top");
  }

  void wrong_sizes_are_refused() {
    RenderOptions options;
    options.width = 10;
    QVERIFY_EXCEPTION_THROWN(render_surface(model_, options), InvalidArgument);
    QVERIFY(!QFile::exists(path("x.png")));
  }

  void a_surface_glides_evenly_to_its_next_state() {
    using namespace std::chrono_literals;
    const float unknown = std::numeric_limits<float>::quiet_NaN();
    SurfaceShape from;
    from.points = {0, 0, 0, 1, 0, 0, 0, 1, 0};
    from.normals = {0, 0, 1, 0, 0, 1, 0, 0, 1};
    from.triangles = std::vector{0, 1, 2};
    from.own_triangles = 1;
    from.H = {0, 4, unknown};
    from.K = {0, 0, 0};
    auto to = std::make_shared<SurfaceShape>(from);
    to->points[2] = 8;
    to->H = {8, 4, 3};
    const ShapeGlide::Clock::time_point start{};
    ShapeGlide glide(from, to, start, 400ms);
    QCOMPARE(glide.shown().points[2], 0.0F);
    glide.advance(start + 100ms);
    QCOMPARE(glide.shown().points[2], 2.0F);
    QCOMPARE(glide.shown().H, (std::vector<float>{2, 4, 3}));  // what was unknown is known at once
    QVERIFY(!glide.has_arrived(start + 399ms));
    // In a hurry it goes on from where it is, evenly, without a leap.
    glide.hurry(start + 100ms, start + 200ms);
    QCOMPARE(glide.shown().points[2], 2.0F);
    glide.advance(start + 150ms);
    QCOMPARE(glide.shown().points[2], 5.0F);
    glide.hurry(start + 150ms, start + 900ms);  // no reason to dawdle
    QVERIFY(glide.has_arrived(start + 200ms));
    glide.advance(start + 250ms);
    QCOMPARE(glide.shown().points, to->points);
    QCOMPARE(glide.goal(), to);
  }

  void surfaces_of_other_vertices_do_not_glide() {
    SurfaceShape from;
    from.points.resize(12);
    from.normals.resize(12);
    from.triangles = std::vector{0, 1, 2, 0, 2, 3, 0, 3, 1};
    from.own_triangles = 3;
    SurfaceShape to = from;
    QVERIFY(ShapeGlide::is_possible(from, to));
    to.triangles = std::vector{0, 1, 2, 0, 2, 3, 0, 1, 3};  // one of three turned over
    QVERIFY(ShapeGlide::is_possible(from, to));
    to.triangles = std::vector{1, 2, 0, 3, 0, 2, 3, 1, 0};
    QVERIFY(!ShapeGlide::is_possible(from, to));
    to = from;
    to.points.resize(9);
    QVERIFY(!ShapeGlide::is_possible(from, to));
  }

 private:
  QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }
  void keep(const char* name, const std::string& bytes) const {
    std::ofstream(path(name).toStdString(), std::ios::binary) << bytes;
  }

  /// Of the second picture, below its caption.
  int dark_pixels(const SurfaceModel& after, Seams seams) const {
    RenderOptions options;
    options.shading = Shading::plain;
    options.width = 800;
    options.height = 400;
    options.seams = seams;
    const QImage pair = QImage::fromData(QByteArray::fromStdString(render_before_after(model_, after, options)));
    int dark = 0;
    for (int y = 60; y < 400; ++y)
      for (int x = 400; x < 800; ++x) dark += qGray(pair.pixel(x, y)) < 70;
    return dark;
  }

  QTemporaryDir folder_;
  SurfaceModel model_;
};

QTEST_GUILESS_MAIN(RenderTest)
#include "render_test.moc"
