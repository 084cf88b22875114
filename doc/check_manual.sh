#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Builds the manual and opens all of its pages in headless Chromium, for which no host resolves: checks that
# every local link leads to a file and that every equation is rendered. Leaves screenshots of the main pages
# in build/manual/pages.
set -eu
cd "$(dirname "$0")/.."
sh cmake/install_packages.sh chromium
sh doc/build_manual.sh
cd build/manual/html
mkdir -p ../pages
profile=$(mktemp -d)
trap 'rm -rf "$profile"' EXIT
browse() {
  chromium --headless --no-sandbox --disable-gpu --disable-quic --no-first-run --disable-background-networking \
    --disable-component-update --disable-sync --hide-scrollbars --host-resolver-rules='MAP * ~NOTFOUND' \
    --user-data-dir="$profile" --virtual-time-budget=20000 "$@" 2> "$profile/log"
}
bad=0
for page in *.html; do
  for link in $(grep -oE '(href|src|data)="[^"]*"' "$page" | sed -E 's/^[^"]*"([^"#?]*).*/\1/' | sort -u); do
    case $link in
      http*|javascript:*|"") ;;
      *) [ -e "$link" ] || { echo "$page: no file $link"; bad=1; } ;;
    esac
  done
  equations=$(grep -oE '\\[[(]' "$page" | wc -l)
  [ "$equations" = 0 ] && continue
  browse --dump-dom "file://$PWD/$page" > "$profile/dom"
  rendered=$(grep -o 'class="MathJax_SVG"' "$profile/dom" | wc -l)
  # MathJax shows an error in a red frame
  errors=$(grep -oE 'class="[^"]*MathJax_Error|stroke="rgb\(204, 0, 0\)"' "$profile/dom" | wc -l)
  echo "$page: $rendered of $equations equations rendered, $errors with errors"
  [ "$rendered" -ge "$equations" ] && [ "$errors" = 0 ] || bad=1
done
for page in index design performance accuracy citelist group__PkgPointSetFlowRef group__PkgPointSetFlowFunctions \
  group__PkgPointSetFlowParameters classPointSetFlow; do
  browse --window-size=1250,2000 --screenshot="../pages/$page.png" "file://$PWD/$page.html" > /dev/null
done
echo "pictures: build/manual/pages"
exit $bad
