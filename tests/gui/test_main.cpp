// SPDX-License-Identifier: GPL-3.0-or-later
// The main function of all programs that test the window.
#include "test_main.h"

#include "driver.h"

#include <QApplication>
#include <QTemporaryDir>
#include <QTest>

#include <cstdio>
#include <cstring>

using namespace loopmend;
using namespace loopmend::testing;

namespace {

/// Started by a test, with its home, to be killed: fills one hole, waits for its own autosave, tells, and hangs around.
int be_a_victim(const QString& scan) {
  Shown window({scan});
  window.autosave().set_delay(0);
  window.selection().select({first_hole(window.document())});
  bool written = false;
  QObject::connect(&window.autosave(), &Autosave::written, [&] { written = true; });
  press(window, "fill");
  if (!wait_idle(window) || !wait_until([&] { return written; }, 30)) return 1;
  std::puts("saved");
  std::fflush(stdout);
  linger(60000);
  return 1;
}

}  // namespace

int main(int argc, char** argv) {
  const bool victim = argc > 2 && std::strcmp(argv[1], "--victim") == 0;
  const QTemporaryDir home;
  if (!victim) use_own_home(home.path());
  prepare_application();
  QApplication application(argc, argv);
  settle_application();
  if (victim) return be_a_victim(QString::fromLocal8Bit(argv[2]));
  return QTest::qExec(make_test().get(), argc, argv);
}
