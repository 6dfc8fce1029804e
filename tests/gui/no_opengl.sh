#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# On a display without OpenGL the window says so in one sentence and ends with exit code 1.
# Usage: no_opengl.sh LOOPMEND_GUI
# Exit code: 0 all well, 1 something is not, 77 there is no Xvfb, or its display of 256 colours has OpenGL.
set -euo pipefail

command -v xvfb-run >/dev/null || { echo "skipped: there is no xvfb-run" >&2; exit 77; }
status=0
said=$(env -u WAYLAND_DISPLAY -u QT_QPA_PLATFORM timeout 60 xvfb-run -a -s "-screen 0 640x480x8" "$1" 2>&1) || status=$?
((status != 124)) || { echo "skipped: the window opens on 256 colours" >&2; exit 77; }
grep -q '^loopmend-gui: this display has no OpenGL 3.2.*loopmend --help$' <<<"$said" && ((status == 1)) ||
  { printf 'exit code %s, said:\n%s\n' "$status" "$said" >&2; exit 1; }
