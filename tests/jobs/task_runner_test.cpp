// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/task_runner.h"

#include <gtest/gtest.h>

#include <future>

namespace loopmend {
namespace {

/// The first writer is at work when it is given up and a second one comes: the second waits, so that its file is the last.
TEST(WriteTurns, ALaterWriterWaitsForOneThatWasGivenUp) {
  WriteTurns turns;
  Job first(nullptr), second(nullptr);
  std::promise<void> begun, go_on;
  std::vector<int> written;
  std::thread slow([&] {
    turns.take(first, [&] {
      begun.set_value();
      go_on.get_future().wait();
      written.push_back(1);
      return true;
    });
  });
  begun.get_future().wait();
  first.cancel();
  std::thread fast([&] {
    turns.take(second, [&] {
      written.push_back(2);
      return true;
    });
  });
  go_on.set_value();
  slow.join();
  fast.join();
  EXPECT_EQ(written, (std::vector<int>{1, 2}));
}

TEST(WriteTurns, AWriterThatWasGivenUpBeforeItsTurnDoesNotBegin) {
  WriteTurns turns;
  Job job(nullptr);
  job.cancel();
  bool begun = false;
  EXPECT_FALSE(turns.take(job, [&] { return begun = true; }));
  EXPECT_FALSE(begun);
}

}  // namespace
}  // namespace loopmend
