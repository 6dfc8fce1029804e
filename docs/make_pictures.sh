#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the pictures of README.md and of the first page: the embedded sample before and after, and the film of a flow; those of
# docs/math/irregular_boundaries.md; those of docs/user/which_option.md; and those of docs/user/walkthrough.md, where PYTHON (default /usr/bin/python3) has pytest,
# PyVista and Matplotlib; those of docs/user/gallery.md, where the shared scans are beside the repository. Those that show other programs are made by
# docs/make_comparisons.py. The pictures of the window are made by docs/user/window/make_pictures.sh.
# Usage: docs/make_pictures.sh BUILD
set -euo pipefail

build=$(cd "${1:?Usage: docs/make_pictures.sh BUILD}" && pwd)
docs=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
program=$build/bin/loopmend assets=$docs/assets
python=${PYTHON:-/usr/bin/python3}
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

"$program" sample -o "$folder/scan.ply"
"$program" fill "$folder/scan.ply" -o "$folder/filled.ply" --quiet
"$program" render "$folder/scan.ply" "$folder/filled.ply" --view front --size 1200x620 -o "$assets/before_after.png"
"$program" render "$folder/scan.ply" --film "$assets/flow.gif" --loop 2 --mode steps --sigma 0.3 --size 480x360
"$python" "$docs/user/pictures/make_cases.py" "$program" "$docs/user/pictures"
shared=$docs/../../shared
if [[ -d $shared/scans2 ]]; then
  "$python" "$docs/user/pictures/make_gallery.py" "$program" "$shared" "$docs/user/pictures"
else
  echo "docs/user/pictures/gallery_*: left as they are, since there is no $shared/scans2" >&2
fi
if "$python" -c 'import numpy, pyvista, PIL' 2>/dev/null; then
  xvfb-run -a "$python" "$docs/user/pictures/make_options.py" "$program" "$docs/user/pictures"
else
  echo "docs/user/pictures/option_*: left as they are, since $python lacks NumPy, PyVista or Pillow" >&2
fi
if "$python" -c 'import numpy' 2>/dev/null; then
  "$python" "$docs/math/three_holes.py" "$program" "$docs/math/pictures"
else
  echo "docs/math/pictures: left as they are, since $python lacks NumPy" >&2
fi

if "$python" -c 'import matplotlib, pytest, pyvista' 2>/dev/null; then
  PYTHONPATH=$build/python LOOPMEND_KEEP_PICTURES=$docs/user/pictures \
    "$python" "$docs/../python/tests/run.py" "$docs/../python/tests/test_user_page.py" -k walkthrough
else
  echo "docs/user/pictures: left as they are, since $python lacks pytest, PyVista or Matplotlib" >&2
fi
