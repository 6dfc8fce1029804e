// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/run_program.h"

#include <gmock/gmock.h>

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace loopmend::test {

std::string text_of(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

Outcome loopmend_program(const std::string& arguments) {
  return run_in_shell(std::string(LOOPMEND_PROGRAM) + " " + arguments);
}

Outcome run_in_shell(const std::string& command) {
  const Workspace files;
  const std::filesystem::path out = files / "stdout", err = files / "stderr";
  const int status = std::system((command + " >" + out.string() + " 2>" + err.string() + " </dev/null").c_str());
  Outcome run;
  run.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  run.out = text_of(out);
  run.err = text_of(err);
  return run;
}

Workspace::Workspace() {
  std::string pattern = (std::filesystem::temp_directory_path() / "loopmend-test-XXXXXX").string();
  if (!mkdtemp(pattern.data())) throw std::runtime_error("no temporary folder");
  folder_ = pattern;
}

Workspace::~Workspace() {
  std::error_code error;
  std::filesystem::remove_all(folder_, error);
}

std::string ProgramTest::path(const std::string& name) const {
  std::string text = "'";
  text.append((work / name).string()).append("' ");
  return text;
}

void ProgramTest::expect_refused(const Outcome& run, int code, const std::string& words) const {
  EXPECT_EQ(run.code, code) << run.err;
  EXPECT_THAT(run.err, testing::HasSubstr("loopmend: "));
  EXPECT_THAT(run.err, testing::HasSubstr(words));
  EXPECT_FALSE(std::filesystem::exists(work / "out.ply"));
}

}  // namespace loopmend::test
