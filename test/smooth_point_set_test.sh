#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Tests the program smooth_point_set from outside.
#   smooth_point_set_test.sh <program> <directory of CGAL's sample data> <work directory>
set -u
program=$1 data=$2 work=$3
rm -rf "$work" && mkdir -p "$work" && cd "$work" || exit 1

check() { # check "what" command...
  local what=$1
  shift
  if "$@"; then echo "ok: $what"; else echo "FAILED: $what"; exit 1; fi
}
fails_with() { # fails_with code "part of the message" command...
  local code=$1 message=$2 out status
  shift 2
  out=$("$@" 2>&1)
  status=$?
  [ "$status" = "$code" ] && [[ $out == *"$message"* ]] && return
  echo "exit code $status (expected $code), output: $out (expected: $message)"
  return 1
}
# the numbers from a column on, without comments: however they are written
columns() { sed 's/#.*//' "$2" | awk -v from="$1" '!/[A-Za-z]/ && NF { line = ""; for (i = from; i <= NF; ++i) line = line " " $i + 0; print line }'; }

# ---- all other properties are kept

cat > colors.xyz <<'END'
# x y z r g b label
0 0 0.1 255 0 12 3
1 0 0 254 1 13 3
0 1 -0.1 253 2 14 4
1 1 0 252 3 15 4
0.5 0.5 0.25 251 4 16 5
2 0 0.1 250 5 17 5
END
check "a run on XYZ" "$program" colors.xyz out.xyz -k 4 -q
check "XYZ keeps its columns" diff <(columns 4 <(tail -n +2 colors.xyz)) <(columns 4 out.xyz)
check "XYZ has new points" bash -c "! diff <(awk '{print \$1, \$2, \$3}' colors.xyz) <(awk '{print \$1, \$2, \$3}' out.xyz) > /dev/null"
check "nothing moves in 0 iterations" "$program" colors.xyz same.xyz -q --iterations 0
check "the text is the same" diff <(tail -n +2 colors.xyz) same.xyz

"$program" colors.xyz colors.ply -q --iterations 0 && "$program" colors.ply back.xyz -q --iterations 0
check "XYZ to PLY and back" diff same.xyz back.xyz

cat > labels.ply <<'END'
ply
format ascii 1.0
comment made for a test
element vertex 6
property float x
property float y
property float z
property uchar red
property uchar green
property uchar blue
property float intensity
property int label
end_header
0 0 0.125 255 0 1 0.5 -7
1 0 0 254 1 2 0.25 -6
0 1 -0.125 253 2 3 0.125 -5
1 1 0 252 3 4 1.5 -4
0.5 0.5 0.25 251 4 5 2.5 70000
2 0 0.125 250 5 6 3.5 -2
END
check "a run on PLY" "$program" labels.ply out.ply -k 4 -q
check "PLY keeps names and types" diff <(grep -a '^property' labels.ply | tail -n +4 | sort) <(grep -a '^property' out.ply | tail -n +4 | sort)
check "PLY keeps the values" diff <(sed '1,/end_header/d' labels.ply | cut -d' ' -f4- | tr -d '\r' | sort) \
  <("$program" out.ply values.xyz -q --iterations 0 && cut -d' ' -f4- values.xyz | sort)
check "PLY keeps comments" grep -aq 'made for a test' out.ply
check "PLY stays ASCII" grep -aq '^format ascii' out.ply

check "a run on OFF" "$program" "$data/meshes/mesh_with_colors.off" out.off -q
check "OFF keeps counts, colors and faces" diff \
  <(columns 4 "$data/meshes/mesh_with_colors.off") <(columns 4 out.off)
check "OFF keeps its keyword" grep -q '^COFF' out.off
check "a run on a mesh" "$program" "$data/meshes/elephant.off" elephant.off -q
check "its faces are the same to the letter" diff <(tail -n 5000 "$data/meshes/elephant.off") <(tail -n 5000 elephant.off)

"$program" "$data/points_3/b9_training.ply" b9.ply -q
check "colors and labels of a LiDAR tile" diff <(grep -a '^property' "$data/points_3/b9_training.ply" | tail -n +4 | sort) \
  <(grep -a '^property' b9.ply | tail -n +4 | sort)

cp colors.xyz in_place.xyz
check "in place" "$program" in_place.xyz in_place.xyz -q -k 4
check "in place, same result" cmp in_place.xyz out.xyz
check "sequential is parallel" bash -c "'$program' '$data/points_3/kitten.xyz' a.xyz -q --threads 1 && '$program' '$data/points_3/kitten.xyz' b.xyz -q && cmp a.xyz b.xyz"
cp colors.xyz target.xyz && chmod 600 target.xyz && ln -s target.xyz link.xyz
check "in place through a link" "$program" link.xyz link.xyz -q -k 4
check "the link is still one, with the permissions of its file" bash -c "cmp target.xyz out.xyz && [ -L link.xyz ] && [ \$(stat -c %a target.xyz) = 600 ]"
check "normals on request" bash -c "'$program' colors.xyz n.xyz -q -k 4 --normals && [ \$(head -1 n.xyz | wc -w) = 10 ]"
check "a summary" bash -c "'$program' '$data/points_3/kitten.xyz' s.xyz --flow curvature --feature-threshold 100 | grep -q 'estimated noise'"

# ---- errors

: > empty.xyz
: > empty.ply
ply_with() { printf 'ply\nformat ascii 1.0\nelement vertex 1\n%b\nend_header\n0 0 0 1 1 1\n' "$1"; }
xyz='property float x\nproperty float y\nproperty float z'
ply_with "$xyz\nproperty double nx\nproperty double ny\nproperty double nz" > mixed.ply
ply_with "${xyz//float/int}" > integers.ply
ply_with "$xyz\nproperty int64 id" > int64.ply
ply_with "$xyz\nproperty int index" > index.ply
sed 's/vertex 1/vertex 99999999999/' mixed.ply > huge.ply
printf '3\n0 0 0\n1 0 0\n' > truncated.pts
head -8000 "$data/meshes/elephant.off" > faces.off
mkfifo fifo.xyz
printf '1 2 3\n4 five 6\n' > garbage.xyz
printf '1 2 3\n4 5\n' > short.xyz
printf '0 0 0\n1 0 0\n0 nan 0\n' > nan.xyz
head -c 20000 "$data/points_3/hippo1.ply" > truncated.ply
head -20 "$data/meshes/elephant.off" > truncated.off
mkdir directory.xyz
check "missing file" fails_with 2 "cannot read missing.xyz: the file can not be opened" "$program" missing.xyz no.xyz
check "empty file" fails_with 2 "there are no points in it" "$program" empty.xyz no.xyz
check "empty PLY" fails_with 2 "not a complete PLY file" "$program" empty.ply no.xyz
check "PLY, normals of another type" fails_with 2 "with the type of x, y and z" "$program" mixed.ply no.xyz
check "PLY, integer coordinates" fails_with 2 "of type float or double" "$program" integers.ply no.xyz
check "PLY, unknown type" fails_with 2 'the type in "property int64 id" is not known' "$program" int64.ply no.xyz
check "PLY, a name of CGAL" fails_with 2 'the property name "index" is taken' "$program" index.ply no.xyz
check "PLY, absurd number of points" fails_with 2 "too short for 99999999999 points" "$program" huge.ply no.xyz
check "garbage" fails_with 2 'line 2: "five" is not a number' "$program" garbage.xyz no.xyz
check "too few columns" fails_with 2 "line 2: a point has three coordinates" "$program" short.xyz no.xyz
check "not finite" fails_with 1 "points[2] is (0, nan, 0)" "$program" nan.xyz no.xyz
check "truncated PLY" fails_with 2 "not a complete PLY file" "$program" truncated.ply no.xyz
check "truncated OFF" fails_with 2 "the file ends after" "$program" truncated.off no.xyz
check "OFF without its last faces" fails_with 2 "of 5558 faces" "$program" faces.off no.xyz
check "truncated PTS" fails_with 2 "announces 3 points, but there are 2" "$program" truncated.pts no.xyz
check "a directory as input" fails_with 2 "this is a directory" "$program" directory.xyz no.xyz
check "a directory as output" fails_with 2 "cannot write directory.xyz: this is a directory" "$program" colors.xyz directory.xyz
check "a pipe as output" fails_with 2 "this is not a regular file" "$program" colors.xyz fifo.xyz
check "no such directory" fails_with 2 "there is no directory nowhere" "$program" colors.xyz nowhere/no.xyz
check "unknown format" fails_with 2 'the format ".docx" is not known' "$program" colors.docx no.xyz
check "unknown option" fails_with 1 "unrecognised option" "$program" colors.xyz no.xyz --speed 3
check "no files" fails_with 1 "is required" "$program"
check "bad value" fails_with 1 "step_length is -1" "$program" colors.xyz no.xyz --step-length -1
check "negative k" fails_with 1 "must not be negative" "$program" colors.xyz no.xyz -k -3
check "unknown flow" fails_with 1 'no flow "lava"' "$program" colors.xyz no.xyz --flow lava
check "help" bash -c "'$program' --help | grep -q sharpness-angle"
check "failed runs leave no file" bash -c '! ls no.xyz* *.part 2> /dev/null'

# ---- Ctrl-C

awk 'BEGIN { srand(1); for (i = 0; i < 400000; ++i) print rand(), rand(), rand() / 100 }' > large.xyz
"$program" large.xyz interrupted.xyz --iterations 1000 2> interrupted.log &
pid=$!
sleep 4
kill -INT $pid
wait $pid
check "Ctrl-C gives 130" test $? = 130
check "Ctrl-C says so" grep -q "interrupted, nothing written" interrupted.log
check "Ctrl-C leaves no file" bash -c '! ls interrupted.xyz* 2> /dev/null'
echo "all checks passed"
