// SPDX-License-Identifier: GPL-3.0-or-later
// Independent pieces of work on as many threads as there are cores.
#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace loopmend {

/// work(k) for k = 0..count−1, begun in this order. Without further threads all is done here. The threads step back behind
/// the window's as the one that calls does. Throws what work throws first; the rest is then not begun.
template <class Work>
void in_parallel(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto go = [&] {
    for (std::size_t k = next++; k < count; k = next++) try {
        work(k);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
  };
  {
    std::vector<std::jthread> helpers;
    const std::size_t threads = std::min<std::size_t>(std::max(1u, std::thread::hardware_concurrency()), count);
    try {
      for (std::size_t t = 1; t < threads; ++t) helpers.emplace_back(go);
    } catch (const std::system_error&) {
      // No further thread is to be had: those that are there do all the work.
    }
    go();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace loopmend
