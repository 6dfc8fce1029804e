// SPDX-License-Identifier: GPL-3.0-or-later
// Files that appear whole or not at all.
#include "io/atomic_file.h"

#include "io_test_support.h"

#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <sys/xattr.h>

#include <csignal>
#include <ostream>
#include <set>
#include <stdexcept>
#include <thread>
#include <vector>

namespace loopmend {
namespace {

class AtomicFile : public ReadTest {
 protected:
  void put(const std::filesystem::path& path, const std::string& text) {
    write_file_atomically(path, [&](std::ostream& out) { out << text; });
  }

  std::string refusal(const std::filesystem::path& path) {
    try {
      put(path, "new");
    } catch (const WriteError& error) {
      return error.what();
    }
    return "";
  }

  mode_t mode_of(const std::filesystem::path& path) {
    struct stat status {};
    EXPECT_EQ(::stat(path.c_str(), &status), 0);
    return status.st_mode & 07777U;
  }
};

TEST_F(AtomicFile, WritesAndReplaces) {
  put(folder_ / "a", "one");
  EXPECT_EQ(read_bytes(folder_ / "a"), "one");
  put(folder_ / "a", std::string(1000000, 'x') + "end");
  EXPECT_EQ(read_bytes(folder_ / "a"), std::string(1000000, 'x') + "end");
  put(folder_ / "a", "");
  EXPECT_EQ(read_bytes(folder_ / "a"), "");
  EXPECT_EQ(folder_.file_count(), 1U);
}

TEST_F(AtomicFile, NewFilesFollowTheMaskAndOldOnesKeepTheirMode) {
  const mode_t mask = ::umask(027);
  put(folder_ / "new", "x");
  ::umask(mask);
  EXPECT_EQ(mode_of(folder_ / "new"), 0640U);
  write_bytes(folder_ / "old", "x");
  ::chmod((folder_ / "old").c_str(), 0604);
  put(folder_ / "old", "y");
  EXPECT_EQ(mode_of(folder_ / "old"), 0604U);
}

TEST_F(AtomicFile, WritesThroughLinks) {
  write_bytes(folder_ / "target", "old");
  std::filesystem::create_symlink("target", folder_ / "link");
  std::filesystem::create_symlink("link", folder_ / "link to link");
  std::filesystem::create_symlink("not yet", folder_ / "dangling");
  put(folder_ / "link to link", "new");
  EXPECT_EQ(read_bytes(folder_ / "target"), "new");
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link to link"));
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link"));
  put(folder_ / "dangling", "born");
  EXPECT_EQ(read_bytes(folder_ / "not yet"), "born");
  std::filesystem::create_symlink("circle", folder_ / "circle");
  EXPECT_NE(refusal(folder_ / "circle"), "");
}

TEST_F(AtomicFile, RelativePaths) {
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder_.path());
  put("a", "here");
  std::filesystem::current_path(before);
  EXPECT_EQ(read_bytes(folder_ / "a"), "here");
}

TEST_F(AtomicFile, RefusesInWords) {
  EXPECT_NE(refusal(folder_.path()).find("is a folder"), std::string::npos);
  EXPECT_NE(refusal(folder_ / "no/a").find("Create the folder first"), std::string::npos);
  write_bytes(folder_ / "file", "x");
  EXPECT_NE(refusal(folder_ / "file/a"), "");
  EXPECT_NE(refusal(""), "");
  EXPECT_NE(refusal("/dev/full").find("not a regular file"), std::string::npos);
  EXPECT_NE(refusal(folder_ / std::string(300, 'n')).find("shorter name"), std::string::npos);
  EXPECT_NE(refusal("/proc/loopmend-test"), "");
  if (::geteuid() != 0) {
    ::chmod((folder_ / "file").c_str(), 0400);
    EXPECT_NE(refusal(folder_ / "file").find("write-protected"), std::string::npos);
    ::chmod(folder_.path().c_str(), 0500);
    EXPECT_NE(refusal(folder_ / "new").find("ermission"), std::string::npos);
    ::chmod(folder_.path().c_str(), 0700);
  }
  EXPECT_EQ(folder_.file_count(), 1U);
}

/// Runs in a child process, because the limit cannot be taken back.
int write_beyond_the_limit(const std::filesystem::path& path, std::size_t size) {
  std::signal(SIGXFSZ, SIG_IGN);
  const rlimit limit = {100000, 100000};
  if (::setrlimit(RLIMIT_FSIZE, &limit) != 0) return 3;
  try {
    write_file_atomically(path, [&](std::ostream& out) { out << std::string(size, 'x'); });
  } catch (const WriteError& error) {
    return std::string(error.what()).find(path.string()) == 0 ? 0 : 2;
  }
  return 1;
}

TEST_F(AtomicFile, AFullDiskLeavesTheOldFile) {
  write_bytes(folder_ / "a", "precious");
  for (const std::size_t size : {std::size_t{100001}, std::size_t{5000000}}) {
    const pid_t child = ::fork();
    ASSERT_GE(child, 0);
    if (child == 0) ::_exit(write_beyond_the_limit(folder_ / "a", size));
    int status = 0;
    ASSERT_EQ(::waitpid(child, &status, 0), child);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    EXPECT_EQ(read_bytes(folder_ / "a"), "precious");
    EXPECT_EQ(folder_.file_count(), 1U);
  }
}

TEST_F(AtomicFile, AFailingWriterLeavesTheOldFile) {
  write_bytes(folder_ / "a", "precious");
  EXPECT_THROW(write_file_atomically(folder_ / "a", [](std::ostream&) { throw std::runtime_error("no"); }),
               std::runtime_error);
  EXPECT_THROW(write_file_atomically(folder_ / "a", [](std::ostream& out) { out.setstate(std::ios::failbit); }),
               WriteError);
  EXPECT_EQ(read_bytes(folder_ / "a"), "precious");
  EXPECT_EQ(folder_.file_count(), 1U);
}

TEST_F(AtomicFile, UnfinishedFilesCanBeRemovedOnTheWayOut) {
  write_bytes(folder_ / "a", "precious");
  EXPECT_THROW(write_file_atomically(folder_ / "a",
                                     [&](std::ostream& out) {
                                       out << "half" << std::flush;
                                       EXPECT_EQ(folder_.file_count(), 2U);
                                       remove_unfinished_files();
                                       EXPECT_EQ(folder_.file_count(), 1U);
                                     }),
               WriteError);
  EXPECT_EQ(read_bytes(folder_ / "a"), "precious");
  put(folder_ / "a", "fine again");
  remove_unfinished_files();
  EXPECT_EQ(read_bytes(folder_ / "a"), "fine again");
}

TEST_F(AtomicFile, ExtendedAttributesSurvive) {
  write_bytes(folder_ / "a", "old");
  if (::setxattr((folder_ / "a").c_str(), "user.note", "mine", 4, 0) != 0) GTEST_SKIP() << "none on this disk";
  ASSERT_EQ(::setxattr((folder_ / "a").c_str(), "user.empty", "", 0, 0), 0);
  put(folder_ / "a", "new");
  char value[16] = {};
  EXPECT_EQ(::getxattr((folder_ / "a").c_str(), "user.note", value, sizeof value), 4);
  EXPECT_EQ(std::string(value), "mine");
  EXPECT_EQ(::getxattr((folder_ / "a").c_str(), "user.empty", value, sizeof value), 0);
  EXPECT_EQ(read_bytes(folder_ / "a"), "new");
}

TEST_F(AtomicFile, OwnerAndGroupSurvive) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root gives files away";
  write_bytes(folder_ / "a", "old");
  ASSERT_EQ(::chown((folder_ / "a").c_str(), 12345, 23456), 0);
  ASSERT_EQ(::chmod((folder_ / "a").c_str(), 0640), 0);
  put(folder_ / "a", "new");
  struct stat status {};
  ASSERT_EQ(::stat((folder_ / "a").c_str(), &status), 0);
  EXPECT_EQ(status.st_uid, 12345U);
  EXPECT_EQ(status.st_gid, 23456U);
  EXPECT_EQ(mode_of(folder_ / "a"), 0640U);
}

TEST_F(AtomicFile, WhatFewMayReadIsNeverOpenToMore) {
  write_bytes(folder_ / "a", "secret");
  ::chmod((folder_ / "a").c_str(), 0600);
  int others = 0;
  write_file_atomically(folder_ / "a", [&](std::ostream& out) {
    out << "secret as well" << std::flush;
    for (const auto& entry : std::filesystem::directory_iterator(folder_.path()))
      others += (mode_of(entry.path()) & 077U) != 0;
  });
  EXPECT_EQ(others, 0);
  EXPECT_EQ(mode_of(folder_ / "a"), 0600U);
}

TEST_F(AtomicFile, OtherNamesKeepTheOldFile) {
  EXPECT_EQ(other_names(folder_ / "a"), 0U);
  write_bytes(folder_ / "a", "old");
  EXPECT_EQ(other_names(folder_ / "a"), 0U);
  std::filesystem::create_hard_link(folder_ / "a", folder_ / "b");
  std::filesystem::create_symlink("a", folder_ / "link");
  EXPECT_EQ(other_names(folder_ / "a"), 1U);
  EXPECT_EQ(other_names(folder_ / "link"), 1U);
  put(folder_ / "a", "new");
  EXPECT_EQ(read_bytes(folder_ / "a"), "new");
  EXPECT_EQ(read_bytes(folder_ / "b"), "old");
}

/// The name of a temporary file of a process that is no more.
std::string name_of_a_leftover(const std::filesystem::path& folder) {
  const pid_t child = ::fork();
  if (child == 0) {
    write_file_atomically(folder / "x", [](std::ostream& out) {
      out << "half" << std::flush;
      ::raise(SIGKILL);
    });
    ::_exit(1);
  }
  int status = 0;
  EXPECT_EQ(::waitpid(child, &status, 0), child);
  EXPECT_EQ(WTERMSIG(status), SIGKILL);
  for (const auto& entry : std::filesystem::directory_iterator(folder))
    if (entry.path().extension() == ".tmp") return entry.path().filename();
  return "";
}

TEST_F(AtomicFile, WhatAKilledProcessLeftGoesAtTheNextWrite) {
  const std::string name = name_of_a_leftover(folder_.path());
  ASSERT_NE(name, "");
  put(folder_ / "a", "new");
  EXPECT_FALSE(std::filesystem::exists(folder_ / name));
  EXPECT_EQ(folder_.file_count(), 1U);
}

TEST_F(AtomicFile, WhatIsNotProvablyALeftoverStays) {
  const std::string name = name_of_a_leftover(folder_.path());  // .loopmend-PID-TAGRANDOM.tmp
  ASSERT_NE(name, "");
  const std::size_t tag = name.find('-', 10) + 1;
  std::string of_another_machine = name;
  of_another_machine[tag] = name[tag] == '0' ? '1' : '0';
  const std::string of_the_living = ".loopmend-" + std::to_string(::getpid()) + name.substr(tag - 1);
  const std::vector<std::string> stay{of_another_machine,
                                      of_the_living,
                                      name + "x",
                                      "x" + name,
                                      ".loopmend-12.tmp",
                                      ".loopmend-99999999999-" + name.substr(tag),
                                      ".loopmend-0" + name.substr(tag - 1),
                                      "loopmend.tmp"};
  for (const std::string& other : stay) write_bytes(folder_ / other, "mine");
  const std::string link = name.substr(0, name.size() - 5) + (name[name.size() - 5] == '0' ? "1" : "0") + ".tmp";
  std::filesystem::create_symlink("loopmend.tmp", folder_ / link);
  put(folder_ / "a", "new");
  EXPECT_FALSE(std::filesystem::exists(folder_ / name));
  for (const std::string& other : stay) EXPECT_TRUE(std::filesystem::exists(folder_ / other)) << other;
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / link));
}

TEST_F(AtomicFile, ManyThreadsAtOnce) {
  std::vector<std::thread> threads;
  threads.reserve(140);
  for (int t = 0; t < 140; ++t) {  // more than the list of unfinished files is long
    threads.emplace_back(
        [&, t] { put(folder_ / std::to_string(t), std::string(1000, static_cast<char>(' ' + t % 90))); });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(folder_.file_count(), 140U);
  for (int t = 0; t < 140; ++t) {
    EXPECT_EQ(read_bytes(folder_ / std::to_string(t)), std::string(1000, static_cast<char>(' ' + t % 90)));
  }
}

TEST_F(AtomicFile, ATransactionShowsAllOfItOrNothing) {
  write_bytes(folder_ / "a", "old");
  const auto text = [](const char* words) { return [words](std::ostream& out) { out << words; }; };
  {
    OutputTransaction given_up;
    given_up.add(folder_ / "a", text("new"));
    given_up.add(folder_ / "b", text("new"));
    EXPECT_EQ(read_bytes(folder_ / "a"), "old");
    EXPECT_THROW(given_up.add(folder_ / "no/c", text("new")), WriteError);
  }
  EXPECT_EQ(read_bytes(folder_ / "a"), "old");
  EXPECT_EQ(folder_.file_count(), 1U);
  OutputTransaction kept;
  kept.add(folder_ / "a", text("new a"));
  kept.add(folder_ / "b", text("new b"));
  kept.commit();
  EXPECT_EQ(read_bytes(folder_ / "a") + read_bytes(folder_ / "b"), "new anew b");
  EXPECT_EQ(folder_.file_count(), 2U);
}

TEST_F(AtomicFile, ARenameThatFailsMidwayTellsWhatIsInPlace) {
  const auto text = [](std::ostream& out) { out << "new"; };
  const auto in_place = [] {
    std::set<std::string> names;
    for (std::size_t k = 0; file_in_place(k) != nullptr; ++k) names.insert(file_in_place(k));
    return names;
  };
  {
    OutputTransaction outputs;
    for (const char* name : {"a", "b", "c"}) outputs.add(folder_ / name, text);
    std::filesystem::create_directory(folder_ / "b");  // nothing can be renamed over it
    EXPECT_THROW(outputs.commit(), WriteError);
  }
  const std::set<std::string> names = in_place();
  EXPECT_TRUE(names.contains(folder_ / "a"));
  for (const char* name : {"b", "c"}) EXPECT_FALSE(names.contains(folder_ / name)) << name;
  EXPECT_EQ(folder_.file_count(), 2U);
}

/// A program that stays open writes more files than the list of known ones is long.
TEST_F(AtomicFile, UnfinishedFilesAreKnownAfterManyThatAreWritten) {
  for (int k = 0; k < 300; ++k) {
    OutputTransaction outputs;
    outputs.add(folder_ / std::to_string(k), [](std::ostream& out) { out << "new"; });
    outputs.commit();
  }
  EXPECT_THROW(write_file_atomically(folder_ / "a",
                                     [&](std::ostream& out) {
                                       out << "half" << std::flush;
                                       EXPECT_EQ(folder_.file_count(), 301U);
                                       remove_unfinished_files();
                                       EXPECT_EQ(folder_.file_count(), 300U);
                                     }),
               WriteError);
}

TEST_F(AtomicFile, FoldersThatWereMadeForNothingGo) {
  { OutputTransaction().add_folder(folder_ / "x/y/z"); }
  EXPECT_EQ(folder_.file_count(), 0U);
  std::filesystem::create_directory(folder_ / "x");
  {
    OutputTransaction outputs;
    outputs.add_folder(folder_ / "x");
    outputs.add_folder(folder_ / "x/y");
    outputs.add(folder_ / "x/y/a", [](std::ostream& out) { out << "new"; });
    outputs.commit();
  }
  EXPECT_EQ(read_bytes(folder_ / "x/y/a"), "new");
  EXPECT_THROW(OutputTransaction().add_folder(folder_ / "x/y/a"), WriteError);
  EXPECT_THROW(OutputTransaction().add_folder(folder_ / "x/y/a/b"), WriteError);
}

TEST_F(AtomicFile, OneFileUnderManyNames) {
  write_bytes(folder_ / "a", "x");
  write_bytes(folder_ / "other", "x");
  std::filesystem::create_hard_link(folder_ / "a", folder_ / "hard");
  std::filesystem::create_symlink("a", folder_ / "soft");
  std::filesystem::create_symlink("not yet", folder_ / "dangling");
  std::filesystem::create_directory_symlink(".", folder_ / "here");
  for (const char* name : {"a", "./a", "hard", "soft", "here/a", "here/./a"})
    EXPECT_TRUE(same_file(folder_ / "a", folder_ / name)) << name;
  for (const char* name : {"other", "not yet", "dangling"})
    EXPECT_FALSE(same_file(folder_ / "a", folder_ / name)) << name;
  for (const char* name : {"./not yet", "dangling", "here/not yet", "here/dangling"})
    EXPECT_TRUE(same_file(folder_ / "not yet", folder_ / name)) << name;
  EXPECT_FALSE(same_file(folder_ / "not yet", folder_ / "nor this"));
  EXPECT_TRUE(same_file(folder_ / "no/such/x", folder_ / "no/./such/x"));
}

}  // namespace
}  // namespace loopmend
