// SPDX-License-Identifier: GPL-3.0-or-later
#include "journal_file.h"

#include "core/path_text.h"
#include "usage_error.h"

#include <windows.h>

#include <system_error>

namespace loopmend {

namespace {

HANDLE handle_of(std::intptr_t file) { return reinterpret_cast<HANDLE>(file); }

std::string last_reason() { return std::system_category().message(static_cast<int>(::GetLastError())); }

}  // namespace

JournalFile::JournalFile(const std::filesystem::path& path)
    : path_(path),
      // Whoever opens it for writing as well is refused: the lock.
      file_(reinterpret_cast<std::intptr_t>(::CreateFileW(path.c_str(), GENERIC_READ | GENERIC_WRITE, FILE_SHARE_READ,
                                                          nullptr, OPEN_ALWAYS, FILE_ATTRIBUTE_NORMAL, nullptr))) {
  if (handle_of(file_) != INVALID_HANDLE_VALUE) return;
  if (::GetLastError() == ERROR_SHARING_VIOLATION)
    throw UsageError(
        say("another batch is at work in %1: wait for its end, or stop it", path_text(path.parent_path())));
  throw WriteError(path, verbatim(last_reason()), say("Choose another folder for the results."));
}

JournalFile::~JournalFile() { ::CloseHandle(handle_of(file_)); }

void JournalFile::cut(std::uintmax_t size) {
  LARGE_INTEGER end;
  end.QuadPart = static_cast<LONGLONG>(size);
  if (::SetFilePointerEx(handle_of(file_), end, nullptr, FILE_BEGIN) == 0 || ::SetEndOfFile(handle_of(file_)) == 0)
    throw WriteError(path_, verbatim(last_reason()), {});
}

void JournalFile::append(const std::string& bytes) {
  DWORD written = 0;
  if (::SetFilePointerEx(handle_of(file_), LARGE_INTEGER{}, nullptr, FILE_END) == 0 ||
      ::WriteFile(handle_of(file_), bytes.data(), static_cast<DWORD>(bytes.size()), &written, nullptr) == 0 ||
      written != bytes.size() || ::FlushFileBuffers(handle_of(file_)) == 0)
    throw WriteError(path_, verbatim(last_reason()), say("Is the disk full?"));
}

}  // namespace loopmend
