// SPDX-License-Identifier: GPL-3.0-or-later
// loopmend-gui: starts the window.
#include "cli/interrupt.h"
#include "core/memory.h"
#include "document/language.h"
#include "document/preferences.h"
#include "io/atomic_file.h"
#include "jobs/autosave.h"
#include "views/main_window.h"
#include "views/mesh_view.h"
#include "window_start.h"

#include <QApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QThread>

#include <algorithm>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <latch>
#include <string>
#include <string_view>
#include <system_error>
#include <thread>
#include <vector>

namespace {

constexpr int exit_usage = 2;
constexpr int exit_no_display = 1;
constexpr int exit_no_memory = 5;

constexpr const char* help =
    "loopmend-gui - close holes in scanned meshes, in a window\n"
    "\n"
    "Usage: loopmend-gui [FILE...]\n"
    "\n"
    "  FILE       scans to open in one scene (PLY, STL, OBJ, OFF, glTF, 3MF or VTK polydata), or one saved session\n"
    "  --help     print this and exit\n"
    "  --version  print the version and exit\n"
    "\n"
    "Example: loopmend-gui bunny.ply\n"
    "Without a display, use the command line: loopmend --help\n";

/// @returns the exit code when there is nothing more to do, −1 otherwise.
int answer_options(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    const std::string_view word = argv[i];
    if (word == "--help" || word == "-h") {
      std::fputs(help, stdout);
      return 0;
    }
    if (word == "--version") {
      std::printf("loopmend-gui %s\n", LOOPMEND_VERSION);
      return 0;
    }
    if (word == "--") break;
    if (word.size() > 1 && word.front() == '-' && word != "-platform" && word != "-style") {
      std::fprintf(stderr, "loopmend-gui: unknown option %s. See loopmend-gui --help.\n", argv[i]);
      return exit_usage;
    }
  }
  return -1;
}

/// Qt ends the program when it cannot reach the display; before it does, say so in words.
void explain_and_leave(QtMsgType type, const QMessageLogContext&, const QString& message) {
  if (type != QtFatalMsg) return;
  std::fprintf(
      stderr,
      "loopmend-gui: the display cannot be reached, or Qt's plugin for it is missing. Check DISPLAY, or use the "
      "command line: loopmend --help\n(Qt says: %s)\n",
      qPrintable(message.section(QLatin1Char('\n'), 0, 0)));
  std::_Exit(exit_no_display);
}

void leave_without_opengl(const QString& reason) {
  std::fprintf(
      stderr,
      "loopmend-gui: this display has no OpenGL 3.2, with which the window draws%s. Install a graphics driver (Debian: "
      "libgl1-mesa-dri), or use the command line: loopmend --help\n",
      reason.isEmpty() ? "" : qPrintable(QStringLiteral(" (Qt says: ") + reason + QLatin1Char(')')));
  std::_Exit(exit_no_display);
}

/// Draws nothing. Where no context can be made, Qt and VTK end the program without a reason once the view appears.
void check_opengl() {
  qInstallMessageHandler([](QtMsgType type, const QMessageLogContext&, const QString& message) {
    if (type == QtFatalMsg) leave_without_opengl(message.section(QLatin1Char('\n'), 0, 0));
  });
  QOffscreenSurface surface;
  surface.create();
  QOpenGLContext context;
  if (!context.create() || !context.makeCurrent(&surface) || context.format().version() < qMakePair(3, 2))
    leave_without_opengl({});
  context.doneCurrent();
  qInstallMessageHandler(nullptr);
}

/// Whether the system would start so many threads beside those that run.
bool can_start(int threads) {
  std::latch end(1);
  std::vector<std::jthread> others;
  bool all = true;
  try {
    while (static_cast<int>(others.size()) < threads) others.emplace_back([&end] { end.wait(); });
  } catch (const std::system_error&) {
    all = false;
  }
  end.count_down();
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  loopmend::find_console();
  loopmend::keep_freed_memory();
  static const std::string last_words = "loopmend-gui: a copy of what was not saved may be in " +
                                        loopmend::Autosave::place().toStdString() +
                                        "; it is offered at the next start\n";
  loopmend::handle_signals(last_words.c_str());
  if (const int code = answer_options(argc, argv); code >= 0) {
    std::fflush(stdout);
    std::_Exit(code);
  }
  if (loopmend::claim_work_memory(QThread::idealThreadCount()) == 0) {
    std::fprintf(stderr,
                 "loopmend-gui: the address space of this process is limited (ulimit -v) and there is too little left "
                 "of it for the work (%zu MB). "
                 "Raise the limit.\n",
                 loopmend::least_work_memory >> 20);
    std::_Exit(exit_no_memory);
  }
  // Qt and the graphics driver wait for ever, behind a black window, for threads that they could not start. Ten at once were
  // counted on two cores; how many more there are on many cores is not known.
  if (const int needed = 8 + 2 * std::min(QThread::idealThreadCount(), 8); !can_start(needed)) {
    std::fprintf(
        stderr,
        "loopmend-gui: the window needs %d threads, and the system allows this user no more so many (ulimit -u). "
        "Close other programs or raise that limit, or use the command line, which needs one: loopmend --help\n",
        needed);
    std::_Exit(exit_no_memory);
  }
  if (!loopmend::has_display()) {
    std::fputs(
        "loopmend-gui: there is no display to open a window on (neither DISPLAY nor WAYLAND_DISPLAY is set). "
        "Start it from a desktop session, or use the command line: loopmend --help\n",
        stderr);
    std::_Exit(exit_no_display);
  }
  loopmend::MeshView::prepare_graphics();
  QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
  QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
  QApplication::setApplicationName(QStringLiteral("Loopmend"));
  QApplication::setApplicationVersion(QStringLiteral(LOOPMEND_VERSION));
  QApplication::setDesktopFileName(QStringLiteral("org.loopmend.Loopmend"));
  qInstallMessageHandler(explain_and_leave);
  QApplication application(argc, argv);
  check_opengl();
  std::setlocale(LC_NUMERIC, "C");
  QApplication::setStyle(QStringLiteral("Fusion"));
  loopmend::install_language(loopmend::load_preferences().language);

  loopmend::MainWindow window;
  window.restore_layout();
  window.show();
  QStringList files = QApplication::arguments().mid(1);
  files.removeAll(QStringLiteral("--"));
  if (!files.isEmpty()) window.open(files);
  window.offer_recovery();
  const int code = QApplication::exec();
  window.keep_layout();
  if (!window.shut_down(std::chrono::seconds(5))) {
    // A worker is deep inside one factorisation. Nothing half-written may stay behind.
    loopmend::remove_unfinished_files();
    std::_Exit(code);
  }
  return code;
}
