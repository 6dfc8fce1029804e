// Takes pictures of the real window, for people to judge and for the help pages: take_screenshots FILE FOLDER [light|dark [de]]
// Twice the size: QT_SCALE_FACTOR=2. See resources/help/make_pictures.sh.
#include "driver.h"

#include "document/language.h"
#include "document/preferences.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QDockWidget>
#include <QFileInfo>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QSlider>
#include <QTabWidget>
#include <QTemporaryDir>
#include <QTest>

#include <cstdio>
#include <cstring>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

QDir folder;

void save(const QPixmap& picture, const char* name) {
  picture.save(folder.filePath(QLatin1String(name) + QStringLiteral(".png")));
}

/// What the person would see: from the screen, composed.
void shoot(MainWindow& window, const char* name) {
  settle(350);
  save(window.screen()->grabWindow(0, window.x(), window.y(), window.width(), window.height()), name);
}

void shoot_part(MainWindow& window, QWidget* part, const char* name) {
  settle(350);
  const QPoint at = part->mapToGlobal(QPoint(0, 0));
  save(window.screen()->grabWindow(0, at.x(), at.y(), part->width(), part->height()), name);
}

void shoot_dialog(MainWindow& window, const char* action, const char* dialog, const char* name) {
  window.findChild<QAction*>(QLatin1String(action))->trigger();
  settle(400);
  auto* shown = window.findChild<QWidget*>(QLatin1String(dialog));
  if (!shown) return;
  shown->move(10, 10);
  settle(300);
  save(shown->grab(), name);
  shown->close();
  settle(100);
}

void trigger(MainWindow& window, const char* action) {
  window.findChild<QAction*>(QLatin1String(action), Qt::FindDirectChildrenOnly)->trigger();
}

void show_story(MainWindow& window, const QString& file) {
  GapMeter gaps;
  shoot(window, "welcome");
  window.open(file);
  wait_idle(window);
  gaps.report("open");
  shoot(window, "opened");
  const QPoint at = visible_point(window, 0);
  if (at.x() >= 0) {
    shoot(window, "hover");
    QTest::mouseClick(window.view().canvas(), Qt::LeftButton, {}, at);
    QTest::mouseMove(window.view().canvas(), QPoint(20, 20));
    shoot(window, "selected");
  }
  window.selection().select({});
  press(window, "fill");
  wait_idle(window);
  gaps.report("fill");
  shoot(window, "filled");
  window.view().fly_to(0);
  settle(800);
  gaps.report("fly");
  window.selection().select({0});
  part<QSlider>(window, "sigma")->setValue(-10);
  press(window, "run");
  settle(900);
  shoot(window, "running");
  window.workbench().cancel();
  settle(200);
  gaps.report("run");
  window.selection().select({});
  press(window, "steady");
  wait_idle(window, 300);
  window.selection().select({0});
  settle(200);
  gaps.report("to steady state");
  shoot(window, "window");
  shoot_part(window, part<QDockWidget>(window, "holesDock"), "holes");
  shoot_part(window, part<QDockWidget>(window, "patchDock"), "patch");
  auto* tabs = part<QTabWidget>(window, "inspectTabs");
  tabs->setCurrentIndex(1);
  shoot_part(window, part<QDockWidget>(window, "inspectDock"), "inspect");
  tabs->setCurrentIndex(2);
  shoot(window, "log");
  tabs->setCurrentIndex(0);
}

void show_looks(MainWindow& window) {
  part<QDockWidget>(window, "lookDock")->raise();
  shoot_part(window, part<QDockWidget>(window, "lookDock"), "look");
  trigger(window, "zebra");
  shoot(window, "zebra");
  trigger(window, "isophotes");
  shoot(window, "isophotes");
  trigger(window, "gaussian");
  QTest::mouseClick(window.view().canvas(), Qt::LeftButton, {}, window.view().canvas()->rect().center());
  shoot(window, "gaussian");
  trigger(window, "plain");
  trigger(window, "wireframe");
  settle(1500);  // the graphics take their time over edges, the first time
  shoot(window, "wireframe");
  trigger(window, "wireframe");
  trigger(window, "curvature");
  part<QDockWidget>(window, "patchDock")->raise();
}

void show_the_rest(MainWindow& window) {
  shoot_dialog(window, "shortcuts", "shortcutSheet", "shortcuts");
  shoot_dialog(window, "preferences", "preferencesDialog", "preferences");
  shoot_dialog(window, "screenshot", "pictureDialog", "picture");
  shoot_dialog(window, "help", "helpWindow", "help");
  window.close();  // asks in place
  shoot(window, "unsaved");
  window.workbench().open({QStringLiteral("/nonexistent/scan.ply")}, OpenMode::replace);
  wait_idle(window);
  shoot(window, "error");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("usage: take_screenshots FILE FOLDER [light|dark [de]]\n", stderr);
    return 2;
  }
  const QTemporaryDir home;
  use_own_home(home.path());
  prepare_application();
  QApplication application(argc, argv);
  settle_application();
  Preferences preferences;
  preferences.theme = argc > 3 && std::strcmp(argv[3], "dark") == 0 ? Theme::dark : Theme::light;
  save_preferences(preferences);
  if (argc > 4) install_language(QString::fromLatin1(argv[4]));
  folder = QDir(QString::fromLocal8Bit(argv[2]));
  folder.mkpath(QStringLiteral("."));
  MainWindow window;
  window.move(0, 0);
  window.show();
  if (!QTest::qWaitForWindowExposed(&window)) return 1;
  QApplication::setActiveWindow(&window);
  show_story(window, QFileInfo(QString::fromLocal8Bit(argv[1])).absoluteFilePath());
  show_looks(window);
  show_the_rest(window);
  window.autosave().finish();
  return window.shut_down(std::chrono::seconds(20)) ? 0 : 1;
}
