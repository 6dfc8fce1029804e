#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the site of docs/ with the API reference, without network, and checks every link and anchor within it.
# Usage: docs/build_site.sh FOLDER
# Exit code: 0 all well, 1 something is not, 77 a tool is missing (Debian: mkdocs-material doxygen libjs-katex linkchecker).
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
folder=$(realpath -m "${1:?Usage: docs/build_site.sh FOLDER}")
katex=/usr/share/javascript/katex
for tool in mkdocs doxygen linkchecker; do
  command -v "$tool" >/dev/null || { echo "docs: $tool is missing" >&2; exit 77; }
done
[[ -d $katex ]] || { echo "docs: $katex is missing" >&2; exit 77; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The pages are copied, so that those of the whole project can be among them.
cp -r "$root/docs" "$root/mkdocs.yml" "$work"
cp "$root/CHANGELOG.md" "$work/docs/changes.md"
mkdocs --quiet build --strict --clean --config-file "$work/mkdocs.yml" --site-dir "$folder"
mkdir -p "$folder/assets/katex/contrib" "$folder/assets/katex/fonts"
cp -L "$katex/katex.min.js" "$folder/assets/katex"
sed -E 's/,url\([^)]*\.(woff|ttf)\) *format\([^)]*\)//g' "$katex/katex.min.css" >"$folder/assets/katex/katex.min.css"
cp -L "$katex"/fonts/*.woff2 "$folder/assets/katex/fonts"
cp -L "$katex/contrib/auto-render.js" "$folder/assets/katex/contrib"

# A comment that Doxygen does not understand is an error.
version=$(sed -nE 's/^project\(Loopmend VERSION ([0-9.]+).*/\1/p' "$root/CMakeLists.txt")
(cd "$root" && {
  cat docs/Doxyfile
  echo "PROJECT_NUMBER = $version"
  echo "OUTPUT_DIRECTORY = $folder/api"
} | doxygen -q -)

printf '[AnchorCheck]\n' >"$work/linkchecker.rc"
chmod -R a+rX "$work" # linkchecker runs as nobody where it is started by root
linkchecker --config "$work/linkchecker.rc" --no-status --no-follow-url '/api/' --ignore-url '^https?:' \
  "file://$folder/index.html"
