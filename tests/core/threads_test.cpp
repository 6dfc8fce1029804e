// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/threads.h"

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace loopmend {
namespace {

TEST(SideBySide, DoesBothAndSharesTheThreads) {
  for (int threads : {1, 2, 5}) {
    const ThreadAllowance allowance(threads);
    for (int repeat = 0; repeat < 50; ++repeat) {
      int first = 0, second = 0;
      side_by_side([&] { first = omp_get_max_threads(); }, [&] { second = omp_get_max_threads(); });
      EXPECT_EQ(first, threads - threads / 2);
      // Half of the threads in a thread of its own; all of them where it is done here, after the first.
      EXPECT_TRUE(second == threads || second == threads / 2) << second;
      EXPECT_EQ(omp_get_max_threads(), threads);
    }
  }
}

TEST(SideBySide, TheFirstHasAllThreadsOnceTheSecondHasEnded) {
  const ThreadAllowance allowance(4);
  int within = 0, set_by_hand = 0, shared = 0;
  side_by_side(
      [&] {
        while (ThreadAllowance::now() < 4) std::this_thread::yield();
        {
          const ThreadAllowance alone(1);
          set_by_hand = ThreadAllowance::now();
        }
        side_by_side([&] { within = omp_get_max_threads(); }, [] {});
        std::atomic<int> workers{0};
        share_work(least_for_threads + 1, [&] { ++workers; });
        shared = workers;
      },
      [] {});
  EXPECT_EQ(within, 2);
  EXPECT_EQ(set_by_hand, 1);
  EXPECT_EQ(shared, 4);
  EXPECT_EQ(ThreadAllowance::now(), 4);
}

TEST(SideBySide, OneThreadKeepsTheOrder) {
  const ThreadAllowance allowance(1);
  std::vector<int> order;
  side_by_side([&] { order.push_back(1); }, [&] { order.push_back(2); });
  EXPECT_EQ(order, (std::vector<int>{1, 2}));
}

TEST(SideBySide, ThrowsWhatEitherThrowsOnceBothHaveEnded) {
  for (int threads : {1, 2}) {
    const ThreadAllowance allowance(threads);
    const auto fail = [] { throw std::runtime_error("spoilt"); };
    bool other = false;
    EXPECT_THROW(side_by_side([&] { other = true; }, fail), std::runtime_error);
    EXPECT_TRUE(other);
    EXPECT_THROW(side_by_side(fail, [] {}), std::runtime_error);
    EXPECT_EQ(omp_get_max_threads(), threads);
  }
}

TEST(ShareWork, DoesEveryPieceOnce) {
  const ThreadAllowance allowance(2);
  for (int vertices : {10, least_for_two + 1, least_for_threads + 1}) {
    std::vector<std::atomic<int>> done(200);
    std::atomic<int> next{0};
    share_work(vertices, [&] {
      for (int k = next++; k < 200; k = next++) ++done[k];
    });
    for (const auto& count : done) EXPECT_EQ(count, 1);
  }
}

}  // namespace
}  // namespace loopmend
