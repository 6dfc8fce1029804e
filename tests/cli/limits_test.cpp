// SPDX-License-Identifier: GPL-3.0-or-later
// A tight limit on memory ends in a sentence or in the result, and never in silence.
#include "cli/run_program.h"

#include "io/write_mesh.h"
#include "samples/analytic_surfaces.h"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

namespace loopmend {
namespace {

using test::text_of;
using testing::AnyOf;
using testing::HasSubstr;

class AddressSpace : public test::ProgramTest {
 protected:
  /// @returns the exit code; 124 when it had not ended after a minute.
  int run(const std::string& words, int megabytes) {
    const std::string command = "ulimit -v " + std::to_string(1024 * megabytes) + "; timeout -s KILL 60 " +
                                LOOPMEND_PROGRAM + " " + words + " >" + path("stdout") + "2>" + path("stderr");
    const int status = std::system(("sh -c \"" + command + "\"").c_str());
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
    return code == 137 ? 124 : code;
  }
};

TEST_F(AddressSpace, EveryLimitEndsTheProgram) {
  if (std::string(LOOPMEND_SANITIZERS) != "") GTEST_SKIP() << "sanitizers need terabytes of address space";
  for (const int megabytes : {100, 150, 200, 230, 250, 300, 1000}) {
    const int code = run("--version", megabytes);
    // 127: the loader itself could not map the libraries.
    EXPECT_THAT(code, AnyOf(0, 127)) << megabytes;
    if (code == 0) {
      EXPECT_EQ(text_of(work / "stdout"), "loopmend 0.1.0\n") << megabytes;
    }
  }
}

TEST_F(AddressSpace, AFillWorksOrSaysWhatIsMissing) {
  if (std::string(LOOPMEND_SANITIZERS) != "") GTEST_SKIP() << "sanitizers need terabytes of address space";
  write_mesh(work / "scan.ply", cut(make_icosphere(3), [](const Vec3& p) { return std::abs(p.z()) > 0.9; }));
  for (const int megabytes : {200, 300, 400, 500, 600, 800, 3000}) {
    std::filesystem::remove(work / "out.ply");
    const int code = run("fill " + path("scan.ply") + "-o " + path("out.ply"), megabytes);
    EXPECT_THAT(code, AnyOf(0, 5)) << megabytes;
    EXPECT_EQ(std::filesystem::exists(work / "out.ply"), code == 0) << megabytes;
    if (code == 5) {
      EXPECT_THAT(text_of(work / "stderr"), HasSubstr("Nothing was written.")) << megabytes;
    }
    if (megabytes == 200) {
      EXPECT_THAT(text_of(work / "stderr"), HasSubstr("ulimit -v"));
    }
    if (megabytes == 3000) {
      EXPECT_EQ(code, 0);
    }
  }
}

/// Runs the program as a user for whom the system makes no further process or thread.
class NoThread : public test::ProgramTest {
 protected:
  test::Outcome run(const std::string& words) {
    const std::string other_user = geteuid() == 0 ? "setpriv --reuid=65534 --regid=65534 --clear-groups " : "";
    const std::string command = other_user + "prlimit --nproc=1 " + LOOPMEND_PROGRAM + " " + words + " >" +
                                path("stdout") + "2>" + path("stderr");
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), text_of(work / "stdout"),
            text_of(work / "stderr")};
  }
  void SetUp() override {
    if (std::string(LOOPMEND_SANITIZERS) != "") GTEST_SKIP() << "sanitizers start threads of their own";
    std::filesystem::permissions(work.folder(), std::filesystem::perms::all);
    if (const test::Outcome none = run("--version"); none.code == 126 || none.code == 127)
      GTEST_SKIP() << "another user, or a limit, is not to be had here: " << none.err;
    write_mesh(work / "scan.ply", cut(make_icosphere(3), [](const Vec3& p) { return std::abs(p.z()) > 0.9; }));
  }
};

TEST_F(NoThread, AFillIsDoneByTheOneThatThereIs) {
  const test::Outcome done = run("fill " + path("scan.ply") + "-o " + path("out.ply"));
  EXPECT_EQ(done.code, 0) << done.err;
  ASSERT_EQ(test::loopmend_program("fill " + path("scan.ply") + "-o " + path("wanted.ply")).code, 0);
  EXPECT_TRUE(text_of(work / "out.ply") == text_of(work / "wanted.ply"));
}

TEST_F(NoThread, WhatNeedsAnotherOneSaysSo) {
  const test::Outcome none = run("fill " + path("scan.ply") + "-o " + path("out.ply") + "--max-time 100");
  expect_refused(none, 5, "--max-time");
  EXPECT_THAT(none.err, HasSubstr("ulimit -u"));
}

using Bounds = test::ProgramTest;

TEST_F(Bounds, LoopsThatAreNotFinishedInTimeAreLeftAndSaid) {
  write_mesh(work / "scan.ply", cut(make_icosphere(3), [](const Vec3& p) { return std::abs(p.z()) > 0.9; }));
  const test::Outcome none =
      test::loopmend_program("fill " + path("scan.ply") + "-o " + path("out.ply") + "--max-time 1e-6 --report -");
  EXPECT_EQ(none.code, 1) << none.err;
  EXPECT_THAT(none.out, HasSubstr("not finished in the time that --max-time allows"));
  EXPECT_THAT(none.out, HasSubstr("\"stopped\": true"));
  EXPECT_EQ(text_of(work / "out.ply"), text_of(work / "scan.ply"));
  const test::Outcome all =
      test::loopmend_program("fill " + path("scan.ply") + "-o " + path("out.ply") + "--max-time 10000 --report -");
  EXPECT_EQ(all.code, 0) << all.err;
  EXPECT_THAT(all.out, HasSubstr("\"stopped\": false"));
}

TEST_F(Bounds, LoopsThatNeedTooMuchMemoryAreLeftAndSaid) {
  write_mesh(work / "scan.ply", cut(make_icosphere(3), [](const Vec3& p) { return std::abs(p.z()) > 0.9; }));
  const test::Outcome none =
      test::loopmend_program("fill " + path("scan.ply") + "-o " + path("out.ply") + "--max-memory 1");
  EXPECT_EQ(none.code, 1) << none.err;
  EXPECT_THAT(none.out, HasSubstr("MB are free for it: left open"));
  EXPECT_EQ(text_of(work / "out.ply"), text_of(work / "scan.ply"));
  for (const char* wrong : {"--max-memory 0", "--max-memory nan", "--max-time 0", "--max-time -1"})
    EXPECT_EQ(test::loopmend_program("fill " + path("scan.ply") + "-o " + path("out.ply") + wrong).code, 2) << wrong;
}

TEST_F(AddressSpace, OtherCommandsThatSolveEndToo) {
  if (std::string(LOOPMEND_SANITIZERS) != "") GTEST_SKIP() << "sanitizers need terabytes of address space";
  write_mesh(work / "scan.ply", make_icosphere(3));
  for (const int megabytes : {400, 500, 520, 600, 3000}) {
    const int code =
        run("evolve " + path("scan.ply") + "-o " + path("out.ply") + "--where 'z>0.7' --boundary exact", megabytes);
    EXPECT_THAT(code, AnyOf(0, 5)) << megabytes;
    if (megabytes == 3000) {
      EXPECT_EQ(code, 0);
    }
  }
}

}  // namespace
}  // namespace loopmend
