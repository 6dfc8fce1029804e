// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/thread_priority.h"

#include <windows.h>

namespace loopmend {

void yield_to_window(Yielding yielding) {
  ::SetThreadPriority(::GetCurrentThread(),
                      yielding == Yielding::mostly ? THREAD_PRIORITY_BELOW_NORMAL : THREAD_PRIORITY_LOWEST);
}

}  // namespace loopmend
