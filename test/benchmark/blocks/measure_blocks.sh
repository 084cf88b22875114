#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Measures smoothing beyond memory against smoothing in memory, on terrains of several sizes:
#   measure_blocks.sh BALANCED_FLOW_SMOOTH BALANCED_FLOW_BLOCKS FOLDER MEMORY POINTS...
# Prints processor time for each point and the largest resident memory of each step. Above MOST_IN_MEMORY points, by default
# 20 million, nothing is smoothed in memory. Needs GNU time, and about 150 bytes of disk for each point.
set -eu
smooth=$(realpath "$1") blocks=$(realpath "$2") memory=$4
make_terrain=$(realpath "$(dirname "$0")/make_terrain.py")
mkdir -p "$3"
cd "$3"
shift 4
timed() { # timed WHAT POINTS COMMAND...
  what=$1 points=$2
  shift 2
  command time -o time.txt -f "%U %S %e %M" "$@"
  awk -v what="$what" -v n="$points" \
    '{ printf "| %s | %d | %.2f | %.0f | %.0f |\n", what, n, ($1 + $2) / n * 1e6, $3, $4 / 1024 }' time.txt
}
echo "| step | points | µs of processor time per point | seconds | MB |"
echo "|---|--:|--:|--:|--:|"
for points; do
  "$make_terrain" "$points" terrain.ply
  if [ "$points" -le "${MOST_IN_MEMORY:-20000000}" ]; then
    timed "in memory" "$points" "$smooth" -q terrain.ply expected.ply
  fi
  rm -rf work
  timed "plan" "$points" "$blocks" plan -q --memory "$memory" work terrain.ply
  timed "smooth" "$points" sh -c 'last=$(($(ls work/blocks | wc -l) - 1)); for b in $(seq 0 $last); do "$1" smooth -q work $b; done' sh "$blocks"
  timed "join" "$points" "$blocks" join -q work
  if [ -e expected.ply ]; then
    cmp expected.ply work/smoothed/terrain.ply
    rm expected.ply
  fi
  rm -r work terrain.ply
done
