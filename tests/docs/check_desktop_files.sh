#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The validators of the desktop find nothing, and the version is the same wherever it stands.
# Usage: check_desktop_files.sh FOLDER   (packaging/ of the build folder)
# Exit code: 0 all well, 1 something is not, 77 a validator is missing.
set -euo pipefail

made=$1
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
for tool in desktop-file-validate appstreamcli xmllint; do
  command -v "$tool" >/dev/null || { echo "$tool is missing" >&2; exit 77; }
done
fail() {
  printf '%s\n' "$*" >&2
  exit 1
}

desktop-file-validate "$root"/packaging/linux/*.desktop
appstreamcli validate --no-net "$made"/*.metainfo.xml
xmllint --noout "$root/packaging/linux/loopmend.mime.xml"

# With an address of the pages the metainfo has screenshots; that has to be valid, too.
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
sed "s,@LOOPMEND_HOME_PAGE@,https://example.org,g" "$root/packaging/linux/metainfo_web.xml" >"$folder/web"
sed "/<provides>/{
  h
  r $folder/web
  g
  N
}" "$made/org.loopmend.Loopmend.metainfo.xml" >"$folder/org.loopmend.Loopmend.metainfo.xml"
appstreamcli validate --no-net "$folder/org.loopmend.Loopmend.metainfo.xml"

# Each type of file that the desktop entry names is one of the system's or one of ours.
for type in $(sed -n 's/^MimeType=//p' "$root"/packaging/linux/*.desktop | tr ';' ' '); do
  grep -qF "\"$type\"" "$root/packaging/linux/loopmend.mime.xml" /usr/share/mime/packages/freedesktop.org.xml ||
    fail "nothing knows the type $type"
done

version=$(sed -nE 's/^project\(Loopmend VERSION ([0-9.]+).*/\1/p' "$root/CMakeLists.txt")
grep -qx "version: $version" "$root/CITATION.cff" || fail "CITATION.cff has another version than $version"
