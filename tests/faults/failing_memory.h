// SPDX-License-Identifier: GPL-3.0-or-later
// Takes the place of malloc and operator new in the program that links failing_memory.cpp: counts what is asked for, refuses the
// n-th request, or sets a token at it.
#pragma once

#include "core/cancel.h"

#include <limits>

namespace loopmend::test {

inline constexpr long never = std::numeric_limits<long>::max();

struct MemoryPlan {
  long first_refused = never;                                    ///< number of the request, from 0
  enum class After { granted, refused } after = After::granted;  ///< requests behind that one
  long cancel_at = never;                                        ///< number of the request at which `token` is set
  CancelToken token;
};

/// While it lives, the plan counts for all threads. One at a time.
class WithPlan {
 public:
  explicit WithPlan(const MemoryPlan& plan);
  ~WithPlan();
  WithPlan(const WithPlan&) = delete;
  WithPlan& operator=(const WithPlan&) = delete;
  /// Requests so far. Those of libraries that have no way to fail are granted and not counted: libc, oneTBB, OpenBLAS, OpenMP, GMP.
  static long requests();
};

/// Blocks that are in use now, whoever asked for them.
long blocks_in_use();

}  // namespace loopmend::test
