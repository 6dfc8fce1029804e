// SPDX-License-Identifier: GPL-3.0-or-later
// The `loopmend` command line.
#include "dispatch.h"
#include "interrupt.h"
#include "library_start.h"

#include "core/memory.h"

#include <clocale>
#include <cstdio>
#include <cstdlib>

int main(int argc, char** argv) {
  loopmend::keep_freed_memory();
  std::setlocale(LC_NUMERIC, "C");
  loopmend::handle_signals();
  loopmend::deliver_interrupts();
  const int code = loopmend::dispatch(argc, argv);
  // Not exit(): OpenBLAS would then wait for a thread of its own that, where `ulimit -v` is tight, asks for memory for ever.
  std::fflush(nullptr);
  std::_Exit(code);
}
