#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Where the system allows no further thread, the window says so and ends: it neither crashes nor waits behind a black picture.
# Usage: no_threads.sh LOOPMEND_GUI
# Exit code: 0 all well, 1 something is not, 77 such a limit is not to be had here.
set -uo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
other_user=()
((EUID != 0)) || other_user=(setpriv --reuid=65534 --regid=65534 --clear-groups) # root has no such limit

limited() { timeout -s KILL 60 "${other_user[@]}" prlimit --nproc="$1" "${@:2}"; }
if ! "${other_user[@]}" prlimit --nproc=100 true 2>/dev/null || ! "${other_user[@]}" test -x "$1"; then
  echo "skipped: another user, or a limit, is not to be had here" >&2
  exit 77
fi

for threads in 2 4 8; do
  # The platform needs no display: where threads were not counted, the window would open, and be killed after a minute.
  QT_QPA_PLATFORM=offscreen limited "$threads" "$1" >"$folder/out" 2>"$folder/err"
  code=$?
  if ((code != 5)) || ! grep -q 'ulimit -u' "$folder/err" || [[ -s $folder/out ]]; then
    echo "with $threads processes and threads: exit code $code, and these words:" >&2
    cat "$folder/out" "$folder/err" >&2
    exit 1
  fi
done
