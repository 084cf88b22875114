#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Tests the page of compare_smoothers --html: the file by itself, and in Chromium if it is installed.
#   page.sh <program> <directory of CGAL's sample data> <work directory>
check_script=$(cd "$(dirname "$0")" && pwd)/page_check.js
. "$(dirname "$0")/../program_test.sh"

quietly() { "$@" > log 2>&1 || { cat log; false; }; }
data_of() { sed -n 's|^.*<script type="application/json" id="data">||p' "$1"; }
# the numbers of the arrays of that name, one array after the other: sizes in bytes
array_sizes() {
  data_of "$1" | grep -oE '"(x|y|z|normal_x|normal_y|curvature|feature|error)":\{[^}]*\}' |
    sed 's/.*"data":"\([^"]*\)".*/\1/' | while read -r text; do echo "$text" | base64 -d | wc -c; done
}
# page number-of-clouds arrays-of-a-cloud points: the arrays decode to as many points
arrays_are_complete() {
  array_sizes "$1" | awk -v n="$(($2 * $3))" -v bytes="$((2 * $4))" '
    $1 != bytes { bad = 1 } END { if (bad || NR != n) print NR " arrays, last of " $1 " bytes"; exit bad || NR != n }'
}
self_contained() { # but for the data, which have a line of their own
  grep -q "default-src 'none'" "$1" && ! grep -vE '^<script type="application/json"' "$1" |
    grep -E '://|url\(|@import|fetch\(|XMLHttpRequest|WebSocket|(src|href)="[^"d]'
}
# rms of the decoded errors of a cloud, in thousandths
rms_error() {
  data_of "$1" | grep -oE "\"name\":\"$2\".*" | grep -oE '"error":\{[^}]*\}' | head -1 > error
  sed 's/.*"data":"\([^"]*\)".*/\1/' error | base64 -d | od -An -v -tu2 --endian=little -w2 |
    awk -v low="$(sed 's/.*"low":\([^,]*\),.*/\1/' error)" -v high="$(sed 's/.*"high":\([^,]*\),.*/\1/' error)" '
      { x = low + $1 / 65535 * (high - low); s += x * x } END { print 1000 * sqrt(s / NR) }'
}
near() { awk -v a="$1" -v b="$2" 'BEGIN { d = a - b; exit !(a != "" && b != "" && d * d < 1e-6 * b * b) }'; }

check "a page of a mesh" quietly "$program" "$data/meshes/fandisk.off" --points 3000 --html --methods none jet bilateral ours -o mesh
page=mesh/comparison.html
check "it needs nothing else" self_contained $page
check "its data decode to all points" arrays_are_complete $page 5 8 3000
check "its errors are those of the table" near "$(rms_error $page ours)" "$(awk -F, 'END { print $2 ? $(NF - 14) : "" }' mesh/comparison.csv | tr -d '"')"
check "it is small" test "$(wc -c < $page)" -lt 500000

awk 'BEGIN { srand(1); for (i = 0; i < 1500; ++i) print 5000 + 3 * rand(), 2 * rand(), 7 + .02 * (rand() - .5) }' > '<!--<script>.xyz'
check "a page of a scan" quietly "$program" '<!--<script>.xyz' --html --html-points 400 --methods none wlop ours -o scan
check "it needs nothing else, either" self_contained scan/comparison.html
check "it has a sample, and no errors" arrays_are_complete scan/comparison.html 3 7 400
check "a file's name is no part of the page" test "$(grep -c '<script' scan/comparison.html)" = 2
check "without --html there is no page" bash -c "'$program' '<!--<script>.xyz' --methods none -o no > /dev/null 2>&1 && ! test -e no/comparison.html"
check "no points are refused" bash -c "! '$program' '<!--<script>.xyz' --html --html-points 0 -o no 2> message && grep -q 'html-points' message"

chromium=$(command -v chromium chromium-browser google-chrome | head -1)
if [ -z "$chromium" ]; then
  echo "all checks passed; Chromium is not installed, so the page was not looked at"
  exit 0
fi
# browse page option...: in a browser of its own, without network; its output is in the file out.
# What the page says to the console is an error.
browse() {
  local page=$1 as_root=
  shift
  [ "$(id -u)" = 0 ] && as_root=--no-sandbox
  rm -rf profile
  timeout 120 "$chromium" --headless $as_root --use-angle=swiftshader --enable-unsafe-swiftshader --no-first-run \
    --disable-quic --disable-background-networking --disable-component-update --disable-sync \
    --host-resolver-rules='MAP * ~NOTFOUND' --user-data-dir="$PWD/profile" --enable-logging=stderr \
    --hide-scrollbars --window-size=1400,950 "$@" "file://$PWD/$page" > out 2> messages
  ! grep -a CONSOLE messages
}
says() { grep -qE "<html[^>]* $2=\"$3\"" "$1" || { grep -oE '<html[^>]*>' "$1"; false; }; }
is_picture() { test "$(head -c 4 "$1" | tail -c 3)" = PNG && test "$(wc -c < "$1")" -gt 50000; }

check "Chromium opens the page" browse $page --dump-dom
check "four panels are drawn" says out data-check "passed: 4 panels, 12000 points"
check "its table has all methods" test "$(grep -o '<th scope="row">' out | wc -l)" = 4
check "Chromium makes a picture" browse $page --screenshot="$PWD/mesh.png"
check "it is one" is_picture mesh.png
check "Chromium opens the page of a scan" browse scan/comparison.html --dump-dom
check "three panels are drawn" says out data-check "passed: 3 panels, 1200 points"
check "it says that this is a sample" grep -q 'random sample of 400 of 1,500' out
for kind in mesh scan; do
  { cat $kind/comparison.html; echo '<script>'; cat "$check_script"; echo '</script>'; } > $kind/used.html
  check "Chromium uses the page of a $kind" browse $kind/used.html --dump-dom
  check "all that a user does works" says out data-test passed
done
browse $page --dump-dom --disable-3d-apis
check "without WebGL it says so" grep -q 'does not offer WebGL 2' out
check "and has its numbers" test "$(grep -o '<th scope="row">' out | wc -l)" = 4
echo "all checks passed"
