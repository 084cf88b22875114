#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# PTX: scans in coordinates of their own, with places where the scanner saw nothing.
. "$(dirname "$0")/checks.sh"

# Two scans of a wall from one side of it, each turned and moved in its own way, and as one PLY
cat > scan.py <<'END'
import math, random
random.seed(1)
def wall(): return [[i / 20, j / 20, random.gauss(0, .02)] for i in range(24) for j in range(15)]
turns = [0.3, -1.1]
moves = [[2., -1., 5.], [1., 0., 3.]]
def own(p, turn, move): # p = own * matrix + move, so own = (p - move) * transposed matrix
    q = [a - b for a, b in zip(p, move)]
    c, s = math.cos(turn), math.sin(turn)
    return [q[0] * c + q[1] * s, -q[0] * s + q[1] * c, q[2]]
def scan(turn, move, points, eol="\n"):
    c, s = math.cos(turn), math.sin(turn)
    head = ["24", "15", "%r %r %r" % tuple(move), "%r %r 0" % (c, s), "%r %r 0" % (-s, c), "0 0 1",
            "%r %r 0 0" % (c, s), "%r %r 0 0" % (-s, c), "0 0 1 0", "%r %r %r 1" % tuple(move)]
    rows = ["0 0 0 0.5 0 0 0" if p is None else "%.9f %.9f %.9f 0.25 10 20 30" % tuple(own(p, turn, move)) for p in points]
    return eol.join(head + rows) + eol
if __name__ == "__main__":
    both, text = [], ""
    for turn, move in zip(turns, moves):
        points = wall()
        for hole in 0, 17, 100, 359: points[hole] = None
        text += scan(turn, move, points)
        both += [p for p in points if p]
    open("two.ptx", "w").write(text)
    open("crlf.ptx", "w", newline="").write(text.replace("\n", "\r\n"))
    open("both.xyz", "w").write("".join("%r %r %r\n" % tuple(p) for p in both))
END
python3 scan.py
for file in two crlf; do
  check "$file.ptx, nothing moves" bash -c "'$program' $file.ptx same.ptx -q --iterations 0 && cmp $file.ptx same.ptx"
  check "$file.ptx, without noise" bash -c "'$program' $file.ptx same.ptx -q --noise 0 && cmp $file.ptx same.ptx"
done
check "a stream" bash -c "'$program' - - -q --iterations 0 < two.ptx | cmp - two.ptx"
check "a run" "$program" two.ptx out.ptx -q --noise 0.02
check "both scans are smoothed as one, in their own coordinates" python3 -c "
import subprocess
from scan import own, turns, moves
subprocess.run(['$program', 'both.xyz', 'out.xyz', '-q', '--noise', '.02'], check=True)
smooth = iter([list(map(float, l.split())) for l in open('out.xyz')])
before, after = (open(f).read().splitlines() for f in ('two.ptx', 'out.ptx'))
assert len(before) == len(after) == 2 * 370
moved = 0
for i, (a, b) in enumerate(zip(before, after)):
    scan, line = divmod(i, 370)
    a, b = a.split(), b.split()
    if line < 10 or a[:3] == ['0', '0', '0']: assert a == b, i
    else:
        assert a[3:] == b[3:], i
        moved += a != b
        expected = own(next(smooth), turns[scan], moves[scan])
        assert all(abs(float(x) - y) < 2e-3 for x, y in zip(b, expected)), (i, b, expected)
assert moved > 500 and next(smooth, None) is None"
check "places without a point are counted" bash -c "'$program' -n two.ptx | grep -q '^points *712$' && '$program' -n two.ptx | grep -q '^invalid points *8, kept'"
# not finite before or after the transformation; the latter are far away, so the noise is given
sed '12s/^[^ ]* [^ ]*/nan 1.5/; 13s/^[^ ]*/inf/; 14s/^[^ ]*/1e308/; 7s/^[^ ]*/10/' two.ptx > odd.ptx
check "points that are not finite keep their place and their bytes" bash -c "'$program' odd.ptx out.ptx -q --noise 0.02 && cmp <(sed -n '12,14p' odd.ptx) <(sed -n '12,14p' out.ptx) && '$program' odd.ptx same.ptx -q --iterations 0 && cmp odd.ptx same.ptx"
check "and refused on request" fails_with 2 "points[0] is (0, 0, 0), which counts as invalid" "$program" two.ptx no.ptx --invalid error
check "a grid drops no points" fails_with 2 "no points can be dropped: each scan is a grid of points" "$program" two.ptx no.ptx --invalid drop
check "other formats get the shared coordinates" python3 -c "
import subprocess
subprocess.run(['$program', 'two.ptx', 'shared.csv', '-q', '--iterations', '0', '--invalid', 'drop'], check=True)
a = [l.split(',') for l in open('shared.csv').read().splitlines()]
assert a[0] == 'x y z intensity red green blue'.split(), a[0]
for r, l in zip(a[1:], open('both.xyz')): assert all(abs(float(x) - float(y)) < 1e-6 for x, y in zip(r, l.split()))
assert len(a) == 713"
check "normals look at the scanner" bash -c "'$program' two.ptx n.csv -q --noise 0.02 --normals --invalid drop && [ \$(wc -l < n.csv) = 713 ] && sed 1d n.csv | awk -F, '\$6 < .5 { exit 1 }' && sed '373s/ 3.0$/ -3.0/' two.ptx > below.ptx && '$program' below.ptx n.csv -q --noise 0.02 --normals --invalid drop && sed 1d n.csv | tail -356 | awk -F, '\$6 > -.5 { exit 1 }'"
check "no place for normals" fails_with 0 "warning: normals can not be added to a file of the format ptx" "$program" two.ptx same.ptx --normals --iterations 0
check "which changes nothing" cmp two.ptx same.ptx
check "PTX comes from PTX" fails_with 2 "PTX is written from PTX only" "$program" both.xyz no.ptx
head -300 two.ptx > short.ptx
head -375 two.ptx > head.ptx
sed '3s/$/ 7/' two.ptx > four.ptx
sed '10s/^[^ ]*/1e999/' two.ptx > infinite.ptx
sed '7,9s/.*/0 0 0 0/' two.ptx > flat.ptx
check "a scan that is not complete" fails_with 2 "the file ends after 290 of 360 points of scan 1" "$program" short.ptx no.ptx
check "a header that is not complete" fails_with 2 "the file ends in the header of a scan" "$program" head.ptx no.ptx
check "a header with other lines" fails_with 2 "line 3: the header of a PTX scan has 3 numbers here, not 4" "$program" four.ptx no.ptx
check "a transformation that is not finite" fails_with 2 "the transformation of a scan is not finite" "$program" infinite.ptx no.ptx
check "a transformation without inverse" fails_with 2 "the transformation of a scan has no inverse" "$program" flat.ptx no.ptx
check "failed runs leave no file" bash -c '! ls no.* *.part 2> /dev/null'
echo "all checks passed"
