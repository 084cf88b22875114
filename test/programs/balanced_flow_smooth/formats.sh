#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# All that is in a file but the coordinates and the normals stays, byte by byte, in each format.
. "$(dirname "$0")/checks.sh"

# ---- XYZ

printf '// cloud\n5\r\n\n0 0 0.1 label one\r\n1 0 0 two two # here\n0 1 -.1 0x3  3\n 1\t1 0 4 4\n0.5 0.5 +.25 2020-01-01T00:00 5' > free.txt
check "nothing moves in 0 iterations" "$program" free.txt same.txt -q --iterations 0
check "the bytes of XYZ are the same" cmp free.txt same.txt
check "a run on XYZ" "$program" colors.xyz out.xyz $few -q
check "XYZ keeps its columns" diff <(words_from 4 colors.xyz) <(words_from 4 out.xyz)
check "XYZ has new points" moved colors.xyz out.xyz
check "normals on request come behind the points" \
  bash -c "'$program' colors.xyz n.xyz -q $few --normals && [ \$(sed 1d n.xyz | head -1 | wc -w) = 10 ]"
check "their columns come after them" diff <(words_from 4 colors.xyz) <(words_from 7 n.xyz)
check "normals are found again" \
  bash -c "'$program' n.xyz n.ply -q --iterations 0 && grep -aq '^property double nx' n.ply && ! grep -aq column_4 n.ply"

# ---- PLY: all types, lists, other elements before and after, in ASCII and both byte orders

cat > make_ply.py <<'END'
import random, struct, sys
form, order, eol = sys.argv[1], ">" if "big" in sys.argv[1] else "<", sys.argv[3]
eol = {"lf": "\n", "crlf": "\r\n"}[eol]
random.seed(1)
types = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d"}
head = ["ply", "format %s 1.0" % form, "comment made for a test", "obj_info by hand",
        "element camera 2", "property list uchar int ids", "property double focus",
        "element vertex 300"]
names = [("char", "a"), ("double", "y"), ("uchar", "red"), ("short", "b"), ("float", "x"), ("ushort", "c"),
         ("list uchar short", "marks"), ("int", "d"), ("uint", "index"), ("float", "z"), ("double", "time"), ("float32", "last")]
head += ["property %s %s" % n for n in names]
head += ["element face 2", "property list uchar uint vertex_indices", "element empty 7", "end_header"]
out = bytearray((eol.join(head) + eol).encode())
def number(t, v):
    if form == "ascii":
        return (repr(struct.unpack("f", struct.pack("f", v))[0]) if t == "f" else repr(v)).encode() + b" "
    return struct.pack(order + t, v)
def listed(c, t, vs): return number(c, len(vs)) + b"".join(number(t, v) for v in vs)
def end(): return eol.encode() if form == "ascii" else b""
for i in range(2): out += listed("B", "i", [7] * i) + number("d", .1) + end()
for i in range(300):
    x, y, z = i % 20 / 20, i // 20 / 20, random.gauss(0, .02)
    out += number("b", -i % 100) + number("d", y) + number("B", i % 256) + number("h", -i) + number("f", x) + number("H", 60000 + i)
    out += listed("B", "h", list(range(i % 4))) + number("i", -70000 * i) + number("I", 4294967295 - i)
    out += number("f", z) + number("d", i + .1) + number("f", .5 * i) + end()
for i in range(2): out += listed("B", "I", [0, 1, 2 + i]) + end()
if form == "ascii": out += eol.encode() * 7
open(sys.argv[2], "wb").write(out)
END
# the bytes of the vertices that differ are those of x, y and z, and all of these differ somewhere
cat > compare_ply.py <<'END'
import struct, sys
a, b = (open(f, "rb").read() for f in sys.argv[1:3])
order = ">" if b"big" in a[:40] else "<"
assert len(a) == len(b), "lengths"
start = a.index(b"end_header") + len("end_header\n") + 2 * 9 + 4
assert a[:start] == b[:start], "header or cameras"
at, moved = start, [0, 0, 0]
for i in range(300):
    size = 1 + 8 + 1 + 2 + 4 + 2 + 1 + 2 * (i % 4) + 4 + 4 + 4 + 8 + 4
    r, s = a[at:at + size], bytearray(b[at:at + size])
    for c, (begin, end) in enumerate([(12, 16), (1, 9), (size - 16, size - 12)]):
        moved[c] += r[begin:end] != s[begin:end]
        t = order + ("d" if end - begin == 8 else "f")
        assert abs(struct.unpack(t, r[begin:end])[0] - struct.unpack(t, s[begin:end])[0]) < .2, "too far"
        s[begin:end] = r[begin:end]
    assert r == bytes(s), "record %d" % i
    at += size
assert a[at:] == b[at:], "faces"
assert min(moved) > 50, moved
END
for form in ascii binary_little_endian binary_big_endian; do
  python3 make_ply.py $form $form.ply lf
  check "nothing moves in 0 iterations: $form" "$program" $form.ply same.ply -q --iterations 0
  check "the bytes of $form are the same" cmp $form.ply same.ply
  check "a run on $form" "$program" $form.ply out_$form.ply -q
  "$program" $form.ply $form.xyz -q --iterations 0 2> /dev/null
  "$program" out_$form.ply out_$form.xyz -q --iterations 0 2> /dev/null
done
for form in binary_little_endian binary_big_endian; do
  check "only the points of $form change" python3 compare_ply.py $form.ply out_$form.ply
  check "$form has the values of ASCII" cmp $form.xyz ascii.xyz
  check "the points of $form become those of ASCII" diff <(cut -d' ' -f1 out_$form.xyz) <(cut -d' ' -f1 out_ascii.xyz)
done
check "ASCII PLY has new points" moved ascii.xyz out_ascii.xyz
check "all but the points of ASCII PLY stays" \
  diff <(awk 'NF > 10 { $2 = $5 = $(NF - 2) = "" } { print }' ascii.ply) <(awk 'NF > 10 { $2 = $5 = $(NF - 2) = "" } { print }' out_ascii.ply)
python3 make_ply.py ascii crlf.ply crlf
check "PLY with the line ends of Windows" bash -c "'$program' crlf.ply same.ply -q --iterations 0 && cmp crlf.ply same.ply"
check "normals on request" bash -c "'$program' binary_big_endian.ply n.ply -q --normals && '$program' n.ply n.xyz -q --iterations 0 2> /dev/null"
check "their header lines have the types of the points" diff <(grep -a '^property' n.ply | sed -n 13,15p) <(printf 'property float n%s\n' x y z)
check "they are unit vectors" bash -c "sed 1d n.xyz | awk '{ d = \$4^2 + \$5^2 + \$6^2 - 1; if (d * d > 1e-8) exit 1 }'"
check "the other values stay" diff <(words_from 7 n.xyz) <(words_from 4 ascii.xyz)
check "normals in ASCII" bash -c "'$program' crlf.ply n.ply -q --normals && '$program' n.ply n2.xyz -q --iterations 0 2> /dev/null && [ \$(sed -n 2p n2.xyz | wc -w) = 14 ]"

"$program" "$data/points_3/b9_training.ply" b9.ply -q
check "the header of a LiDAR tile" cmp <(sed '/end_header/q' "$data/points_3/b9_training.ply") <(sed '/end_header/q' b9.ply)
cp "$data/points_3/kitten.xyz" kitten.pwn
check "a scan with normals keeps them as unit vectors" \
  bash -c "'$program' kitten.pwn out.pwn -q && ! cmp -s kitten.pwn out.pwn && awk '{ d = \$4^2 + \$5^2 + \$6^2 - 1; if (NF != 6 || d * d > 1e-8) exit 1 }' out.pwn"

# ---- OFF

check "a run on OFF" "$program" "$data/meshes/mesh_with_colors.off" out.off -q
check "OFF keeps counts, colors and faces" diff <(awk '{ if (NF == 7) $1 = $2 = $3 = ""; print }' "$data/meshes/mesh_with_colors.off") \
  <(awk '{ if (NF == 7) $1 = $2 = $3 = ""; print }' out.off)
check "a run on a mesh" "$program" "$data/meshes/elephant.off" elephant.off -q
check "its faces are the same to the letter" diff <(tail -n 5000 "$data/meshes/elephant.off") <(tail -n 5000 elephant.off)
check "OFF, nothing moves" bash -c "'$program' '$data/meshes/elephant.off' same.off -q --iterations 0 && cmp '$data/meshes/elephant.off' same.off"
check "normals on request" bash -c "'$program' '$data/meshes/mesh_with_colors.off' n.off -q --normals && grep -q '^CNOFF' n.off && '$program' n.off n.xyz -q"

# ---- from one format to another

"$program" colors.xyz same.xyz -q --iterations 0
"$program" colors.xyz colors.ply -q --iterations 0 && "$program" colors.ply back.xyz -q --iterations 0
check "XYZ to PLY and back, with its names" cmp same.xyz back.xyz
check "XYZ to OFF and back" bash -c "'$program' colors.xyz colors.off -q --iterations 0 && '$program' colors.off back.xyz -q --iterations 0 && diff <(sed 1d same.xyz) <(sed 1d back.xyz)"
check "what is lost is told" fails_with 0 "warning: the PLY element face can not be kept in the format xyz" "$program" ascii.ply lost.xyz
check "and lists, too" fails_with 0 "warning: the lists marks can not be kept" "$program" ascii.ply lost.xyz
check "values of any type" diff <(cut -d' ' -f4-8 ascii.xyz | sed -n 301p) <(echo "1 43 -299 60299 -20930000")
check "words do not become numbers" fails_with 2 'line 4: "label" is not a number' "$program" free.txt no.ply
echo "all checks passed"
