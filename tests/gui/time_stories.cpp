// SPDX-License-Identifier: GPL-3.0-or-later
// Four stories of a person who repairs scans, by mouse and keyboard alone, timed, with a picture after each step for people to
// judge: time_stories FOLDER_OF_SCANS FOLDER_FOR_PICTURES [sample|dragon|bunny|doll]...
#include "driver.h"

#include "dialogs/repair_dialog.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFile>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScreen>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>

#include <cstdio>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

constexpr double patience = 90;  // s

class Story {
 public:
  Story(const char* name, const QDir& pictures) : name_(name), pictures_(pictures) { clock_.start(); }
  MainWindow& window() { return shown_; }

  /// What has been done, when, and how it looks.
  void tell(const char* what) {
    const qint64 begun = clock_.elapsed(), taken = begun - paused_;
    linger(500);
    std::printf("%-7s %6.1f s  %-28s %s | %s\n", name_, static_cast<double>(taken) / 1000, what,
                qPrintable(part<QLabel>(window(), "statusWatertight")->text()),
                qPrintable(part<QLabel>(window(), "seamSentence")->text()));
    std::fflush(stdout);
    MainWindow& w = window();
    w.screen()
        ->grabWindow(0, w.x(), w.y(), w.width(), w.height())
        .save(pictures_.filePath(QStringLiteral("%1_%2.png").arg(QLatin1String(name_)).arg(++count_)));
    paused_ += clock_.elapsed() - begun;
  }
  void click(const char* button) { QTest::mouseClick(part<QPushButton>(window(), button), Qt::LeftButton); }
  bool idle() { return wait_idle(window(), patience); }
  bool verdict() {
    return wait_until([this] { return window().print_check().result().has_value(); }, patience);
  }
  /// Types into the file dialog that the keys open.
  void type_file(Qt::Key letter, const QString& path) {
    QTimer waiting;
    QObject::connect(&waiting, &QTimer::timeout, [&] {
      for (QWidget* widget : QApplication::topLevelWidgets())
        if (auto* dialog = qobject_cast<QFileDialog*>(widget); dialog && dialog->isVisible()) {
          waiting.stop();
          auto* line = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
          line->setText(path);
          QTest::keyClick(line, Qt::Key_Return);
          if (dialog->isVisible()) dialog->reject();  // it is modal: the program would hang
        }
    });
    waiting.start(50);
    key(window(), letter, Qt::ControlModifier);
    wait_until([&] { return !waiting.isActive(); }, 20);
    linger(100);
  }
  void open(const QString& path) {
    type_file(Qt::Key_O, path);
    idle();
  }
  void click_row(int number) {
    auto* table = part<QTableView>(window(), "holesTable");
    for (int row = 0; row < table->model()->rowCount(); ++row)
      if (table->model()->index(row, 0).data().toInt() == number) {
        table->scrollTo(table->model()->index(row, 0));
        QTest::mouseClick(table->viewport(), Qt::LeftButton, {},
                          table->visualRect(table->model()->index(row, 0)).center());
      }
    linger(100);
  }
  /// Right click on the row that is selected, then on the menu's entry.
  void choose(const char* action) {
    auto* table = part<QTableView>(window(), "holesTable");
    const QModelIndexList rows = table->selectionModel()->selectedRows(1);
    if (rows.isEmpty()) return;
    table->scrollTo(rows.first());
    QMetaObject::invokeMethod(table, "customContextMenuRequested",
                              Q_ARG(QPoint, table->visualRect(rows.first()).center()));
    QMenu* menu = nullptr;
    wait_until(
        [&] {
          for (QMenu* found : window().findChildren<QMenu*>(QStringLiteral("holeMenu")))
            if (found->isVisible()) menu = found;
          return menu != nullptr;
        },
        5);
    if (!menu) return;
    auto* entry = window().findChild<QAction*>(QLatin1String(action), Qt::FindDirectChildrenOnly);
    QTest::mouseClick(menu, Qt::LeftButton, {}, menu->actionGeometry(entry).center());
    linger(50);
    idle();
  }

 private:
  const char* name_;
  QDir pictures_;
  QElapsedTimer clock_;
  qint64 paused_ = 0;
  int count_ = 0;
  Shown shown_;
};

void sample(const QDir&, const QDir& pictures, const QString& out) {
  Story story("sample", pictures);
  story.tell("the window is there");
  story.click("welcomeSample");
  story.idle();
  story.tell("sample open");
  story.click("fillAndSmooth");
  story.idle();
  story.tell("filled");
  story.type_file(Qt::Key_E, out + QStringLiteral("/sample.ply"));
  wait_until([&] { return QFile::exists(out + QStringLiteral("/sample.ply")); }, patience);
  story.idle();
  story.tell("exported");
}

void dragon(const QDir& scans, const QDir& pictures, const QString&) {
  Story story("dragon", pictures);
  story.open(scans.filePath(QStringLiteral("dragon.ply")));
  story.tell("open");
  story.click("stitch");
  story.idle();
  story.click("proposalApply");
  story.idle();
  story.tell("stitched");
  story.verdict();
  story.tell("checked");
}

void bunny(const QDir& scans, const QDir& pictures, const QString&) {
  for (int hole : {3, 4}) {
    Story story("bunny", hole == 3 ? pictures : QDir(pictures.filePath(QStringLiteral("4"))));
    story.open(scans.filePath(QStringLiteral("bunny.ply")));
    story.tell("open");
    story.click_row(hole);
    for (int ring = 0; ring < 3; ++ring) story.choose("eraseRingAction");
    story.tell("three rings erased");
    story.click("fillAndSmooth");
    story.idle();
    story.tell("filled");
    for (const OpenPatch& patch : story.window().document().patches())
      for (const SeamReport& seam : patch.state->seams)
        std::printf("        hole %d: %.2f degrees rms, %.2f at most\n", hole, seam.g1_rms_deg, seam.g1_max_deg);
  }
}

void doll(const QDir& scans, const QDir& pictures, const QString&) {
  Story story("doll", pictures);
  story.open(scans.filePath(QStringLiteral("doll.obj")));
  story.tell("open");
  story.verdict();
  story.tell("checked");
  story.click("repair");
  auto* dialog = story.window().findChild<RepairDialog*>();
  wait_until([&] { return dialog->findChild<QPushButton*>(QStringLiteral("repairAll"))->isEnabled(); }, patience);
  story.tell("Repair is open");
  const WhenAsked asked([](QDialog& question) {  // where many holes would be made
    if (auto* apply = question.findChild<QPushButton*>(QStringLiteral("repairApply"))) apply->click();
  });
  QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("repairAll")), Qt::LeftButton);
  story.idle();
  story.tell("all fixed");
  dialog->close();
  story.click("fillAndSmooth");
  story.idle();
  story.verdict();
  story.tell("filled");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("Usage: time_stories FOLDER_OF_SCANS FOLDER_FOR_PICTURES [sample|dragon|bunny|doll]...\n", stderr);
    return 2;
  }
  const QTemporaryDir home, out;
  use_own_home(home.path());
  prepare_application();
  QApplication application(argc, argv);
  settle_application();
  QStringList wanted;
  for (int k = 3; k < argc; ++k) wanted << QString::fromLocal8Bit(argv[k]);
  const QDir scans(QString::fromLocal8Bit(argv[1])), pictures(QString::fromLocal8Bit(argv[2]));
  pictures.mkpath(QStringLiteral("4"));
  for (const auto& [name, story] :
       {std::pair{"sample", &sample}, {"dragon", &dragon}, {"bunny", &bunny}, {"doll", &doll}})
    if (wanted.isEmpty() || wanted.contains(QLatin1String(name))) story(scans, pictures, out.path());
  return 0;
}
