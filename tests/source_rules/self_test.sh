#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The check must name exactly the files of a small tree that break a rule, and pass the rest.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
tree=$(mktemp -d)
trap 'rm -rf "$tree"' EXIT
mkdir -p "$tree/engine" "$tree/tests" "$tree/build" "$tree/docs/dev" "$tree/nothing"
licence='SPDX-License-Identifier: GPL-3.0-or-later'

# Allowed: the first line, the third, a script below its shebang, and what is no source.
printf '// %s\nint a;\n' "$licence" >"$tree/engine/first.cpp"
printf '#!/bin/bash\n# What it is.\n# %s\n' "$licence" >"$tree/engine/third.sh"
printf '# %s\n' "$licence" >"$tree/CMakeLists.txt"
printf 'text\n' >"$tree/engine/notes.txt"
printf 'int generated;\n' >"$tree/build/generated.cpp"
# Broken: absent, empty, too late, another licence, a longer word.
printf '#pragma once\n' >"$tree/engine/absent.h"
: >"$tree/engine/empty.cpp"
printf '\n\n\n// %s\n' "$licence" >"$tree/engine/late.cpp"
printf '# SPDX-License-Identifier: MIT\n' >"$tree/tests/other.py"
printf '# %s-not\n' "$licence" >"$tree/tests/CMakeLists.txt"
# Citations: lines 2 and 3 are allowed, 4 to 7 are broken; of a document, line 1.
page=docs/dev/filling
printf '# Page\n## Size field\n' >"$tree/$page.md"
{
  echo "// $licence"
  echo "// $page.md, \"Size field\", and again $page.md, \"Page\""
  echo 'enum { boundaries, PEER };'
  echo "// $page.md, \"Size\""
  echo "// $page.md"
  printf '// NUMERIC%s §4\n' S
  printf '// see GUI%s\n' .md
} >"$tree/engine/citing.cpp"
# Names: line 2 is allowed, 3 and 4 are broken.
mkdir "$tree/app"
printf '// %s\nint nearest = 0;  // near "far"\nint near = 0;\nx.far += 1;\n' "$licence" >"$tree/app/names.cpp"
printf 'As PEER%s says.\n%s\n' S "$page.md" >"$tree/engine/README.md"
expected=$'app/names.cpp:3\napp/names.cpp:4\nengine/README.md:1\nengine/absent.h\nengine/citing.cpp:4\nengine/citing.cpp:5\nengine/citing.cpp:6\nengine/citing.cpp:7
engine/empty.cpp\nengine/late.cpp\ntests/CMakeLists.txt\ntests/other.py'

status=0
report=$(bash "$here/check_sources.sh" "$tree") || status=$?
named=$(grep -oE '^[^ :]+(:[0-9]+)?: ' <<<"$report" | sed 's/: $//' | LC_ALL=C sort)
if ! diff <(echo "$expected") <(echo "$named"); then
  echo "Above: '<' was broken but not named, '>' was named but is allowed." >&2
  exit 1
fi
((status == 1)) || { echo "exit code $status where rules are broken, not 1" >&2; exit 1; }

status=0
bash "$here/check_sources.sh" "$tree/nothing" >/dev/null 2>&1 || status=$?
((status == 2)) || { echo "exit code $status where there is nothing to check, not 2" >&2; exit 1; }
echo "$(wc -l <<<"$expected") faults, all named; nothing else named"
