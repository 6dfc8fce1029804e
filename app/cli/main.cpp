// SPDX-License-Identifier: GPL-3.0-or-later
// The `loopmend` command line.
#include "dispatch.h"
#include "interrupt.h"

#include "core/memory.h"
#include "core/path_text.h"

#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

int run_program(int argc, char** argv) {
  loopmend::keep_freed_memory();
  std::setlocale(LC_NUMERIC, "C");
  loopmend::handle_signals();
  const int code = loopmend::dispatch(argc, argv);
  std::fflush(nullptr);
  std::_Exit(code);
}

}  // namespace

#ifdef _WIN32
/// Arguments in UTF-8, as everywhere in this program.
int wmain(int argc, wchar_t** argv) {
  std::vector<std::string> arguments;
  for (int i = 0; i < argc; ++i) arguments.push_back(loopmend::path_text(argv[i]));
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  return run_program(argc, pointers.data());
}
#else
int main(int argc, char** argv) { return run_program(argc, argv); }
#endif
