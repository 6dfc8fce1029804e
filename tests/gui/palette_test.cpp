// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl+K: every command of the menus is found by typing, and run by Return.
#include "driver.h"
#include "test_main.h"

#include "dialogs/command_palette.h"

#include <QAction>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QPointer>
#include <QScreen>
#include <QTemporaryDir>
#include <QTest>

#include <functional>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

struct Palette {
  explicit Palette(MainWindow& window) {
    key(window, Qt::Key_K, Qt::ControlModifier);
    wait_until([&] { return (dialog = window.findChild<CommandPalette*>()) && dialog->isVisible(); }, 20);
    typed = dialog->findChild<QLineEdit*>(QStringLiteral("commandTyped"));
    list = dialog->findChild<QListWidget*>(QStringLiteral("commandList"));
  }
  QString first() const { return list->count() > 0 ? list->item(0)->text() : QString(); }
  QPointer<CommandPalette> dialog;
  QLineEdit* typed = nullptr;
  QListWidget* list = nullptr;
};

QString menu_words(const QAction& action) { return action.text().remove(QLatin1Char('&')).remove(QChar(0x2026)); }

}  // namespace

class PaletteTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void words_are_found_by_their_starts_first();
  void it_has_every_command_of_the_menus();
  void typing_and_return_run_a_command();
  void what_cannot_be_done_is_shown_and_not_run();

 private:
  QTemporaryDir folder_;
};

void PaletteTest::words_are_found_by_their_starts_first() {
  const QString command = QStringLiteral("Copy command line");
  QVERIFY(fit_of(QStringLiteral("line"), command) > fit_of(QStringLiteral("ine"), command));
  QVERIFY(fit_of(QStringLiteral("ine"), command) > fit_of(QStringLiteral("cpyl"), command));
  QVERIFY(fit_of(QStringLiteral("line copy"), command) > 0);  // in any order
  QCOMPARE(fit_of(QStringLiteral("copy zebra"), command), 0);
  QVERIFY(fit_of(QString(), command) > 0);
}

void PaletteTest::it_has_every_command_of_the_menus() {
  Shown window({sample_file(folder_)});
  const Palette palette(window);
  QStringList shown_texts;
  for (int k = 0; k < palette.list->count(); ++k)
    shown_texts << palette.list->item(k)->text().remove(QStringLiteral(" \u2713"));
  QStringList commands, submenus;
  const std::function<void(const QMenu&)> list = [&](const QMenu& menu) {
    for (const QAction* action : menu.actions()) {
      if (action->menu()) {
        submenus << menu_words(*action);
        list(*action->menu());
      } else if (!action->isSeparator()) {
        commands << menu_words(*action);
      }
    }
  };
  for (const QAction* menu : window.menuBar()->actions()) list(*menu->menu());
  for (const QString& command : commands) QVERIFY2(shown_texts.contains(command), qPrintable(command));
  QVERIFY(commands.size() > 60);
  for (const char* menu : {"Up axis", "Navigation"}) QVERIFY(submenus.contains(QLatin1String(menu)));
  for (const char* command : {"Z up", "Blender navigation"}) QVERIFY2(commands.contains(QLatin1String(command)), command);
  palette.dialog->close();
}

void PaletteTest::typing_and_return_run_a_command() {
  Shown window({sample_file(folder_)});
  const Palette palette(window);
  QTest::keyClicks(palette.typed, QStringLiteral("zeb"));
  QCOMPARE(palette.first(), QStringLiteral("Zebra"));
  if (const QString folder = qEnvironmentVariable("LOOPMEND_SHOTS"); !folder.isEmpty()) {
    palette.typed->setText(QStringLiteral("hole"));
    linger(400);
    window.screen()
        ->grabWindow(0, window.x(), window.y(), window.width(), window.height())
        .save(folder + QStringLiteral("/palette.png"));
    palette.typed->setText(QStringLiteral("zeb"));
  }
  QTest::keyClick(palette.typed, Qt::Key_Return);
  QVERIFY(wait_until([&] { return window.view().look().shading == Shading::zebra; }, 20));
  QVERIFY(!palette.dialog || !palette.dialog->isVisible());
}

void PaletteTest::what_cannot_be_done_is_shown_and_not_run() {
  Shown window({sample_file(folder_)});
  const Palette palette(window);
  QTest::keyClicks(palette.typed, QStringLiteral("discard"));
  QCOMPARE(palette.first(), QStringLiteral("Discard"));
  QVERIFY(!palette.list->item(0)->flags().testFlag(Qt::ItemIsEnabled));
  QTest::keyClick(palette.typed, Qt::Key_Return);
  QVERIFY(palette.dialog->isVisible());
  QTest::keyClick(palette.typed, Qt::Key_Escape);
  QVERIFY(wait_until([&] { return !palette.dialog || !palette.dialog->isVisible(); }, 20));
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<PaletteTest>(); }

#include "palette_test.moc"
