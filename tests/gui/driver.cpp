// SPDX-License-Identifier: GPL-3.0-or-later
#include "driver.h"

#include "document/language.h"
#include "document/targets.h"
#include "io/write_mesh.h"
#include "samples/sample_scan.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QElapsedTimer>
#include <QFile>
#include <QScrollArea>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>

#include <clocale>
#include <cstdio>
#include <ctime>
#include <set>

namespace loopmend::testing {

bool at_length() { return qEnvironmentVariableIntValue("LOOPMEND_AT_LENGTH") == 1; }

void prepare_application() {
  MeshView::prepare_graphics();
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
}

void settle_application() {
  std::setlocale(LC_NUMERIC, "C");
  QApplication::setStyle(QStringLiteral("Fusion"));
  install_language(QStringLiteral("en"));
}

void use_own_home(const QString& folder) {
  for (const char* name : {"XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME"})
    qputenv(name, QString(folder + QLatin1Char('/') + QLatin1String(name)).toLocal8Bit());
}

QString write_sheet_with_holes(const QString& path, int across) {
  constexpr int pitch = 6, first = 2, last = 3;  // squares first..last of every pitch are missing, both ways
  const int squares = across * pitch + 1;
  const auto missing = [&](int i) { return i % pitch >= first && i % pitch <= last && i / pitch < across; };
  TriangleSoup soup;
  for (int j = 0; j <= squares; ++j)
    for (int i = 0; i <= squares; ++i) soup.points.emplace_back(i, j, 1e-2 * ((i * 7 + j * 13) % 5));
  const auto at = [&](int i, int j) { return j * (squares + 1) + i; };
  for (int j = 0; j < squares; ++j)
    for (int i = 0; i < squares; ++i) {
      if (missing(i) && missing(j)) continue;
      soup.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      soup.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  write_mesh(path.toStdString(), soup);
  return path;
}

double share_changed(const QImage& a, const QImage& b) {
  if (a.size() != b.size()) return 1;
  const QImage one = a.convertToFormat(QImage::Format_ARGB32), other = b.convertToFormat(QImage::Format_ARGB32);
  int changed = 0, all = 0;
  for (int y = 0; y < one.height(); y += 2) {
    const auto *left = reinterpret_cast<const QRgb*>(one.constScanLine(y)),
               *right = reinterpret_cast<const QRgb*>(other.constScanLine(y));
    for (int x = 0; x < one.width(); x += 2, ++all) changed += left[x] != right[x];
  }
  return static_cast<double>(changed) / std::max(1, all);
}

bool picture_changes(MainWindow& window, const QImage& before, double share) {
  settle();
  return wait_until([&] { return share_changed(before, window.view().picture()) > share; });
}

bool picture_returns(MainWindow& window, const QImage& before) {
  settle();
  return wait_until([&] { return share_changed(before, window.view().picture()) < 0.001; });
}

namespace {

double thread_cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

/// Notes when a window was last drawn, moved, shown or laid out.
class Unrest : public QObject {
 public:
  Unrest() {
    clock_.start();
    QCoreApplication::instance()->installEventFilter(this);
  }
  qint64 quiet_for() const { return clock_.elapsed(); }

 protected:
  bool eventFilter(QObject*, QEvent* event) override {
    switch (event->type()) {
      case QEvent::Resize:
      case QEvent::Move:
      case QEvent::Show:
      case QEvent::Hide:
      case QEvent::Expose:
      case QEvent::LayoutRequest:
      case QEvent::UpdateRequest:
      case QEvent::WindowActivate:
      case QEvent::WindowDeactivate:
      case QEvent::WindowStateChange: clock_.restart(); break;
      default: break;
    }
    return false;
  }

 private:
  QElapsedTimer clock_;
};

/// Whether a window has put something off for a moment: its picture, a flight, a table, a preview. What waits longer waits
/// for a person.
bool something_is_due() {
  constexpr int moment_ms = 300;
  for (const QWidget* top : QApplication::topLevelWidgets()) {
    for (const QTimer* timer : top->findChildren<QTimer*>())
      if (timer->isActive() && timer->interval() <= moment_ms) return true;
    for (const auto* view : top->findChildren<MeshView*>())
      if (view->isVisible() && view->is_rough()) return true;
  }
  return false;
}

}  // namespace

GapMeter::GapMeter() {
  cpu_ = thread_cpu_ms();
  connect(&timer_, &QTimer::timeout, this, [this] {
    worst_ = std::max(worst_, clock_.restart());
    const double now = thread_cpu_ms();
    worst_cpu_ = std::max(worst_cpu_, now - cpu_);
    cpu_ = now;
  });
  timer_.start(1);
  clock_.start();
}

double GapMeter::report(const char* what) {
  QCoreApplication::processEvents();
  const qint64 worst = std::max(std::exchange(worst_, 0), clock_.elapsed());
  const double work = std::exchange(worst_cpu_, 0);
  std::printf("gap %5lld ms, of these %4.0f ms own work  %s\n", static_cast<long long>(worst), work, what);
  cpu_ = thread_cpu_ms();
  std::fflush(stdout);
  clock_.restart();
  return work;
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
  return wait_until([&] { return !window.controller().busy() && !window.controller().computing_curvature(); }, seconds);
}

bool fly(MainWindow& window, int loop) {
  window.view().fly_to(loop);
  const bool there = wait_until([&] { return !window.view().is_flying(); });
  settle();
  return there;
}

bool settle() {
  constexpr qint64 quiet_ms = 40;  // longer than the pause between two pictures of one movement
  Unrest unrest;
  const bool still = wait_until([&] { return unrest.quiet_for() >= quiet_ms && !something_is_due(); });
  if (!still) qWarning("the window did not come to rest");
  return still;
}

void linger(int milliseconds) { QTest::qWait(milliseconds); }

WhenAsked::WhenAsked(std::function<void(QDialog&)> answer) {
  connect(&timer_, &QTimer::timeout, this, [this, answer = std::move(answer)] {
    auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
    if (!dialog || !dialog->isVisible()) return;
    timer_.stop();
    if (!QTest::qWaitForWindowExposed(dialog, 60000)) qWarning("the dialog is not on the screen");
    answer(*dialog);
    if (dialog->isVisible()) dialog->reject();
  });
  timer_.start(20);
}

bool apply_proposal(MainWindow& window) {
  const auto is_shown = [&] {
    const auto* apply = window.findChild<QPushButton*>(QStringLiteral("proposalApply"));
    return apply && apply->isVisible();
  };
  if (!wait_until(is_shown)) return false;
  press(window, "proposalApply");
  return wait_idle(window);
}

bool press_and_apply(MainWindow& window, const char* button) {
  press(window, button);
  return apply_proposal(window);
}

void trigger(MainWindow& window, const char* action) {
  window.findChild<QAction*>(QLatin1String(action), Qt::FindDirectChildrenOnly)->trigger();
}

void reveal(QObject* widget) {
  if (!qobject_cast<QWidget*>(widget)) return;
  for (QObject* above = widget ? widget->parent() : nullptr; above; above = above->parent()) {
    auto* around = qobject_cast<QWidget*>(above);
    if (auto* scroll = qobject_cast<QScrollArea*>(around); scroll && scroll->widget() != widget && scroll->isVisible())
      scroll->ensureWidgetVisible(qobject_cast<QWidget*>(widget));
    if (!around || !around->isHidden()) continue;
    const QString fold = QString(around->objectName()).remove(QStringLiteral("Content"));
    auto* toggle = around->window()->findChild<QToolButton*>(fold);
    if (qobject_cast<QDockWidget*>(around))
      around->show();
    else if (toggle && fold != around->objectName())
      toggle->setChecked(true);
    else
      continue;
    settle();
  }
}

void press(MainWindow& window, const char* button) {
  QTest::mouseClick(part<QAbstractButton>(window, button), Qt::LeftButton);
}

bool press_and_wait(MainWindow& window, const char* button, double seconds) {
  press(window, button);
  return wait_idle(window, seconds);
}

void key(MainWindow& window, Qt::Key which, Qt::KeyboardModifiers with) {
  QApplication::setActiveWindow(&window);  // a dialog that closes does not give the focus back by itself
  QTest::keyClick(&window, which, with);
}

Shown::Shown(const QStringList& paths, Extent extent) {
  // One whose size was kept has that.
  if (const QSize at_first(1360, 860); extent == Extent::small && size() == at_first) resize(1120, 740);
  move(0, 0);
  show();
  exposed = QTest::qWaitForWindowExposed(this);
  QApplication::setActiveWindow(this);  // there is no window manager to do it, and shortcuts need it
  if (!paths.isEmpty()) open(paths);
  ready = wait_idle(*this) && (paths.isEmpty() || document().has_scan());
  settle();
}

Shown::~Shown() { autosave().finish(); }

QString scan_file(const QTemporaryDir& folder, const QString& name, const TriangleSoup& soup) {
  const QString path = folder.filePath(name);
  write_mesh(path.toStdString(), soup);
  return path;
}

QString sample_file(const QTemporaryDir& folder) {
  const QString path = folder.filePath(QStringLiteral("sample.ply"));
  if (!QFile::exists(path)) write_mesh(path.toStdString(), make_sample_scan());
  return path;
}

int first_hole(const Document& document) {
  int loop = 0;
  while (loop < document.loop_count() && !document.fillable(loop)) ++loop;
  return loop;
}

int open_holes(const Document& document) {
  return static_cast<int>(loops_up_to(document, SizeMeasure::edges, 1e9).size());
}

QPoint visible_point(MainWindow& window, int loop) {
  const int count = window.document().loops()[loop].edges();
  QWidget* canvas = window.view().canvas();
  for (int round = 0; round < 3; ++round, settle())  // the view may still have been drawing
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

QStringList texts_of(const QObject& object) {
  QStringList texts;
  for (const char* property : {"text", "title", "toolTip", "statusTip", "whatsThis", "windowTitle", "accessibleName",
                               "accessibleDescription", "placeholderText", "prefix", "suffix", "plainText"})
    if (const QString text = object.property(property).toString(); !text.isEmpty()) texts << text;
  if (const auto* view = qobject_cast<const QAbstractItemView*>(&object); view && view->model()) {
    const QAbstractItemModel& model = *view->model();
    for (int column = 0; column < model.columnCount(); ++column) {
      for (const int role : {Qt::DisplayRole, Qt::ToolTipRole})
        texts << model.headerData(column, Qt::Horizontal, role).toString();
      for (int row = 0; row < model.rowCount(); ++row)
        for (const int role : {Qt::DisplayRole, Qt::ToolTipRole})
          texts << model.index(row, column).data(role).toString();
    }
  }
  if (const auto* combo = qobject_cast<const QComboBox*>(&object))
    for (int k = 0; k < combo->count(); ++k)
      texts << combo->itemText(k) << combo->itemData(k, Qt::ToolTipRole).toString();
  return texts;
}

}  // namespace loopmend::testing
