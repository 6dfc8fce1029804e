#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Every source file states its licence within its first three lines, and cites a page of docs/dev or docs/math by a heading that is
# there: docs/dev/PAGE.md, "Heading", without the number of the section; docs/math/PAGE.md alone means the whole page. Neither sources nor
# documents name notes that are not in the repository. The programs have no name that windows.h takes away. Names each file or line that
# breaks a rule.
# Usage: check_sources.sh ROOT
# Exit code: 0 all well, 1 rules broken, 2 nothing to check there.
set -euo pipefail

cd "${1:?Usage: check_sources.sh ROOT}"
mapfile -t files < <(find ./*.md CMakeLists.txt app docs engine packaging python resources tests -type f \
  \( -name '*.h' -o -name '*.cpp' -o -name '*.sh' -o -name '*.py' -o -name '*.pyi' -o -name '*.cmake' -o -name CMakeLists.txt -o -name '*.md' \) \
  2>/dev/null | LC_ALL=C sort)
if ((${#files[@]} == 0)); then
  echo "source rules: no sources under $PWD" >&2
  exit 2
fi

exec awk '
  BEGIN {
    # In brackets, so that this line does not name them.
    outside = "NUMERIC[S]|FILLIN[G]|BOUNDARIE[S]|PEER[S]|GLOSSAR[Y]|(GU[I]|ARCHITECTUR[E])[.]md"
    page = "docs/(dev|math)/[a-z_]+[.]md"
    while (("find docs/dev docs/math -name \"*.md\" 2>/dev/null" | getline file) > 0) {
      if (file ~ /^docs.math/) heading[file, ""] = 1
      while ((getline line < file) > 0)
        if (sub(/^#+ ([0-9]+[.][0-9]* ?)?/, "", line)) heading[file, line] = 1
    }
  }

  FNR <= 3 && /(^|[ \t])SPDX-License-Identifier: GPL-3\.0-or-later$/ { licensed[FILENAME] = 1 }
  $0 ~ outside { broken("names a document that is not in the repository") }
  FILENAME !~ /[.]md$/ {
    rest = $0
    while (match(rest, page)) {
      cited = substr(rest, RSTART, RLENGTH)
      rest = substr(rest, RSTART + RLENGTH)
      quoted = match(rest, /^, "[^"]+"/) ? substr(rest, 4, RLENGTH - 4) : ""
      if (!((cited, quoted) in heading)) broken("cites " cited ", which has no heading \"" quoted "\"")
    }
  }

  FILENAME ~ /^app[/].*[.](h|cpp)$/ && /near|far/ {
    code = $0
    gsub(/"[^"]*"/, "", code)
    sub(/[/][/].*/, "", code)
    if (code ~ /(^|[^A-Za-z_0-9])(near|far) *([^A-Za-z_0-9 ]|$)/) broken("has a name, near or far, that windows.h takes away")
  }

  function broken(rule) {
    printf "%s:%d: %s\n", FILENAME, FNR, rule
    ++count
  }

  END {
    for (i = 1; i < ARGC; ++i) {
      if (ARGV[i] ~ /[.]md$/ || ARGV[i] in licensed) continue
      printf "%s: no line \"SPDX-License-Identifier: GPL-3.0-or-later\" among the first three\n", ARGV[i]
      ++count
    }
    if (count > 0) {
      printf "source rules: %d broken\n", count
      exit 1
    }
    printf "source rules: %d files, all well\n", ARGC - 1
  }
' "${files[@]}"
