// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/own_files.h"

namespace loopmend {

std::filesystem::path own_file(const std::string& name) {
  throw Error(say("%1 is not part of the program for Windows", name));
}

ChildRun run_child(const std::filesystem::path&, const std::vector<std::string>&, const std::string&) {
  throw Error(say("this is not part of the program for Windows"));
}

}  // namespace loopmend
