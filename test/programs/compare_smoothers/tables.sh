#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Tests the program compare_smoothers from outside.
#   tables.sh <program> <directory of CGAL's sample data> <work directory>
. "$(dirname "$0")/../program_test.sh"

# field file row column: a number of the CSV table by the names of its row and column
field() {
  tr -d '"' < "$1" | sed 's/, /; /g' | awk -F, -v row="$2" -v column="$3" '
    NR == 1 { for (i = 1; i <= NF; ++i) if ($i == column) c = i }
    $1 == row { print $c }'
}
between() { awk -v low="$1" -v x="$2" -v high="$3" 'BEGIN { exit !(x != "" && low <= x && x <= high) }'; }
# all numbers are finite; whole rows: how many are expected, with this many columns
table_is_complete() {
  tr -d '"' < "$1" | sed 's/, /; /g' | awk -F, -v rows="$2" -v columns="$3" '
    NF != columns { print "line " NR " has " NF " columns"; bad = 1 }
    NR > 1 { for (i = 2; i <= NF; ++i) if ($i !~ /^-?[0-9.]+(e[-+]?[0-9]+)?$/ && !($1 == "WLOP" && $i == "")) { print "line " NR ": " $i; bad = 1 } }
    END { if (NR != rows + 1) print NR - 1 " rows"; exit bad || NR != rows + 1 }'
}

check "a mesh" "$program" "$data/meshes/fandisk.off" --points 1500 --noise 2 --seed 3 -o mesh
check "its table is complete" table_is_complete mesh/comparison.csv 10 16
check "its Markdown has all rows" test "$(grep -c '^|' mesh/comparison.md)" = 12
check "isotropic noise of 2% has that rms" between 18 "$(field mesh/comparison.csv none rms)" 20.6
check "jet denoises" between 0 "$(field mesh/comparison.csv 'jet; k=24' rms)" 17
check "nothing drifts in none" between 0 "$(field mesh/comparison.csv none drift)" 0
check "as many clouds as methods" test "$(ls mesh/*.ply | wc -l)" = 10
check "a cloud has all points" grep -aq '^element vertex 1500' mesh/ours.ply
check "a cloud has errors and colors" test "$(grep -acE '^property (double signed_error|uchar (red|green|blue))' mesh/ours.ply)" = 4

# points on a plane, far from the origin, and the same with noise of deviation 0.01 x sqrt(1/3)
awk 'BEGIN { srand(1); for (i = 0; i < 1500; ++i) { x = 5000 + rand(); y = rand();
  print x, y, 7 > "clean.xyz"; print x, y, 7 + .02 * (rand() - .5) > "noisy.xyz" } }'
check "two files" "$program" noisy.xyz clean.xyz -o files --methods none jet ours
check "their table is complete" table_is_complete files/comparison.csv 3 14
sigma=$(awk 'BEGIN { print 1000 * .01 / sqrt(3) / (sqrt(2) / 2) }') # the square has half a diagonal as radius
check "the noise is what was added" between "$(awk "BEGIN { print .93 * $sigma }")" "$(field files/comparison.csv none rms)" "$(awk "BEGIN { print 1.07 * $sigma }")"
"$program" files/none.ply noisy.xyz -o back --methods none
check "clouds are where the data are" between 0 "$(field back/comparison.csv none rms)" 1e-6

check "one file" "$program" noisy.xyz -o scan --methods none jet wlop ours
check "its table has what is known without a truth" table_is_complete scan/comparison.csv 4 7
check "jet moves points" between 1 "$(field scan/comparison.csv 'jet; k=24' movement)" 30
check "jet makes them less rough" between 0 "$(field scan/comparison.csv 'jet; k=24' roughness)" "$(field scan/comparison.csv none roughness)"

head -100 noisy.xyz > short.xyz
check "files of different length are refused" bash -c "! '$program' short.xyz clean.xyz -o no 2> message && grep -q 'different numbers' message"
check "an unknown method is refused" bash -c "! '$program' noisy.xyz --methods lava -o no 2> message && grep -q 'no method \"lava\"' message"
check "a missing file is refused" bash -c "! '$program' missing.xyz -o no 2> message && grep -q 'cannot read' message"
check "help" bash -c "'$program' --help | grep -q methods"
echo "all checks passed"
