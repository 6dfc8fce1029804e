// SPDX-License-Identifier: GPL-3.0-or-later
#include "exit_notice.h"

#include "io/atomic_file.h"

#include <unistd.h>

#include <cstddef>
#include <cstring>

namespace loopmend {

void say_at_exit(const char* words) noexcept {
  static_cast<void>(!write(STDERR_FILENO, words, static_cast<unsigned>(std::strlen(words))));
}

void say_what_was_written(const char* at_the_end) noexcept {
  if (file_in_place(0) == nullptr) {
    say_at_exit(*at_the_end == '\0' ? "; nothing was written\n" : "\n");  // a window may have written files before
  } else {
    say_at_exit(" after ");
    for (std::size_t k = 0; const char* name = file_in_place(k); ++k) {
      if (k > 0) say_at_exit(file_in_place(k + 1) != nullptr ? ", " : " and ");
      say_at_exit(name);
    }
    say_at_exit(file_in_place(1) != nullptr ? " were written\n" : " was written\n");
  }
  say_at_exit(at_the_end);
}

}  // namespace loopmend
