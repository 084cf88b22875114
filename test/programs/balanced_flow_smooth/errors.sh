#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What goes wrong is told, with the right exit code, and leaves no file behind.
. "$(dirname "$0")/checks.sh"

: > empty.xyz
: > empty.ply
ply_with() { printf 'ply\nformat ascii 1.0\nelement vertex 1\n%b\nend_header\n0 0 0 1 1 1\n' "$1"; }
xyz='property float x\nproperty float y\nproperty float z'
ply_with "$xyz\nproperty double nx\nproperty double ny\nproperty double nz" > huge.ply
sed -i 's/vertex 1/vertex 99999999999/' huge.ply
ply_with "$xyz\nproperty float nx" > partial.ply
ply_with "$xyz\nproperty float x" > twice.ply
ply_with "${xyz/float x/list uchar float x}" > list_x.ply
ply_with "$xyz\nproperty complex id" > complex.ply
ply_with "$xyz\nproperty list float int ids" > list.ply
ply_with "$xyz" | sed 's/ascii/morse/' > morse.ply
ply_with "$xyz" > columns.ply
printf 'ply\nformat ascii 1.0\nelement vertex 1\n%b\nelement face 2\nproperty list uchar int i\nend_header\n0 0 0\n1 0\n' "$xyz" > faces.ply
printf '3\n0 0 0\n1 0 0\n' > truncated.pts
head -8000 "$data/meshes/elephant.off" > faces.off
mkfifo fifo.xyz
printf '1 2 3\n4 five 6\n' > garbage.xyz
printf '1 2 3\n4 5\n' > short.xyz
printf '1 2 3\n4 5 6 7\n' > uneven.xyz
printf '0 0 0\n1 0 0\n0 nan 0\n' > nan.xyz
head -c 20000 "$data/points_3/hippo1.ply" > truncated.ply
head -200 "$data/meshes/elephant.off" > truncated.off
printf '4OFF\n1 0 0\n0 0 0 0\n' > four.off
printf '\0\1\2\3' > binary.dat
mkdir directory.xyz
check "missing file" fails_with 2 "cannot read missing.xyz: the file can not be opened" "$program" missing.xyz no.xyz
check "empty file" fails_with 2 "there are no points in it" "$program" empty.xyz no.xyz
check "empty PLY" fails_with 2 "not a complete PLY file" "$program" empty.ply no.xyz
check "PLY, part of a normal" fails_with 2 "nx, ny and nz must be there together" "$program" partial.ply no.xyz
check "PLY, two x" fails_with 2 "two properties called x" "$program" twice.ply no.xyz
check "PLY, a list of coordinates" fails_with 2 "be numbers and no lists" "$program" list_x.ply no.xyz
check "PLY, unknown type" fails_with 2 'the type in "property complex id" is not known' "$program" complex.ply no.xyz
check "PLY, unknown list" fails_with 2 'the type in "property list float int ids" is not known' "$program" list.ply no.xyz
check "PLY, unknown format" fails_with 2 'the format in "format morse 1.0" is not known' "$program" morse.ply no.xyz
check "PLY, other columns" fails_with 2 "line 8: 6 columns, but 3 are expected" "$program" columns.ply no.xyz
check "PLY, absurd number of points" fails_with 2 "too short for 99999999999 points" "$program" huge.ply no.xyz
check "PLY, without its last faces" fails_with 2 "it ends after 1 of 2 times face" "$program" faces.ply no.xyz
check "garbage" fails_with 2 'line 2: "five" is not a number' "$program" garbage.xyz no.xyz
check "too few columns" fails_with 2 "line 2: a point has three coordinates" "$program" short.xyz no.xyz
check "other columns" fails_with 2 "line 2: 4 columns, but 3 before" "$program" uneven.xyz no.xyz
check "not finite" fails_with 2 "cannot read nan.xyz: points[2] is (0, nan, 0)" "$program" nan.xyz no.xyz
check "truncated PLY" fails_with 2 "not a complete PLY file" "$program" truncated.ply no.xyz
check "truncated OFF" fails_with 2 "the file ends after" "$program" truncated.off no.xyz
check "OFF without its last faces" fails_with 2 "of 5558 faces" "$program" faces.off no.xyz
check "OFF in four dimensions" fails_with 2 "this is not an OFF file" "$program" four.off no.xyz
check "truncated PTS" fails_with 2 "announces 3 points, but there are 2" "$program" truncated.pts no.xyz
check "a directory as input" fails_with 2 "this is a directory" "$program" directory.xyz no.xyz
check "a directory as output" fails_with 2 "cannot write directory.xyz: this is a directory" "$program" colors.xyz directory.xyz
check "a pipe as output" fails_with 2 "this is not a regular file" "$program" colors.xyz fifo.xyz
check "no such directory" fails_with 2 "there is no directory nowhere" "$program" colors.xyz nowhere/no.xyz
check "unknown format" fails_with 2 'the format ".docx" is not known' "$program" colors.docx no.xyz
check "bytes that tell no format" fails_with 2 "can not be guessed: use --format" "$program" - - < binary.dat
check "a full disk" bash -c "'$program' colors.xyz - > /dev/full 2> full.log; [ \$? = 2 ] && grep -q 'cannot write standard output' full.log"
check "unknown option" fails_with 1 "unrecognised option '--speed'" "$program" colors.xyz no.xyz --speed 3
check "no files" fails_with 1 "is required" "$program"
check "no output" fails_with 1 "an output is required" "$program" colors.xyz
check "three files" fails_with 1 "more than two files need" "$program" a.xyz b.xyz c.xyz
check "bad value" fails_with 1 "step_length is -1" "$program" colors.xyz no.xyz --step-length -1
for noise in -1 nan; do
  check "noise of $noise" fails_with 1 "--noise is $noise, but must not be negative" "$program" colors.xyz no.xyz --noise $noise
done
check "infinite noise" fails_with 1 "noise is inf, but must be finite" "$program" colors.xyz no.xyz --noise inf
check "noise that is no number" fails_with 1 "('much') for option '--noise' is invalid" "$program" colors.xyz no.xyz --noise much
check "negative k" fails_with 1 "must not be negative" "$program" colors.xyz no.xyz -k -3
check "k of one" fails_with 1 "at least 2 neighbors" "$program" colors.xyz no.xyz -k 1
check "unknown flow" fails_with 1 'no flow "lava"' "$program" colors.xyz no.xyz --flow lava
check "unknown estimator" fails_with 1 'no curvature "ruler"' "$program" colors.xyz no.xyz --curvature ruler
check "unknown shell" fails_with 1 'no print-completion "csh"' "$program" --print-completion csh
check "standard input in place" fails_with 1 "standard input has no place" "$program" --in-place -
check "points and report in one stream" fails_with 1 "use --json=FILE" "$program" colors.xyz - --json
check "a directory that is not there" fails_with 1 "there is no directory nowhere" "$program" --output-dir nowhere colors.xyz
check "the directory of the input" fails_with 1 "is the input itself" "$program" --output-dir . colors.xyz
check "two files of one name" fails_with 1 "two files would become" "$program" --output-dir directory.xyz colors.xyz ./colors.xyz
check "failed runs leave no file" bash -c '! ls no.* *.part directory.xyz/* 2> /dev/null'

# ---- Ctrl-C and the like

awk 'BEGIN { srand(1); for (i = 0; i < 50000; ++i) print rand(), rand(), rand() / 100 }' > large.xyz
for signal in INT TERM; do
  cp large.xyz in_place.xyz
  (trap - INT; exec "$program" in_place.xyz --in-place --json=report.json --iterations 100000 2> interrupted.log) &
  pid=$!
  sleep 4
  kill -$signal $pid
  wait $pid
  check "SIG$signal gives its exit code" test $? = $((128 + $(kill -l $signal)))
  check "SIG$signal is told" grep -q "interrupted, nothing written" interrupted.log
  check "SIG$signal leaves the file" cmp large.xyz in_place.xyz
  check "SIG$signal leaves nothing else" bash -c '! ls *.part 2> /dev/null'
  check "SIG$signal is in the report" grep -q '"status": "interrupted"' report.json
done
echo "all checks passed"
