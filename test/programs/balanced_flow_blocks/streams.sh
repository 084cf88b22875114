# SPDX-License-Identifier: GPL-3.0-or-later
# Files that are read and written some points at a time, their scans and the positions of their scanners: the same bytes as
# from the program that has all points in memory.
. "$(dirname "$0")/checks.sh"

# same_bytes FILE [OPTION]...
same_bytes() {
  local file=$1
  shift
  rm -rf out && mkdir out
  "$smooth" -q "$@" "$file" out/expected."${file##*/}" || return
  env TMPDIR=out "$smooth" -q --memory 256M --block-size "${size:-2500}" "$@" "$file" "out/${file##*/}" &&
    cmp "out/expected.${file##*/}" "out/${file##*/}"
}

# text of all kinds, with what stands between the points: comments, names, numbers of points, faces
python3 - <<'END'
import random, struct
random.seed(5)
def points(n, z=0):
    return [(random.random() * n / 300, random.random() * 3, z + random.gauss(0, .03)) for _ in range(n)]
def line(p, end="\n", between=" "):
    return between.join(f"{c:.6f}" for c in p) + end
with open("lines.xyz", "w", newline="") as out:
    out.write("\ufeff# made by hand\r\n")
    for i, p in enumerate(points(5000)):
        out.write(line(p, f" {i}\r\n") + ("\r\n# a comment\r\n" if i % 700 == 0 else ""))
    out.write("# the end, without a line end")
with open("quotes.csv", "w") as out:
    out.write('"name";X;Y;Z;nx;ny;nz\n')
    for i, p in enumerate(points(4000)):
        out.write(f'"a ""b"" {i}";' + line(p, ";0;0;1\n" if i % 3 else ";0;0;0\n", ";"))
with open("mesh.off", "w") as out:
    out.write("OFF # a mesh\n4000 2 0\n\n" + "".join(line(p) for p in points(4000)) + "3 0 1 2\n3 1 2 3\n")
with open("text.ply", "w") as out:
    out.write("ply\nformat ascii 1.0\nelement camera 1\nproperty float f\nelement vertex 4000\nproperty float z\nproperty float x\n"
              "property double y\nproperty list uchar int near\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n1.5\n")
    for i, p in enumerate(points(4000)): # lines may end anywhere
        out.write(line(p, "\n" if i % 11 == 0 else " ") + f"{i % 3} " + "7 " * (i % 3) + "\n")
    out.write("3 0 1 2\n")
with open("two.pts", "w") as out:
    for scan in range(3):
        cloud = points(2600, scan * .02)
        out.write(f"{len(cloud)}\n" + "".join(line(p, f" {i % 99}\n") for i, p in enumerate(cloud)))
for kind in "ascii", "binary":
    with open(f"view.{kind}.pcd", "wb") as out:
        cloud = points(4000)
        out.write(("# .PCD v0.7\nVERSION 0.7\nFIELDS x y z normal_x normal_y normal_z i\nSIZE 8 8 8 4 4 4 2\nTYPE F F F F F F U\n"
                   "COUNT 1 1 1 1 1 1 1\nWIDTH 4000\nHEIGHT 1\nVIEWPOINT 6 1.5 9 1 0 0 0\nPOINTS 4000\n" f"DATA {kind}\n").encode())
        for i, p in enumerate(cloud): # some normals are known
            normal = (0., 0., 1.) if i % 5 == 0 else (float("nan"),) * 3 if i % 5 == 1 else (0., 0., 0.)
            out.write(struct.pack("<dddfffH", *p, *normal, i % 999) if kind == "binary" else
                      (line(p + normal, f" {i % 999}\n")).encode())
def ptx(name, scans):
    with open(name, "w") as out:
        for at, height in scans:
            out.write(f"60\n50\n1 1 {height}\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n{at} 0 0 1\n")
            for i in range(3000):
                x, y, z = i // 50 / 20 + at, i % 50 / 20 + at, random.gauss(0, .01)
                out.write("0 0 0 0.5\n" if i % 70 == 3 else f"{x:.5f} {y:.5f} {z:.5f} 0.{i % 10}\n")
ptx("scan.ptx", [(0, 5)])
ptx("scans.ptx", [(0, 5), (.01, 5), (.3, -4)])
# a thin wall, which is two surfaces only for those who know from where it was seen
with open("wall.ptx", "w") as out:
    for side in 1, -1:
        out.write(f"60\n60\n1.5 1.5 {4 * side}\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n")
        for i in range(3600):
            out.write(f"{i // 60 / 20 + random.random() / 30:.5f} {i % 60 / 20 + random.random() / 30:.5f} "
                      f"{.03 * side + random.gauss(0, .01):.5f} 0.5\n")
END
for file in lines.xyz quotes.csv mesh.off text.ply two.pts view.ascii.pcd view.binary.pcd scan.ptx scans.ptx wall.ptx; do
  check "$file" same_bytes $file
  check "$file, moves" bash -c "! cmp -s $file out/$file"
done
check "positions of scanners count" bash -c "grep -v x wall.ptx | awk 'NF == 4 && \$4 == 0.5 { print \$1, \$2, \$3 }' > wall.xyz &&
  '$smooth' -q wall.xyz none.xyz && ! cmp -s <(cut -d' ' -f3 none.xyz) <(awk 'NF == 4 && \$4 == 0.5 { print \$3 }' out/wall.ptx)"
size=1000 check "scans in small blocks" same_bytes scans.ptx
check "scans, without a step" same_bytes scans.ptx --iterations 0
check "scans, the estimator of the paper" same_bytes scans.ptx --curvature covariance --iterations 2
sided_points() { "$smooth" --json "$1" in.ptx | sed -n 's/.*"sided_points": \([0-9]*\).*/\1/p'; }
check "the position of a single scanner" [ "$(sided_points scan.ptx)" -gt 2500 ]
check "the report" bash -c "'$smooth' --json scans.ptx in.ptx | grep -E '\"(scans|sided_points|points|invalid_points)\"' > in.json &&
  '$smooth' --memory 256M --block-size 2500 --json scans.ptx in.ptx | grep -E '\"(scans|sided_points|points|invalid_points)\"' | diff in.json -"

# several files with positions of scanners are scans of one scene
mkdir together separate && cp scans.ptx view.ascii.pcd quotes.csv separate
check "together, in memory" "$smooth" -q --together --output-dir together separate/quotes.csv separate/scans.ptx separate/view.ascii.pcd
check "together" "$blocks" run -q --block-size 2500 scene separate
check "together, the result" same_tree together scene/smoothed
mkdir tiles tiles/expected && cp lines.xyz mesh.off tiles
check "--together, in memory" "$smooth" -q --together --output-dir tiles/expected tiles/lines.xyz tiles/mesh.off
check "--together" "$blocks" run -q --together --block-size 2500 as_scans tiles
check "--together, the result" same_tree tiles/expected as_scans/smoothed

# more points than are read at a time, and what a killed process leaves of the scans
python3 - <<'END'
import random
random.seed(6)
with open("long.pts", "w") as out:
    for n in 100000, 70000:
        out.write(f"{n}\n" + "".join(f"{random.random() * 300:.4f} {random.random() * 200:.4f} {random.gauss(0, .2):.4f} 5\n" for _ in range(n)))
END
size=90000 check "many points" same_bytes long.pts --iterations 1

# files of all kinds, byte for byte
shopt -s nullglob
for file in "$(dirname "$0")"/../../fuzz/good/*; do
  case $file in *.laz) continue ;; esac
  cp "$file" . && size=100 check "${file##*/}" same_bytes "${file##*/}" --invalid keep
done
for file in ${REAL_SCANS:+"$REAL_SCANS"/scans/*.ply "$REAL_SCANS"/formats/*.las "$REAL_SCANS"/formats/*.pcd}; do
  "$smooth" -q --invalid keep "$file" trial."${file##*.}" 2> /dev/null || continue # made to be refused
  size=20000 check "${file##*/}" same_bytes "$file" --invalid keep
  size=3000 check "${file##*/}, small blocks" same_bytes "$file" --invalid keep --iterations 2
done

# memory, with 300 MB of text
if [ -n "${LARGE:-}" ]; then
  python3 - <<'END'
import random
random.seed(7)
with open("large.xyz", "w") as out:
    for i in range(8000000):
        out.write(f"{random.random() * 2800:.6f} {i / 2800 + random.random():.6f} {random.gauss(0, .4):.6f} {i}\n")
END
  check "text that is larger than the memory" python3 -c "
import resource, subprocess, sys
done = subprocess.run(sys.argv[1:])
megabytes = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
print(megabytes, 'MB')
sys.exit(done.returncode or megabytes > 256)" "$blocks" run -q --memory 256M large large.xyz
fi
