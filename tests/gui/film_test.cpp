// SPDX-License-Identifier: GPL-3.0-or-later
// Films of a flow: the file itself, the one that the window writes, the one that `loopmend render --film` writes.
// Qt's GIF reader reads them back. And the report of the holes.
#include "driver.h"
#include "test_main.h"

#include "dialogs/film_dialog.h"
#include "document/fill_report.h"
#include "document/labels.h"
#include "jobs/export_scene.h"
#include "scene/film.h"
#include "views/film_source.h"
#include "views/report_writer.h"

#include <QAbstractTextDocumentLayout>
#include <QAction>
#include <QDir>
#include <QElapsedTimer>
#include <QImageReader>
#include <QLabel>
#include <QPointer>
#include <QProcess>
#include <QProgressDialog>
#include <QPushButton>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QTextDocument>
#include <QTextTable>
#include <QToolButton>
#include <QUrl>

#include <algorithm>
#include <fstream>
#include <numeric>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

struct ReadFilm {
  explicit ReadFilm(const QString& path) {
    QImageReader reader(path);
    loops = reader.loopCount();
    while (reader.canRead()) {
      const QImage picture = reader.read();
      if (picture.isNull()) break;
      pictures << picture.convertToFormat(QImage::Format_RGB32);
      delays << reader.nextImageDelay();  // ms, of the picture just read
    }
  }
  QList<QImage> pictures;
  QList<int> delays;
  int loops = 0;
};

/// Mean over the channels of all pixels.
double mean_difference(const QImage& a, const QImage& b) {
  double sum = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < a.width(); ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      sum += std::abs(qRed(p) - qRed(q)) + std::abs(qGreen(p) - qGreen(q)) + std::abs(qBlue(p) - qBlue(q));
    }
  return sum / (3.0 * a.width() * a.height());
}

/// A ramp of two colors, `at` brighter.
RgbPicture ramp(int width, int height, int at) {
  RgbPicture picture{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) {
      picture.bytes.push_back(static_cast<unsigned char>(255 * x / width));
      picture.bytes.push_back(static_cast<unsigned char>(at));
      picture.bytes.push_back(static_cast<unsigned char>(255 * y / height));
    }
  return picture;
}

QImage image_of(const RgbPicture& picture) {
  return QImage(picture.bytes.data(), picture.width, picture.height, 3 * picture.width, QImage::Format_RGB888)
      .convertToFormat(QImage::Format_RGB32);
}

/// Fills the sample's first hole; its flow has several steps.
void run_a_flow(MainWindow& window) {
  window.selection().select({first_hole(window.document())});
  trigger(window, "fillAction");
  QVERIFY(wait_idle(window));
}

QPointer<FilmDialog> opened(MainWindow& window) {
  trigger(window, "film");
  QPointer<FilmDialog> dialog;
  wait_until([&] { return (dialog = window.findChild<FilmDialog*>()) && dialog->isVisible(); }, 20);
  return dialog;
}

}  // namespace

class FilmTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_gif_keeps_colors_and_times();
  void at_most_ten_pictures_a_second();
  void a_film_lasts_as_long_as_is_asked();
  void a_caption_names_a_flow_only_where_one_ran();
  void the_window_writes_the_flow();
  void a_film_given_up_leaves_no_file();
  void a_film_that_cannot_be_written_says_so();
  void the_command_line_writes_the_flow();
  void a_report_shows_each_patch();
  void a_picture_of_the_report_has_the_outline_of_its_hole();
  void a_page_of_the_report_ends_between_two_holes();
  void a_report_given_up_leaves_no_file();

 private:
  QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }
  QTemporaryDir folder_;
};

void FilmTest::a_caption_names_a_flow_only_where_one_ran() {
  PatchState state;
  state.flow = FlowKind::mmcvf;
  state.steps = 4;
  state.method = Method::split_flow;
  QCOMPARE(film_caption(state, 7, Shading::curvature), QStringLiteral("MMCVF, step 4 of 7: mean curvature"));
  state.method = Method::linear_fairing;
  QCOMPARE(film_caption(state, 7, Shading::curvature), QStringLiteral("Step 4 of 7: mean curvature"));
}

void FilmTest::a_gif_keeps_colors_and_times() {
  const std::vector<RgbPicture> pictures{ramp(160, 120, 40), ramp(160, 120, 120), ramp(160, 120, 120)};
  const std::vector<GifColor> palette = film_palette(pictures);
  QVERIFY(palette.size() > 100 && palette.size() <= most_gif_colors);
  std::ofstream out(path("ramp.gif").toStdString(), std::ios::binary);
  std::size_t k = 0;
  const int times[] = {30, 10, 250};
  const int count = write_film(out, 160, 120, palette, [&]() -> std::optional<FilmPicture> {
    if (k == pictures.size()) return std::nullopt;
    ++k;
    return FilmPicture{pictures[k - 1], times[k - 1]};
  });
  out.close();
  QCOMPARE(count, 3);
  const ReadFilm film(path("ramp.gif"));
  QCOMPARE(film.pictures.size(), 3);
  QCOMPARE(film.loops, -1);  // for ever
  for (int p = 0; p < 3; ++p) {
    QCOMPARE(film.delays[p], 10 * times[p]);
    // Dithering scatters single pixels; means of squares are the colors that the eye sees.
    const QImage seen = film.pictures[p].scaled(20, 15, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    const QImage wanted = image_of(pictures[p]).scaled(20, 15, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    QVERIFY2(mean_difference(seen, wanted) < 3, qPrintable(QString::number(mean_difference(seen, wanted))));
  }
  QCOMPARE(film.pictures[1], film.pictures[2]);  // what stands still does not flicker
}

void FilmTest::at_most_ten_pictures_a_second() {
  for (std::size_t count : {1, 2, 7, 60, 120, 1000}) {
    const std::vector<std::size_t> shown = states_of_film(count);
    QCOMPARE(shown.size(), std::min(count, most_film_states));
    QCOMPARE(shown.front(), std::size_t{0});
    QCOMPARE(shown.back(), count - 1);
    QVERIFY(std::adjacent_find(shown.begin(), shown.end(), std::greater_equal<>()) == shown.end());
    const std::vector<int> durations = film_durations(shown.size());
    QCOMPARE(durations.size(), shown.size());
    for (int hundredths : durations) QVERIFY(hundredths >= 10);
    QCOMPARE(*std::max_element(durations.begin(), durations.end()), durations.back());
  }
}

void FilmTest::a_film_lasts_as_long_as_is_asked() {
  const auto sum = [](const std::vector<int>& durations) {
    return std::accumulate(durations.begin(), durations.end(), 0);
  };
  for (std::size_t count : {1, 2, 7, 60, 120}) {
    const std::vector<int> fast = film_durations(count, {25, 0});
    for (std::size_t k = 1; k + 1 < count; ++k) QCOMPARE(fast[k], 4);
    for (const FilmPace& pace : {FilmPace{0, 10}, FilmPace{25, 10}, FilmPace{1, 10}}) {
      const std::vector<int> durations = film_durations(count, pace);
      QVERIFY(sum(durations) >= 1000);
      const std::vector<int> free = film_durations(count, {pace.rate, 0});
      if (sum(free) >= 1000)
        QVERIFY(durations == free);
      else
        QVERIFY(sum(durations) < 1000 + static_cast<int>(count));
    }
  }
}

void FilmTest::the_window_writes_the_flow() {
  Shown window({sample_file(folder_)});
  QVERIFY(!window.findChild<QAction*>(QStringLiteral("film"))->isEnabled());  // there is no flow yet
  run_a_flow(window);
  const QPointer<FilmDialog> dialog = opened(window);
  QVERIFY(dialog);
  QVERIFY(settle());
  const QImage before = window.view().picture();
  QSignalSpy saved(dialog, &FilmDialog::saved);
  const auto choose = [&](const char* box, double value) {
    auto* choices = dialog->findChild<QComboBox*>(QLatin1String(box));
    choices->setCurrentIndex(choices->findData(value));
    QCOMPARE(choices->currentData().toDouble(), value);
  };
  choose("filmRate", 25);
  choose("filmLength", 20);
  GapMeter gaps;
  dialog->save(path("flow.gif"));
  QVERIFY(wait_until([&] { return saved.count() == 1; }));
  gaps.report("film");
  const OpenPatch& patch = *window.document().patch_of(first_hole(window.document()));
  const ReadFilm film(path("flow.gif"));
  QCOMPARE(static_cast<std::size_t>(film.pictures.size()), patch.timeline->size());
  QVERIFY(film.pictures.size() > 1);
  QCOMPARE(film.pictures.front().height(), 480);
  QVERIFY(share_changed(film.pictures.front(), film.pictures.back()) > 0.002);  // the patch moved
  QVERIFY(count_colors(film.pictures.back()) >= 64);
  QVERIFY(film.delays.back() >= 2000);
  QVERIFY(std::accumulate(film.delays.begin(), film.delays.end(), 0) >= 20'000);
  QTest::mouseClick(part<QToolButton>(window, "bannerClose"), Qt::LeftButton);  // the legend makes room for it
  QVERIFY(settle());
  QVERIFY(share_changed(before, window.view().picture()) < 0.001);  // the view is what it was
}

void FilmTest::a_film_given_up_leaves_no_file() {
  Shown window({sample_file(folder_)});
  run_a_flow(window);
  const QPointer<FilmDialog> dialog = opened(window);
  QVERIFY(dialog);
  const QStringList files = QDir(folder_.path()).entryList(QDir::Files | QDir::Hidden);
  QSignalSpy saved(dialog, &FilmDialog::saved);
  dialog->save(path("given_up.gif"));
  QVERIFY(wait_until(
      [&] { return QDir(folder_.path()).entryList(QDir::Files | QDir::Hidden) != files; }));  // it is being written
  QElapsedTimer clock;
  clock.start();
  dialog->findChild<QPushButton*>(QStringLiteral("filmCancel"))->click();
  QVERIFY(!dialog->busy());
  QVERIFY2(clock.elapsed() < 100, qPrintable(QString::number(clock.elapsed())));
  QVERIFY(wait_until([&] { return QDir(folder_.path()).entryList(QDir::Files | QDir::Hidden) == files; }));
  QCOMPARE(saved.count(), 0);
  QVERIFY(dialog->isVisible());  // another size may be tried
  dialog->close();
}

void FilmTest::a_film_that_cannot_be_written_says_so() {
  Shown window({sample_file(folder_)});
  run_a_flow(window);
  const QPointer<FilmDialog> dialog = opened(window);
  QVERIFY(dialog);
  dialog->save(path("no_such_folder/flow.gif"));
  auto* fault = dialog->findChild<QLabel*>(QStringLiteral("filmTrouble"));
  QVERIFY(wait_until([&] { return !dialog->busy(); }));
  QVERIFY(fault->isVisible());
  QVERIFY2(fault->text().contains(QLatin1String("no_such_folder")), qPrintable(fault->text()));
  dialog->close();
}

void FilmTest::the_command_line_writes_the_flow() {
  const QString scan = sample_file(folder_);
  const auto film = [&](const QStringList& options) {
    QProcess program;
    program.start(
        QStringLiteral(LOOPMEND_PROGRAM),
        QStringList{QStringLiteral("render"), scan, QStringLiteral("--size"), QStringLiteral("320x240")} + options);
    program.waitForFinished(240000);
    return program.exitCode();
  };
  const auto words = [](const char* text) { return QString::fromLatin1(text).split(QLatin1Char(' ')); };
  QCOMPARE(film(words("--film") << path("steps.gif") << words("--loop 2 --mode steps --flow wf")), 0);
  const ReadFilm steps(path("steps.gif"));
  QVERIFY(steps.pictures.size() > 3);
  QCOMPARE(steps.pictures.front().size(), QSize(320, 240));
  QVERIFY(share_changed(steps.pictures.front(), steps.pictures.back()) > 0.02);
  for (int delay : steps.delays) QVERIFY(delay >= 100);
  QVERIFY(steps.delays.back() >= 2000);
  QCOMPARE(film(words("--film") << path("long.gif") << words("--loop 2 --film-rate 25 --film-length 10")), 0);
  const ReadFilm at_length(path("long.gif"));
  const int all = std::accumulate(at_length.delays.begin(), at_length.delays.end(), 0);  // ms
  QVERIFY2(all >= 10000 && all < 10010 + 10 * at_length.delays.size(), qPrintable(QString::number(all)));
  QCOMPARE(film(words("--film") << path("a.gif") << words("--film-rate 0")), 2);
  QCOMPARE(film(words("--film-length 10 -o") << path("a.png")), 2);
  QCOMPARE(film(words("--film") << path("a.gif") << words("--loop 99")), 2);
  QCOMPARE(film(words("--film") << path("a.gif") << words("-o") << path("a.png")), 2);
  QCOMPARE(film(words("--flow wf -o") << path("a.png")), 2);
  QCOMPARE(film({}), 2);
  QCOMPARE(film(words("--film") << path("a.png")), 4);
  for (const char* name : {"a.gif", "a.png"}) QVERIFY(!QFile::exists(path(name)));
}

void FilmTest::a_report_shows_each_patch() {
  Shown window({sample_file(folder_)});
  QVERIFY(!window.findChild<QAction*>(QStringLiteral("report"))->isEnabled());  // there is no patch yet
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  const Document& document = window.document();
  const Viewpoint before = window.view().viewpoint();
  QSignalSpy written(&window.report(), &ReportWriter::written);
  GapMeter gaps;
  window.report().write(path("holes.html"));
  QVERIFY(wait_until([&] { return written.count() == 1; }));
  gaps.report("report");
  QVERIFY((window.view().viewpoint().eye - before.eye).norm() < 1e-9);
  QFile file(path("holes.html"));
  QVERIFY(file.open(QIODevice::ReadOnly));
  const QString page = QString::fromUtf8(file.readAll());
  const auto patched = std::count_if(document.loops().begin(), document.loops().end(), [&](const BoundaryLoop& loop) {
    return document.patch_of(static_cast<int>(&loop - document.loops().data())) != nullptr;
  });
  QVERIFY(patched > 1);
  QCOMPARE(page.count(QStringLiteral("<img src=\"data:image/png;base64,")), static_cast<int>(patched));
  QCOMPARE(page.count(QStringLiteral("<h3>Hole ")), static_cast<int>(patched));
  QVERIFY(page.contains(QStringLiteral("loopmend fill ")));
  // Of the triangles and the area of the scan with its patches.
  const TriangleSoup all = plain_surface(export_task(document, {}));
  const auto area_from = [&](std::size_t first) {
    double area = 0;
    for (std::size_t f = first; f < all.triangles.size(); ++f) {
      const auto [a, b, c] = all.triangles[f];
      area += (all.points[b] - all.points[a]).cross(all.points[c] - all.points[a]).norm() / 2;
    }
    return area;
  };
  const std::size_t given = document.first_scan().model->soup.triangles.size();
  QVERIFY(page.contains(
      QStringLiteral("The patches add %1 triangles; they are %2 % of the whole area.")
          .arg(labels::count(all.triangles.size() - given), labels::number(100 * area_from(given) / area_from(0)))));
  const FillReport report = fill_report(document);
  for (const FillReport::Hole& hole : report.holes)
    for (const QString& line : hole.lines) QVERIFY2(page.contains(line.toHtmlEscaped()), qPrintable(line));
  // Pictures of two holes are two pictures, with the colours of the view.
  const auto picture = [&](int k) {
    const QString data = page.section(QStringLiteral("base64,"), k + 1).section(QLatin1Char('"'), 0, 0);
    return QImage::fromData(QByteArray::fromBase64(data.toLatin1())).convertToFormat(QImage::Format_RGB32);
  };
  QCOMPARE(picture(0).size(), QSize(720, 480));
  QVERIFY(count_colors(picture(0)) >= 64);
  QVERIFY(share_changed(picture(0), picture(1)) > 0.1);

  window.report().write(path("holes.pdf"));
  QVERIFY(wait_until([&] { return written.count() == 2; }));
  QFile pdf(path("holes.pdf"));
  QVERIFY(pdf.open(QIODevice::ReadOnly));
  const QByteArray bytes = pdf.readAll();
  QVERIFY(bytes.startsWith("%PDF-"));
  QVERIFY(bytes.count("/Subtype /Image") >= patched);
}

/// Also of the selected hole, whose seam has no line in the view, and where the view has none at all.
void FilmTest::a_picture_of_the_report_has_the_outline_of_its_hole() {
  Shown window({sample_file(folder_)});
  const int loop = first_hole(window.document());
  window.selection().select({loop});
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  trigger(window, "seams");
  QVERIFY(fly(window, loop));
  settle();
  const QImage before = window.view().picture();
  PictureOptions options{QSize(720, 480), PictureOptions::Ground::as_seen, PictureOptions::Extras::none};
  const QImage bare = window.view().picture(options);
  options.outlined = loop;
  const QImage outlined = window.view().picture(options);
  const double share = share_changed(bare, outlined);
  QVERIFY2(share > 0.005 && share < 0.1, qPrintable(QString::number(share)));
  QVERIFY(picture_returns(window, before));
  QSignalSpy written(&window.report(), &ReportWriter::written);
  window.report().write(path("outlined.html"));
  QVERIFY(wait_until([&] { return written.count() == 1; }));
  QFile file(path("outlined.html"));
  QVERIFY(file.open(QIODevice::ReadOnly));
  const QString data =
      QString::fromUtf8(file.readAll()).section(QStringLiteral("base64,"), 1).section(QLatin1Char('"'), 0, 0);
  const QImage shown = QImage::fromData(QByteArray::fromBase64(data.toLatin1())).convertToFormat(QImage::Format_RGB32);
  const auto white = [](const QImage& image) {  // of the line's casing
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) count += image.pixelColor(x, y) == QColor(Qt::white);
    return count;
  };
  QVERIFY2(white(shown) > white(bare) + 100, qPrintable(QString::number(white(shown))));
}

/// As QTextDocument prints on A4: margins of 2 cm at 96 dots per inch.
void FilmTest::a_page_of_the_report_ends_between_two_holes() {
  FillReport report;
  report.title = QStringLiteral("Holes of a scan");
  for (int k = 0; k < 6; ++k) report.facts << QStringLiteral("A fact of the scan.");
  QImage picture(720, 480, QImage::Format_RGB32);
  picture.fill(Qt::gray);
  constexpr int holes = 12, lines = 6;
  for (int k = 0; k < holes; ++k) {
    FillReport::Hole hole;
    hole.name = QStringLiteral("Hole %1").arg(k + 1);
    hole.verdict = QStringLiteral("look");
    for (int line = 0; line < lines; ++line) hole.lines << QStringLiteral("Likely within 0.019 of what was there.");
    hole.picture = picture;
    report.holes.push_back(hole);
  }
  QTextDocument document;
  for (int k = 0; k < holes; ++k)
    document.addResource(QTextDocument::ImageResource, QUrl(QStringLiteral("picture:%1").arg(k)), picture);
  document.setHtml(html_of(report, PictureLinks::named));
  QTextFrameFormat format = document.rootFrame()->frameFormat();
  format.setMargin(76);
  document.rootFrame()->setFrameFormat(format);
  document.setPageSize(QSizeF(794, 1123));
  QCOMPARE(document.pageCount(), 4);
  const auto page_of = [&](double y) { return static_cast<int>(y / document.pageSize().height()); };
  int rows = 0;
  for (const QTextFrame* frame : document.rootFrame()->childFrames()) {
    const auto* table = qobject_cast<const QTextTable*>(frame);
    for (int row = 0; table && row < table->rows(); ++row, ++rows) {
      const QRectF text =
                       document.documentLayout()->blockBoundingRect(table->cellAt(row, 1).lastCursorPosition().block()),
                   head = document.documentLayout()->blockBoundingRect(
                       table->cellAt(row, 1).firstCursorPosition().block()),
                   image = document.documentLayout()->blockBoundingRect(
                       table->cellAt(row, 0).firstCursorPosition().block());
      QCOMPARE(page_of(image.bottom()), page_of(head.top()));
      QCOMPARE(page_of(text.bottom()), page_of(head.top()));
    }
  }
  QCOMPARE(rows, holes);
}

void FilmTest::a_report_given_up_leaves_no_file() {
  Shown window({sample_file(folder_)});
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  QSignalSpy failed(&window.report(), &ReportWriter::failed);
  window.report().write(path("none.html"));
  auto* progress = window.findChild<QProgressDialog*>(QStringLiteral("reportProgress"));
  QVERIFY(progress);
  Q_EMIT progress->canceled();
  QVERIFY(!window.report().busy());
  window.report().write(path("none.html"));
  trigger(window, "undo");  // the patches that it shows are gone
  QVERIFY(!window.report().busy());
  trigger(window, "redo");
  QVERIFY(wait_idle(window));
  window.report().write(QStringLiteral("/nonexistent-folder/none.html"));
  QVERIFY(wait_until([&] { return failed.count() == 1; }));
  QVERIFY(!window.report().busy());
  QVERIFY(!QFile::exists(path("none.html")));
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<FilmTest>(); }

#include "film_test.moc"
