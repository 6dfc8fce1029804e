// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/system_files.h"

#include <windows.h>

#include <fcntl.h>
#include <io.h>

#include <array>
#include <cerrno>

namespace loopmend {

namespace {

/// On the stack: an exit path may have no memory. Empty where it does not fit.
struct WidePath {
  explicit WidePath(const char* path) noexcept {
    if (MultiByteToWideChar(CP_UTF8, 0, path, -1, text.data(), static_cast<int>(text.size())) == 0) text[0] = L'\0';
  }
  std::array<wchar_t, 4096> text{};
};

}  // namespace

int open_new_file(const std::filesystem::path& path, Readers) {
  // May be removed while it is open: remove_file_at_exit() has to.
  const HANDLE file =
      ::CreateFileW(path.c_str(), GENERIC_WRITE | DELETE, FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE,
                    nullptr, CREATE_NEW, FILE_ATTRIBUTE_NORMAL, nullptr);
  if (file == INVALID_HANDLE_VALUE) {
    errno =
        std::error_code(static_cast<int>(::GetLastError()), std::system_category()).default_error_condition().value();
    return -1;
  }
  return ::_open_osfhandle(reinterpret_cast<std::intptr_t>(file), _O_BINARY | _O_NOINHERIT);
}

int flush_to_disk(int descriptor) { return ::_commit(descriptor); }

void flush_folder(const std::filesystem::path&) {}

bool may_write(const std::filesystem::path& path) {
  constexpr int write = 2;
  return ::_waccess(path.c_str(), write) == 0;
}

int take_properties(int, const std::filesystem::path&) { return 0; }

std::error_code replace_file(const std::filesystem::path& from, const std::filesystem::path& to) {
  if (::MoveFileExW(from.c_str(), to.c_str(), MOVEFILE_REPLACE_EXISTING | MOVEFILE_WRITE_THROUGH) != 0) return {};
  return {static_cast<int>(::GetLastError()), std::system_category()};
}

std::int32_t process_id() { return static_cast<std::int32_t>(::GetCurrentProcessId()); }

bool process_has_ended(std::int32_t process) {
  const HANDLE handle = ::OpenProcess(SYNCHRONIZE, FALSE, static_cast<DWORD>(process));
  if (handle == nullptr) return ::GetLastError() == ERROR_INVALID_PARAMETER;
  const bool ended = ::WaitForSingleObject(handle, 0) == WAIT_OBJECT_0;
  ::CloseHandle(handle);
  return ended;
}

std::string process_namespace() {
  std::array<char, 256> name{};
  auto size = static_cast<DWORD>(name.size());
  return ::GetComputerNameA(name.data(), &size) != 0 ? std::string(name.data(), size) : std::string();
}

bool is_own_file(const std::filesystem::path& path) {
  std::error_code error;
  return std::filesystem::is_regular_file(std::filesystem::symlink_status(path, error));
}

int remove_file_at_exit(const char* path) noexcept { return ::_wunlink(WidePath(path).text.data()) == 0 ? 0 : errno; }

void remove_folder_at_exit(const char* path) noexcept { ::RemoveDirectoryW(WidePath(path).text.data()); }

}  // namespace loopmend
