// SPDX-License-Identifier: GPL-3.0-or-later
// Loops and pairs of work shared by threads, and how many threads that may take. On oneTBB, which stays in the .cpp file.
// Calls may be nested: an idle thread helps with the calls that others have begun.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <type_traits>
#include <utility>

namespace loopmend {

/// Threads that the caller's work may be shared by, the calling thread included: at most one for each core, and fewer where
/// the system grants no more. At least 1.
int thread_budget();

void call_with_thread_budget(int n, const std::function<void()>& f);

/// Calls f() on this thread. Work that it shares takes at most n threads, this one included; a budget within another can only
/// shrink it. @param n  0: as many as before. @returns what f() returned.
template <class F>
auto with_thread_budget(int n, const F& f) {
  using Result = decltype(f());
  if constexpr (std::is_void_v<Result>) {
    call_with_thread_budget(n, f);
  } else {
    std::optional<Result> result;
    call_with_thread_budget(n, [&] { result.emplace(f()); });
    return std::move(*result);
  }
}

/// Work that a free thread does beside the calling one; or else finish() does it. To be made, finished and destroyed by one
/// thread, within one call of anything else in this file.
class SideWork {
 public:
  explicit SideWork(std::function<void()> work);
  /// Waits if the work has begun; otherwise it is dropped.
  ~SideWork();
  SideWork(const SideWork&) = delete;
  SideWork& operator=(const SideWork&) = delete;
  /// Returns when the work is done. @throws what it threw.
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// first() and second(), which must not touch what the other writes: side by side where a thread is free; with one thread in
/// this order. Worth it from some hundredths of a millisecond each on.
/// @throws what first() threw, in which case second() may not have run; else what second() threw.
template <class First, class Second>
void parallel_invoke(const First& first, const Second& second) {
  SideWork beside([&second] { second(); });
  first();
  beside.finish();
}

using LoopPart = std::function<void(int begin, int end)>;  ///< does the indices from `begin` to before `end`

/// What parallel_for is made of. @param make_part  called once by each thread that takes part.
void share_loop(int begin, int end, int grain, const std::function<LoopPart()>& make_part);

/// f(i, scratch) for begin <= i < end. Threads take `grain` successive indices at a time, in order, and each has a scratch of
/// its own; a loop of no more than `grain` stays on this thread. The result is the same for any number of threads if each
/// index writes to its own place alone, and nothing that it reads from the scratch depends on other indices.
/// @throws what the lowest failing index threw, as a serial loop would; some higher ones may have run.
template <class MakeScratch, class F>
void parallel_for(int begin, int end, int grain, const MakeScratch& make_scratch, const F& f) {
  share_loop(begin, end, grain, [&]() -> LoopPart {
    return [&f, scratch = make_scratch()](int from, int to) mutable {
      for (int i = from; i < to; ++i) f(i, scratch);
    };
  });
}

/// The same with f(i).
template <class F>
void parallel_for(int begin, int end, int grain, const F& f) {
  parallel_for(
      begin, end, grain, [] { return 0; }, [&f](int i, int) { f(i); });
}

}  // namespace loopmend
