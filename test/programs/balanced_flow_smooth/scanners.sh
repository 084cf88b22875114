#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What the positions of the scanners are good for, and that they do no harm: PTX, which has them, against
# the same scans in PTS, which has not.
. "$(dirname "$0")/checks.sh"

cat > make.py <<'END'
import math, random
def write(name, scans): # of a position, and points with their true heights
    with open(name + ".ptx", "w") as ptx, open(name + ".pts", "w") as pts:
        for position, points in scans:
            ptx.write("%d\n2\n%r %r %r\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n" % ((len(points) // 2,) + position))
            pts.write("%d\n" % len(points))
            for p in points:
                ptx.write("%.6f %.6f %.6f %.6f\n" % p)
                pts.write("%.6f %.6f %.6f %.6f\n" % p)
def surface(size, n, height, noise, offset=0., seed=1):
    r = random.Random(seed)
    points = []
    for i in range(n):
        x, y = size * (r.random() - .5), size * (r.random() - .5)
        points.append((x, y, height(x, y) + offset + r.gauss(0, noise), height(x, y)))
    return points
flat = lambda x, y: 0.
waves = lambda x, y: math.sin(x / 5) * math.cos(y / 6)
# one side of the ground, from places where it is seen in opposite directions, and with a registration error
for name, height, z in ("ground", flat, 10.), ("waves", waves, 12.), ("grazing", waves, 6.):
    write(name, [((s * 40., 0., z), surface(50., 2500, height, .05, s * .2, 2 + s)) for s in (-1, 1)])
# noise that is large against the angle of the view
write("noise", [((-65., 0., 2.), surface(50., 4000, waves, .3))])
# both sides of a wall that is thinner than the neighborhoods
for name, thickness, noise, place in ("thin", .03, .02, 0.), ("thick", .2, .04, 0.), ("oblique", .06, .02, 4.), ("crossing", .06, .02, 4.):
    write(name, [((s * place if name == "crossing" else place, 0., 2.5 * s),
                  surface(2., 2500, lambda x, y: s * thickness / 2, noise, 0., 5 + s)) for s in (-1, 1)])
END
python3 make.py
cat > errors.py <<'END'
# the rms error of the heights in the inner part of a file, whose last column is the truth
import math
def error(path):
    points = [[float(w) for w in l.split()] for l in open(path) if "." in l.split(" ")[0] and l.count(" ") == 3]
    size = max(abs(p[0]) for p in points)
    points = [p for p in points if max(abs(p[0]), abs(p[1])) < .7 * size]
    return math.sqrt(sum((p[2] - p[3]) ** 2 for p in points) / len(points))
END
for name in ground waves grazing noise thin thick oblique crossing; do
  "$program" $name.ptx out_$name.ptx > $name.txt || exit 1
  "$program" $name.pts out_$name.pts -q || exit 1
done
against() { # against NAME CONDITION: of the error before, b, and those with and without positions, w and o
  python3 -c "
from errors import error
b, w, o = error('$1.pts'), error('out_$1.ptx'), error('out_$1.pts')
print('$1: %.4f before, %.4f with positions, %.4f without' % (b, w, o))
assert $2"
}
for name in ground waves grazing; do
  check "$name: two scans from opposite directions come together" against $name "w < .3 * b and w < 1.05 * o"
done
check "a view that grazes noise does no harm" against noise "w < 1.02 * o"
for name in thin thick oblique crossing; do
  check "$name: both sides of a wall stay apart" against $name "w < .5 * o and w < .5 * b"
done
check "the summary tells how many" grep -q '^sides *of .*% of the points by the scanner$' thin.txt
check "the report, too" bash -c "'$program' -n thin.ptx --json | grep -q '\"sided_points\": [0-9]' && ! '$program' -n thin.pts --json | grep -q sided"
echo "all checks passed"
