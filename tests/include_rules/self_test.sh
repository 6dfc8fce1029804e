#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The check must name exactly the lines of the fixture that are marked "broken", and pass the rest.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
status=0
report=$(bash "$here/check_includes.sh" "$here/fixture") || status=$?
expected=$(cd "$here/fixture" && grep -rn '// broken' engine app python | cut -d: -f1,2 | LC_ALL=C sort)
named=$(grep ': includes ' <<<"$report" | cut -d: -f1,2 | LC_ALL=C sort)
if ! diff <(echo "$expected") <(echo "$named"); then
  echo "Above: '<' was broken but not named, '>' was named but is allowed." >&2
  exit 1
fi
((status == 1)) || { echo "exit code $status where rules are broken, not 1" >&2; exit 1; }

status=0
bash "$here/check_includes.sh" "$here" >/dev/null 2>&1 || status=$?
((status == 2)) || { echo "exit code $status where there is nothing to check, not 2" >&2; exit 1; }
echo "$(wc -l <<<"$expected") broken lines, all named; nothing else named"
