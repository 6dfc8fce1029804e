#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the extension for Blender of the wheel that build_wheel.sh left, and fills holes with it in Blender, which PyPI has as a module.
# Usage: fill_in_blender.sh PYTHON WHEEL_FOLDER FOLDER   (the environment in FOLDER is kept)
# Exit code: 0 all well, 1 something is not, 77 there is no wheel, or no Blender for this Python.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
python=$1 wheels=$2 folder=$3
compgen -G "$wheels/loopmend-*.whl" >/dev/null || { echo "skipped: there is no wheel in $wheels, which the test python.wheel makes" >&2; exit 77; }
[[ -x $folder/bin/python ]] || "$python" -m venv "$folder"
if ! "$folder/bin/pip" install --quiet --disable-pip-version-check bpy >"$folder/log" 2>&1; then
  echo "skipped: Blender is not to be had for $("$python" --version): $(tail -1 "$folder/log")" >&2
  exit 77
fi
rm -f "$folder"/*.zip
cp "$wheels"/loopmend-*.whl "$folder"
"$here/../../packaging/make_blender_extension" "$folder" || exit 77 # a wheel for another Python than Blender's
unset PYTHONPATH
"$folder/bin/python" "$here/fill_in_blender.py" "$folder"/loopmend-blender-*.zip
