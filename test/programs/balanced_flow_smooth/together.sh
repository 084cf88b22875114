#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Scans of one scene that are smoothed as one: each file keeps its format, and all are written or none.
. "$(dirname "$0")/checks.sh"

# Three scans of the same ground, .2 above, below and above it, with noise of .05
cat > make.py <<'END'
import random, struct
random.seed(7)
def scan(n, offset, shift=0.):
    return [(50 * random.random() + shift, 50 * random.random(), offset + random.gauss(0, .05)) for i in range(n)]
scans = [scan(1500, .2), scan(1400, -.2), scan(600, .2)]
rows = [["%.6f %.6f %.6f" % p for p in s] for s in scans]
open("a.xyz", "w").write("# a comment\n" + "".join("%s %d word\n" % (r, i) for i, r in enumerate(rows[0])))
open("b.csv", "w", newline="").write("label,z,y,x\r\n" + "".join(",".join(["%d" % i] + r.split()[::-1]) + "\r\n" for i, r in enumerate(rows[1])))
with open("c.ply", "wb") as f:
    f.write(b"ply\nformat binary_big_endian 1.0\ncomment c\nelement vertex 600\nproperty uchar red\nproperty double x\nproperty double y\nproperty double z\nelement extra 1\nproperty int i\nend_header\n")
    for i, p in enumerate(scans[2]): f.write(struct.pack(">Bddd", i % 256, *p))
    f.write(struct.pack(">i", 42))
for name, i in ("one", 0), ("two", 1): open(name + ".xyz", "w").write("".join(r + "\n" for r in rows[i]))
open("blocks.pts", "w").write("".join("%d\n" % len(r) + "".join(l + "\n" for l in r) for r in rows[:2]))
open("merged.xyz", "w").write("".join(l + "\n" for r in rows[:2] for l in r))
open("apart.xyz", "w").write("".join("%r %r %r\n" % p for p in scan(400, 0., 4e5)))
END
python3 make.py
cat > compare.py <<'END'
# what is in the files but coordinates, and the coordinates
import math, struct
def xyz(path):
    lines = open(path).read().split("\n")
    points = [l for l in lines if l and l[0] != "#"]
    return [l if l.startswith("#") else l.split(" ")[3:] for l in lines], [list(map(float, l.split()[:3])) for l in points]
def csv(path):
    lines = open(path, newline="").read().split("\r\n")
    return [lines[0]] + [l.split(",")[:1] for l in lines[1:]], [list(map(float, l.split(",")[:0:-1])) for l in lines[1:] if l]
def ply(path):
    head, body = open(path, "rb").read().split(b"end_header\n")
    records = [struct.unpack_from(">Bddd", body, 25 * i) for i in range(600)]
    return (head, [r[0] for r in records], body[25 * 600:]), [list(r[1:]) for r in records]
readers = {"a.xyz": xyz, "b.csv": csv, "c.ply": ply}
def rms(points): return math.sqrt(sum(p[2] ** 2 for p in points) / len(points))
END
same() { # same DIRECTORY DIRECTORY FILE...
  local from=$1 to=$2
  shift 2
  for f in "$@"; do cmp "$from/$f" "$to/$f" || return; done
}
stays_apart() { awk '{ s += $3^2 } END { exit !(s / NR > .01) }' "$1"; }

# ---- one cloud, and each file as it was

mkdir out
check "three formats" bash -c "'$program' --together -d out a.xyz b.csv c.ply > summary.txt"
check "all but coordinates stays, and the scans come together" python3 -c "
from compare import *
for name, read in readers.items():
    (before, p), (after, q) = read(name), read('out/' + name)
    assert before == after, name
    assert len(p) == len(q) and sum(a != b for a, b in zip(p, q)) > .9 * len(p), name
    assert rms(p) > .19 and rms(q) < .5 * rms(p), (name, rms(q))"
check "the summary tells each and all" bash -c "tr '\n' ' ' < summary.txt | tr -s ' ' | grep -q '^a.xyz points 1500 .*b.csv points 1400 .*c.ply points 600 .*together points 3500 scans 3 spacing .* seconds'"
mkdir place && cp a.xyz b.csv c.ply place
check "in place" "$program" --together -i place/a.xyz place/b.csv place/c.ply -q
check "in place, the same" same out place a.xyz b.csv c.ply
check "nothing else comes to be" test "$(ls -A place | wc -l)" = 3
check "nothing moves" "$program" --together -d out a.xyz b.csv c.ply -q --noise 0
check "all bytes stay" same . out a.xyz b.csv c.ply
check "the scans of a file, by themselves" bash -c "'$program' blocks.pts out.pts -q && '$program' -d out --together one.xyz two.xyz -q && grep ' ' out.pts | cmp - <(cat out/one.xyz out/two.xyz)"
check "the report counts them" bash -c "'$program' -n blocks.pts | grep -q '^scans *2$' && '$program' -n blocks.pts --json | grep -q '\"scans\": 2'"
"$program" merged.xyz out.xyz -q && "$program" -d out one.xyz -q
check "without their numbers they stay apart" stays_apart out.xyz
check "without --together, too" stays_apart out/one.xyz
check "other formats" bash -c "'$program' --together -d out one.xyz two.xyz -q --output-format ply && head -1 out/one.ply | grep -q ply && head -1 out/two.ply | grep -q ply"
"$program" two.xyz two.las -q --iterations 0
python3 - <<'END' # so fine a scale that the points can not leave their height
import struct
b = bytearray(open("two.las", "rb").read())
begin, size = struct.unpack_from("<I", b, 96)[0], struct.unpack_from("<H", b, 105)[0]
scale, offset = struct.unpack_from("<d", b, 147)[0], struct.unpack_from("<d", b, 171)[0]
heights = [struct.unpack_from("<i", b, i + 8)[0] * scale + offset for i in range(begin, begin + 1400 * size, size)]
fine, middle = 1e-9, sum(heights) / len(heights)
struct.pack_into("<d", b, 147, fine)
struct.pack_into("<d", b, 171, middle - 2 if middle < 0 else middle + 2)
for k, height in enumerate(heights):
    value = round((height - (middle - 2 if middle < 0 else middle + 2)) / fine)
    struct.pack_into("<i", b, begin + k * size + 8, max(-2**31, min(2**31 - 1, value)))
open("fine.las", "wb").write(b)
END
check "LAS among them" bash -c "'$program' -d out --together one.xyz two.las -q && '$program' out/two.las two.csv -q --iterations 0 && sed 1d two.csv | awk -F, '{ s += \$3^2 } END { exit !(NR == 1400 && s / NR < .01) }'"
echo old > out/one.xyz
check "LAS that can not hold its points" fails_with 2 "which the 32 bits of LAS can not hold" "$program" -d out --together one.xyz fine.las
check "nothing is written" bash -c "[ \"\$(cat out/one.xyz)\" = old ] && [ ! -e out/fine.las ]"

# ---- reports

"$program" --together -d out a.xyz b.csv c.ply --json=report.json > /dev/null
"$program" --together -n a.xyz b.csv c.ply --json > dry.json
check "the JSON report" python3 -c "
import json
r, dry = json.load(open('report.json')), json.load(open('dry.json'))
files, all = r['files'], r['together']
assert [f['input'] for f in files] == ['a.xyz', 'b.csv', 'c.ply'] and [f['format'] for f in files] == ['xyz', 'csv', 'ply']
assert [f['points'] for f in files] == [1500, 1400, 600] and all['points'] == 3500 and all['scans'] == 3
assert sum(f['moved'] for f in files) == all['moved'] and all['moved'] + sum(all['not_moved'].values()) == 3500
mean = sum(f['mean_movement'] * f['points'] for f in files) / 3500
assert 0 < mean < all['spacing'] and 'noise' not in files[0] and files[0]['output'] == 'out/a.xyz'
assert dry['together']['noise'] == all['noise'] and dry['together']['parameters'] == all['parameters'] and 'moved' not in dry['together']
assert [f['status'] for f in files] == ['ok'] * 3"
check "files that lie apart are told" fails_with 0 "warning: apart.xyz: it lies apart from all other files" "$program" -n --together one.xyz apart.xyz two.xyz
check "others are not" test -z "$("$program" -n --together one.xyz two.xyz 2>&1 > /dev/null)"

# ---- attributes that only some have, and points that are none

(echo "x y z nx ny nz"; sed 's/$/ 0 0 2/' one.xyz) > normals.txt
(cat two.xyz; echo "nan 0 0 "; echo "0 0 0") > holes.xyz
unit() { awk '!/[#x]/ && (NF != 6 || ($4^2 + $5^2 + $6^2 - 1)^2 > 1e-4) { exit 1 }' "$1"; }
check "normals of one" "$program" --together -d out normals.txt two.xyz -q
check "they are smoothed" unit out/normals.txt
check "the other gets none" awk 'NF != 3 { exit 1 }' out/two.xyz
check "normals for all" fails_with 0 "warning: two.las: normals can not be added to a file of the format las" "$program" --together -d out normals.txt two.xyz two.las --normals
check "all that can have them have them" unit out/two.xyz
check "a hole is an error for all" fails_with 2 "cannot read holes.xyz: points[1400] is (nan, 0, 0), but coordinates must be finite (--invalid keeps or drops such points) (so none of the files is written)" "$program" --together -d out one.xyz holes.xyz
"$program" --together -d out one.xyz two.xyz -q
check "holes stay" bash -c "'$program' --together -d out one.xyz holes.xyz -q --invalid keep --invalid-zeros && tail -2 holes.xyz | cmp - <(tail -2 out/holes.xyz) && cmp out/two.xyz <(head -1400 out/holes.xyz)"
check "holes are dropped" bash -c "'$program' --together -d out one.xyz holes.xyz -q --invalid drop --invalid-zeros && cmp out/two.xyz out/holes.xyz"

# ---- all or none

echo garbage > bad.xyz
rm -rf out place && mkdir out && cp one.xyz two.xyz bad.xyz out
check "one is bad" fails_with 2 'cannot read out/bad.xyz: line 1: "garbage" is not a number (so none' "$program" --together -i out/one.xyz out/bad.xyz out/two.xyz --json=report.json
check "none is written" same . out one.xyz two.xyz bad.xyz
check "nothing else is left" test "$(ls -A out | wc -l)" = 3
check "all have failed" test "$(grep -c '"status": "failed"' report.json)" = 3

# the last of the outputs becomes a directory while the first input is waited for
rm -rf out && mkdir out pipes && mkfifo pipes/first.xyz && echo old > out/first.xyz
"$program" --together -d out pipes/first.xyz one.xyz two.xyz 2> failed.log &
pid=$!
exec 3> pipes/first.xyz # goes on when the pipe is read
mkdir out/two.xyz && touch out/two.xyz/file
cat two.xyz >&3
exec 3>&-
wait $pid
check "the last file can not be replaced" test $? = 2
check "which is told" grep -q "cannot write .*two.xyz: this is not a regular file" failed.log
check "the others are as they were" bash -c "[ \"\$(cat out/first.xyz)\" = old ] && [ ! -e out/one.xyz ] && [ -e out/two.xyz/file ] && [ \$(ls -A out | wc -l) = 2 ]"

awk 'BEGIN { srand(1); for (i = 0; i < 50000; ++i) print rand(), rand(), rand() / 100 }' > large.xyz
rm -rf out && mkdir out && cp large.xyz out/a.xyz && sed 's/$/ 1/' large.xyz > out/b.xyz && cp -r out kept
(trap - INT; exec "$program" --together -i out/a.xyz out/b.xyz --json=report.json --iterations 100000 2> interrupted.log) &
pid=$!
sleep 4
kill -INT $pid
wait $pid
check "Ctrl-C" test $? = 130
check "it is told, and leaves all files" bash -c "grep -q 'interrupted, nothing written' interrupted.log && diff -r out kept && [ \$(grep -c '\"status\": \"interrupted\"' report.json) = 2 ]"

# ---- what is refused

ln -s one.xyz link.xyz; ln one.xyz hard.xyz; ln -s . here
for name in ./one.xyz link.xyz hard.xyz here/one.xyz "$PWD/one.xyz"; do
  check "refused: $name, too" fails_with 1 "are the same file, which can not be two scans" "$program" --together -d out one.xyz two.xyz "$name"
  check "refused in a dry run: $name" fails_with 1 "are the same file, which can not be two scans" "$program" --together -n one.xyz "$name"
done
check "refused: the same name" fails_with 1 "one.xyz is given twice" "$program" --together -n one.xyz one.xyz
check "refused: an output" fails_with 1 "--together needs --in-place or --output-dir" "$program" --together one.xyz two.xyz
check "refused: streams" fails_with 1 "standard input has no place or name" "$program" --together -d out - one.xyz
check "nothing was written" diff -r out kept
echo "all checks passed"
