#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the preset hostile, and reads and fills damaged files and surfaces with it: made by the tests, and of the shared corpus where
# that is there. The address and undefined behaviour sanitizers, and the assertions of the standard library, end a test that fails.
# Usage: damaged_input.sh SOURCES SHARED_FOLDER
# Exit code: 0 all well, 1 something is not, 77 not asked for: it compiles the whole engine a second time, so it runs where CI=true,
# as in .ci/run, or LOOPMEND_TEST_SANITIZERS=1 asks for it.
set -euo pipefail

if [[ ${CI:-} != true && ${LOOPMEND_TEST_SANITIZERS:-} != 1 ]]; then
  echo "skipped: compiles the whole engine; LOOPMEND_TEST_SANITIZERS=1 runs it" >&2
  exit 77
fi

cd "$1"
log=$(mktemp)
trap 'rm -f "$log"' EXIT
cmake --preset hostile -DLOOPMEND_SHARED_DIR="$2" >"$log" 2>&1 && cmake --build --preset hostile --parallel 2 >"$log" 2>&1 ||
  { tail -40 "$log" >&2; exit 1; }
echo "built after $SECONDS s"
ASAN_OPTIONS=detect_leaks=0 build/hostile/bin/hostile_tests --gtest_brief=1 --gtest_print_time=1
echo "ended after $SECONDS s"
