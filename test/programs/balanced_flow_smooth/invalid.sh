#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Points that are none: kept untouched in their places, dropped as if they had never been, or refused.
. "$(dirname "$0")/checks.sh"

# Each file once with points that are not finite or 0, and once without: holes.*, valid.*
cat > make.py <<'END'
import random, struct
def points():
    random.seed(1)
    return [("%.4f" % (1 + i % 20 / 20), "%.4f" % (1 + i // 20 / 20), "%.6f" % random.gauss(0, .02)) for i in range(300)]
holes = {0: ("nan", "nan", "nan"), 7: ("1", "NaN", "2"), 8: ("0", "0", "0"), 120: ("inf", "0", "0"), 299: ("0", "0", "0.0")}
finite = {8, 299}
def write(name, head, line, tail="", zeros=True, binary=None):
    for kind in "holes", "valid":
        rows = []
        for i, p in enumerate(points()):
            if i in holes and (zeros or i not in finite):
                if kind == "holes": rows.append((i, holes[i]))
            else: rows.append((i, p))
        text = head(len(rows)).encode()
        text += b"".join(struct.pack("<fffB", *map(float, p), i % 256) for i, p in rows) if binary else "".join(line(i, p) for i, p in rows).encode()
        open(kind + "." + name, "wb").write(text + tail.encode())
blanks = lambda i, p: " ".join(p) + " %d\n" % i
ply = lambda form, n: "ply\nformat %s 1.0\nelement   vertex %d\ncomment vertex 1\nproperty float x\nproperty float y\nproperty float z\nproperty uchar k\nend_header\n" % (form, n)
for zeros in True, False:
    z = "" if zeros else "finite."
    write(z + "txt", lambda n: "%d\n" % n, blanks, zeros=zeros)
    write(z + "csv", lambda n: "# some points\nx,y,z,i\n", lambda i, p: ",".join(p) + ",%d\r\n" % i, ",,,\r\n", zeros)
    write(z + "off", lambda n: "OFF\n  %d 0 0\n" % n, lambda i, p: " ".join(p) + "\n", zeros=zeros)
    write(z + "ascii.ply", lambda n: ply("ascii", n), lambda i, p: " ".join(p) + "\n%d\n" % (i % 256), "\n", zeros)
    write(z + "binary.ply", lambda n: ply("binary_little_endian", n), None, "", zeros, True)
END
python3 make.py
python3 - <<'END'
lines = [l for l in open("holes.txt").read().splitlines()[1:]]
scans = [lines[:1], [], lines[1:150], lines[150:]]
open("scans.pts", "w").write("".join("%d\n" % len(s) + "".join(l + "\n" for l in s) for s in scans))
good = lambda l: l.split()[0] not in ("nan", "inf") and l.split()[1] != "NaN" and l.split()[:2] != ["0", "0"]
scans = [[l for l in s if good(l)] for s in scans]
open("valid_scans.pts", "w").write("".join("%d\n" % len(s) + "".join(l + "\n" for l in s) for s in scans))
END
run="-q --noise 0.02"
for file in txt csv off ascii.ply binary.ply; do
  holes=holes.$file valid=valid.$file
  check "$file: an error by default" fails_with 2 "cannot read $holes: points[0] is (nan, nan, nan), but coordinates must be finite (--invalid" "$program" $holes no.$file
  check "$file: an error on request" fails_with 2 "points[0] is (nan, nan, nan)" "$program" $holes no.$file --invalid error
  for action in keep "keep --invalid-zeros"; do
    check "$file: $action, nothing moves" bash -c "'$program' $holes same.$file -q --invalid $action --iterations 0 && cmp $holes same.$file"
  done
  check "$file: drop and keep zeros" bash -c "'$program' holes.finite.$file out.$file $run --invalid drop && '$program' valid.finite.$file expected.$file $run && cmp out.$file expected.$file"
  check "$file: drop all" bash -c "'$program' $holes out.$file $run --invalid drop --invalid-zeros && '$program' $valid expected.$file $run && cmp out.$file expected.$file"
  check "$file: normals beside what is dropped" bash -c "'$program' $holes out.$file $run --normals --invalid drop --invalid-zeros && '$program' $valid expected.$file $run --normals && cmp out.$file expected.$file"
  check "$file: what is kept does not matter to the others" bash -c "'$program' $holes kept.$file $run --invalid keep --invalid-zeros && '$program' kept.$file dropped.$file -q --iterations 0 --invalid drop --invalid-zeros && '$program' $valid expected.$file $run && cmp dropped.$file expected.$file"
  check "$file: conversions drop" bash -c "'$program' $holes out.off $run --invalid drop --invalid-zeros 2> /dev/null; '$program' $valid expected.off $run 2> /dev/null; cmp out.off expected.off"
  check "$file: zeros are points" bash -c "'$program' -n $valid | grep -q '^points *295$' && '$program' -n $holes --invalid keep | grep -q '^points *297$'"
  check "$file: invalid points are counted" bash -c "'$program' -n $holes --invalid keep --invalid-zeros | grep -q '^invalid points *5, kept' && '$program' -n $holes --invalid drop --json | grep -q '\"invalid_points\": 3'"
done
check "lines of what is kept stay" cmp <(grep -iE '^([^ ]* )?(nan|inf)|^0 0 ' holes.txt) <("$program" holes.txt - $run --invalid keep --invalid-zeros | grep -iE '^([^ ]* )?(nan|inf)|^0 0 ')
check "each scan has its number" bash -c "'$program' scans.pts out.pts $run --invalid drop --invalid-zeros && '$program' valid_scans.pts expected.pts $run && cmp out.pts expected.pts"
check "kept points in another format are told" bash -c "'$program' holes.csv out.ply --invalid keep --noise 0.02 2>&1 | grep -q 'warning: 3 invalid points are in the ply, too'"
printf 'nan 0 0\n' > all.xyz
check "nothing is left" fails_with 2 "all of its points are invalid" "$program" all.xyz no.xyz --invalid drop
check "nothing to smooth" bash -c "'$program' all.xyz same.xyz -q --invalid keep && cmp all.xyz same.xyz"
printf 'OFF\n4 1 0\n0 0 0\n1 0 0\n0 1 0\nnan 0 0\n3 0 1 2\n' > faces.off
check "no points of a mesh are dropped" fails_with 2 "no points can be dropped: the faces tell points by their number" "$program" faces.off no.off --invalid drop
check "an action that is none" fails_with 1 'no invalid "hide"' "$program" holes.csv no.csv --invalid hide
check "failed runs leave no file" bash -c '! ls no.* *.part 2> /dev/null'
echo "all checks passed"
