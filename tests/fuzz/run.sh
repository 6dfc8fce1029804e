#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs each fuzzer for a time.
# Usage: run.sh SECONDS FOLDER [BIN]   FOLDER keeps what is found; BIN: build/fuzz/bin
# Exit code: 0 nothing found, 1 something found.
set -uo pipefail

seconds=${1:?Usage: run.sh SECONDS FOLDER [BIN]}
folder=${2:?Usage: run.sh SECONDS FOLDER [BIN]}
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
bin=${3:-$root/build/fuzz/bin}
export ASAN_OPTIONS=detect_leaks=0:allocator_may_return_null=1

mkdir -p "$folder"
"$bin/make_fuzz_seeds" "$folder/seeds" || exit 1
result=0
for target in "$bin"/fuzz_*; do
  name=${target##*/fuzz_}
  mkdir -p "$folder/inputs/$name" "$folder/found/$name"
  if "$target" -max_total_time="$seconds" -max_len=4096 -timeout=20 -rss_limit_mb=3000 -malloc_limit_mb=2500 \
    -artifact_prefix="$folder/found/$name/" "$folder/inputs/$name" "$folder/seeds/$name" >"$folder/$name.log" 2>&1; then
    printf '%-8s %s\n' "$name" "$(grep '^Done' "$folder/$name.log" | tail -1)"
  else
    printf '%-8s FAILED: %s\n' "$name" "$(ls "$folder/found/$name" | tail -1)"
    result=1
  fi
done
exit $result
