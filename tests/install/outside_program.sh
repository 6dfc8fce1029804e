#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs the engine into an empty folder, builds the example against it and nothing else, and fills the sample with it.
# Usage: outside_program.sh BUILD_FOLDER ENGINE_LIBRARY LOOPMEND_PROGRAM
# Exit code: 0 all well, 1 something is not, 77 nothing is built yet.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
build=$1 library=$2 program=$3
[[ -f $library && -x $program ]] || exit 77
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
fail() {
  printf '%s\n' "$*" >&2
  exit 1
}

# The engine's page shows the example as it is.
diff <(sed -n '/^```cpp$/,/^```$/p' "$here/../../engine/README.md" | grep -v '^```') \
  <(tail -n +2 "$here/example/fill_every_hole.cpp") || fail "engine/README.md shows another example"

"$LOOPMEND_CMAKE" --install "$build" --prefix "$folder/installed" --component development >"$folder/log"
[[ ! -e $folder/installed/bin ]] || fail "the component development holds programs"
[[ -f $folder/installed/include/loopmend/core/error.h ]] || fail "no headers under include/loopmend"
if "$LOOPMEND_CMAKE" --install "$build" --prefix "$folder/application" --component application >>"$folder/log"; then
  [[ ! -e $folder/application/include && ! -e $folder/application/lib ]] || fail "the component application holds headers"
fi

"$LOOPMEND_CMAKE" -S "$here/example" -B "$folder/example" -DCMAKE_PREFIX_PATH="$folder/installed" \
  -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$LOOPMEND_CXX" -DCMAKE_CXX_FLAGS="${LOOPMEND_CXX_FLAGS:-}"
"$LOOPMEND_CMAKE" --build "$folder/example"
if grep -rqF -- "$here/../../engine" "$folder/example/CMakeCache.txt"; then fail "the example sees the sources"; fi

"$program" sample -o "$folder/sample.ply"
"$folder/example/fill_every_hole" "$folder/sample.ply" "$folder/filled.ply"
count() { "$program" info "$1" | grep -cE '^ +[0-9]+ +hole ' || true; }
before=$(count "$folder/sample.ply") after=$(count "$folder/filled.ply")
echo "holes before: $before, after: $after"
((before == 5 && after == 0)) || fail "the example did not fill the sample's five holes"
