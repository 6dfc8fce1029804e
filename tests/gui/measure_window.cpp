// SPDX-License-Identifier: GPL-3.0-or-later
// Figures that issue after issue asks of the window, on this machine: measure_window DRAGON [BUNNY] [WHAT...]
// WHAT: opening (and hovering), gaps (on BUNNY), memory, flow (18 000 triangles in a scan of a million), compare (four flows on a patch of
// 20 000); all of them without it. Run by hand: none of it is a test.
#include "driver.h"

#include "compare/compare_controller.h"
#include "compare/flow_canvas.h"
#include "compare/flow_view.h"
#include "document/undo_history.h"
#include "io/write_mesh.h"
#include "samples/analytic_surfaces.h"

#include <QApplication>
#include <QEventLoop>
#include <QLabel>
#include <QMouseEvent>
#include <QPushButton>
#include <QRegularExpression>
#include <QSlider>
#include <QTemporaryDir>
#include <QTest>

#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <ctime>
#include <fstream>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

long megabytes() {
  malloc_trim(0);
  std::ifstream status("/proc/self/statm");
  long pages = 0, resident = 0;
  status >> pages >> resident;
  return resident * sysconf(_SC_PAGESIZE) >> 20;
}

long peak_megabytes() {
  rusage used{};
  ::getrusage(RUSAGE_SELF, &used);
  return used.ru_maxrss >> 10;
}

/// What this thread has worked, ms: does not depend on how busy the machine is.
double own_work() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

double seconds(const QElapsedTimer& clock) { return static_cast<double>(clock.elapsed()) / 1000; }

/// A move that is there at once: by way of the X server some come late, two in the time of one.
void move_mouse(QWidget* canvas, const QPoint& to) {
  QMouseEvent move(QEvent::MouseMove, to, canvas->mapToGlobal(to), Qt::NoButton, Qt::NoButton, Qt::NoModifier);
  QCoreApplication::sendEvent(canvas, &move);
}

/// Across the picture, twice: the first move after a picture reads depths, later ones do not. Until the window has been
/// painted.
void measure_hover(MainWindow& window) {
  QWidget* canvas = window.view().canvas();
  double sum = 0;
  int count = 0;
  std::vector<std::array<double, 4>> moves;  // ms; ms of own work; loop before, after
  for (int row : {canvas->height() / 2, canvas->height() / 3})
    for (int x = 40; x + 40 < canvas->width(); x += 7, ++count) {
      const int before = window.selection().hovered();
      QElapsedTimer clock;
      clock.start();
      const double cpu = own_work();
      move_mouse(canvas, {x, row});
      QCoreApplication::processEvents();
      const double ms = 1e-6 * static_cast<double>(clock.nsecsElapsed());
      sum += ms;
      moves.push_back(
          {ms, own_work() - cpu, static_cast<double>(before), static_cast<double>(window.selection().hovered())});
    }
  std::sort(moves.rbegin(), moves.rend());
  std::printf("hover: %.1f ms in the mean of %d moves; the slowest:\n", sum / count, count);
  for (std::size_t k = 0; k < 5; ++k)
    std::printf("  %.1f ms, of these %.1f ms own work, from loop %.0f to %.0f\n", moves[k][0], moves[k][1], moves[k][2],
                moves[k][3]);
}

void measure_opening(const QString& path) {
  Shown window({}, Shown::Extent::usual);
  linger(2500);
  GapMeter gaps;
  QElapsedTimer clock;
  clock.start();
  window.open(path);
  wait_until([&] { return !part<QWidget>(window, "welcome")->isVisible(); });
  std::printf("first picture after %.2f s\n", seconds(clock));
  wait_until([&] { return window.document().has_scan() && !window.controller().busy(); });
  std::printf("holes can be picked and filled after %.2f s\n", seconds(clock));
  wait_idle(window);
  std::printf("open, with holes and curvature, after %.2f s\n", seconds(clock));
  linger(500);
  gaps.report("opening");
  window.view().fly_to(0);
  linger(1500);
  gaps.report("flying");
  measure_hover(window);
  gaps.report("hovering");
  window.selection().select({0});
  clock.restart();
  press_and_wait(window, "fillAndSmooth");
  std::printf("a hole filled and smoothed after %.2f s\n", seconds(clock));
  linger(500);
  gaps.report("filled and smoothed");
  std::printf("memory at the peak: %ld MB\n", peak_megabytes());
}

/// Everything at once, on a window that has just appeared: no waiting for its graphics to be ready.
enum class Start { at_once, after_a_moment };

/// A person takes a moment to choose a file; meanwhile the window makes the graphics ready.
void measure_gaps(const QString& path, Start start) {
  std::printf(start == Start::at_once ? "a file opened at once:\n" : "a file opened after 3 s:\n");
  GapMeter gaps;
  Shown window({}, Shown::Extent::usual);
  gaps.report("the window appears");
  if (start == Start::after_a_moment) {
    linger(3000);
    gaps.report("nothing is done for 3 s");
  }
  window.open(path);
  wait_until([&] { return window.document().has_scan() && !window.controller().busy(); });
  gaps.report("bunny opened");
  press_and_wait(window, "fill");
  gaps.report("filled at once");
  press_and_wait(window, "fillAndSmooth", 300);
  gaps.report("to steady state");
  for (Qt::Key digit : {Qt::Key_4, Qt::Key_2, Qt::Key_3, Qt::Key_5, Qt::Key_1}) {
    key(window, digit);
    linger(300);
    gaps.report("shading");
  }
  key(window, Qt::Key_W);
  linger(300);
  gaps.report("wireframe");
  for (int k = 0; k < 2; ++k) key(window, Qt::Key_Z, Qt::ControlModifier);
  linger(200);
  gaps.report("undo");
}

void measure_frame_rate(const QTemporaryDir& folder) {
  const QString path = folder.filePath(QStringLiteral("million.ply"));
  // 1.3 million triangles; the cap that is missing takes 18 000 of them.
  write_mesh(path.toStdString(), cut(make_icosphere(8), [](const Vec3& p) { return p.z() > 0.9725; }));
  Shown window({path}, Shown::Extent::usual);
  window.view().fly_to(0);
  linger(2000);
  press_and_wait(window, "fill", 600);
  part<QSlider>(window, "sigma")->setValue(-20);
  const OpenPatch* patch = window.document().patch_of(0);
  if (!patch) return;
  const int triangles = patch->state->patch.patch_triangles, before = patch->state->steps;
  int pictures = 0, first_pictures = 0;
  QElapsedTimer clock;
  double moves = 0;  // s; from here on there are two states, and pictures between them
  const QMetaObject::Connection counting = QObject::connect(&window.view(), &MeshView::drawn, [&] {
    ++pictures;
    if (moves > 0 || window.document().patch_of(0)->timeline->size() < 3) return;
    moves = seconds(clock);
    first_pictures = pictures;
  });
  GapMeter gaps;
  clock.start();
  press(window, "run");
  wait_until([&] { return window.document().patch_of(0)->state->steps >= before + 5 || !window.controller().busy(); },
             60);
  const double time = seconds(clock);
  const int steps = window.document().patch_of(0)->state->steps - before;
  gaps.report("running");
  window.controller().cancel();
  std::printf("patch of %d triangles: %d steps in %.1f s; from the second on %.1f pictures a second\n", triangles,
              steps, time, (pictures - first_pictures) / std::max(0.1, time - moves));
  QObject::disconnect(counting);
  QObject::connect(&window.view(), &MeshView::drawn, [&] { ++pictures; });
  // Were the steps free: recorded states, one after another.
  const OpenPatch& moving = *window.document().patch_of(0);
  const int id = moving.id;
  pictures = 0;
  clock.start();
  for (std::size_t k = 0; clock.elapsed() < 8000; ++k) {
    window.controller().scrub_to({id}, k % moving.timeline->size());
    QCoreApplication::processEvents();
  }
  std::printf("its states as fast as they can be drawn: %.1f pictures a second\n", pictures / seconds(clock));
}

/// Of all threads of the program, the drawing ones among them.
double process_cpu_ms() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return 1e3 * static_cast<double>(now.tv_sec) + 1e-6 * static_cast<double>(now.tv_nsec);
}

constexpr int views = 4;
using Frames = std::array<int, views>;

Frames frames_of(CompareWindow& window) {
  Frames frames{};
  for (int k = 0; k < views; ++k) frames[k] = window.flow_view(k).canvas().frames();
  return frames;
}

void move_cameras(CompareWindow& window, const char* what) {
  double worst = 0, sum = 0;
  constexpr int moves = 10;
  for (int move = 0; move < moves; ++move) {
    CameraPose pose = window.flow_view(0).canvas().pose();
    pose.position += (move % 2 ? -0.05 : 0.05) * (pose.position - pose.focus).norm() * pose.up;
    const Frames before = frames_of(window);
    QElapsedTimer clock;
    clock.start();
    for (int k = 0; k < views; ++k) window.flow_view(k).canvas().set_pose(pose);
    wait_until([&] {
      const Frames now = frames_of(window);
      return std::equal(now.begin(), now.end(), before.begin(), std::greater<>());
    });
    const double ms = 1e-6 * static_cast<double>(clock.nsecsElapsed());
    worst = std::max(worst, ms);
    sum += ms;
  }
  std::printf("%s: a move of the camera in all four views takes %.0f ms, at worst %.0f\n", what, sum / moves, worst);
}

/// Were there no flows to be computed: two states, to and fro.
void draw_alone(CompareWindow& window, const std::array<SurfaceShapePtr, 2>& states) {
  const Frames before = frames_of(window);
  QElapsedTimer clock;
  clock.start();
  const double cpu = process_cpu_ms();
  std::size_t turn = 0;
  QTimer news;
  const auto show = [&] {
    for (int k = 0; k < views; ++k)
      window.flow_view(k).canvas().show_patch(0, states[turn % 2], Arrival::with_the_next);
    ++turn;
  };
  QObject::connect(&news, &QTimer::timeout, show);
  show();
  news.start(500);
  QEventLoop loop;
  QTimer::singleShot(5000, &loop, &QEventLoop::quit);
  loop.exec();
  int all = 0;
  const Frames now = frames_of(window);
  for (std::size_t k = 0; k < views; ++k) all += now[k] - before[k];
  std::printf(
      "drawing alone: %.1f pictures a second in each view, %.1f ms of processor time each, neighborhood in %d of %d\n",
      all / seconds(clock) / views, (process_cpu_ms() - cpu) / all, window.flow_view(0).canvas().neighborhood_drawn(),
      now[0]);
}

/// The state, swollen a little.
SurfaceShapePtr swollen(const SurfaceShape& shape) {
  auto other = std::make_shared<SurfaceShape>(shape);
  for (float& x : other->points) x *= 1.03F;
  return other;
}

enum class Part { all, drawing };

void measure_compare(const QTemporaryDir& folder, Part part_of_it) {
  const QString large = folder.filePath(QStringLiteral("large.ply"));
  write_mesh(large.toStdString(), cut(make_icosphere(6), [](const Vec3& p) { return p.z() > 0.5; }));
  Shown shown({large});
  CompareWindow* window = shown.comparisons().compare_holes({});
  if (!QTest::qWaitForWindowExposed(window)) return;
  auto* run = window->findChild<QPushButton*>(QStringLiteral("compareRun"));
  wait_until([&] { return run->isEnabled(); }, 240);
  if (const int width = qEnvironmentVariableIntValue("LOOPMEND_WIDTH")) window->resize(width, width * 2 / 3);
  linger(1500);
  const QSize size = window->flow_view(0).canvas().size();
  std::printf("four views of %d x %d pixels; %s\n", size.width(), size.height(),
              qPrintable(window->findChild<QLabel*>(QStringLiteral("compareWait"))->text()));
  move_cameras(*window, "at rest");
  const auto start = window->flow_comparison().start()->shape;
  draw_alone(*window, {start, swollen(*start)});
  for (int k = 0; k < views; ++k) window->flow_view(k).canvas().show_patch(0, start);
  if (part_of_it == Part::drawing) return;
  const auto moving = [&](int k) { return window->flow_comparison().flow_run(k)->stage == ComparedRun::Stage::moving; };
  GapMeter gaps;
  const Frames first = frames_of(*window);
  Frames last = first;
  std::array<double, views> time{};
  std::array<bool, views> seen{};
  QElapsedTimer clock;
  clock.start();
  QTest::mouseClick(run, Qt::LeftButton);
  bool turned = false;
  wait_until(
      [&] {
        if (!turned && clock.elapsed() > 4000) {
          turned = true;
          move_cameras(*window, "while the flows run");
        }
        for (std::size_t k = 0; k < views; ++k) {
          const bool moves = moving(static_cast<int>(k));
          if (moves || !seen[k]) {
            last[k] = frames_of(*window)[k];
            time[k] = seconds(clock);
          }
          seen[k] = seen[k] || moves;
        }
        return run->isEnabled();
      },
      400);
  for (int k = 0; k < views; ++k) {
    const auto at = static_cast<std::size_t>(k);
    std::printf("view %d: %d pictures in the %.1f s that its flow ran: %.1f a second; %s\n", k, last[at] - first[at],
                time[at], (last[at] - first[at]) / time[at],
                qPrintable(window->findChild<QLabel*>(QStringLiteral("paneFigures%1").arg(k))->text()));
  }
  gaps.report("four flows on a 20k patch");
}

void measure_memory(const QTemporaryDir& folder) {
  Shown window({sample_file(folder)}, Shown::Extent::usual);
  const long sample = megabytes();
  window.open(write_sheet_with_holes(folder.filePath(QStringLiteral("sheet.ply")), 30));
  wait_idle(window);
  const long opened = megabytes();
  press_and_wait(window, "fill", 200);
  press_and_wait(window, "fillAndSmooth", 200);
  const long filled = megabytes();
  while (window.undo().can_undo()) window.undo().undo();
  linger(300);
  const long undone = megabytes();
  // Undone is not forgotten: it can be done again, until something else is.
  window.selection().select({first_hole(window.document())});
  press_and_wait(window, "fill");
  linger(300);
  const long forgotten = megabytes();
  window.controller().open({sample_file(folder)}, OpenMode::replace);
  wait_idle(window);
  linger(300);
  std::printf(
      "memory in MB: sample %ld, sheet with 900 holes %ld, all filled and at rest %ld, undone %ld, undone and "
      "something "
      "else done %ld, closed for the sample %ld\n",
      sample, opened, filled, undone, forgotten, megabytes());
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    std::fputs("usage: measure_window DRAGON [BUNNY] [opening|gaps|memory|flow|compare|drawing ...]\n", stderr);
    return 2;
  }
  const QTemporaryDir home, folder;
  use_own_home(home.path());
  prepare_application();
  QApplication application(argc, argv);
  settle_application();
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const QStringList words = application.arguments().mid(2);
  const auto wanted = [&](const char* what) {
    const auto names = words.filter(QRegularExpression(QStringLiteral("^[a-z]+$")));
    return names.isEmpty() || names.contains(QLatin1String(what));
  };
  if (wanted("opening")) measure_opening(QString::fromLocal8Bit(argv[1]));
  if (wanted("gaps") && argc > 2)
    for (Start start : {Start::at_once, Start::after_a_moment}) measure_gaps(QString::fromLocal8Bit(argv[2]), start);
  if (wanted("memory")) measure_memory(folder);
  if (wanted("flow")) measure_frame_rate(folder);
  if (wanted("compare")) measure_compare(folder, Part::all);
  if (words.contains(QStringLiteral("drawing"))) measure_compare(folder, Part::drawing);
  return 0;
}
