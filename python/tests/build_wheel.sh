#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the wheel, installs it into an empty virtual environment, and fills a mesh in three lines.
# Usage: build_wheel.sh PYTHON FOLDER   (FOLDER is made anew; the wheel stays there)
# It compiles the whole engine a second time, so it runs only where LOOPMEND_TEST_WHEEL=1 asks for it.
# Exit code: 0 all well, 1 something is not, 77 not asked for, or PyPI cannot be reached, which has what the build needs.
set -euo pipefail

if [[ ${LOOPMEND_TEST_WHEEL:-} != 1 ]]; then
  echo "skipped: compiles the whole engine; LOOPMEND_TEST_WHEEL=1 runs it" >&2
  exit 77
fi

here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
python=$1 folder=$2
rm -rf "$folder"
mkdir -p "$folder"
"$python" -m venv "$folder/builder" || { echo "skipped: no virtual environment can be made" >&2; exit 77; }
if ! "$folder/builder/bin/pip" install --quiet --disable-pip-version-check "scikit-build-core>=0.10" "pybind11>=2.12" \
  >"$folder/log" 2>&1; then
  echo "skipped: scikit-build-core and pybind11 are not to be had: $(tail -1 "$folder/log")" >&2
  exit 77
fi
# The compiler by the name that CMake gives it, under which ccache knows what it compiled.
PATH="$folder/builder/bin:$PATH" CC=${CC:-cc} CXX=${CXX:-c++} CMAKE_BUILD_PARALLEL_LEVEL=${CMAKE_BUILD_PARALLEL_LEVEL:-1} \
  "$folder/builder/bin/pip" wheel --disable-pip-version-check --no-build-isolation --no-deps -w "$folder" "$here/../.." \
  >"$folder/log" 2>&1 || { tail -30 "$folder/log" >&2; exit 1; }
"$python" -m venv "$folder/user"
"$folder/user/bin/pip" install --quiet --disable-pip-version-check "$folder"/loopmend-*.whl >"$folder/log" 2>&1 ||
  { echo "skipped: NumPy is not to be had: $(tail -1 "$folder/log")" >&2; exit 77; }

cd "$folder"
unset PYTHONPATH
filled=$(user/bin/python -c '
import loopmend
scan = loopmend.sample()
result = loopmend.fill(scan)
print(*(hole.status for hole in result.holes))')
echo "the sample: $filled"
[[ $filled == "skipped early_stop early_stop early_stop early_stop early_stop" ]]
files=$(user/bin/python -m zipfile -l "$folder"/loopmend-*.whl | awk '{ print $1 }')
for file in loopmend/__init__.py loopmend/_core.pyi loopmend/py.typed loopmend/LICENSE loopmend/THIRD_PARTY_NOTICES.txt; do
  grep -qx "$file" <<<"$files" || { echo "$file is not in the wheel" >&2; exit 1; }
done
notices=$(user/bin/python -c 'import loopmend, pathlib
print((pathlib.Path(loopmend.__file__).parent / "THIRD_PARTY_NOTICES.txt").read_text())')
"$here/check_notices.sh" <<<"$notices"
if grep -qE '\.(h|a|cmake)$|^(bin|include|lib|share)/' <<<"$files"; then
  echo "the wheel holds more than the package:" >&2
  echo "$files" >&2
  exit 1
fi
ls -l "$folder"/loopmend-*.whl
