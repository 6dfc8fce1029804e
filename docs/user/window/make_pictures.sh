#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pictures of the help pages from the real window, so that they stay true, in English and German; and, for
# people to judge, all of them light and dark, at once and twice the size.
# Usage: docs/user/window/make_pictures.sh BUILD SCAN [FOLDER]
#   BUILD   a build folder with bin/take_screenshots
#   SCAN    the scan to show: the pages have the sample (`loopmend sample`), in likely_error.png ../shared/data/bunny.ply;
#           compare, repair, edges and mirror have surfaces of their own
#   FOLDER  where all pictures go; without it only those of the help pages are made
set -euo pipefail

build=$(cd "${1:?Usage: make_pictures.sh BUILD SCAN [FOLDER]}" && pwd)
scan=$(realpath "${2:?Usage: make_pictures.sh BUILD SCAN [FOLDER]}")
pictures=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)/pictures
folder=${3:-$(mktemp -d)}

shoot() { # NAME SCALE SCREEN [light|dark [de]]
  QT_SCALE_FACTOR=$2 xvfb-run -a -s "-screen 0 $3x24" "$build/bin/take_screenshots" "$scan" "$folder/$1" "${@:4}"
}

shoot light 1 1400x900
shoot german 1 1400x900 light de
if [[ -n ${3:-} ]]; then
  shoot dark 1 1400x900 dark
  shoot light2 2 2800x1800
  shoot dark2 2 2800x1800 dark
fi
german=$(dirname "$pictures")/de/pictures
mkdir -p "$pictures" "$german"
for name in window candidates holes patch running display zebra inspect compare region repair edges mirror likely_error; do
  cp "$folder/light/$name.png" "$pictures/$name.png"
  cp "$folder/german/$name.png" "$german/$name.png"
done
echo "pictures of the help pages: $pictures and $german; all: $folder"
