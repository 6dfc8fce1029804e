#include "driver.h"

#include <QAbstractButton>
#include <QApplication>
#include <QElapsedTimer>
#include <QSignalSpy>
#include <QTest>

#include <clocale>
#include <set>

namespace loopmend::testing {

void prepare_application() {
  MeshView::prepare_graphics();
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
}

void settle_application() {
  std::setlocale(LC_NUMERIC, "C");
  QApplication::setStyle(QStringLiteral("Fusion"));
}

bool wait_until(const std::function<bool()>& holds, double seconds) {
  QElapsedTimer clock;
  clock.start();
  while (!holds()) {
    if (static_cast<double>(clock.elapsed()) > 1000 * seconds) return false;
    QApplication::processEvents(QEventLoop::WaitForMoreEvents | QEventLoop::AllEvents, 20);
    QTest::qSleep(2);
  }
  return true;
}

bool wait_idle(MainWindow& window, double seconds) {
  return wait_until([&] { return !window.workbench().busy(); }, seconds);
}

void settle(int milliseconds) { QTest::qWait(milliseconds); }

void press(MainWindow& window, const char* button) {
  QTest::mouseClick(part<QAbstractButton>(window, button), Qt::LeftButton);
}

QPoint visible_point(MainWindow& window, int loop) {
  const int count = window.document().loops()[static_cast<std::size_t>(loop)].edges();
  QWidget* canvas = window.view().canvas();
  for (int v = 0; v < count; ++v) {
    const QPoint at = window.view().position_of(loop, v);
    if (!canvas->rect().adjusted(4, 4, -4, -4).contains(at)) continue;
    QTest::mouseMove(canvas, at);
    QApplication::processEvents();
    if (window.selection().hovered() == loop) return at;
  }
  return {-1, -1};
}

int count_colors(const QImage& image, int enough) {
  std::set<QRgb> colors;
  for (int y = 0; y < image.height(); y += 3)
    for (int x = 0; x < image.width(); x += 3) {
      colors.insert(image.pixel(x, y));
      if (static_cast<int>(colors.size()) >= enough) return enough;
    }
  return static_cast<int>(colors.size());
}

}  // namespace loopmend::testing
