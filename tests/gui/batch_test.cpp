// SPDX-License-Identifier: GPL-3.0-or-later
// Fill a folder: the window writes the bytes that `loopmend batch` writes, and its table agrees with the page.
#include "driver.h"
#include "test_main.h"

#include "dialogs/batch_dialog.h"
#include "document/language.h"
#include "io/write_mesh.h"
#include "panels/banner.h"
#include "samples/analytic_surfaces.h"
#include "support/english_words.h"

#include <QAction>
#include <QClipboard>
#include <QDir>
#include <QDirIterator>
#include <QElapsedTimer>
#include <QLabel>
#include <QLineEdit>
#include <QPointer>
#include <QProcess>
#include <QPushButton>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

TriangleSoup open_ball(int level, double above) {
  return cut(make_icosphere(level), [above](const Vec3& p) { return p.z() > above; });
}

QByteArray bytes_of(const QString& path) {
  QFile file(path);
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QStringList files_in(const QString& folder) {
  QStringList names;
  QDirIterator walk(folder, QDir::Files | QDir::Hidden, QDirIterator::Subdirectories);
  while (walk.hasNext()) names << QDir(folder).relativeFilePath(walk.next());
  names.sort();
  return names;
}

/// A report without what differs from run to run: times and memory.
QString lasting(const QString& path) {
  QString text = QString::fromUtf8(bytes_of(path));
  static const QRegularExpression numbers(QStringLiteral(
      "\"[a-z_]*(?:seconds|memory)[a-z_]*\": *(?:\\{[^}]*\\}|[0-9.e+-]+)|"
      "\"(?:initial_patch|survey|choice|assemble|solve|checks|rejected|expected_deviation|other|total)\": "
      "[0-9.e+-]+|--max-memory [0-9]+"));
  text.remove(numbers);
  return text;
}

}  // namespace

class BatchTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void init();
  void the_window_writes_what_the_command_writes();
  void stopping_takes_no_time_and_the_next_run_goes_on();
  void what_is_wrong_is_told_in_the_dialog();
  void closing_the_window_asks_while_a_folder_is_filled();
  void a_german_window_tells_it_in_german();

 private:
  QString path(const char* name) const { return folder_->filePath(QLatin1String(name)); }
  void write_scans(int level) const;
  QPointer<BatchDialog> opened(MainWindow& window) const;
  static void press(BatchDialog& dialog, const char* name) {
    QTest::mouseClick(dialog.findChild<QPushButton*>(QLatin1String(name)), Qt::LeftButton);
  }
  static QString summary(const BatchDialog& dialog) {
    return dialog.findChild<QLabel*>(QStringLiteral("batchSummary"))->text();
  }
  static QTreeWidget& table(const BatchDialog& dialog) {
    return *dialog.findChild<QTreeWidget*>(QStringLiteral("batchTable"));
  }
  std::unique_ptr<QTemporaryDir> folder_;
};

void BatchTest::init() { folder_ = std::make_unique<QTemporaryDir>(); }

void BatchTest::write_scans(int level) const {
  QDir(folder_->path()).mkpath(QStringLiteral("scans/inner"));
  scan_file(*folder_, QStringLiteral("scans/ball.ply"), open_ball(level, 0.9));
  scan_file(*folder_, QStringLiteral("scans/inner/ball.stl"), open_ball(level, 0.8));
  scan_file(*folder_, QStringLiteral("scans/whole.off"), make_icosphere(2));
}

QPointer<BatchDialog> BatchTest::opened(MainWindow& window) const {
  trigger(window, "batch");
  QPointer<BatchDialog> dialog;
  wait_until([&] { return (dialog = window.findChild<BatchDialog*>()) && dialog->isVisible(); }, 20);
  if (dialog) dialog->set_folders(path("scans"), path("results"));
  return dialog;
}

void BatchTest::the_window_writes_what_the_command_writes() {
  write_scans(3);
  QVERIFY(QFile::copy(sample_file(*folder_), path("scans/sample.ply")));
  QFile notes(path("scans/notes.ply"));
  QVERIFY(notes.open(QIODevice::WriteOnly));
  notes.write("This is not a mesh.\n");
  notes.close();
  Shown window;
  const QPointer<BatchDialog> dialog = opened(window);
  QVERIFY(dialog);
  QVERIFY(!dialog->findChild<QPushButton*>(QStringLiteral("batchReport"))->isEnabled());  // there is none yet
  GapMeter gaps;
  press(*dialog, "batchStart");
  QVERIFY(window.batch().busy());
  QVERIFY(wait_until([&] { return !window.batch().busy(); }));
  gaps.report("batch");
  QCOMPARE(summary(*dialog),
           QStringLiteral("5 scans: 3 filled, 1 with nothing to fill, 1 with an error. Patches: 7 good, 0 to "
                          "look at, 0 bad."));
  QVERIFY(dialog->findChild<QPushButton*>(QStringLiteral("batchReport"))->isEnabled());

  // The command that the dialog copies, run as it stands, into the same folder under another name.
  press(*dialog, "batchCopy");
  const QString command = QApplication::clipboard()->text();
  QCOMPARE(command, QStringLiteral("loopmend batch %1 -o %2").arg(path("scans"), path("results")));
  QVERIFY(QDir().rename(path("results"), path("of_window")));
  QStringList words = command.split(QLatin1Char(' ')).mid(1);
  QProcess program;
  program.start(QStringLiteral(LOOPMEND_PROGRAM), words);
  QVERIFY(program.waitForFinished(240000));
  QCOMPARE(program.exitCode(), 1);  // of the file that is no mesh
  QCOMPARE(files_in(path("of_window")), files_in(path("results")));
  int same = 0;
  for (const QString& name : files_in(path("results"))) {
    const QString window_file = path("of_window/") + name, command_file = path("results/") + name;
    if (name.startsWith(QLatin1String("filled/")) || name.startsWith(QLatin1String("pictures/"))) {
      QVERIFY2(bytes_of(window_file) == bytes_of(command_file), qPrintable(name));
      ++same;
    } else if (name.startsWith(QLatin1String("reports/"))) {
      QCOMPARE(lasting(window_file), lasting(command_file));
      ++same;
    }
  }
  QCOMPARE(same, 12);  // three files of each of four scans
  const auto words_of_page = [](const QString& file) {
    QString text = QString::fromUtf8(bytes_of(file));
    text.remove(QRegularExpression(QStringLiteral("<td class='n'>[0-9.]*</td>")));  // seconds and memory are among them
    return text.remove(QRegularExpression(QStringLiteral("<code>[^ ]*loopmend ")));
  };
  QCOMPARE(words_of_page(path("of_window/summary.html")), words_of_page(path("results/summary.html")));

  // What the table says, against the table that the command wrote.
  const QStringList rows = QString::fromUtf8(bytes_of(path("results/summary.csv"))).split(QLatin1Char('\n'));
  const QTreeWidget& seen = table(*dialog);
  QCOMPARE(seen.topLevelItemCount(), 5);
  for (int k = 0; k < 5; ++k) {
    const QTreeWidgetItem& item = *seen.topLevelItem(k);
    const QStringList fields = rows[k + 1].split(QLatin1Char(','));
    QCOMPARE(item.text(0), fields[0]);
    if (fields[2] == QLatin1String("error")) {
      QVERIFY2(item.text(7).contains(QLatin1String("does not begin with \"ply\"")), qPrintable(item.text(7)));
      continue;
    }
    const int filled = fields[8].toInt();
    QCOMPARE(item.text(2).toInt() + item.text(3).toInt() + item.text(4).toInt(), filled);
    QCOMPARE(item.text(4), fields[9]);
    QCOMPARE(item.text(5).toInt(), fields[10].toInt() + fields[11].toInt());
    QCOMPARE(item.text(6).isEmpty(), fields[19].isEmpty());
  }

  // A second run fills nothing, and the filled scan opens in the window.
  QVERIFY(QDir(path("results")).removeRecursively());
  QVERIFY(QDir().rename(path("of_window"), path("results")));
  press(*dialog, "batchStart");
  QVERIFY(wait_until([&] { return !window.batch().busy(); }));
  QVERIFY2(summary(*dialog).endsWith(QLatin1String("4 were complete before.")), qPrintable(summary(*dialog)));
  table(*dialog).setCurrentItem(table(*dialog).findItems(QStringLiteral("sample.ply"), Qt::MatchExactly).first());
  QTest::keyClick(&table(*dialog), Qt::Key_Return);
  QVERIFY(wait_until([&] { return window.document().has_scan(); }));
  QVERIFY(wait_idle(window));
  QVERIFY(window.document().scan(window.document().scans().front())->path.endsWith(QLatin1String("filled/sample.ply")));
  dialog->close();
}

void BatchTest::stopping_takes_no_time_and_the_next_run_goes_on() {
  write_scans(7);
  Shown window;
  const QPointer<BatchDialog> dialog = opened(window);
  QVERIFY(dialog);
  press(*dialog, "batchStart");
  const auto begun = [&] { return bytes_of(path("results/batch.jsonl")).count("begun"); };
  QVERIFY(wait_until([&] { return begun() >= 1; }));
  QElapsedTimer clock;
  clock.start();
  press(*dialog, "batchStop");
  QVERIFY(wait_until([&] { return !window.batch().busy(); }));
  const auto took = clock.elapsed();
  qInfo("stopped after %lld ms", static_cast<long long>(took));
  QVERIFY(took < 1000);  // on a busy machine
  QVERIFY2(summary(*dialog).contains(QLatin1String("waiting for the next run")), qPrintable(summary(*dialog)));
  for (const QString& name : files_in(path("results")))
    QVERIFY2(!QFileInfo(name).fileName().startsWith(QLatin1Char('.')), qPrintable(name));  // nothing half-written
  QVERIFY(QFile::exists(path("results/summary.html")));

  QTest::keyClick(dialog.data(), Qt::Key_Return);  // Start is the button of the key
  QVERIFY(wait_until([&] { return window.batch().busy(); }, 10));
  QVERIFY(wait_until([&] { return !window.batch().busy(); }));
  QVERIFY2(summary(*dialog).startsWith(QLatin1String("3 scans: 2 filled, 1 with nothing to fill.")),
           qPrintable(summary(*dialog)));
  dialog->close();
}

void BatchTest::what_is_wrong_is_told_in_the_dialog() {
  write_scans(2);
  Shown window;
  const QPointer<BatchDialog> dialog = opened(window);
  QVERIFY(dialog);
  const auto message_of = [&](const QString& input, const QString& output) {
    dialog->set_folders(input, output);
    press(*dialog, "batchStart");
    wait_until([&] { return !window.batch().busy(); });
    return summary(*dialog);
  };
  QCOMPARE(message_of(path("scans"), path("scans")),
           QStringLiteral("the results would go among the scans of %1; choose another folder").arg(path("scans")));
  QCOMPARE(message_of(path("none"), path("results")), QStringLiteral("There is no folder %1.").arg(path("none")));
  QDir().mkpath(path("mine"));
  QFile mine(path("mine/summary.html"));
  QVERIFY(mine.open(QIODevice::WriteOnly));
  mine.write("mine");
  mine.close();
  const QString refused = message_of(path("scans"), path("mine"));
  QVERIFY2(refused.endsWith(QLatin1String("move it away, or tick Replace other files")), qPrintable(refused));
  QCOMPARE(bytes_of(path("mine/summary.html")), QByteArray("mine"));
  dialog->close();
}

void BatchTest::closing_the_window_asks_while_a_folder_is_filled() {
  write_scans(7);
  Shown window;
  const QPointer<BatchDialog> dialog = opened(window);
  QVERIFY(dialog);
  press(*dialog, "batchStart");
  QVERIFY(wait_until([&] { return bytes_of(path("results/batch.jsonl")).count("begun") >= 1; }));
  QVERIFY(!window.close());
  QVERIFY(window.isVisible());
  QTest::mouseClick(part<QPushButton>(window, "answerStop"), Qt::LeftButton);
  QVERIFY(wait_until([&] { return !window.isVisible(); }, 20));
  QVERIFY(window.shut_down(std::chrono::seconds(5)));
  QVERIFY(QFile::exists(path("results/summary.csv")));
}

void BatchTest::a_german_window_tells_it_in_german() {
  install_language(QStringLiteral("de"));
  write_scans(3);
  QVERIFY(QFile::copy(sample_file(*folder_), path("scans/sample.ply")));
  {
    Shown window;
    const QPointer<BatchDialog> dialog = opened(window);
    QVERIFY(dialog);
    press(*dialog, "batchStart");
    QVERIFY(wait_until([&] { return !window.batch().busy(); }));
    QCOMPARE(table(*dialog).topLevelItemCount(), 4);
    QStringList texts;
    for (const QObject* object : dialog->findChildren<QObject*>()) texts << texts_of(*object);
    for (int k = 0; k < 4; ++k)
      for (int column = 1; column < 8; ++column) texts << table(*dialog).topLevelItem(k)->text(column);
    for (const QString& text : texts) {
      if (text.contains(QLatin1String("loopmend"))) continue;  // the folders' names
      const QStringList english = loopmend::test::english_in(text);
      QVERIFY2(english.isEmpty(), qPrintable(text));
    }
    dialog->close();
  }
  install_language(QStringLiteral("en"));
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<BatchTest>(); }

#include "batch_test.moc"
