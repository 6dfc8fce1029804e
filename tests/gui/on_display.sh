#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a program on an X display of its own, under the window manager openbox where it is installed: several run side by side.
# Usage: on_display.sh [--alone] WIDTHxHEIGHT PROGRAM [ARGUMENTS]   --alone: without a window manager
# Exit code: that of the program; 1 where the display does not start.
set -euo pipefail

manager=openbox
if [[ $1 == --alone ]]; then
  manager=
  shift
fi
size=$1
shift
home=$(mktemp -d)
running=()
finish() {
  for ((k = ${#running[@]} - 1; k >= 0; --k)); do
    kill "${running[k]}" 2>/dev/null || true
    wait "${running[k]}" 2>/dev/null || true
  done
  rm -rf "$home"
}
trap finish EXIT
trap 'exit 143' TERM INT HUP

# The server chooses a number that is free, and writes it. Both end with this script, even if ctest kills it.
mkfifo "$home/number"
setpriv --pdeathsig TERM Xvfb -displayfd 3 -screen 0 "${size}x24" -nolisten tcp -noreset 3>"$home/number" >"$home/log" 2>&1 &
running+=($!)
if ! read -r -t 60 number <"$home/number"; then
  echo "Xvfb does not start:" >&2
  cat "$home/log" >&2
  exit 1
fi
export DISPLAY=:$number
unset WAYLAND_DISPLAY XAUTHORITY
if [[ -n $manager ]]; then
  if command -v openbox >/dev/null; then
    XDG_CONFIG_HOME=$home XDG_CACHE_HOME=$home XDG_DATA_HOME=$home setpriv --pdeathsig TERM openbox --sm-disable >/dev/null 2>&1 &
    running+=($!)
  else
    echo "openbox is not installed: the tests run without a window manager" >&2
  fi
fi
status=0
"$@" || status=$?
exit "$status"
