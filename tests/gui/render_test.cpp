// Pictures without a display. The test is started with DISPLAY unset.
#include "driver.h"

#include "core/error.h"
#include "mesh/boundary_loops.h"
#include "samples/sample_scan.h"
#include "scene/offscreen_render.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

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
      render_to_png(model_, options, file("one.png"));
      const QImage picture(path("one.png"));
      QCOMPARE(picture.size(), QSize(400, 300));
      QVERIFY(count_colors(picture) >= 64);
      pictures << picture;
    }
    QVERIFY(pictures[0] != pictures[1]);
    QVERIFY(pictures[1] != pictures[2]);
  }

  void the_same_picture_every_time() {
    RenderOptions options;
    options.width = 320;
    options.height = 240;
    render_to_png(model_, options, file("a.png"));
    render_to_png(model_, options, file("b.png"));
    QCOMPARE(QImage(path("a.png")), QImage(path("b.png")));
  }

  void before_and_after_side_by_side() {
    RenderOptions options;
    options.width = 800;
    options.height = 400;
    render_before_after(model_, model_, options, file("pair.png"));
    const QImage picture(path("pair.png"));
    QCOMPARE(picture.size(), QSize(800, 400));
    QVERIFY(count_colors(picture.copy(0, 0, 400, 400)) >= 64);
    QVERIFY(count_colors(picture.copy(400, 0, 400, 400)) >= 64);
  }

  void wrong_sizes_are_refused() {
    RenderOptions options;
    options.width = 10;
    QVERIFY_EXCEPTION_THROWN(render_to_png(model_, options, file("x.png")), InvalidArgument);
    QVERIFY(!QFile::exists(path("x.png")));
  }

  void unwritable_path_is_refused() {
    RenderOptions options;
    options.width = options.height = 64;
    QVERIFY_EXCEPTION_THROWN(render_to_png(model_, options, "/nonexistent-folder/x.png"), WriteError);
  }

 private:
  QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }
  std::filesystem::path file(const char* name) const { return path(name).toStdString(); }

  QTemporaryDir folder_;
  SurfaceModel model_;
};

QTEST_GUILESS_MAIN(RenderTest)
#include "render_test.moc"
