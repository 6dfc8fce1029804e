// SPDX-License-Identifier: GPL-3.0-or-later
// The man page and the shell completion against what the program itself says.
#include "cli/run_program.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <sstream>

namespace loopmend {
namespace {

using test::loopmend_program;
using test::text_of;
using testing::HasSubstr;

const std::filesystem::path packaging = LOOPMEND_PACKAGING_DIR;

/// What a line of the help begins with, such as "--flow" in "  --flow TEXT:{mmcvf,...}", and the long form of "-o,--output".
std::set<std::string> options_in(const std::string& help) {
  std::set<std::string> options;
  std::istringstream lines(help);
  const std::regex option("^  (?:-[a-z],)?(--[a-z-]+)");
  std::smatch found;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_search(line, found, option)) options.insert(found[1]);
  return options;
}

std::set<std::string> commands_in(const std::string& help) {
  std::set<std::string> commands;
  std::istringstream lines(help.substr(help.find("Subcommands:")));
  const std::regex command("^  ([a-z]+) ");
  std::smatch found;
  for (std::string line; std::getline(lines, line);)
    if (std::regex_search(line, found, command)) commands.insert(found[1]);
  return commands;
}

/// A page of troff as a person reads its words: no font changes, no escaped hyphens.
std::string plain(std::string troff) {
  troff = std::regex_replace(troff, std::regex(R"(\\f[BIPR])"), "");
  return std::regex_replace(troff, std::regex(R"(\\-)"), "-");
}

/// The words that bash offers behind a command.
std::string completion_of(const std::string& script, const std::string& command) {
  const std::size_t at = script.find("            " + command + ")");
  return at == std::string::npos ? "" : script.substr(at, script.find(";;", at) - at);
}

TEST(Documents, TellOfEveryCommandAndOption) {
  const std::string page = plain(text_of(packaging / "loopmend.1"));
  const std::string completion = text_of(packaging / "loopmend.bash-completion");
  const std::set<std::string> commands = commands_in(loopmend_program("--help").out);
  ASSERT_GE(commands.size(), 9u);
  for (const std::string& command : commands) {
    EXPECT_THAT(page, HasSubstr(".B " + command + "\n"));
    const std::set<std::string> options = options_in(loopmend_program(command + " --help").out);
    ASSERT_GE(options.size(), 2u) << command;
    for (const std::string& option : options) {
      EXPECT_TRUE(std::regex_search(page, std::regex(option + "(?![a-z-])"))) << "man page: " << option;
      EXPECT_TRUE(std::regex_search(completion_of(completion, command), std::regex(option + "(?![a-z-])")))
          << "completion: " << command << " " << option;
    }
  }
}

TEST(Documents, OfferNoOptionThatIsNone) {
  const std::string completion = text_of(packaging / "loopmend.bash-completion");
  for (const std::string& command : commands_in(loopmend_program("--help").out)) {
    const std::set<std::string> options = options_in(loopmend_program(command + " --help").out);
    const std::string offered = completion_of(completion, command);
    const std::regex option("--[a-z-]+");
    for (std::sregex_iterator it(offered.begin(), offered.end(), option), end; it != end; ++it)
      EXPECT_TRUE(options.count(it->str())) << command << " " << it->str();
  }
}

TEST(Documents, TheManPageIsSoundTroff) {
  // groff warns of a macro that is none and of a font that was not closed.
  const std::string page = (packaging / "loopmend.1").string();
  const int code = std::system(("man --warnings -E UTF-8 -l '" + page + "' >/dev/null 2>man_warnings.txt").c_str());
  if (code != 0) GTEST_SKIP() << "no man here";
  EXPECT_EQ(text_of("man_warnings.txt"), "");
  std::filesystem::remove("man_warnings.txt");
}

}  // namespace
}  // namespace loopmend
