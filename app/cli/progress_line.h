// SPDX-License-Identifier: GPL-3.0-or-later
// Progress on standard error: a bar on a terminal, plain lines otherwise.
#pragma once

#include <chrono>
#include <string>

namespace loopmend {

enum class Verbosity { normal, quiet };

class ProgressLine {
 public:
  explicit ProgressLine(Verbosity verbosity);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  /// A step that has begun, in a few words.
  void say(const std::string& words);
  /// done of total, e.g. loops; on a terminal a bar that is redrawn at most ten times a second.
  void show(int done, int total, const std::string& words);

 private:
  void clear();
  Verbosity verbosity_;
  bool terminal_;
  bool line_open_ = false;
  int last_tenth_ = 0;
  std::chrono::steady_clock::time_point last_drawn_;
};

}  // namespace loopmend
