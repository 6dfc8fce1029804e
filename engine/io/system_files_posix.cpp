// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/system_files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#ifdef __linux__
#include <sys/xattr.h>
#endif

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <string_view>
#include <vector>

namespace loopmend {

namespace {

/// Owner first, since changing it may take away bits of the mode. A foreign owner cannot be kept by everyone; what ran with
/// the owner's rights must not run with another's then.
int take_mode(int descriptor, const struct stat& status) {
  mode_t mode = status.st_mode & 07777U;
  if (::fchown(descriptor, status.st_uid, status.st_gid) != 0) {
    const bool group_kept = ::fchown(descriptor, static_cast<uid_t>(-1), status.st_gid) == 0;
    if (status.st_uid != ::geteuid()) mode &= ~static_cast<mode_t>(S_ISUID);
    if (!group_kept) mode &= ~static_cast<mode_t>(S_ISGID);
  }
  return ::fchmod(descriptor, mode) == 0 ? 0 : errno;
}

#ifdef __linux__
/// Access lists and whatever a person or a desktop has noted with the file; what the system refuses is left. Signatures of
/// the content and rights of a program do not hold for another content.
void take_attributes(int descriptor, const std::filesystem::path& from) {
  const ssize_t length = ::listxattr(from.c_str(), nullptr, 0);
  if (length <= 0) return;
  std::vector<char> names(static_cast<std::size_t>(length));
  const ssize_t filled = ::listxattr(from.c_str(), names.data(), names.size());
  for (ssize_t at = 0; at < filled; at += static_cast<ssize_t>(std::strlen(&names[at])) + 1) {
    const char* name = &names[at];
    if (std::string_view(name).starts_with("security.") && std::string_view(name) != "security.selinux") continue;
    const ssize_t size = ::getxattr(from.c_str(), name, nullptr, 0);
    if (size < 0) continue;
    std::vector<char> value(static_cast<std::size_t>(size) + 1);
    if (::getxattr(from.c_str(), name, value.data(), value.size()) == size)
      static_cast<void>(::fsetxattr(descriptor, name, value.data(), static_cast<std::size_t>(size), 0));
  }
}
#else
void take_attributes(int, const std::filesystem::path&) {}
#endif

}  // namespace

int open_new_file(const std::filesystem::path& path, Readers readers) {
  const mode_t before_umask = readers == Readers::owner ? S_IRUSR | S_IWUSR : 0666;
  return ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, before_umask);
}

int flush_to_disk(int descriptor) { return ::fsync(descriptor); }

void flush_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  ::fsync(descriptor);
  ::close(descriptor);
}

bool may_write(const std::filesystem::path& path) { return ::access(path.c_str(), W_OK) == 0; }

int take_properties(int descriptor, const std::filesystem::path& from) {
  struct stat status {};
  if (::stat(from.c_str(), &status) != 0) return errno;
  if (const int reason = take_mode(descriptor, status); reason != 0) return reason;
  take_attributes(descriptor, from);
  return 0;
}

std::error_code replace_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  return ::rename(from.c_str(), to.c_str()) == 0 ? std::error_code() : std::error_code(errno, std::generic_category());
}

std::int32_t process_id() { return ::getpid(); }

bool process_has_ended(std::int32_t process) { return ::kill(static_cast<pid_t>(process), 0) != 0 && errno == ESRCH; }

std::string process_namespace() {
  std::string identity;
  std::ifstream machine("/etc/machine-id");
  std::getline(machine, identity);
  std::array<char, 256> host{};
  if (::gethostname(host.data(), host.size() - 1) == 0) identity += host.data();
  struct stat processes {};
  if (::stat("/proc/self/ns/pid", &processes) == 0) identity.append(" ").append(std::to_string(processes.st_ino));
  return identity;
}

bool is_own_file(const std::filesystem::path& path) {
  struct stat status {};
  return ::lstat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid();
}

int remove_file_at_exit(const char* path) noexcept { return ::unlink(path) == 0 ? 0 : errno; }

void remove_folder_at_exit(const char* path) noexcept { ::rmdir(path); }

}  // namespace loopmend
