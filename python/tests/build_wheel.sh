#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the source distribution and the wheel of this interpreter, which fills a mesh in an empty virtual environment, and looks into it.
# Usage: build_wheel.sh PYTHON BUILD FOLDER   (BUILD has the engine; FOLDER is made anew; the files stay there)
# Exit code: 0 all well, 1 something is not, 77 PyPI cannot be reached, which has what the build needs.
set -euo pipefail

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
python=$1 build=$2 folder=$3
rm -rf "$folder"
unset PYTHONPATH
"$here/../../packaging/make_wheels" "$build" "$folder" "$python"
cd "$folder"
[[ $(find . -name 'loopmend-*.whl' | wc -l) == 1 ]] || { echo "there is not one wheel" >&2; exit 1; }
wheel=$(find . -name 'loopmend-*-manylinux*.whl')
files=$("$python" -m zipfile -l "$wheel" | awk '{ print $1 }')
for file in loopmend/__init__.py loopmend/_core.pyi loopmend/py.typed loopmend/LICENSE loopmend/THIRD_PARTY_NOTICES.txt; do
  grep -qx "$file" <<<"$files" || { echo "$file is not in the wheel" >&2; exit 1; }
done
"$python" -c 'import sys, zipfile
print(zipfile.ZipFile(sys.argv[1]).read("loopmend/THIRD_PARTY_NOTICES.txt").decode())' "$wheel" | "$here/check_notices.sh"
if grep -qE '\.(h|a|cmake)$|^(bin|include|lib|share)/|libblas|liblapack|libgfortran' <<<"$files"; then
  echo "the wheel holds more than the package and its libraries:" >&2
  echo "$files" >&2
  exit 1
fi
megabytes=$(($(stat -c %s "$wheel") / 1000000))
((megabytes < 10)) || { echo "the wheel has $megabytes MB: packaging/slim_openblas makes it less than 10" >&2; exit 1; }
