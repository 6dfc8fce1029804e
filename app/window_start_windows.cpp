// SPDX-License-Identifier: GPL-3.0-or-later
#include "window_start.h"

#include <windows.h>

#include <cstdio>

namespace loopmend {

namespace {

/// Whether the stream leads somewhere, as in `loopmend-gui --version > file`.
bool is_open(DWORD stream) { return ::GetFileType(::GetStdHandle(stream)) != FILE_TYPE_UNKNOWN; }

}  // namespace

bool has_display() { return true; }

void find_console() {
  const bool out = is_open(STD_OUTPUT_HANDLE), error = is_open(STD_ERROR_HANDLE);
  if ((out && error) || !::AttachConsole(ATTACH_PARENT_PROCESS)) return;
  if (!out) static_cast<void>(!std::freopen("CONOUT$", "w", stdout));
  if (!error) static_cast<void>(!std::freopen("CONOUT$", "w", stderr));
}

}  // namespace loopmend
