// SPDX-License-Identifier: GPL-3.0-or-later
// What a screen reader is told: the tree of accessible objects, as Qt hands it to AT-SPI. Whatever takes input has a name.
#include "driver.h"
#include "test_main.h"

#include "dialogs/repair_dialog.h"

#include <QAccessible>
#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QTemporaryDir>
#include <QTest>
#include <QTreeWidget>
#include <QWheelEvent>

#include <set>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

const std::set<QAccessible::Role> takes_input{
    QAccessible::PushButton, QAccessible::CheckBox,      QAccessible::RadioButton,  QAccessible::ComboBox,
    QAccessible::SpinBox,    QAccessible::Slider,        QAccessible::EditableText, QAccessible::Table,
    QAccessible::Tree,       QAccessible::List,          QAccessible::ButtonMenu,   QAccessible::MenuItem,
    QAccessible::PageTab,    QAccessible::ButtonDropDown};

struct Found {
  int named = 0;
  QStringList nameless;
};

void walk(QAccessibleInterface* at, const QString& way, Found& found, int depth = 0) {
  if (!at || !at->isValid() || depth > 40) return;
  const QString name = at->text(QAccessible::Name);
  const QObject* object = at->object();
  const QString label = object && !object->objectName().isEmpty() ? object->objectName()
                        : object ? QString::fromLatin1(object->metaObject()->className())
                                 : QStringLiteral("?");
  const bool part_of_another = object && (object->objectName().startsWith(QStringLiteral("qt_")) ||
                                          object->objectName() == QStringLiteral("ScrollLeftButton") ||
                                          object->objectName() == QStringLiteral("ScrollRightButton"));
  if (at->state().invisible) return;
  if (takes_input.count(at->role()) > 0 && !part_of_another) {
    if (name.trimmed().isEmpty())
      found.nameless << way + QLatin1Char('/') + label;
    else
      ++found.named;
  }
  // Cells are as many as there are holes, and have their text.
  if (at->role() == QAccessible::Table || at->role() == QAccessible::Tree || at->role() == QAccessible::List ||
      at->role() == QAccessible::ComboBox || at->role() == QAccessible::SpinBox)
    return;
  for (int k = 0; k < at->childCount(); ++k) walk(at->child(k), way + QLatin1Char('/') + label, found, depth + 1);
}

Found names_in(QWidget* window) {
  Found found;
  walk(QAccessible::queryAccessibleInterface(window), QString(), found);
  return found;
}

}  // namespace

class AccessTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatever_takes_input_has_a_name();
  void keys_belong_to_what_has_the_focus();

 private:
  QTemporaryDir folder_;
};

void AccessTest::whatever_takes_input_has_a_name() {
  Shown window({sample_file(folder_)});
  QVERIFY(press_and_wait(window, "fillAndSmooth"));
  window.visibility().set_patches({window.document().patches().front().id}, SceneVisibility::Visible::hidden);
  QStringList nameless;
  int named = 0;
  const auto look = [&](QWidget* at) {
    const Found found = names_in(at);
    nameless << found.nameless;
    named += found.named;
  };
  for (const char* dock : {"holesDock", "sceneDock", "patchDock", "toolsDock", "lookDock"}) {
    part<QDockWidget>(window, dock)->raise();
    settle();
    look(&window);
  }
  for (const char* tool : {"toolRegionAction", "toolPointsAction", "toolBlendAction", "toolMeasureAction"}) {
    window.findChild<QAction*>(QLatin1String(tool), Qt::FindDirectChildrenOnly)->trigger();
    settle();
    look(&window);
  }
  for (const char* action : {"preferences", "screenshot", "shortcuts", "help", "repairAction"}) {
    window.findChild<QAction*>(QLatin1String(action), Qt::FindDirectChildrenOnly)->trigger();
    settle();
    for (QWidget* dialog : QApplication::topLevelWidgets())
      if (dialog != &window && dialog->isVisible() && dialog->isWindow() && dialog->inherits("QWidget") &&
          !dialog->inherits("QMenu")) {
        look(dialog);
        dialog->close();
      }
  }
  nameless.removeDuplicates();
  QVERIFY2(nameless.isEmpty(), qPrintable(nameless.join(QLatin1Char('\n'))));
  QVERIFY2(named > 200, qPrintable(QString::number(named)));
}

/// Space ticks a check box and starts no run; Delete needs a selection.
void AccessTest::keys_belong_to_what_has_the_focus() {
  Shown window({sample_file(folder_)});
  QVERIFY(press_and_wait(window, "fill"));
  const PatchStatePtr before = window.document().patches().front().state;
  auto* islands = part<QCheckBox>(window, "islands");
  islands->setFocus();
  const bool ticked = islands->isChecked();
  QTest::keyClick(islands, Qt::Key_Space);
  settle();
  QCOMPARE(islands->isChecked(), !ticked);
  QVERIFY(!window.controller().busy());
  QVERIFY(window.document().patches().front().state == before);

  // The same after a click.
  QTest::mouseClick(islands, Qt::LeftButton, {}, QPoint(8, islands->height() / 2));
  QCOMPARE(islands->isChecked(), ticked);
  QVERIFY(islands->hasFocus());
  QTest::keyClick(islands, Qt::Key_Space);
  settle();
  QCOMPARE(islands->isChecked(), !ticked);
  QVERIFY(!window.controller().busy() && window.document().patches().front().state == before);

  // The wheel over a control that has no focus scrolls the panel, and leaves the value.
  auto* boundary = part<QComboBox>(window, "boundary");
  const int chosen = boundary->currentIndex();
  const QPointF over(boundary->rect().center());
  const auto turn = [&] {
    QWheelEvent wheel(over, boundary->mapToGlobal(over.toPoint()), {}, {0, -120}, {}, {}, Qt::NoScrollPhase, false);
    QApplication::sendEvent(boundary, &wheel);
    return boundary->currentIndex();
  };
  QCOMPARE(turn(), chosen);
  boundary->setFocus();
  QVERIFY(turn() != chosen);
  boundary->setCurrentIndex(chosen);

  for (const char* name : {"boundary", "flow", "shading"}) {
    auto* at = part<QWidget>(window, name);
    QVERIFY2(at, name);
    for (QWidget* dock = at; dock; dock = dock->parentWidget())
      if (qobject_cast<QDockWidget*>(dock)) dock->raise();
    settle();
    at->setFocus();
    QTest::keyClick(at, Qt::Key_Space);
    settle();
    if (QWidget* list = QApplication::activePopupWidget()) list->close();
    QVERIFY2(!window.controller().busy() && window.document().patches().front().state == before, name);
  }
  // A row of the list is shown or hidden by Space.
  part<QDockWidget>(window, "sceneDock")->raise();
  settle();
  auto* tree = part<QTreeWidget>(window, "sceneTree");
  tree->setFocus();
  tree->setCurrentItem(tree->topLevelItem(0));
  const Qt::CheckState shown_before = tree->topLevelItem(0)->checkState(0);
  QTest::keyClick(tree, Qt::Key_Space);
  settle();
  QVERIFY(tree->topLevelItem(0)->checkState(0) != shown_before);
  QVERIFY(!window.controller().busy() && window.document().patches().front().state == before);

  window.selection().select({});
  const std::size_t patches = window.document().patches().size();
  QTest::keyClick(&window, Qt::Key_Delete);
  QCOMPARE(window.document().patches().size(), patches);
}

std::unique_ptr<QObject> loopmend::testing::make_test() { return std::make_unique<AccessTest>(); }

#include "access_test.moc"
