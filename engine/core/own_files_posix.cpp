// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/own_files.h"

#include "core/error.h"
#include "core/path_text.h"

#include <dlfcn.h>
#include <link.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <system_error>

namespace loopmend {

namespace {

/// The program, or the library or module that has the engine in it. Empty where /proc is not mounted.
std::filesystem::path this_file() {
  Dl_info info{};
  link_map* map = nullptr;
  if (dladdr1(reinterpret_cast<const void*>(&own_file), &info, reinterpret_cast<void**>(&map), RTLD_DL_LINKMAP) != 0 &&
      map && map->l_name && *map->l_name)
    return std::filesystem::absolute(map->l_name);
  std::error_code error;
  return std::filesystem::read_symlink("/proc/self/exe", error);
}

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;

/// Without a name; it goes with the last who has it open.
File temporary_file() {
  File file(std::tmpfile(), &std::fclose);
  if (!file) throw Error(say("no temporary file can be made: %1", std::generic_category().message(errno)));
  return file;
}

std::string content_of(std::FILE* file) {
  std::string bytes(static_cast<std::size_t>(std::max<off_t>(0, lseek(fileno(file), 0, SEEK_END))), '\0');
  std::rewind(file);
  bytes.resize(std::fread(bytes.data(), 1, bytes.size(), file));
  return bytes;
}

}  // namespace

std::filesystem::path own_file(const std::string& name) {
  const std::filesystem::path self = this_file(), folder = self.parent_path();
  std::filesystem::path file = folder / name;
  if (!exists(file)) file = (folder / LOOPMEND_OWN_FOLDER / name).lexically_normal();
  if (self.empty() || !exists(file))
    throw Error(say("%1 is missing; in Debian's packages it is in loopmend-pictures", path_text(file)));
  return file;
}

ChildRun run_child(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                   const std::string& input) {
  const File in = temporary_file(), out = temporary_file(), complaint = temporary_file();
  if (std::fwrite(input.data(), 1, input.size(), in.get()) != input.size() || std::fflush(in.get()) != 0)
    throw Error(say("no temporary file can be made: %1", std::generic_category().message(errno)));
  std::rewind(in.get());
  std::vector<char*> words{const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(in.get()), 0);
  posix_spawn_file_actions_adddup2(&actions, fileno(out.get()), 1);
  posix_spawn_file_actions_adddup2(&actions, fileno(complaint.get()), 2);
  pid_t child = -1;
  const int failed = posix_spawn(&child, program.c_str(), &actions, nullptr, words.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (failed != 0)
    throw Error(say("%1 cannot be started: %2", path_text(program), std::generic_category().message(failed)));
  int status = 0;
  while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
  }
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, content_of(out.get()), content_of(complaint.get())};
}

}  // namespace loopmend
