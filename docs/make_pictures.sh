#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the picture of README.md and of the first page: the embedded sample before and after. The pictures of the window are
# made by docs/user/window/make_pictures.sh.
# Usage: docs/make_pictures.sh BUILD
set -euo pipefail

program=$(cd "${1:?Usage: docs/make_pictures.sh BUILD}" && pwd)/bin/loopmend
assets=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/assets
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$program" sample -o "$folder/scan.ply"
"$program" fill "$folder/scan.ply" -o "$folder/filled.ply" --quiet
"$program" render "$folder/scan.ply" "$folder/filled.ply" --view front --size 1200x620 -o "$assets/before_after.png"
