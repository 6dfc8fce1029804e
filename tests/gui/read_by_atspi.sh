#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Reads and drives the program over AT-SPI (read_by_atspi.py), on a message bus and with a home of its own.
# Usage: on_display.sh ... read_by_atspi.sh LOOPMEND_GUI LOOPMEND
# Exit code: 77 where AT-SPI, its Python module or dbus is not installed, or Qt does not reach the bus (see there).
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
if ! command -v dbus-run-session >/dev/null || ! /usr/bin/python3 -c 'import gi; gi.require_version("Atspi", "2.0")' 2>/dev/null ||
  ! [[ -x /usr/libexec/at-spi-bus-launcher || -x /usr/lib/at-spi2-core/at-spi-bus-launcher ]]; then
  echo "dbus, at-spi2-core or gir1.2-atspi-2.0 is not installed: no test over AT-SPI" >&2
  exit 77
fi
home=$(mktemp -d)
trap 'rm -rf "$home"' EXIT
mkdir -m 700 "$home/run"
"$2" sample -o "$home/sample.ply" >/dev/null
env --unset=DBUS_SESSION_BUS_ADDRESS HOME="$home" XDG_CONFIG_HOME="$home" XDG_DATA_HOME="$home" XDG_CACHE_HOME="$home" XDG_RUNTIME_DIR="$home/run" \
  LC_ALL=C.UTF-8 QT_LINUX_ACCESSIBILITY_ALWAYS_ON=1 dbus-run-session -- /usr/bin/python3 "$here/read_by_atspi.py" "$1" "$home/sample.ply"
