#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the icon at fixed sizes: up to 32 pixels from the simple drawing, above from the full one. Needs librsvg2-bin.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
for size in 16 24 32 48 128; do
  drawing=loopmend.svg
  ((size > 32)) || drawing=loopmend-small.svg
  mkdir -p "$size"
  rsvg-convert -w "$size" -h "$size" "$drawing" -o "$size/loopmend.png"
done
