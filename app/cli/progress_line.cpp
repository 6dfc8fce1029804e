// SPDX-License-Identifier: GPL-3.0-or-later
#include "progress_line.h"

#include <unistd.h>
#include <cstdio>

namespace loopmend {

ProgressLine::ProgressLine(Verbosity verbosity) : verbosity_(verbosity), terminal_(isatty(STDERR_FILENO) == 1) {}

ProgressLine::~ProgressLine() { clear(); }

void ProgressLine::clear() {
  if (!line_open_) return;
  std::fputs("\r\033[K", stderr);
  line_open_ = false;
}

void ProgressLine::say(const std::string& words) {
  if (verbosity_ == Verbosity::quiet) return;
  clear();
  std::fprintf(stderr, "%s\n", words.c_str());
}

void ProgressLine::show(int done, int total, const std::string& words) {
  if (verbosity_ == Verbosity::quiet || total <= 0) return;
  if (!terminal_) {
    const int tenth = 10 * done / total;
    if (tenth > last_tenth_) std::fprintf(stderr, "%d of %d %s\n", done, total, words.c_str());
    last_tenth_ = tenth;
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  if (done < total && now - last_drawn_ < std::chrono::milliseconds(100)) return;
  last_drawn_ = now;
  constexpr int width = 30;
  const int filled = width * done / total;
  std::string bar(width, '.');
  bar.replace(0, filled, filled, '#');
  std::fprintf(stderr, "\r\033[K[%s] %d of %d %s", bar.c_str(), done, total, words.c_str());
  std::fflush(stderr);
  line_open_ = true;
}

}  // namespace loopmend
