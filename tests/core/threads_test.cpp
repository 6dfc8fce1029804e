// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/threads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace loopmend {
namespace {

using ThreadIds = std::set<std::thread::id>;

/// The threads that take part in loops, in pairs and in these within each other.
ThreadIds threads_at_work() {
  ThreadIds ids;
  std::mutex mutex;
  const auto note = [&] {
    std::this_thread::sleep_for(std::chrono::microseconds(100));
    const std::lock_guard lock(mutex);
    ids.insert(std::this_thread::get_id());
  };
  parallel_for(0, 50, 1, [&](int) {
    parallel_invoke(note, note);
    parallel_for(0, 4, 1, [&](int) { note(); });
  });
  return ids;
}

TEST(ThreadBudget, OneIsTheCallingThreadAlone) {
  EXPECT_EQ(with_thread_budget(1, thread_budget), 1);
  EXPECT_EQ(with_thread_budget(1, threads_at_work), ThreadIds{std::this_thread::get_id()});
}

TEST(ThreadBudget, IsTakenUpAndNotExceeded) {
  const int all = thread_budget();
  EXPECT_LE(all, static_cast<int>(std::thread::hardware_concurrency()));
  bool several = threads_at_work().size() > 1;
  for (int again = 0; all > 1 && !several && again < 100; ++again)
    several = threads_at_work().size() > 1;  // on a busy machine
  EXPECT_EQ(several, all > 1);
  for (int budget : {2, 3}) {
    if (budget > all) continue;
    with_thread_budget(budget, [&] {
      EXPECT_EQ(thread_budget(), budget);
      EXPECT_LE(threads_at_work().size(), static_cast<std::size_t>(budget));
    });
  }
}

TEST(ThreadBudget, HoldsOnEveryThreadAndOnlyShrinks) {
  const int all = thread_budget();
  with_thread_budget(0, [&] { EXPECT_EQ(thread_budget(), all); });
  with_thread_budget(1000, [&] { EXPECT_EQ(thread_budget(), all); });
  std::atomic<int> wrong = 0;
  parallel_for(0, 100, 1, [&](int) {
    wrong += thread_budget() != all;
    with_thread_budget(1, [&] { with_thread_budget(2, [&] { wrong += thread_budget() != 1; }); });
  });
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(thread_budget(), all);
}

TEST(ThreadBudget, LetsExceptionsThrough) {
  EXPECT_THROW(with_thread_budget(1, [] { throw std::runtime_error("spoilt"); }), std::runtime_error);
}

TEST(ParallelFor, DoesEveryIndexOnceByAnyBudget) {
  for (int budget : {1, 0})
    with_thread_budget(budget, [&] {
      for (int grain : {1, 7, 64, 1000})
        for (int count : {0, 1, 63, 64, 65, 500}) {
          std::vector<int> done(count, 0);
          parallel_for(100, 100 + count, grain, [&](int i) { ++done[i - 100]; });
          EXPECT_EQ(done, std::vector<int>(count, 1)) << grain << " " << count;
        }
    });
}

TEST(ParallelFor, GivesTheSameBitsByAnyBudget) {
  const auto sums = [](int budget) {
    std::vector<double> sum(3000, 0.0);
    with_thread_budget(budget, [&] {
      parallel_for(
          0, 3000, 16, [] { return std::vector<double>(50); },
          [&](int i, std::vector<double>& scratch) {
            for (int k = 0; k < 50; ++k) scratch[k] = std::sin(0.37 * i * k);
            for (double value : scratch) sum[i] += value;
          });
    });
    return sum;
  };
  EXPECT_EQ(sums(1), sums(0));
}

TEST(ParallelFor, GivesEachThreadAScratchOfItsOwn) {
  std::atomic<int> made = 0, shared = 0;
  struct Scratch {
    std::thread::id owner = std::this_thread::get_id();
  };
  const auto make_scratch = [&] {
    ++made;
    return Scratch();
  };
  parallel_for(0, 1000, 1, make_scratch, [&](int, Scratch& scratch) {
    parallel_for(0, 3, 1, [](int) {});
    shared += scratch.owner != std::this_thread::get_id();
  });
  EXPECT_EQ(shared, 0);
  EXPECT_GE(made, 1);
  EXPECT_LE(made, thread_budget());
}

std::string thrown_by(const std::function<void()>& f) {
  try {
    f();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "nothing";
}

TEST(ParallelFor, ThrowsWhatTheLowestFailingIndexThrew) {
  for (int budget : {1, 0})
    with_thread_budget(budget, [] {
      for (int repeat = 0; repeat < 200; ++repeat) {
        std::atomic<int> before = 0;
        const auto loop = [&] {
          parallel_for(0, 1000, 3, [&](int i) {
            if (i >= 400) throw std::runtime_error(std::to_string(i));
            ++before;
          });
        };
        ASSERT_EQ(thrown_by(loop), "400");
        ASSERT_EQ(before, 400);
      }
    });
}

TEST(ParallelInvoke, WithOneThreadKeepsTheOrder) {
  std::vector<int> order;
  with_thread_budget(1, [&] { parallel_invoke([&] { order.push_back(1); }, [&] { order.push_back(2); }); });
  EXPECT_EQ(order, (std::vector<int>{1, 2}));
}

TEST(ParallelInvoke, ThrowsWhatTheFirstThrewOrElseTheSecond) {
  const auto fail = [](const char* what) { return [what] { throw std::runtime_error(what); }; };
  for (int budget : {1, 0})
    with_thread_budget(budget, [&] {
      for (int repeat = 0; repeat < 200; ++repeat) {
        bool other = false;
        ASSERT_EQ(thrown_by([&] { parallel_invoke([&] { other = true; }, fail("second")); }), "second");
        ASSERT_TRUE(other);
        ASSERT_EQ(thrown_by([&] { parallel_invoke(fail("first"), [] {}); }), "first");
        ASSERT_EQ(thrown_by([&] { parallel_invoke(fail("first"), fail("second")); }), "first");
      }
    });
}

TEST(SideWork, IsDroppedUnlessItHasBegun) {
  with_thread_budget(1, [] {
    bool done = false;
    {
      const SideWork dropped([&] { done = true; });
    }
    EXPECT_FALSE(done);
    SideWork finished([&] { done = true; });
    EXPECT_FALSE(done);
    finished.finish();
    EXPECT_TRUE(done);
  });
  for (int repeat = 0; repeat < 200; ++repeat) {
    std::atomic<bool> alive = true, late = false;
    {
      const SideWork ended([&] { late = late || !alive; });
    }
    alive = false;
    ASSERT_FALSE(late);
  }
}

/// 2^depth leaves.
long leaves(int depth) {
  if (depth == 0) return 1;
  long left = 0, right = 0;
  parallel_invoke([&] { left = leaves(depth - 1); }, [&] { right = leaves(depth - 1); });
  return left + right;
}

TEST(Threads, NestedLoadEndsFromSeveralCallersAtOnce) {
  std::vector<long> sums(8, 0);
  std::vector<std::jthread> callers;
  callers.reserve(sums.size());
  for (long& sum : sums)
    callers.emplace_back([&sum] {
      std::vector<long> parts(100, 0);
      parallel_for(0, 100, 1, [&](int i) { parts[i] = leaves(6); });
      for (long part : parts) sum += part;
    });
  callers.clear();
  EXPECT_EQ(sums, std::vector<long>(8, 6400));
}

}  // namespace
}  // namespace loopmend
