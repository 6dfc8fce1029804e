#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Runs the tests of arrays and the examples of the user's pages with the wheel, the newest NumPy, and the packages of the examples;
# checks the type hints with mypy.
# Usage: with_packages.sh PYTHON WHEEL_FOLDER FOLDER   (WHEEL_FOLDER is build_wheel.sh's; the environment in FOLDER is kept)
# Exit code: 0 all well, 1 something is not, 77 there is no wheel, or PyPI cannot be reached.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
python=$1 wheels=$2 folder=$3
wheel=$(find "$wheels" -maxdepth 1 -name 'loopmend-*.whl' 2>/dev/null | head -1 || true)
[[ -n $wheel ]] || { echo "skipped: there is no wheel in $wheels, which the test python.wheel makes" >&2; exit 77; }
[[ -x $folder/bin/python ]] || "$python" -m venv "$folder"
if ! "$folder/bin/pip" install --quiet --disable-pip-version-check numpy pytest mypy \
  trimesh meshio pyvista matplotlib pandas tqdm distributed snakemake \
  >"$folder/log" 2>&1; then
  echo "skipped: the packages are not to be had: $(tail -1 "$folder/log")" >&2
  exit 77
fi
# Large, and not for every Python: its test is skipped without it.
"$folder/bin/pip" install --quiet --disable-pip-version-check open3d >>"$folder/log" 2>&1 || echo "Open3D is not to be had: $(tail -1 "$folder/log")"
"$folder/bin/pip" install --quiet --disable-pip-version-check --no-deps --force-reinstall "$wheel"
unset PYTHONPATH
cd "$folder"
bin/mypy --strict --cache-dir=mypy_cache -p loopmend
PATH="$folder/bin:$PATH" bin/python "$here/run.py" "$here/test_user_page.py" "$here/test_workflows.py" "$here/test_many_scans.py" "$here/test_fill.py" \
  "$here/test_files_and_curvatures.py" "$here/test_meshes.py" "$here/test_results.py" "$here/test_vtk_programs.py" | tee log
if grep -E '^SKIPPED.*(is not installed|could not import)' log; then
  echo "an example was skipped, though its package should be there" >&2
  exit 1
fi
