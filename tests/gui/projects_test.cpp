// SPDX-License-Identifier: GPL-3.0-or-later
// Sessions that hold their scans, and the unit of lengths: chosen, shown, written, kept.
#include "driver.h"
#include "test_main.h"

#include "dialogs/session_dialog.h"
#include "io/read_mesh.h"
#include "mesh/scan_attributes.h"
#include "panels/banner.h"
#include "views/file_controller.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

QString header(MainWindow& window, int column) {
  return part<QTableView>(window, "holesTable")->model()->headerData(column, Qt::Horizontal).toString();
}

void choose_unit(MainWindow& window, const char* unit) {
  part<QDockWidget>(window, "sceneDock")->raise();
  auto* box = part<QComboBox>(window, "sceneUnit");
  box->setFocus();
  box->setCurrentIndex(box->findData(QLatin1String(unit)));
  Q_EMIT box->activated(box->currentIndex());
}

constexpr int diameter_column = 2;

}  // namespace

class ProjectsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void a_session_may_hold_its_scans();
  void damaged_sessions_with_scans_are_refused();
  void the_unit_is_chosen_shown_written_and_kept();

 private:
  QTemporaryDir folder_;
};

void ProjectsTest::a_session_may_hold_its_scans() {
  const QString scan = folder_.filePath(QStringLiteral("to-be-lost.ply"));
  const QString path = folder_.filePath(QStringLiteral("whole.loopmend"));
  QVERIFY(QFile::copy(sample_file(folder_), scan));
  PatchStatePtr patch;
  {
    Shown window({scan});
    window.selection().select({first_hole(window.document())});
    QVERIFY(press_and_wait(window, "fillAndSmooth"));
    patch = window.document().patches().front().state;
    const WhenAsked asked([&](QDialog& dialog) {
      dialog.findChild<QCheckBox*>(QStringLiteral("keepScans"))->click();
      auto* name = dialog.findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
      name->setText(path);
      QTest::keyClick(name, Qt::Key_Return);
    });
    window.findChild<FileController*>()->save_session();
    QVERIFY(wait_until([&] { return QFile::exists(path); }));
    QVERIFY(wait_idle(window));
    QVERIFY(!window.isWindowModified());
  }
  // Neither the scan nor its folder is needed.
  QVERIFY(QFile::remove(scan));
  const QString moved = folder_.filePath(QStringLiteral("elsewhere/whole.loopmend"));
  QVERIFY(QDir(folder_.path()).mkpath(QStringLiteral("elsewhere")) && QFile::rename(path, moved));
  const QString again = folder_.filePath(QStringLiteral("again.loopmend"));
  {
    Shown window({moved});
    QVERIFY(window.ready);
    QCOMPARE(window.document().first_scan().name, QStringLiteral("to-be-lost.ply"));
    QCOMPARE(window.document().patches().size(), std::size_t(1));
    QVERIFY(window.document().patches().front().state->patch.positions == patch->patch.positions);
    // Saved once more, even without the wish: the scan is nowhere else.
    window.controller().save_session(again, KeepScans::outside);
    QVERIFY(wait_idle(window));
  }
  Shown shown({again});
  QVERIFY(shown.ready);
  QCOMPARE(shown.document().patches().size(), std::size_t(1));
  // Where the scan has a file of its own, the session is small unless it is asked for.
  QVERIFY(QFile::copy(sample_file(folder_), scan));
  const QString small = folder_.filePath(QStringLiteral("small.loopmend"));
  shown.controller().save_session(small, KeepScans::outside);
  QVERIFY(wait_idle(shown));
  QVERIFY(QFile(small).size() + QFile(scan).size() / 10 < QFile(again).size());
}

void ProjectsTest::damaged_sessions_with_scans_are_refused() {
  const QString path = folder_.filePath(QStringLiteral("sound.loopmend"));
  Shown window({sample_file(folder_)});
  window.controller().save_session(path, KeepScans::inside);
  QVERIFY(wait_idle(window));
  QFile file(path);
  QVERIFY(file.open(QIODevice::ReadOnly));
  const QByteArray sound = file.readAll();
  QByteArray flipped = sound;
  flipped[60 + sound.size() / 4] = static_cast<char>(~flipped[60 + sound.size() / 4]);  // within the scan
  const QString damaged = folder_.filePath(QStringLiteral("damaged.loopmend"));
  for (const QByteArray& bytes : {sound.left(sound.size() / 2), sound.left(30), sound + '\0', flipped}) {
    QFile out(damaged);
    QVERIFY(out.open(QIODevice::WriteOnly));
    out.write(bytes);
    out.close();
    window.open(damaged);
    QVERIFY(wait_idle(window));
    QVERIFY(!part<QLabel>(window, "bannerText")->text().isEmpty());
    QVERIFY(window.document().has_scan());  // what was open stays
    QCOMPARE(window.document().first_scan().name, QStringLiteral("sample.ply"));
    QVERIFY(!window.document().first_scan().kept);
  }
}

void ProjectsTest::the_unit_is_chosen_shown_written_and_kept() {
  Shown window({sample_file(folder_)});
  QVERIFY(window.document().unit().empty());
  QCOMPARE(header(window, diameter_column), QStringLiteral("Diameter"));
  choose_unit(window, "inch");
  QCOMPARE(window.document().unit(), std::string("inch"));
  QCOMPARE(header(window, diameter_column), QStringLiteral("Diameter, in"));
  QVERIFY(window.undo().can_undo());
  QVERIFY(window.isWindowModified());
  QVERIFY2(!window.close(), "a chosen unit is work: it should ask");
  window.undo().undo();
  QVERIFY(!window.isWindowModified());
  QCOMPARE(header(window, diameter_column), QStringLiteral("Diameter"));
  window.undo().redo();
  // A scan in the place of this one keeps it.
  const std::vector<int>& vertices = window.document().loop(first_hole(window.document())).vertices;
  const std::vector<int>& soup = window.document().scan(0)->model->soup_vertex;
  window.controller().bridge(0, soup[vertices[0]], soup[vertices[vertices.size() / 2]]);
  QVERIFY(wait_idle(window));
  QVERIFY(window.document().scans().front() != 0);
  QCOMPARE(window.document().unit(), std::string("inch"));
  window.undo().undo();
  // It is in what is written, and not a coordinate is another.
  const QString path = folder_.filePath(QStringLiteral("inches.3mf"));
  window.controller().export_to(path);
  QVERIFY(wait_idle(window));
  const TriangleSoup written = read_mesh(path.toStdString()).soup;
  QVERIFY(written.attributes);
  QCOMPARE(written.attributes->unit, std::string("inch"));
  QCOMPARE(written.points.size(), window.document().scan(0)->model->soup.points.size());
  const QString session = folder_.filePath(QStringLiteral("inches.loopmend"));
  window.controller().save_session(session);
  QVERIFY(wait_idle(window));
  window.open(session);
  QVERIFY(wait_idle(window));
  QCOMPARE(window.document().unit(), std::string("inch"));
  // A file that says it is believed.
  window.open(path);
  QVERIFY(wait_idle(window));
  QCOMPARE(header(window, diameter_column), QStringLiteral("Diameter, in"));
  QVERIFY(window.document().chosen_units().empty());
  choose_unit(window, "millimeter");
  QCOMPARE(header(window, diameter_column), QStringLiteral("Diameter, mm"));
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<ProjectsTest>(); }

#include "projects_test.moc"
