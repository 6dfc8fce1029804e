#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a program of GUI tests on Wayland, under weston without a screen.
# Usage: on_wayland.sh PROGRAM [ARGUMENTS]
# Exit code: that of the program; 77 where weston or Qt's plugin for Wayland is not installed.
set -euo pipefail

plugins=$(qtpaths --plugin-dir 2>/dev/null || echo "/usr/lib/$(uname -m)-linux-gnu/qt5/plugins")
if ! command -v weston >/dev/null || ! compgen -G "$plugins/platforms/libqwayland-*.so" >/dev/null; then
  echo "weston or qtwayland5 is not installed: no test on Wayland" >&2
  exit 77
fi
XDG_RUNTIME_DIR=$(mktemp -d) # holds the socket
export XDG_RUNTIME_DIR
weston --backend=headless-backend.so --socket=tests --width=1400 --height=900 --idle-time=0 >"$XDG_RUNTIME_DIR/log" 2>&1 &
weston=$!
for ((i = 0; i < 100; ++i)); do
  [[ -S $XDG_RUNTIME_DIR/tests ]] && break
  sleep 0.1
done
status=0
env --unset=DISPLAY WAYLAND_DISPLAY=tests QT_QPA_PLATFORM=wayland "$@" || status=$?
kill "$weston" 2>/dev/null || true
wait "$weston" 2>/dev/null || true
rm -rf "$XDG_RUNTIME_DIR"
exit "$status"
