// SPDX-License-Identifier: GPL-3.0-or-later
// Words and keys: what the interface says and in which language, Qt's own dialogs included; and what each key does where.
#include "driver.h"
#include "test_main.h"

#include "dialogs/help_window.h"
#include "document/language.h"

#include <QAction>
#include <QApplication>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QPushButton>
#include <QRegularExpression>
#include <QTableView>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>
#include <QTreeView>

#include <algorithm>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

void add_languages() {
  QTest::addColumn<QString>("language");
  QTest::newRow("English") << QStringLiteral("en");
  QTest::newRow("German") << QStringLiteral("de");
}

}  // namespace

class WordsTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void help_is_there_in_german();
  void dialogs_of_qt_are_in_german();
  void no_word_of_the_workshop_is_shown();
  void everything_can_be_reached_by_keys();
  void shift_end_extends();
  void delete_without_a_selection_does_nothing();
  void a_right_click_on_a_hole_offers_what_applies();
  void accept_and_discard_have_the_same_words_data();
  void accept_and_discard_have_the_same_words();
  void no_two_controls_share_a_letter_data();
  void no_two_controls_share_a_letter();
  void numbers_are_written_in_one_locale_data();
  void numbers_are_written_in_one_locale();

 private:
  QTemporaryDir folder_;
};

void WordsTest::help_is_there_in_german() {
  const QLocale before;
  QLocale::setDefault(QLocale(QStringLiteral("de")));
  HelpWindow help;
  auto* pages = help.findChild<QListWidget*>();
  QSet<QString> names, links;
  for (int row = 0; row < pages->count(); ++row) {
    const QString name = pages->item(row)->data(Qt::UserRole).toString();
    names << name;
    pages->setCurrentRow(row);
    QVERIFY2(help.shown_text().contains(QStringLiteral(" der ")), qPrintable(name));
    // The same links and pictures as in English, and all of them there.
    QStringList found[2];
    for (int german : {0, 1}) {
      QFile page((german ? QStringLiteral(":/help/de/%1.md") : QStringLiteral(":/help/%1.md")).arg(name));
      QVERIFY(page.open(QIODevice::ReadOnly));
      auto matches =
          QRegularExpression(QStringLiteral("\\]\\(([^)]+)\\)")).globalMatch(QString::fromUtf8(page.readAll()));
      while (matches.hasNext()) found[german] << matches.next().captured(1).remove(QStringLiteral("../"));
    }
    QCOMPARE(found[1], found[0]);
    for (const QString& link : found[1]) QVERIFY2(QFile::exists(QStringLiteral(":/help/") + link), qPrintable(link));
  }
  QLocale::setDefault(before);
}

/// Opening asks by a dialog of Qt where the desktop has none of its own, exporting always.
void WordsTest::dialogs_of_qt_are_in_german() {
  install_language(QStringLiteral("de"));
  QStringList opening, exporting;
  {
    Shown window({sample_file(folder_)});
    QStringList* into = &opening;
    const auto read = [&](const QDialog& dialog) {
      for (const QPushButton* button : dialog.findChildren<QPushButton*>())
        *into << button->text().remove(QLatin1Char('&'));
      for (const QLabel* label : dialog.findChildren<QLabel*>()) *into << label->text().remove(QLatin1Char('&'));
      if (const auto* tree = dialog.findChild<QTreeView*>())
        for (int column = 0; column < tree->model()->columnCount(); ++column)
          *into << tree->model()->headerData(column, Qt::Horizontal).toString();
    };
    const WhenAsked asked_to_open(read);
    trigger(window, "open");
    QVERIFY(wait_until([&] { return !opening.isEmpty(); }));
    into = &exporting;
    const WhenAsked asked_to_export(read);
    trigger(window, "export");
    QVERIFY(wait_until([&] { return !exporting.isEmpty(); }));
  }
  install_language(QStringLiteral("en"));
  for (const QStringList& words : {opening, exporting}) {
    const QString all = words.join(QStringLiteral(" | "));
    QVERIFY2(words.contains(QStringLiteral("Abbrechen")), qPrintable(all));
    QVERIFY2(all.contains(QStringLiteral("Dateityp")) || all.contains(QStringLiteral("Dateien des Typs")),
             qPrintable(all));
    QVERIFY2(!all.contains(QStringLiteral("Cancel")) && !all.contains(QStringLiteral("File name")) &&
                 !all.contains(QStringLiteral("Date Modified")),
             qPrintable(all));
  }
  QVERIFY2(exporting.contains(QStringLiteral("Speichern")), qPrintable(exporting.join(QStringLiteral(" | "))));
}

/// What the paper's authors and we call things among ourselves, and the numbers of the paper's figures.
void WordsTest::no_word_of_the_workshop_is_shown() {
  const QRegularExpression forbidden(
      QStringLiteral("\\bfillers?\\b|\\bfig(ure)?\\.? ?\\d|\\bstrays\\b|\\bretreat|\\bracing\\b|To do|Trouble"),
      QRegularExpression::CaseInsensitiveOption);
  Shown window;
  QStringList found;
  int read = 0;
  const auto look = [&](const QObject& of) {
    for (const QObject* object : of.findChildren<QObject*>())
      for (const QString& text : texts_of(*object)) {
        ++read;
        if (forbidden.match(text).hasMatch()) found << text;
      }
  };
  look(window);  // the start page with the paper's examples
  QTest::mouseClick(part<QToolButton>(window, "example_fig5.2a"), Qt::LeftButton);
  QVERIFY(wait_until([&] { return window.document().has_scan(); }));
  settle();
  look(window);
  window.open(sample_file(folder_));
  QVERIFY(wait_idle(window));
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  for (const char* tool :
       {"toolRegionAction", "toolPointsAction", "toolBlendAction", "toolBridgeAction", "toolMeasureAction"}) {
    trigger(window, tool);
    settle();
    look(window);
  }
  for (const char* action : {"compare", "preferences", "screenshot", "shortcuts", "repairAction", "about"}) {
    trigger(window, action);
    settle();
    for (QWidget* other : QApplication::topLevelWidgets())
      if (other != &window && other->isVisible() && !other->inherits("QMenu")) {
        look(*other);
        other->close();
      }
  }
  found.removeDuplicates();
  QVERIFY2(found.isEmpty(), qPrintable(found.join(QLatin1Char('\n'))));
  QVERIFY2(read > 1000, qPrintable(QString::number(read)));
}

void WordsTest::everything_can_be_reached_by_keys() {
  Shown window({sample_file(folder_)});
  QVERIFY(press_and_wait(window, "fill"));
  window.view().canvas()->setFocus();
  QSet<QWidget*> reached;
  for (int i = 0; i < 200; ++i) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    reached << QApplication::focusWidget();
  }
  QStringList missed;
  for (QWidget* widget : window.findChildren<QWidget*>()) {
    const bool control = widget->inherits("QAbstractButton") || widget->inherits("QComboBox") ||
                         widget->inherits("QAbstractSpinBox") || widget->inherits("QAbstractSlider") ||
                         widget->inherits("QAbstractItemView") || widget->inherits("QLineEdit");
    const bool inner = widget->objectName().isEmpty() || widget->objectName().startsWith(QStringLiteral("qt_")) ||
                       widget->inherits("QScrollBar") || qobject_cast<QAbstractSpinBox*>(widget->parentWidget());
    if (control && !inner && widget->isVisible() && widget->isEnabled() && !reached.contains(widget))
      missed << widget->objectName();
  }
  QVERIFY2(missed.isEmpty(), qPrintable(missed.join(QStringLiteral(", "))));
  // Every action has a key or stands in a menu, which keys open.
  QSet<QAction*> in_menus;
  for (QMenu* menu : window.findChildren<QMenu*>())
    for (QAction* action : menu->actions()) in_menus << action;
  for (QAction* action : window.findChildren<QAction*>(QString(), Qt::FindDirectChildrenOnly))
    if (!action->objectName().isEmpty())
      QVERIFY2(in_menus.contains(action) || !action->shortcut().isEmpty(), qPrintable(action->objectName()));
}

/// In the table from the row with the focus to the last one, in a text from the caret to its end, in the list of the scene.
void WordsTest::shift_end_extends() {
  Shown window({write_sheet_with_holes(folder_.filePath(QStringLiteral("sheet.ply")), 3)});
  auto* table = part<QTableView>(window, "holesTable");
  const int rows = table->model()->rowCount();
  QVERIFY(rows >= 9);
  const auto in_row = [&](int row) { return table->visualRect(table->model()->index(row, 0)).center(); };
  const auto selected_rows = [&] {
    QList<int> result;
    for (const QModelIndex& index : table->selectionModel()->selectedRows()) result << index.row();
    std::sort(result.begin(), result.end());
    return result;
  };
  const auto run = [](int first, int last) {
    QList<int> result;
    for (int row = first; row <= last; ++row) result << row;
    return result;
  };
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, in_row(2));
  table->setFocus();
  QTest::keyClick(table, Qt::Key_End, Qt::ShiftModifier);
  QCOMPARE(selected_rows(), run(2, rows - 1));
  QCOMPARE(window.selection().selected().size(), static_cast<std::size_t>(rows - 2));
  QTest::keyClick(table, Qt::Key_Home, Qt::ShiftModifier);
  QCOMPARE(selected_rows(), run(0, 2));
  QTest::keyClick(table, Qt::Key_End);
  QCOMPARE(selected_rows(), run(rows - 1, rows - 1));
  // A hole that was selected in the picture is where it begins.
  window.selection().select({4});
  const int begin = selected_rows().value(0);
  QTest::keyClick(table, Qt::Key_End, Qt::ShiftModifier);
  QCOMPARE(selected_rows(), run(begin, rows - 1));

  auto* filter = part<QLineEdit>(window, "holesFilter");
  filter->setFocus();
  filter->setText(QStringLiteral("hole"));
  filter->setCursorPosition(1);
  QTest::keyClick(filter, Qt::Key_End, Qt::ShiftModifier);
  QCOMPARE(filter->selectedText(), QStringLiteral("ole"));
  QTest::keyClick(filter, Qt::Key_Delete);
  QCOMPARE(filter->text(), QStringLiteral("h"));
}

/// Neither with the focus in the picture, nor in the table, nor in a text.
void WordsTest::delete_without_a_selection_does_nothing() {
  Shown window({sample_file(folder_)});
  QVERIFY(press_and_wait(window, "fill"));
  window.selection().select({});
  const std::size_t patches = window.document().patches().size();
  QVERIFY(patches > 2);
  for (const char* name : {"meshCanvas", "holesTable", "holesFilter", "sceneTree"}) {
    auto* widget = part<QWidget>(window, name);
    widget->setFocus();
    QTest::keyClick(widget, Qt::Key_Delete);
    QCOMPARE(window.document().patches().size(), patches);
  }
  // In a text it deletes letters, whatever is selected.
  auto* filter = part<QLineEdit>(window, "holesFilter");
  window.selection().select({first_hole(window.document())});
  filter->setFocus();
  filter->setText(QStringLiteral("x"));
  filter->setCursorPosition(0);
  QTest::keyClick(filter, Qt::Key_Delete);
  QCOMPARE(filter->text(), QString());
  QCOMPARE(window.document().patches().size(), patches);
  window.view().canvas()->setFocus();
  QTest::keyClick(window.view().canvas(), Qt::Key_Delete);
  QCOMPARE(window.document().patches().size(), patches - 1);
}

void WordsTest::a_right_click_on_a_hole_offers_what_applies() {
  Shown window({sample_file(folder_)});
  const int hole = first_hole(window.document());
  QVERIFY(fly(window, hole));
  const QPoint at = visible_point(window, hole);
  QTest::mouseClick(window.view().canvas(), Qt::RightButton, {}, at);
  // One that was closed is deleted a little later.
  const auto open_menu = [&]() -> QMenu* {
    for (QMenu* menu : window.findChildren<QMenu*>(QStringLiteral("holeMenu")))
      if (menu->isVisible()) return menu;
    return nullptr;
  };
  QVERIFY(wait_until([&] { return open_menu() != nullptr; }));
  QCOMPARE(window.selection().selected(), std::set<int>{hole});
  QMenu* menu = open_menu();
  const QList<QAction*> offered = menu->actions();
  const auto is_offered = [&](const char* name) {
    const auto* action = part<QAction>(window, name);
    return offered.contains(const_cast<QAction*>(action)) && action->isEnabled();
  };
  QVERIFY(is_offered("fillAction") && is_offered("trimAction"));
  QVERIFY(!is_offered("acceptAction"));
  menu->close();
  // Within it just so, open and filled.
  QPointF middle;
  const int edges = window.document().loop(hole).edges();
  for (int v = 0; v < edges; ++v) middle += QPointF(window.view().position_of(hole, v)) / edges;
  const auto offered_within = [&] {
    window.selection().select({});
    QVERIFY(wait_until([&] { return open_menu() == nullptr; }));
    QTest::mouseClick(window.view().canvas(), Qt::RightButton, {}, middle.toPoint());
    QVERIFY(wait_until([&] { return open_menu() != nullptr; }));
    QCOMPARE(window.selection().selected(), std::set<int>{hole});
    open_menu()->close();
  };
  offered_within();
  trigger(window, "initialAction");
  QVERIFY(wait_idle(window));
  QVERIFY(part<QAction>(window, "acceptAction")->isEnabled());
  settle();
  offered_within();
  // The same menu in the table; the header keeps the columns.
  auto* table = part<QTableView>(window, "holesTable");
  Q_EMIT table->customContextMenuRequested(table->visualRect(table->model()->index(0, 1)).center());
  QVERIFY(wait_until([&] { return open_menu() != nullptr; }));
  open_menu()->close();
}

void WordsTest::accept_and_discard_have_the_same_words_data() { add_languages(); }

/// On the buttons of the Patch tab, the tools and the compare window, and in the menus.
void WordsTest::accept_and_discard_have_the_same_words() {
  QFETCH(QString, language);
  install_language(language);
  QSet<QString> accept, discard, reopen;
  QString menu_accept, undo_reopen;
  {
    Shown window({sample_file(folder_)});
    const auto plain = [](QString text) { return text.remove(QLatin1Char('&')); };
    window.selection().select({first_hole(window.document())});
    press_and_wait(window, "fillAndSmooth");
    accept << plain(part<QPushButton>(window, "accept")->text());
    discard << plain(part<QPushButton>(window, "reject")->text());
    for (const char* tool : {"toolRegionAction", "toolPointsAction", "toolBlendAction"}) {
      trigger(window, tool);
      settle();
      for (const auto& [name, words] : {std::pair{"trialAccept", &accept}, {"trialDiscard", &discard}})
        if (const auto* button = part<QPushButton>(window, name); button->isVisible()) *words << plain(button->text());
    }
    discard << plain(window.findChild<QAction*>(QStringLiteral("rejectAction"), Qt::FindDirectChildrenOnly)->text());
    menu_accept = plain(window.findChild<QAction*>(QStringLiteral("acceptAction"), Qt::FindDirectChildrenOnly)->text());
    trigger(window, "compare");
    settle();
    for (QWidget* other : QApplication::topLevelWidgets())
      if (auto* button = other->findChild<QPushButton*>(QStringLiteral("paneAccept0")); button && other != &window) {
        accept << plain(button->text());
        other->close();
      }
    window.selection().select({first_hole(window.document())});
    press(window, "accept");
    accept << plain(window.undo().undo_text()).section(QLatin1Char(' '), 0, 0).remove(QLatin1Char(':'));
    reopen << plain(part<QPushButton>(window, "accept")->text());
    const int interval = QApplication::doubleClickInterval();
    QApplication::setDoubleClickInterval(1);  // or the second press counts as a double click, which is one
    settle();
    press(window, "accept");
    QApplication::setDoubleClickInterval(interval);
    undo_reopen = window.undo().undo_text();
    press(window, "reject");
    discard << plain(window.undo().undo_text()).section(QLatin1Char(' '), 0, 0).remove(QLatin1Char(':'));
  }
  install_language(QStringLiteral("en"));
  const auto listed = [](const QSet<QString>& words) {
    return QStringList(words.values()).join(QStringLiteral(" | "));
  };
  QVERIFY2(accept.size() == 1, qPrintable(listed(accept)));
  QVERIFY2(discard.size() == 1, qPrintable(listed(discard)));
  QVERIFY2(menu_accept.startsWith(*accept.begin()), qPrintable(menu_accept));
  QVERIFY2(menu_accept.contains(*reopen.begin(), Qt::CaseInsensitive), qPrintable(menu_accept));
  QVERIFY2(undo_reopen.startsWith(*reopen.begin()), qPrintable(undo_reopen));
}

void WordsTest::no_two_controls_share_a_letter_data() { add_languages(); }

/// Alt with a letter presses one control, or opens one menu: never the one of several that happens to come first.
void WordsTest::no_two_controls_share_a_letter() {
  QFETCH(QString, language);
  install_language(language);
  QSet<QString> shared;
  {
    Shown window({sample_file(folder_)});
    const auto look = [&] {
      settle();
      QMultiMap<QString, QString> controls;
      const auto add = [&](const QString& text) {
        const QString letter = QKeySequence::mnemonic(text).toString();
        if (!letter.isEmpty()) controls.insert(letter, text);
      };
      for (const QAction* menu : window.menuBar()->actions()) add(menu->text());
      for (const QWidget* widget : window.findChildren<QWidget*>()) {
        if (!widget->isVisible()) continue;
        if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) add(button->text());
        if (const auto* label = qobject_cast<const QLabel*>(widget); label && label->buddy()) add(label->text());
      }
      for (const QString& letter : controls.uniqueKeys())
        if (controls.count(letter) > 1)
          shared << letter + QStringLiteral(": ") + controls.values(letter).join(QStringLiteral(" | "));
    };
    look();
    QVERIFY(press_and_wait(window, "fillAndSmooth"));
    look();
    for (const char* tool :
         {"toolRegionAction", "toolPointsAction", "toolBlendAction", "toolBridgeAction", "toolMeasureAction"}) {
      trigger(window, tool);
      look();
    }
    for (const char* dock : {"lookDock", "sceneDock"}) {
      part<QDockWidget>(window, dock)->raise();
      look();
    }
  }
  install_language(QStringLiteral("en"));
  QVERIFY2(shared.isEmpty(), qPrintable(QStringList(shared.values()).join(QLatin1Char('\n'))));
}

void WordsTest::numbers_are_written_in_one_locale_data() { add_languages(); }

/// In whatever shows text. File names, versions and command lines are no numbers of the window.
void WordsTest::numbers_are_written_in_one_locale() {
  QFETCH(QString, language);
  const bool german = language == QStringLiteral("de");
  install_language(language);
  QStringList wrong;
  int right = 0;
  {
    Shown window({sample_file(folder_)});
    // A digit, a mark, and digits that no grouping by thousands explains.
    const QRegularExpression by_point(QStringLiteral("\\d\\.(\\d{1,2}|\\d{4,})(?![\\d.])")),
        by_comma(QStringLiteral("\\d,(\\d{1,2}|\\d{4,})(?![\\d,])"));
    const auto look = [&](const QObject& of) {
      for (const QObject* object : of.findChildren<QObject*>())
        for (const QString& text : texts_of(*object)) {
          if (text.contains(QStringLiteral("loopmend ")) || text.contains(QStringLiteral("://"))) continue;
          right += text.contains(german ? by_comma : by_point);
          if (text.contains(german ? by_point : by_comma)) wrong << object->objectName() + QStringLiteral(": ") + text;
        }
    };
    window.selection().select({first_hole(window.document())});
    press_and_wait(window, "fillAndSmooth");
    press_and_wait(window, "step");
    window.view().setFocus();
    key(window, Qt::Key_P);
    settle();
    look(window);
    for (const char* dock : {"sceneDock", "toolsDock", "lookDock"}) {
      part<QDockWidget>(window, dock)->raise();
      settle();
      look(window);
    }
    for (const char* tool : {"toolRegionAction", "toolPointsAction", "toolBlendAction", "toolMeasureAction"}) {
      trigger(window, tool);
      settle();
      look(window);
    }
    for (const char* action : {"compare", "preferences", "screenshot", "repairAction"}) {
      trigger(window, action);
      settle();
      for (QWidget* other : QApplication::topLevelWidgets())
        if (other != &window && other->isVisible() && !other->inherits("QMenu")) {
          if (qstrcmp(action, "compare") == 0) {
            if (auto* run = other->findChild<QPushButton*>(QStringLiteral("compareRun"))) {
              wait_until([&] { return run->isEnabled(); });
              run->click();
              const auto* accept = other->findChild<QPushButton*>(QStringLiteral("paneAccept0"));
              wait_until([&] { return accept->isEnabled() || run->isEnabled(); });
              other->findChild<QPushButton*>(QStringLiteral("compareStop"))->click();
              wait_until([&] { return run->isEnabled(); });
            }
          }
          look(*other);
          other->close();
        }
    }
  }
  install_language(QStringLiteral("en"));
  wrong.removeDuplicates();
  QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
  QVERIFY2(right > 30, qPrintable(QString::number(right)));
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<WordsTest>(); }

#include "words_test.moc"
