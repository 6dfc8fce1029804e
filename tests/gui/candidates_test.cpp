// SPDX-License-Identifier: GPL-3.0-or-later
// Other patches for a hole: what they are, how they are looked at, taken and taken back.
#include "driver.h"
#include "test_main.h"

#include "document/command_line.h"
#include "io/write_mesh.h"
#include "panels/candidate_card.h"
#include "panels/candidates_panel.h"
#include "samples/analytic_surfaces.h"
#include "support/mirror_models.h"
#include "support/sharp_surfaces.h"

#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QProcess>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <set>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

/// Where LOOPMEND_SHOTS names a folder: the window as it is, for people to judge.
void shoot(MainWindow& window, const char* name) {
  const QString folder = qEnvironmentVariable("LOOPMEND_SHOTS");
  if (folder.isEmpty()) return;
  linger(400);
  window.screen()
      ->grabWindow(0, window.x(), window.y(), window.width(), window.height())
      .save(folder + QLatin1Char('/') + QLatin1String(name) + QStringLiteral(".png"));
}

bool is_of_one_colour(const QImage& picture) {
  const QImage small = picture.convertToFormat(QImage::Format_RGB32);
  std::set<QRgb> colours;
  for (int y = 0; y < small.height(); y += 3)
    for (int x = 0; x < small.width(); x += 3) colours.insert(small.pixel(x, y));
  return colours.size() < 20;
}

bool fill_hole(MainWindow& window, int hole) {
  window.selection().select({hole});
  press(window, "fillAndSmooth");
  return wait_idle(window, 240) && window.document().patch_of(hole);
}

bool compute(MainWindow& window) {
  press(window, "otherPatches");
  return wait_until([&] { return !window.candidates().busy(); }, 240) && settle();
}

/// From near.
bool show_candidates(MainWindow& window, int hole) {
  return fill_hole(window, hole) && fly(window, hole) && compute(window);
}

int index_of(MainWindow& window, CandidateKind kind) {
  const auto& all = window.candidates().candidates();
  for (std::size_t k = 0; k < all.size(); ++k)
    if (all[k].kind == kind) return static_cast<int>(k);
  return -1;
}

QByteArray bytes_of(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Runs the command that the window copies, with another output. @returns the bytes that it wrote.
QByteArray written_by(const QString& command, const QString& output) {
  QStringList words = QProcess::splitCommand(command);
  if (words.size() < 5) return {};
  words[words.indexOf(QStringLiteral("-o")) + 1] = output;
  QProcess program;
  program.start(QStringLiteral(LOOPMEND_PROGRAM), words.mid(1));
  return program.waitForFinished(240000) ? bytes_of(output) : QByteArray();
}

}  // namespace

class CandidatesTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void cards_show_pictures_and_the_view_shows_the_one_under_the_mouse();
  void pictures_turn_with_the_view();
  void one_is_taken_and_one_step_of_undo_takes_it_back();
  void cards_of_another_hole_cannot_be_taken();
  void cancelled_at_once_and_nothing_changes();
  void the_view_keeps_its_room();
  void what_is_taken_has_the_bits_of_the_command_that_is_copied_data();
  void what_is_taken_has_the_bits_of_the_command_that_is_copied();
  void a_mirror_image_that_does_not_fit_says_why();

 private:
  QTemporaryDir folder_;
};

void CandidatesTest::cards_show_pictures_and_the_view_shows_the_one_under_the_mouse() {
  Shown window({sample_file(folder_)});
  QVERIFY(show_candidates(window, first_hole(window.document())));
  shoot(window, "candidates");
  const auto& all = window.candidates().candidates();
  QVERIFY2(all.size() >= 3, qPrintable(QString::number(all.size())));
  QCOMPARE(all[window.candidates().in_place()].kind, CandidateKind::automatic);
  auto* panel = part<CandidatesPanel>(window, "candidatesPanel");
  for (const Candidate& candidate : all) {
    const QImage& picture = panel->card(candidate.kind)->picture();
    QCOMPARE(picture.size(), panel->card(candidate.kind)->picture_size());
    QVERIFY(!is_of_one_colour(picture));
    // The verdict and the figures, as the table has them: a flat patch has an edge at the seam on purpose.
    const QString words = panel->card(candidate.kind)->accessibleName();
    const auto& crease = candidate.patches.front().state->verdicts.front().crease_deg;
    const QString figure =
        crease ? QStringLiteral("crease %1\u00b0").arg(std::lround(*crease)) : QStringLiteral("an edge at the seam");
    QVERIFY2(words.contains(figure), qPrintable(words));
    QCOMPARE(crease.has_value(), candidate.kind != CandidateKind::flat);
  }
  QVERIFY(share_changed(panel->card(CandidateKind::automatic)->picture(), panel->card(CandidateKind::flat)->picture()) >
          0.02);
  QVERIFY(settle());
  const QImage before = window.view().picture();
  CandidateCard* flat = panel->card(CandidateKind::flat);
  reveal(flat);
  QVERIFY(settle());
  QTest::mouseMove(flat, flat->rect().center());
  QVERIFY(picture_changes(window, before, 0.005));
  shoot(window, "candidates_hover");
  QCOMPARE(index_of(window, CandidateKind::automatic), window.candidates().in_place());  // only looked at
  QTest::mouseMove(window.view().canvas(), QPoint(5, 5));
  QVERIFY(picture_returns(window, before));
}

void CandidatesTest::pictures_turn_with_the_view() {
  Shown window({sample_file(folder_)});
  QVERIFY(show_candidates(window, first_hole(window.document())));
  auto* panel = part<CandidatesPanel>(window, "candidatesPanel");
  const QImage before = panel->card(CandidateKind::flat)->picture();
  trigger(window, "lookTop");
  QVERIFY(wait_until([&] { return share_changed(before, panel->card(CandidateKind::flat)->picture()) > 0.1; }));
  const QImage turned = panel->card(CandidateKind::flat)->picture();
  trigger(window, "plain");
  QVERIFY(wait_until([&] { return share_changed(turned, panel->card(CandidateKind::flat)->picture()) > 0.1; }));
}

void CandidatesTest::one_is_taken_and_one_step_of_undo_takes_it_back() {
  Shown window({sample_file(folder_)});
  const Document& document = window.document();
  const int hole = first_hole(document);
  QVERIFY(fill_hole(window, hole));
  const PatchStatePtr before = document.patch_of(hole)->state;
  QVERIFY(compute(window));
  auto* panel = part<CandidatesPanel>(window, "candidatesPanel");
  CandidateCard* tangent = panel->card(CandidateKind::tangent);
  reveal(tangent);
  QTest::mouseClick(tangent, Qt::LeftButton);
  const PatchStatePtr after = document.patch_of(hole)->state;
  QVERIFY(after != before);
  QCOMPARE(after->method, Method::linear_fairing);
  QCOMPARE(window.candidates().in_place(), index_of(window, CandidateKind::tangent));
  QVERIFY(document.patch_of(hole)->timeline->size() >= 2);  // back to the initial patch
  const std::size_t offered = window.candidates().candidates().size();
  key(window, Qt::Key_Z, Qt::ControlModifier);
  QCOMPARE(document.patch_of(hole)->state, before);
  QCOMPARE(window.candidates().in_place(), index_of(window, CandidateKind::automatic));
  QCOMPARE(window.candidates().candidates().size(), offered);  // they are still there
  key(window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  QCOMPARE(document.patch_of(hole)->state, after);
  // What leads away from all of them drops them.
  window.controller().reject({document.patch_of(hole)->id});
  QVERIFY(window.candidates().candidates().empty());
}

void CandidatesTest::cards_of_another_hole_cannot_be_taken() {
  Shown window({sample_file(folder_)});
  const Document& document = window.document();
  const int hole = first_hole(document);
  int other = hole + 1;
  while (!document.fillable(other)) ++other;
  QVERIFY(fill_hole(window, other) && fill_hole(window, hole));
  QVERIFY(compute(window));
  const PatchStatePtr before = document.patch_of(hole)->state, before_other = document.patch_of(other)->state;
  CandidateCard* flat = part<CandidatesPanel>(window, "candidatesPanel")->card(CandidateKind::flat);
  reveal(flat);
  const auto note = [&] { return part<QLabel>(window, "candidatesNote")->text(); };
  for (const std::set<int>& selected : {std::set<int>{other}, std::set<int>{}, std::set<int>{hole, other}}) {
    window.selection().select(selected);
    QVERIFY(settle());
    shoot(window, "candidates_of_another");
    const QImage picture = window.view().picture();
    QTest::mouseMove(flat, flat->rect().center());
    QTest::mouseClick(flat, Qt::LeftButton);
    QVERIFY(!flat->isEnabled());
    QCOMPARE(document.patch_of(hole)->state, before);
    QCOMPARE(document.patch_of(other)->state, before_other);
    QCOMPARE(part<CandidatesPanel>(window, "candidatesPanel")->looked_at(), -1);
    QVERIFY(picture_returns(window, picture));
    QVERIFY2(note().startsWith(selected.size() == 1 ? QStringLiteral("Press Compute for hole ")
                                                    : QStringLiteral("Select one hole that is filled")),
             qPrintable(note()));
    QTest::mouseMove(window.view().canvas(), QPoint(5, 5));
  }
  window.selection().select({hole});
  QVERIFY(flat->isEnabled());
  QTest::mouseClick(flat, Qt::LeftButton);
  QVERIFY(document.patch_of(hole)->state != before);
  QCOMPARE(document.patch_of(other)->state, before_other);
  QVERIFY(flat->isEnabled());  // the hole is still the one that is selected
}

void CandidatesTest::cancelled_at_once_and_nothing_changes() {
  Shown window({sample_file(folder_)});
  const Document& document = window.document();
  const int hole = first_hole(document);
  QVERIFY(fill_hole(window, hole));
  const PatchStatePtr before = document.patch_of(hole)->state;
  press(window, "otherPatches");
  QVERIFY(window.candidates().busy());
  QCOMPARE(part<QPushButton>(window, "candidatesCompute")->text(), QStringLiteral("Cancel"));
  key(window, Qt::Key_Escape);
  QVERIFY(!window.candidates().busy());
  QCOMPARE(document.patch_of(hole)->state, before);
  const std::size_t ready = window.candidates().candidates().size();
  linger(300);
  QCOMPARE(window.candidates().candidates().size(), ready);  // what was given up is not heard
  QVERIFY(window.selection().selected().contains(hole));
  press(window, "candidatesCompute");
  QVERIFY(window.candidates().busy());
  press(window, "candidatesCompute");
  QVERIFY(!window.candidates().busy());
}

void CandidatesTest::the_view_keeps_its_room() {
  Shown window({sample_file(folder_)});
  window.resize(1400, 900);
  QVERIFY(fill_hole(window, first_hole(window.document())));
  QVERIFY(compute(window));
  QVERIFY(settle());
  const QSize view = window.view().size();
  const double share =
      static_cast<double>(view.width()) * view.height() / (static_cast<double>(window.width()) * window.height());
  QVERIFY2(share >= 0.6, qPrintable(QString::number(share)));
  const QSize before = view;
  part<QDockWidget>(window, "candidatesDock")->close();
  QVERIFY(settle());
  QCOMPARE(window.view().size(), before);
}

void CandidatesTest::what_is_taken_has_the_bits_of_the_command_that_is_copied_data() {
  QTest::addColumn<QString>("scan");
  QTest::addColumn<int>("kind");
  QTest::addColumn<QString>("option");
  const auto row = [](const char* name, const QString& scan, CandidateKind kind, const char* option) {
    QTest::newRow(name) << scan << static_cast<int>(kind) << QString::fromLatin1(option);
  };
  const QString sample = sample_file(folder_);
  row("tangent", sample, CandidateKind::tangent, "--loops 2:tangent");
  row("flat", sample, CandidateKind::flat, "--loops 2:flat");
  row("robust", sample, CandidateKind::robust, "--boundary robust");
  row("exact", sample, CandidateKind::exact, "--boundary exact");
  const QString edge = folder_.filePath(QStringLiteral("edge.ply"));
  write_mesh(edge.toStdString(),
             cut(test::make_cube(16), [](const Vec3& p) { return (p - Vec3(1, 1, 0.5)).norm() < 0.2; }));
  row("edges rounded", edge, CandidateKind::rounded, "--edges round");
  const QString bumps = folder_.filePath(QStringLiteral("bumps.ply"));
  write_mesh(bumps.toStdString(), test::BumpyEllipsoid().open_mesh(4));
  row("mirror image", bumps, CandidateKind::mirror, "--mirror");
}

void CandidatesTest::what_is_taken_has_the_bits_of_the_command_that_is_copied() {
  QFETCH(QString, scan);
  QFETCH(int, kind);
  QFETCH(QString, option);
  Shown window({scan});
  const Document& document = window.document();
  // The sample's third loop has a neighborhood with noise: there exact is another patch than the automatic one.
  const int hole = first_hole(document);
  QVERIFY(fill_hole(window, hole));
  QVERIFY(compute(window));
  if (kind == static_cast<int>(CandidateKind::rounded)) shoot(window, "candidates_edges");
  if (kind == static_cast<int>(CandidateKind::mirror)) shoot(window, "candidates_mirror");
  const int index = index_of(window, static_cast<CandidateKind>(kind));
  QVERIFY(index >= 0);
  window.candidates().take(index);
  const CommandLine command = command_line(document, {document.patch_of(hole)->id});
  QVERIFY2(command.text.contains(option), qPrintable(command.text));
  QVERIFY2(command.remarks.isEmpty(), qPrintable(command.remarks.join(QLatin1Char(' '))));
  const QString by_hand = folder_.filePath(QStringLiteral("window.ply"));
  window.controller().export_to(by_hand);
  QVERIFY(wait_idle(window));
  const QByteArray ours = bytes_of(by_hand);
  QVERIFY(ours.size() > 1000);
  QVERIFY2(ours == written_by(command.text, folder_.filePath(QStringLiteral("command.ply"))), qPrintable(command.text));
}

void CandidatesTest::a_mirror_image_that_does_not_fit_says_why() {
  Shown window({sample_file(folder_)});
  QVERIFY(fill_hole(window, first_hole(window.document())));
  QVERIFY(compute(window));
  QCOMPARE(index_of(window, CandidateKind::mirror), -1);
  const QString words = part<QLabel>(window, "candidatesRefused")->text();
  QVERIFY2(words.startsWith(QStringLiteral("Mirror image: not copied")), qPrintable(words));
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<CandidatesTest>(); }

#include "candidates_test.moc"
