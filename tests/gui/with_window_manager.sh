#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs a program of GUI tests under the window manager openbox, as on a desktop; without one where openbox is not installed.
# Usage: xvfb-run ... with_window_manager.sh PROGRAM [ARGUMENTS]
set -euo pipefail

if ! command -v openbox >/dev/null; then
  echo "openbox is not installed: the tests run without a window manager" >&2
  exec "$@"
fi
home=$(mktemp -d)
XDG_CONFIG_HOME=$home XDG_CACHE_HOME=$home XDG_DATA_HOME=$home openbox --sm-disable &
manager=$!
status=0
"$@" || status=$?
kill "$manager" 2>/dev/null || true
wait "$manager" 2>/dev/null || true
rm -rf "$home"
exit "$status"
