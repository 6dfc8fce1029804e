// Takes pictures of the real window for people to judge: take_screenshots FILE OUT_FOLDER [dark]
#include "driver.h"

#include <QApplication>
#include <QDir>
#include <QElapsedTimer>
#include <QPalette>
#include <QPushButton>
#include <QScreen>
#include <QTest>
#include <QTimer>

#include <cstdio>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

QDir folder;

/// What the person would see: the composed window from the screen.
void shoot(MainWindow& window, const char* name) {
  settle(250);
  window.screen()
      ->grabWindow(0, window.x(), window.y(), window.width(), window.height())
      .save(folder.filePath(QLatin1String(name) + QStringLiteral(".png")));
}

QPalette dark_palette() {
  QPalette p(QColor(52, 56, 62), QColor(44, 47, 52));
  p.setColor(QPalette::Base, QColor(34, 37, 41));
  p.setColor(QPalette::AlternateBase, QColor(44, 47, 52));
  p.setColor(QPalette::Highlight, QColor(64, 112, 176));
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(role, QColor(228, 230, 232));
  for (auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, QColor(122, 126, 132));
  p.setColor(QPalette::PlaceholderText, QColor(160, 164, 170));
  return p;
}

/// The longest time that the event loop did not come round.
class GapMeter : public QObject {
 public:
  GapMeter() {
    connect(&timer_, &QTimer::timeout, this, [this] { worst_ = std::max(worst_, clock_.restart()); });
    timer_.start(1);
    clock_.start();
  }
  void report(const char* what) {
    std::printf("%-28s longest event-loop gap %lld ms\n", what, static_cast<long long>(worst_));
    worst_ = 0;
  }

 private:
  QTimer timer_;
  QElapsedTimer clock_;
  qint64 worst_ = 0;
};

void story(MainWindow& window, const QString& file) {
  GapMeter gaps;
  shoot(window, "1-welcome");
  gaps.report("welcome");
  QElapsedTimer clock;
  clock.start();
  window.open(file);
  wait_until([&] { return window.document().has_scan(); });
  std::printf("loops known after %lld ms\n", static_cast<long long>(clock.elapsed()));
  wait_idle(window);
  std::printf("coloured after %lld ms\n", static_cast<long long>(clock.elapsed()));
  shoot(window, "2-opened");
  gaps.report("open");
  const QPoint at = visible_point(window, 0);
  if (at.x() >= 0) {
    shoot(window, "3-hover");
    QTest::mouseClick(window.view().canvas(), Qt::LeftButton, {}, at);
    QTest::mouseMove(window.view().canvas(), QPoint(20, 20));
    shoot(window, "4-selected");
  }
  gaps.report("hover and select");
  window.selection().select({});
  if (!part<QPushButton>(window, "fill")->isEnabled()) {
    std::set<int> all;
    for (int i = 0; i < static_cast<int>(window.document().loops().size()); ++i) all.insert(i);
    window.selection().select(all);
  }
  press(window, "fill");
  wait_idle(window);
  shoot(window, "5-filled");
  gaps.report("fill");
  window.view().fly_to(0);
  settle(800);
  shoot(window, "6-close");
  gaps.report("fly");
  press(window, "run");
  settle(700);
  shoot(window, "7-running");
  window.workbench().cancel();
  press(window, "steady");
  wait_idle(window, 300);
  shoot(window, "8-steady");
  gaps.report("run and steady");
  window.view().set_shading(Shading::zebra);
  shoot(window, "9-zebra");
  window.view().set_shading(Shading::plain);
  window.view().set_edges(Edges::shown);
  shoot(window, "10-plain-wire");
  window.open(QStringLiteral("/nonexistent/scan.ply"));
  wait_idle(window);
  shoot(window, "11-error");
  gaps.report("shading, error");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3) {
    std::fputs("usage: take_screenshots FILE OUT_FOLDER [dark]\n", stderr);
    return 2;
  }
  prepare_application();
  QApplication application(argc, argv);
  settle_application();
  if (argc > 3) QApplication::setPalette(dark_palette());
  folder = QDir(QString::fromLocal8Bit(argv[2]));
  folder.mkpath(QStringLiteral("."));
  MainWindow window;
  window.move(0, 0);
  window.show();
  if (!QTest::qWaitForWindowExposed(&window)) return 1;
  story(window, QString::fromLocal8Bit(argv[1]));
  window.close();
  return 0;
}
