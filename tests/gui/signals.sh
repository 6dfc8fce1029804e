#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# A signal or a crash ends the window with a sentence that says where the copy of its work is.
# Usage: on_display.sh ... signals.sh LOOPMEND_GUI
# Exit code: 0 all well, 1 something is not.
set -uo pipefail

folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
export HOME=$folder XDG_DATA_HOME=$folder/data
ulimit -c 0

# Bit n - 1 of SigCgt is set where a process handles signal n; so does the shell, which it is a copy of at first.
handles_crashes() { [[ $(readlink "/proc/$1/exe") == */loopmend-gui ]] && (((0x$(awk '/^SigCgt/ { print $2 }' "/proc/$1/status" 2>/dev/null || echo 0) >> 10) & 1)); }

for signal in TERM HUP INT SEGV ABRT; do
  "$1" >"$folder/out" 2>"$folder/err" &
  window=$!
  for ((k = 0; k < 600; ++k)); do
    handles_crashes "$window" && break
    sleep 0.05
  done
  kill -s "$signal" "$window"
  wait "$window"
  code=$?
  if ((code != 128 + $(kill -l "$signal"))) || ! grep -qF "a copy of what was not saved may be in $XDG_DATA_HOME/loopmend/recovery" "$folder/err"; then
    echo "SIG$signal: exit code $code, and these words:" >&2
    cat "$folder/out" "$folder/err" >&2
    exit 1
  fi
done
