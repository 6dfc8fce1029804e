// SPDX-License-Identifier: GPL-3.0-or-later
#include "child.h"

#include "core/error.h"
#include "core/path_text.h"

#include <windows.h>

#include <algorithm>
#include <array>
#include <system_error>

namespace loopmend {

namespace {

constexpr LONGLONG most_said = 4096;  ///< bytes that are kept of what a child says

struct HandleOwner {
  HANDLE handle = INVALID_HANDLE_VALUE;
  ~HandleOwner() {
    if (handle != nullptr && handle != INVALID_HANDLE_VALUE) ::CloseHandle(handle);
  }
};

/// As CommandLineToArgvW takes it apart again: backslashes count only before a quotation mark.
std::wstring quoted(const std::wstring& argument) {
  std::wstring result = L"\"";
  std::size_t backslashes = 0;
  for (const wchar_t c : argument) {
    if (c == L'"') result.append(backslashes + 1, L'\\');
    backslashes = c == L'\\' ? backslashes + 1 : 0;
    result += c;
  }
  return result.append(backslashes, L'\\') + L'"';
}

/// Gone when it is closed.
HANDLE temporary_file() {
  std::array<wchar_t, MAX_PATH + 1> folder{}, name{};
  if (::GetTempPathW(MAX_PATH, folder.data()) == 0 || ::GetTempFileNameW(folder.data(), L"lm", 0, name.data()) == 0)
    return INVALID_HANDLE_VALUE;
  SECURITY_ATTRIBUTES inherited{sizeof(SECURITY_ATTRIBUTES), nullptr, TRUE};
  return ::CreateFileW(name.data(), GENERIC_READ | GENERIC_WRITE,
                       FILE_SHARE_READ | FILE_SHARE_WRITE | FILE_SHARE_DELETE, &inherited, CREATE_ALWAYS,
                       FILE_ATTRIBUTE_TEMPORARY | FILE_FLAG_DELETE_ON_CLOSE, nullptr);
}

std::string end_of(HANDLE file) {
  LARGE_INTEGER size{};
  ::GetFileSizeEx(file, &size);
  LARGE_INTEGER from{};
  from.QuadPart = std::max<LONGLONG>(0, size.QuadPart - most_said);
  ::SetFilePointerEx(file, from, nullptr, FILE_BEGIN);
  std::string text(static_cast<std::size_t>(size.QuadPart - from.QuadPart), '\0');
  DWORD read = 0;
  if (::ReadFile(file, text.data(), static_cast<DWORD>(text.size()), &read, nullptr) == 0) read = 0;
  text.resize(read);
  return text;
}

/// All children belong to it, and end with this process.
HANDLE job() {
  static const HANDLE made = [] {
    const HANDLE handle = ::CreateJobObjectW(nullptr, nullptr);
    JOBOBJECT_EXTENDED_LIMIT_INFORMATION limits{};
    limits.BasicLimitInformation.LimitFlags = JOB_OBJECT_LIMIT_KILL_ON_JOB_CLOSE;
    ::SetInformationJobObject(handle, JobObjectExtendedLimitInformation, &limits, sizeof limits);
    return handle;
  }();
  return made;
}

}  // namespace

struct Child::Process {
  HandleOwner process;
  HandleOwner said{temporary_file()};  ///< takes its standard error
};

Child::Child(const std::filesystem::path& program, const std::vector<std::string>& arguments)
    : process_(std::make_unique<Process>()) {
  std::array<wchar_t, 32768> own{};
  ::GetModuleFileNameW(nullptr, own.data(), static_cast<DWORD>(own.size()));
  const std::wstring file = program.empty() ? std::wstring(own.data()) : program.wstring();
  std::wstring line = quoted(file);
  for (const std::string& argument : arguments) line += L" " + quoted(path_of_text(argument).wstring());
  STARTUPINFOW start{};
  start.cb = sizeof start;
  start.dwFlags = STARTF_USESTDHANDLES;
  start.hStdError = process_->said.handle;
  PROCESS_INFORMATION made{};
  if (::CreateProcessW(file.c_str(), line.data(), nullptr, nullptr, TRUE, CREATE_NO_WINDOW | CREATE_SUSPENDED, nullptr,
                       nullptr, &start, &made) == 0)
    throw Error(say("the system starts no further process: %1. A smaller --jobs needs fewer.",
                    std::system_category().message(static_cast<int>(::GetLastError()))));
  process_->process.handle = made.hProcess;
  ::AssignProcessToJobObject(job(), made.hProcess);
  ::ResumeThread(made.hThread);
  ::CloseHandle(made.hThread);
}

Child::~Child() {
  if (process_->process.handle == INVALID_HANDLE_VALUE) return;
  kill();
  ::WaitForSingleObject(process_->process.handle, INFINITE);
}

std::optional<ChildEnd> Child::end() {
  if (::WaitForSingleObject(process_->process.handle, 0) != WAIT_OBJECT_0) return {};
  DWORD code = 0;
  ::GetExitCodeProcess(process_->process.handle, &code);
  return ChildEnd{static_cast<int>(code), end_of(process_->said.handle)};
}

void Child::stop() const { kill(); }

void Child::kill() const { ::TerminateProcess(process_->process.handle, 130); }

}  // namespace loopmend
