#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Every source file states its licence within its first three lines. Names each file that does not.
# Usage: check_sources.sh ROOT
# Exit code: 0 all well, 1 rules broken, 2 nothing to check there.
set -euo pipefail

cd "${1:?Usage: check_sources.sh ROOT}"
mapfile -t files < <(find CMakeLists.txt app engine packaging resources tests -type f \
  \( -name '*.h' -o -name '*.cpp' -o -name '*.sh' -o -name '*.py' -o -name '*.cmake' -o -name CMakeLists.txt \) \
  2>/dev/null | LC_ALL=C sort)
if ((${#files[@]} == 0)); then
  echo "source rules: no sources under $PWD" >&2
  exit 2
fi

awk '
  FNR > 3 { nextfile }
  /(^|[ \t])SPDX-License-Identifier: GPL-3\.0-or-later$/ { licensed[FILENAME] = 1 }
  END {
    for (i = 1; i < ARGC; ++i) {
      if (ARGV[i] in licensed) continue
      printf "%s: no line \"SPDX-License-Identifier: GPL-3.0-or-later\" among the first three\n", ARGV[i]
      ++broken
    }
    if (broken > 0) {
      printf "source rules: %d broken\n", broken
      exit 1
    }
    printf "source rules: %d files, all well\n", ARGC - 1
  }
' "${files[@]}"
