// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal_file.h"

#include "core/path_text.h"
#include "usage_error.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace loopmend {

namespace {

int flush(int file) {
#ifdef __linux__
  return fdatasync(file);
#else
  return fsync(file);
#endif
}

}  // namespace

JournalFile::JournalFile(const std::filesystem::path& path)
    : path_(path),
      file_(open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666)) {
  const int file = static_cast<int>(file_);
  if (file < 0) throw WriteError(path, verbatim(std::strerror(errno)), say("Choose another folder for the results."));
  if (flock(file, LOCK_EX | LOCK_NB) == 0) return;
  const bool busy = errno == EWOULDBLOCK;
  close(file);
  if (busy)
    throw UsageError(
        say("another batch is at work in %1: wait for its end, or stop it", path_text(path.parent_path())));
  throw WriteError(path, say("the file system cannot lock the file"), say("Choose a folder on another one."));
}

JournalFile::~JournalFile() { close(static_cast<int>(file_)); }

void JournalFile::cut(std::uintmax_t size) {
  if (ftruncate(static_cast<int>(file_), static_cast<off_t>(size)) != 0)
    throw WriteError(path_, verbatim(std::strerror(errno)), {});
}

void JournalFile::append(const std::string& bytes) {
  const int file = static_cast<int>(file_);
  std::size_t written = 0;
  while (written < bytes.size()) {
    const ssize_t n = write(file, bytes.data() + written, bytes.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw WriteError(path_, verbatim(std::strerror(errno)), say("Is the disk full?"));
    written += static_cast<std::size_t>(n);
  }
  if (flush(file) != 0) throw WriteError(path_, verbatim(std::strerror(errno)), say("Is the disk full?"));
}

}  // namespace loopmend
