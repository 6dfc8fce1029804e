// SPDX-License-Identifier: GPL-3.0-or-later
// Drives the real window as a person would; shared by the GUI tests and the screenshot tool.
#pragma once

#include "views/main_window.h"
#include "views/mesh_view.h"

#include <QDialog>
#include <QElapsedTimer>
#include <QImage>
#include <QTemporaryDir>
#include <QTimer>

#include <functional>

namespace loopmend::testing {

/// Whether LOOPMEND_AT_LENGTH asks for what takes long and proves little more each day: large scans, every shared scan.
bool at_length();
constexpr const char* for_the_night = "takes long: .ci/nightly runs it, with LOOPMEND_AT_LENGTH=1";

/// To be called before and after QApplication is made, as main.cpp does.
void prepare_application();
void settle_application();

/// Runs the event loop until `holds`, at most `seconds`, which is for a machine with much else to do. @returns whether it holds.
bool wait_until(const std::function<bool()>& holds, double seconds = 120);
bool wait_idle(MainWindow& window, double seconds = 240);
/// Flies to a loop and waits until the camera is there.
bool fly(MainWindow& window, int loop);
/// Runs the event loop until nothing is due in any window: pictures, flights, tables and layouts have come to rest. While a
/// flow runs they do not. @returns false after two minutes.
bool settle();
/// As long as a person looks. For pictures and measurements; a test waits for what it needs.
void linger(int milliseconds);

/// Does this with the next modal dialog as soon as it is on the screen, and closes it if it is still there: exec() would
/// wait for ever.
class WhenAsked : public QObject {
 public:
  explicit WhenAsked(std::function<void(QDialog&)> answer);

 private:
  QTimer timer_;
};

/// Opens what hides the widget and scrolls to it, as a person would: a dock, a fold of a panel.
void reveal(QObject* widget);
template <class T>
T* part(MainWindow& window, const char* name) {
  T* found = window.findChild<T*>(QLatin1String(name));
  reveal(found);
  return found;
}
void press(MainWindow& window, const char* button);
/// And waits until what it begins has ended. @returns whether it has.
bool press_and_wait(MainWindow& window, const char* button, double seconds = 240);
/// Presses the button, which shows first what it would change, and lets it. @returns whether the change is made.
bool press_and_apply(MainWindow& window, const char* button);
/// Applies the change that the preview proposes, once it is shown.
bool apply_proposal(MainWindow& window);
/// As from a menu.
void trigger(MainWindow& window, const char* action);

void key(MainWindow& window, Qt::Key which, Qt::KeyboardModifiers with = {});

/// A window on the screen, with these files open. A small one has half as many pixels to draw as one of the size that it has at first.
class Shown : public MainWindow {
 public:
  enum class Extent { small, usual };
  explicit Shown(const QStringList& paths = {}, Extent extent = Extent::small);
  ~Shown() override;
  bool exposed = false, ready = false;
};

/// A scan as a file in this folder. @returns its path.
QString scan_file(const QTemporaryDir& folder, const QString& name, const TriangleSoup& soup);
/// The embedded sample as a file in this folder.
QString sample_file(const QTemporaryDir& folder);
/// The first loop that is a hole.
int first_hole(const Document& document);
/// How many holes have no patch.
int open_holes(const Document& document);

/// Everything that a person can read or hear of an object: each of its properties that holds text.
QStringList texts_of(const QObject& object);

/// A pixel on the loop's line where nothing hides it, in canvas coordinates; by trying its vertices.
QPoint visible_point(MainWindow& window, int loop);

/// A file with a plane sheet of `across` by `across` square holes, each of eight edges.
QString write_sheet_with_holes(const QString& path, int across);

/// The share of pixels that differ.
double share_changed(const QImage& a, const QImage& b);

/// Waits until the picture differs from `before`, or is like it again: drawing takes its time on a busy machine.
bool picture_changes(MainWindow& window, const QImage& before, double share);
bool picture_returns(MainWindow& window, const QImage& before);

/// The longest time that the event loop did not come round: what a person feels as a window that hangs.
class GapMeter : public QObject {
 public:
  GapMeter();
  /// Prints the longest gap since the last report. @returns the longest work of this thread in one, ms of the processor: a busy machine
  /// makes gaps, too.
  double report(const char* what);

 private:
  QTimer timer_;
  QElapsedTimer clock_;
  qint64 worst_ = 0;
  double cpu_ = 0, worst_cpu_ = 0;  ///< of this thread: what does not depend on how busy the machine is
};

/// Keeps settings and recovery files of the test out of the user's own. To be called before QApplication is made.
void use_own_home(const QString& folder);

/// How many different colours a picture has, counted up to `enough`.
int count_colors(const QImage& image, int enough = 64);

}  // namespace loopmend::testing
