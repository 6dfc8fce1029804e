// Drives the real window as a person would; shared by the GUI tests and the screenshot tool.
#pragma once

#include "views/main_window.h"
#include "views/mesh_view.h"

#include <QImage>

#include <functional>

namespace loopmend::testing {

/// To be called before and after QApplication is made, as main.cpp does.
void prepare_application();
void settle_application();

/// Runs the event loop until `holds`, at most `seconds`. @returns whether it holds.
bool wait_until(const std::function<bool()>& holds, double seconds = 60);
bool wait_idle(MainWindow& window, double seconds = 120);
/// Lets drawing catch up.
void settle(int milliseconds = 120);

template <class T>
T* part(MainWindow& window, const char* name) {
  return window.findChild<T*>(QLatin1String(name));
}
void press(MainWindow& window, const char* button);

/// A pixel on the loop's line where nothing hides it, in canvas coordinates; by trying its vertices.
QPoint visible_point(MainWindow& window, int loop);

/// How many different colours a picture has, counted up to `enough`.
int count_colors(const QImage& image, int enough = 64);

}  // namespace loopmend::testing
