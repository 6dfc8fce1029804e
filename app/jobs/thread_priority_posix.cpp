// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/thread_priority.h"

#include <sys/resource.h>
#include <sys/syscall.h>
#include <unistd.h>

namespace loopmend {

void yield_to_window(Yielding yielding) {
  const int steps_back = yielding == Yielding::mostly ? 7 : 19;
  // Linux gives every thread a niceness of its own. Beyond the least priority it stops there.
  const auto thread = static_cast<id_t>(::syscall(SYS_gettid));
  ::setpriority(PRIO_PROCESS, thread, ::getpriority(PRIO_PROCESS, thread) + steps_back);
}

}  // namespace loopmend
