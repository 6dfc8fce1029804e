// SPDX-License-Identifier: GPL-3.0-or-later
// Signals, and streams that are not read: the exit code says so, files are old or new and whole, and nothing is left behind.
#include "cli/run_program.h"

#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "samples/analytic_surfaces.h"

#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <functional>
#include <map>
#include <thread>

namespace loopmend {
namespace {

using test::text_of;
using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

class Signals : public test::ProgramTest {
 protected:
  /// A shell's background job ignores SIGINT, nohup's SIGHUP: neither may reach a child, not even before its first line.
  Signals() {
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU, SIGPIPE})
      inherited[signal] = std::signal(signal, SIG_DFL);
  }
  ~Signals() override {
    for (const auto& [signal, handler] : inherited) std::signal(signal, handler);
  }

  /// @param prepare  runs in the child, before the program. @returns the process.
  pid_t start(const std::vector<std::string>& words, const std::function<void()>& prepare = nullptr) {
    std::filesystem::remove(work / "said");  // what the last one said is no news
    const pid_t child = fork();
    if (child != 0) return child;
    std::vector<char*> arguments{const_cast<char*>("loopmend")};
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    if (!std::freopen((work / "said").c_str(), "w", stderr) || !std::freopen("/dev/null", "w", stdout)) _exit(98);
    if (prepare) prepare();
    execv(LOOPMEND_PROGRAM, arguments.data());
    _exit(99);
  }

  /// @returns the exit code; 1000 + the signal where one has killed it.
  int end_of(pid_t child) {
    int status = 0;
    EXPECT_EQ(waitpid(child, &status, 0), child);
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }

  bool has_ended(pid_t child) {
    siginfo_t info{};
    return waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOHANG | WNOWAIT) == 0 && info.si_pid == child;
  }

  int temporary_files(std::uintmax_t least_size = 0) {
    int count = 0;
    std::error_code error;
    for (const auto& entry : std::filesystem::directory_iterator(work.folder()))
      if (entry.path().filename().string().starts_with(".loopmend-") && entry.file_size(error) >= least_size && !error)
        ++count;
    return count;
  }

  void wait_until(pid_t child, const std::function<bool()>& holds) {
    while (!holds() && !has_ended(child)) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }

  /// Takes long enough to be written that a signal meets it half-written.
  void make_large_scan() {
    write_mesh(work / "scan.ply", cut(make_icosphere(7), [](const Vec3& p) { return p.z() > 0.99; }));
  }
  std::vector<std::string> fill(const std::vector<std::string>& options) {
    std::vector<std::string> words{"fill", work / "scan.ply", "-o", work / "out.ply"};
    words.insert(words.end(), options.begin(), options.end());
    return words;
  }

 private:
  std::map<int, void (*)(int)> inherited;
};

TEST_F(Signals, WhileAFileIsWrittenLeaveTheOldOneAndNothingElse) {
  make_large_scan();
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGXCPU}) {
    std::ofstream(work / "out.ply") << "precious";
    const pid_t child = start(fill({"--flow", "none", "--ascii"}));
    wait_until(child, [&] { return temporary_files(1) > 0; });
    kill(child, signal);
    EXPECT_EQ(end_of(child), 128 + signal);
    EXPECT_EQ(text_of(work / "out.ply"), "precious") << signal;
    EXPECT_EQ(temporary_files(), 0) << signal;
    EXPECT_THAT(text_of(work / "said"), HasSubstr("nothing was written")) << signal;
  }
}

TEST_F(Signals, AnInterruptBeforeMainIsNotLost) {
  make_large_scan();
  using Clock = std::chrono::steady_clock;
  constexpr int most_tries = 20;
  for (const int pause : {0, 1, 2, 4, 8, 16, 32})  // ms; loading the libraries takes some tens of them
    for (int tries = 1;; ++tries) {
      std::ofstream(work / "out.ply") << "precious";
      const Clock::time_point begin = Clock::now();
      const pid_t child = start(fill({}));
      std::this_thread::sleep_for(std::chrono::milliseconds(pause));
      kill(child, SIGINT);
      const bool late = Clock::now() - begin > std::chrono::milliseconds(pause + 50);
      const int code = end_of(child);
      if (late && code == 0 && tries < most_tries)
        continue;  // this process was not given the processor until the fill had ended
      EXPECT_THAT(code, AnyOf(128 + SIGINT, 1000 + SIGINT)) << pause;  // the latter: before the program was loaded
      EXPECT_TRUE(text_of(work / "out.ply") == "precious") << pause;   // what else it holds is no text
      break;
    }
}

TEST_F(Signals, ACrashRemovesUnfinishedFilesAndStaysACrash) {
  if (std::string(LOOPMEND_SANITIZERS) != "") GTEST_SKIP() << "sanitizers tell of crashes themselves";
  make_large_scan();
  for (const int signal : {SIGSEGV, SIGABRT}) {
    std::ofstream(work / "out.ply") << "precious";
    const pid_t child = start(fill({"--flow", "none", "--ascii"}), [] {
      const rlimit none{0, 0};
      setrlimit(RLIMIT_CORE, &none);
    });
    wait_until(child, [&] { return temporary_files(1) > 0; });
    kill(child, signal);
    EXPECT_EQ(end_of(child), 1000 + signal);
    EXPECT_EQ(text_of(work / "out.ply"), "precious") << signal;
    EXPECT_EQ(temporary_files(), 0) << signal;
    EXPECT_THAT(text_of(work / "said"), HasSubstr("crashed")) << signal;
  }
}

TEST_F(Signals, WhatSigkillLeavesIsRemovedByTheNextCommand) {
  make_large_scan();
  const pid_t child = start(fill({"--flow", "none", "--ascii"}));
  wait_until(child, [&] { return temporary_files(1) > 0; });
  kill(child, SIGKILL);
  EXPECT_EQ(end_of(child), 1000 + SIGKILL);
  EXPECT_EQ(temporary_files(), 1);
  EXPECT_EQ(test::loopmend_program("sample -o " + path("sample.ply")).code, 0);
  EXPECT_EQ(temporary_files(), 0);
}

TEST_F(Signals, KeepPartialWritesWhatIsFinishedForEachOfThem) {
  // A large hole that takes long, and a small one that is ready at once.
  TriangleSoup small = cut(make_icosphere(2), [](const Vec3& p) { return p.z() > 0.9; });
  for (Vec3& p : small.points) p += Vec3(5, 0, 0);
  TriangleSoup large = cut(make_icosphere(7), [](const Vec3& p) { return p.z() > 0.2; });
  write_mesh(work / "scan.ply", joined({large, small}));
  for (const int signal : {SIGTERM, SIGHUP}) {
    std::filesystem::remove(work / "out.ply");
    const pid_t child = start(fill({"--keep-partial", "--threads", "2"}));
    wait_until(child, [&] { return text_of(work / "said").find("1 of 2 loops") != std::string::npos; });
    kill(child, signal);
    const int code = end_of(child);
    EXPECT_EQ(code, 128 + signal) << text_of(work / "said");
    EXPECT_EQ(read_mesh(work / "out.ply").report.format, "PLY");
    EXPECT_EQ(temporary_files(), 0);
  }
}

TEST_F(Signals, NohupIsRespected) {
  write_mesh(work / "scan.ply", cut(make_icosphere(5), [](const Vec3& p) { return p.z() > 0.5; }));
  const pid_t child = start(fill({}), [] { std::signal(SIGHUP, SIG_IGN); });
  wait_until(child, [&] { return text_of(work / "said").find("filling") != std::string::npos; });
  kill(child, SIGHUP);
  EXPECT_EQ(end_of(child), 0);
  EXPECT_TRUE(std::filesystem::exists(work / "out.ply"));
}

TEST_F(Signals, AReaderThatHasGoneTakesNoFileWithIt) {
  write_mesh(work / "scan.ply", cut(make_icosphere(3), [](const Vec3& p) { return std::abs(p.z()) > 0.9; }));
  int ends[2];
  ASSERT_EQ(pipe(ends), 0);
  const auto say_to_nobody = [&](int stream) {
    return [&ends, stream] {
      dup2(ends[1], stream);
      close(ends[0]);
      close(ends[1]);
    };
  };
  const pid_t first = start(fill({}), say_to_nobody(STDOUT_FILENO));
  close(ends[0]);
  EXPECT_EQ(end_of(first), 141);
  EXPECT_THAT(text_of(work / "said"), Not(HasSubstr("loopmend:")));
  EXPECT_EQ(read_mesh(work / "out.ply").report.format, "PLY");
  close(ends[1]);
  std::filesystem::remove(work / "out.ply");
  ASSERT_EQ(pipe(ends), 0);
  const pid_t second = start(fill({}), say_to_nobody(STDERR_FILENO));
  close(ends[0]);
  EXPECT_EQ(end_of(second), 0);  // standard output took what was told
  EXPECT_EQ(read_mesh(work / "out.ply").report.format, "PLY");
  close(ends[1]);
}

TEST_F(Signals, ClosedStreamsNeverBecomePartsOfAFile) {
  write_mesh(work / "scan.ply", cut(make_icosphere(3), [](const Vec3& p) { return std::abs(p.z()) > 0.9; }));
  EXPECT_EQ(test::loopmend_program("fill " + path("scan.ply") + "-o " + path("right.ply")).code, 0);
  const pid_t child = start(fill({"--report", "-"}), [] {
    for (const int stream : {0, 1, 2}) close(stream);
  });
  EXPECT_EQ(end_of(child), 0);
  EXPECT_EQ(text_of(work / "out.ply"), text_of(work / "right.ply"));
}

TEST_F(Signals, ALimitOfFileSizeIsASentenceAndTheOldFileStays) {
  make_large_scan();
  std::ofstream(work / "out.ply") << "precious";
  const pid_t child = start(fill({"--flow", "none"}), [] {
    const rlimit limit{100000, 100000};
    setrlimit(RLIMIT_FSIZE, &limit);
  });
  EXPECT_EQ(end_of(child), 4);
  EXPECT_THAT(text_of(work / "said"), HasSubstr("File too large"));
  EXPECT_EQ(text_of(work / "out.ply"), "precious");
  EXPECT_EQ(temporary_files(), 0);
}

TEST_F(Signals, HardLinksAreTold) {
  EXPECT_EQ(test::loopmend_program("sample -o " + path("out.ply")).code, 0);
  std::filesystem::create_hard_link(work / "out.ply", work / "other.ply");
  const test::Outcome run = test::loopmend_program("sample -o " + path("out.ply"));
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.err, HasSubstr("1 other name (hard link); that keeps the old file"));
}

}  // namespace
}  // namespace loopmend
