#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes the tables of speed and memory of the manual, and its plots, from runs on this machine, which
# should have nothing else to do for about 40 minutes, and 16 GB of memory: measure_speed.sh BENCHMARK_SPEED FOLDER
set -eu
run=$(realpath "$1")
mkdir -p "$2"
cd "$2"
# one pass of each peer, and the neighbor graphs
"$run" --points 1000000 --orders unordered ordered --csv peers.csv | tee peers.md
# scan lines
"$run" --points 1000000 --samplings scan --orders ordered --repeats 1 --csv scan.csv | tee scan.md
# threads
"$run" --points 1000000 --orders unordered --threads 1 2 --methods ours "our graph" --csv threads.csv | tee threads.md
# sizes
"$run" --points 10000 100000 1000000 10000000 --orders unordered --methods ours "our graph" --repeats 1 --csv sizes.csv | tee sizes.md
"$run" --points 10000 100000 1000000 --orders unordered --methods jet bilateral Neighbor_query --repeats 1 --csv peer_sizes.csv | tee peer_sizes.md
# phases
"$run" --phases --points 1000000 --orders unordered --threads 1 2 | tee phases.md
# what the machine can do
"$run" --machine | tee machine.md
# the default number of points in a block is exceeded
"$run" --points 100000000 --orders unordered --threads 2 --methods ours --repeats 1 | tee large.md
# steps and neighbors
"$(dirname "$run")/benchmark_accuracy" --groups cost --points 20000 | tee cost.md
# duplicates, lines, far points
"$run" --points 100000 --orders unordered --difficult | tee difficult.md

cat > plot.gnuplot <<'EOF'
set terminal svg size 720,420 background "white"
set output "speed.svg"
set datafile separator ","
set logscale xy
set key left top
set xlabel "points"
set ylabel "seconds, one thread"
set format x "10^{%L}"
set grid
plot "<grep -h ',ours,' sizes.csv" using 2:5 with linespoints lw 2 title "ours, whole run", \
     "<grep -h ',jet,' peer_sizes.csv" using 2:5 with linespoints lw 2 title "jet, one pass", \
     "<grep -h ',bilateral,' peer_sizes.csv" using 2:5 with linespoints lw 2 title "bilateral, one pass, normals given", \
     "<grep -h ',our graph,' sizes.csv" using 2:5 with linespoints dt 2 title "our neighbor graph, k=20", \
     "<grep -h ',Neighbor_query,' peer_sizes.csv" using 2:5 with linespoints dt 2 title "Neighbor\\_query, k=20"
set output "cost.svg"
unset logscale
set datafile separator "|"
set key right top
set xlabel "time of one jet pass"
set ylabel "rms error to that of jet"
set format x "%g"
plot "<grep '^| steps: [0-9]* |' cost.md" using 3:4 with linespoints lw 2 title "1 to 12 steps", \
     "<grep '^| neighbors' cost.md" using 3:4 with linespoints lw 2 title "40% to 150% of the neighbors"
EOF
if command -v gnuplot > /dev/null; then gnuplot plot.gnuplot; fi
