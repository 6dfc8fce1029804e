// The commands for the paper's other problems: blend, interpolate, evolve, compare, reproduce.
#pragma once

#include "flow_words.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace loopmend {

struct BlendCommand {
  std::vector<std::filesystem::path> inputs;
  std::filesystem::path output;
  std::string loops;  ///< "FILE:LOOP,..." by number; empty: those that face each other
  FlowWords words;
  std::string command_line;  ///< as typed, for the report
};

/// @returns an ExitCode. @throws ReadError, WriteError, UsageError, InvalidArgument.
int run_blend(const BlendCommand& command);

/// Options of all of them, and which one to run.
class PaperCommands {
 public:
  void add_to(CLI::App& app);
  /// @returns the exit code of the command that was given; empty if it was none of these.
  std::optional<int> run(const CLI::App& app, const std::string& command_line);

 private:
  BlendCommand blend_;
};

}  // namespace loopmend
