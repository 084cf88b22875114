#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes learned_weights.h anew: records, trains and writes one network after the other, as README.md says.
#   train_all.sh BUILD FOLDER
# BUILD has POINT_SET_FLOW_BUILD_BENCHMARKS=ON. FOLDER receives weights, and for a time the records of each step.
set -eu
PATH=/usr/bin:$PATH # the Python that python3-torch is for
here=$(realpath "$(dirname "$0")")
build=$(realpath "$1")
header=$here/../../../include/CGAL/Point_set_flow/internal/fitting/learned_weights.h
mkdir -p "$2"
cd "$2"

write() { # write OPTIONS: the header, with what there is so far
  "$here/write_weights.py" "$@" > learned_weights.h
  cp learned_weights.h "$header"
}
record() { # record PROGRAM NAME FIRST LAST: in two processes
  cmake --build "$build" --target "$1"
  middle=$((($3 + $4) / 2))
  "$build/test/benchmark/$1" "$2_1.bin" "$3" "$middle" > "$2_1.log" &
  "$build/test/benchmark/$1" "$2_2.bin" "$middle" "$4" > "$2_2.log"
  wait $!
}
train() { # train TASK NAME OPTIONS: with the records of this name
  task=$1 name=$2
  shift 2
  "$here/train.py" "$task" "${name}_1.bin" "${name}_2.bin" --out "$name.txt" --threads 2 "$@" > "$name.log"
  rm "${name}_1.bin" "${name}_2.bin"
}

echo "0 0 0 0 0 0 0 0 0 9" > open.txt # a gate that is always open
write --gate open.txt
record record_sheets sheets_1 1000 1440
train sheets sheets_1 --epochs 6
write --gate open.txt --sheets sheets_1.txt
record record_sheets gate 4000 4120
train gate gate
record record_sheets sheets_2 2000 2440
train sheets sheets_2 --epochs 6
write --gate gate.txt --sheets sheets_1.txt sheets_2.txt
record record_features correction 3000 3460
train correction correction --epochs 6
write --gate gate.txt --sheets sheets_1.txt sheets_2.txt --correction correction.txt
