// SPDX-License-Identifier: GPL-3.0-or-later
// The words of the command line, one a line: they are a command whose numbers are in their ranges, or wrong usage. The
// commands themselves do nothing here.
#include "cli/batch/batch_command.h"
#include "cli/commands.h"
#include "cli/dispatch.h"
#include "cli/exit_codes.h"
#include "cli/outputs.h"
#include "cli/paper/paper_commands.h"

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace loopmend {

namespace {

void require(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

bool is_within(double x, double low, double high) { return x >= low && x <= high; }  // NaN is not

void require_flow(const FlowWords& words) {
  require(is_within(words.density, 0.1, 10), "the density is in its range");
  require(is_within(words.sigma, 1e-6, 1e8), "sigma is in its range");
  require(is_within(words.steps, 0, 1e6), "steps are in their range");
  options_of(words);
}

}  // namespace

std::string what_was_written() { return "Nothing was written."; }

int run_info(const InfoCommand&) { return exit_done; }
int run_sample(const std::filesystem::path&) { return exit_done; }

int run_fill(const FillCommand& command) {
  require(is_within(command.trim_rounds, 0, 100), "rings to be trimmed are in their range");
  require(is_within(command.fill.threads, 0, 1024), "threads are in their range");
  require(!command.max_diameter || is_within(*command.max_diameter, 0, 1e300), "the diameter is in its range");
  require(!command.max_edges || *command.max_edges > 0, "the number of edges is in its range");
  require(!command.max_seconds || is_within(*command.max_seconds, 0, 1e9), "the time is in its range");
  require(!command.max_memory_mb || is_within(*command.max_memory_mb, 0, 1e9), "the memory is in its range");
  return exit_done;
}

int run_render(const RenderCommand& command) {
  require(command.inputs.size() == 1 || command.inputs.size() == 2, "there are one mesh or two");
  for (const int size : {command.width, command.height})
    require(size == 0 || is_within(size, 64, 8192), "the size is in its range");
  require(!command.direction || (command.direction->allFinite() && !command.direction->isZero(0)),
          "a direction is one");
  require(!command.loop || *command.loop > 0, "loops count from 1");
  return exit_done;
}

int run_batch(const BatchCommand& command, const CheckFillOptions& check) {
  require(command.jobs >= 0, "jobs are in their range");
  check(command.fill_options);
  return exit_done;
}

int run_blend(const BlendCommand& command) {
  require_flow(command.words);
  return exit_done;
}
int run_interpolate(const InterpolateCommand& command) {
  require_flow(command.words);
  return exit_done;
}
int run_evolve(const EvolveCommand& command) {
  require_flow(command.words);
  return exit_done;
}
int run_compare(const CompareCommand& command) {
  require_flow(command.words);
  require(is_within(command.subdivide, 0, 8), "subdivisions are in their range");
  return exit_done;
}
int run_reproduce(const ReproduceCommand&) { return exit_done; }

}  // namespace loopmend

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t most_words = 64;
  std::vector<std::string> words{"loopmend"};
  std::string word;
  for (std::size_t k = 0; k < size && words.size() < most_words; ++k) {
    if (data[k] != '\n' && data[k] != '\0') {
      word += static_cast<char>(data[k]);
      continue;
    }
    words.push_back(word);
    word.clear();
  }
  words.push_back(word);
  std::vector<char*> pointers;
  for (std::string& one : words) pointers.push_back(one.data());
  pointers.push_back(nullptr);
  const int code = loopmend::dispatch(static_cast<int>(words.size()), pointers.data());
  loopmend::require(code == loopmend::exit_done || code == loopmend::exit_usage, "words are a command or wrong usage");
  return 0;
}
