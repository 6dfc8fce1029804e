#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes these pictures:
#   README.md and the first page: the embedded sample before and after, and the film of a flow
#   docs/user/first_hole.md and docs/user/which_option.md
#   docs/math/irregular_boundaries.md, where PYTHON (default /usr/bin/python3) has NumPy
#   docs/user/holes_and_options.md, the numbers in first_hole.md, and the window's start page, where it has PyVista and Pillow
#   docs/user/walkthrough.md, where it has pytest, PyVista and Matplotlib
#   what a notebook shows (docs/user/first_hole.md), where it has NumPy, and Chromium is installed
#   docs/user/gallery.md, where the shared scans are beside the repository
# docs/make_comparisons.py makes those that show other programs, docs/user/window/make_pictures.sh those of the window.
# Usage: docs/make_pictures.sh BUILD
set -euo pipefail

build=$(cd "${1:?Usage: docs/make_pictures.sh BUILD}" && pwd)
docs=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$build/bin/loopmend assets=$docs/assets pictures=$docs/user/pictures
python=${PYTHON:-/usr/bin/python3}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$program" sample -o "$folder/scan.ply"
"$program" fill "$folder/scan.ply" -o "$folder/filled.ply" --quiet
"$program" render "$folder/scan.ply" "$folder/filled.ply" --view front --size 1200x620 -o "$assets/before_after.png"
"$program" render "$folder/scan.ply" --film "$assets/flow.gif" --film-length 10 --loop 2 --mode steps --sigma 0.3 --size 480x360
"$program" render "$folder/scan.ply" --color plain --view front --size 360x320 -o "$pictures/first_hole_sample.png"
"$program" render "$folder/scan.ply" "$folder/filled.ply" --color plain --seams --view front --size 720x340 -o "$pictures/first_hole_filled.png"
"$python" "$pictures/make_cases.py" "$program" "$pictures"
shared=$docs/../../shared
if [[ -d $shared/scans2 ]]; then
  "$python" "$pictures/make_gallery.py" "$program" "$shared" "$pictures"
else
  echo "docs/user/pictures/gallery_*: left as they are, since there is no $shared/scans2" >&2
fi
if "$python" -c 'import numpy, pyvista, PIL' 2>/dev/null; then
  xvfb-run -a "$python" "$pictures/make_options.py" "$program" "$pictures"
  xvfb-run -a "$python" "$docs/../resources/gallery/make_gallery.py" "$program"
else
  echo "docs/user/pictures/option_* and first_hole_numbers.png, resources/gallery: left as they are, since $python lacks NumPy, PyVista or Pillow" >&2
fi
if "$python" -c 'import numpy' 2>/dev/null; then
  "$python" "$docs/math/three_holes.py" "$program" "$docs/math/pictures"
else
  echo "docs/math/pictures: left as they are, since $python lacks NumPy" >&2
fi

if "$python" -c 'import numpy' 2>/dev/null && command -v chromium >/dev/null; then
  PYTHONPATH=$build/python "$python" "$pictures/make_notebook.py" "$pictures"
else
  echo "docs/user/pictures/notebook.png: left as it is, since $python lacks NumPy, or there is no Chromium" >&2
fi

if "$python" -c 'import matplotlib, pytest, pyvista' 2>/dev/null; then
  PYTHONPATH=$build/python LOOPMEND_KEEP_PICTURES=$pictures \
    "$python" "$docs/../python/tests/run.py" "$docs/../python/tests/test_user_page.py" -k walkthrough
else
  echo "docs/user/pictures: left as they are, since $python lacks pytest, PyVista or Matplotlib" >&2
fi
