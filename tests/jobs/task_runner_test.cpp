// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/task_runner.h"

#include <QCoreApplication>

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <future>
#include <stdexcept>

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

void handle_events_until(const std::function<bool()>& holds) {
  while (!holds()) QCoreApplication::processEvents(QEventLoop::WaitForMoreEvents, 100);
}

TEST(TaskRunner, WhatAWorkerThrowsIsToldOnTheWindowsThread) {
  QObject window_side;
  TaskRunner runner;
  QString told;
  const auto job = std::make_shared<Job>(&window_side);
  runner.start(
      job, [] { throw std::runtime_error("no such file"); },
      [&, here = std::this_thread::get_id()](const QString& words) {
        EXPECT_EQ(std::this_thread::get_id(), here);
        told = words;
      });
  handle_events_until([&] { return !told.isEmpty(); });
  EXPECT_EQ(told, QStringLiteral("no such file"));
}

TEST(TaskRunner, AJobThatWasGivenUpIsNotHeard) {
  QObject window_side;
  TaskRunner runner;
  bool told = false, heard = false;
  const auto first = std::make_shared<Job>(&window_side), second = std::make_shared<Job>(&window_side);
  std::promise<void> go_on;
  runner.start(
      first,
      [&, until = go_on.get_future().share()] {
        until.wait();
        throw std::runtime_error("too late");
      },
      [&](const QString&) { told = true; });
  first->cancel();  // the worker is at work, and the window does not wait for it
  go_on.set_value();
  EXPECT_TRUE(runner.wait(std::chrono::minutes(1)));
  runner.run(
      second, [] { return 7; }, [&](int seven) { heard = seven == 7; }, [](const QString&) {});
  handle_events_until([&] { return heard; });
  EXPECT_FALSE(told);
}

#ifdef __linux__
/// In a process of its own, as a user for whom the system starts no further thread.
TEST(TaskRunnerDeathTest, WhereNoThreadIsToBeHadThatIsTold) {
  testing::FLAGS_gtest_death_test_style = "threadsafe";  // a fork alone would have this process's threads half
  const auto without_threads = [] {
    constexpr uid_t nobody = 65534;
    if (geteuid() == 0 && setresuid(nobody, nobody, nobody) != 0) std::_Exit(1);
    const rlimit none{0, 0};
    if (setrlimit(RLIMIT_NPROC, &none) != 0) std::_Exit(1);
    QObject window_side;
    TaskRunner runner;
    QString told;
    runner.start(
        std::make_shared<Job>(&window_side), [] { std::_Exit(1); }, [&](const QString& words) { told = words; });
    handle_events_until([&] { return !told.isEmpty(); });
    std::fputs(qPrintable(told), stderr);
    std::_Exit(0);
  };
  EXPECT_EXIT(without_threads(), testing::ExitedWithCode(0), "ulimit -u");
}
#endif

}  // namespace
}  // namespace loopmend
