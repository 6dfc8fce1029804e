// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests of the comparison window share.
#pragma once

#include "driver.h"

#include "compare/compare_controller.h"
#include "samples/analytic_surfaces.h"

#include <QPushButton>
#include <QTest>

namespace loopmend::testing {

/// A ball with an open cap: one hole, and every flow but MCF comes to rest on the sphere.
inline QString ball_file(const QTemporaryDir& folder) {
  return scan_file(folder, QStringLiteral("ball.ply"),
                   cut(make_icosphere(4), [](const Vec3& p) { return p.z() > 0.85; }));
}

inline CompareWindow* compare_window(MainWindow& window) {
  return window.findChild<CompareWindow*>(QStringLiteral("compareWindow"));
}

template <class T>
T* in(CompareWindow& window, const char* name) {
  return window.findChild<T*>(QLatin1String(name));
}

inline bool run_all(CompareWindow& window) {
  auto* run = in<QPushButton>(window, "compareRun");
  if (!wait_until([&] { return run->isEnabled(); })) return false;
  QTest::mouseClick(run, Qt::LeftButton);
  return wait_until([&] { return run->isEnabled(); }, 240);
}

}  // namespace loopmend::testing
