#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the site of docs/ with the API reference, without network, and checks every link and anchor within it.
# Usage: docs/build_site.sh [--no-links] FOLDER   (a new or empty folder, or one that this made before)
#   --no-links: checks no more than mkdocs does, which refuses links to pages that are missing; the check of all takes a minute
# Exit code: 0 all well, 1 something is not, 77 a tool is missing (Debian: mkdocs-material doxygen libjs-katex linkchecker).
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
links=yes
if [[ ${1:-} == --no-links ]]; then
  links=no
  shift
fi
folder=$(realpath -m "${1:?Usage: docs/build_site.sh [--no-links] FOLDER}")
katex=/usr/share/javascript/katex
tools=(mkdocs doxygen)
[[ $links == no ]] || tools+=(linkchecker)
for tool in "${tools[@]}"; do
  command -v "$tool" >/dev/null || { echo "docs: $tool is missing" >&2; exit 77; }
done
[[ -d $katex ]] || { echo "docs: $katex is missing" >&2; exit 77; }
[[ ! -e $folder || -z $(ls -A "$folder") || -f $folder/sitemap.xml ]] ||
  { echo "docs: $folder holds other files; choose a new folder" >&2; exit 1; }
work=$(mktemp -d)
site=$work/site
trap 'rm -rf "$work"' EXIT

# The pages are copied, so that those of the whole project can be among them.
cp -r "$root/docs" "$root/mkdocs.yml" "$work"
cp "$root/CHANGELOG.md" "$work/docs/changes.md"
python3 "$root/docs/python_api.py" "$root/python/loopmend" "$work/docs/user/python_api.md"
find "$work/docs" \( -name '*.sh' -o -name '*.py' -o -name '*.sed' -o -name Doxyfile \) -delete
mkdocs --quiet build --strict --clean --config-file "$work/mkdocs.yml" --site-dir "$site"
mkdir -p "$site/assets/katex/contrib" "$site/assets/katex/fonts"
cp -L "$katex/katex.min.js" "$site/assets/katex"
sed -E 's/,url\([^)]*\.(woff|ttf)\) *format\([^)]*\)//g' "$katex/katex.min.css" >"$site/assets/katex/katex.min.css"
cp -L "$katex"/fonts/*.woff2 "$site/assets/katex/fonts"
cp -L "$katex/contrib/auto-render.js" "$site/assets/katex/contrib"

# A comment that Doxygen does not understand is an error.
version=$(sed -nE 's/^project\(Loopmend VERSION ([0-9.]+).*/\1/p' "$root/CMakeLists.txt")
(cd "$root" && {
  cat docs/Doxyfile
  echo "PROJECT_NUMBER = $version"
  echo "OUTPUT_DIRECTORY = $site/api"
} | doxygen -q -)

if [[ $links == yes ]]; then
  printf '[AnchorCheck]\n' >"$work/linkchecker.rc"
  chmod -R a+rX "$work" # linkchecker runs as nobody where it is started by root
  linkchecker --config "$work/linkchecker.rc" --no-status --no-follow-url '/api/' --ignore-url '^https?:' \
    "file://$site/index.html"
fi
# What is not ours among the pages: its notices.
for package in libjs-katex fonts-katex mkdocs-material mkdocs doxygen; do
  printf '===== from the Debian package %s =====\n\n' "$package"
  cat "/usr/share/doc/$package/copyright" 2>/dev/null || true
done >"$site/third_party_licenses.txt"
rm -rf "$folder"
mkdir -p "$(dirname "$folder")"
cp -r "$site" "$folder"
