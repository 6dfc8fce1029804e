#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The notices name what is compiled into the Python module, with the words of each licence.
# Usage: check_notices.sh NOTICES.PY BUILD MODULE, or with the notices at the standard input
# Exit code: 0 all well, 1 something is missing, 77 there is no dpkg, whose records have the licences.
set -euo pipefail

command -v dpkg-query >/dev/null || { echo "skipped: there is no dpkg" >&2; exit 77; }
if (($# == 3)); then
  file=$(mktemp)
  trap 'rm -f "$file"' EXIT
  python3 "$1" --build "$2" --module "$3" "$file"
  notices=$(cat "$file")
else
  notices=$(cat)
fi

others='These (are loaded from the system, and are not contained|libraries are in loopmend.libs):'
compiled_in=$(sed -E "/^$others/,\$d" <<<"$notices")
# The name of the package, then words that only its licence has.
while read -r package words; do
  grep -qE "^  (.*, )?$package" <<<"$compiled_in" || { echo "$package is not among what is compiled in:" >&2; head -60 <<<"$compiled_in" >&2; exit 1; }
  grep -q "$words" <<<"$notices" || { echo "the licence of $package is missing: no '$words'" >&2; exit 1; }
done <<'END'
libeigen3-dev Mozilla Public License Version 2.0
libcgal-dev GNU LESSER GENERAL PUBLIC LICENSE
libopenmesh-dev RWTH
libboost Boost Software License
nlohmann-json3-dev Niels Lohmann
libtbb-dev Apache License
libgmp-dev Free Software Foundation
pybind11 Wenzel Jakob
END
if grep -qE '^  (.*, )?(libvtk9|qtbase5|libqt5|libcli11)' <<<"$compiled_in"; then
  echo "the notices name what is not in the module:" >&2
  echo "$compiled_in" >&2
  exit 1
fi
libraries=$(sed -nE "/^$others/,\$p" <<<"$notices")
for library in libopenblas libtbb libzip4; do
  head -40 <<<"$libraries" | grep -q "^  $library" || { echo "$library is not among what is loaded" >&2; exit 1; }
done
