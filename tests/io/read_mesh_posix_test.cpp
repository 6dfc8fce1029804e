// SPDX-License-Identifier: GPL-3.0-or-later
// What POSIX alone has: pipes, and files that may not be read.
#include "io_test_support.h"

#include <sys/stat.h>

namespace loopmend {
namespace {

class ReadMeshPosix : public ReadTest {
 protected:
  static std::string refusal(const std::filesystem::path& path) {
    try {
      read_mesh(path);
    } catch (const ReadError& error) {
      return error.what();
    }
    return "";
  }
};

TEST_F(ReadMeshPosix, RefusesAPipe) {
  ASSERT_EQ(::mkfifo((folder_ / "pipe.ply").c_str(), 0600), 0);
  EXPECT_NE(refusal(folder_ / "pipe.ply").find("regular file"), std::string::npos);
}

TEST_F(ReadMeshPosix, RefusesWhatMayNotBeRead) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may read everything";
  write_bytes(folder_ / "closed.ply", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  ::chmod((folder_ / "closed.ply").c_str(), 0);
  EXPECT_NE(refusal(folder_ / "closed.ply").find("permission"), std::string::npos);
}

}  // namespace
}  // namespace loopmend
