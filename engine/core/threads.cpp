// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/threads.h"

namespace loopmend {

void share_work(int vertices, const std::function<void()>& work) {
  if (vertices > least_for_threads) {
#pragma omp parallel num_threads(ThreadAllowance::now())
    work();
  } else if (vertices > least_for_two) {
    side_by_side(work, work);
  } else {
    work();
  }
}

}  // namespace loopmend
