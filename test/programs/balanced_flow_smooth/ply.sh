#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# PLY beyond the usual: all types, names and ways to break lines; what need not be understood stays.
. "$(dirname "$0")/checks.sh"

# make_ply.py form file property... writes 300 points of a rough plane; a property is "type name" or "list type type name"
cat > ply.py <<'END'
import math, random, re, struct, sys
code = dict(char="b", int8="b", bool="?", uchar="B", uint8="B", short="h", int16="h", ushort="H", uint16="H", int="i", int32="i",
            uint="I", uint32="I", int64="q", uint64="Q", float="f", float32="f", double="d", float64="d")
big = dict(int64=-2**63, uint64=2**64 - 301, uint32=2**32 - 301, uint=2**32 - 301, int8=-100, char=-100, bool=0)
def scale(t): return {"f": 1, "d": 1, "i": 10000, "h": 1000, "q": 10**12}[code[t]]
def value(t, name, i):
    role = name.lower()
    if role in "xyz":
        v = (i % 20 / 20, i // 20 / 20, random.gauss(0, .02))["xyz".index(role)] * scale(t)
        return v if code[t] in "fd" else round(v)
    if re.fullmatch("n[xyz]|normal_?[xyz]", role):
        n = [random.gauss(0, .1), random.gauss(0, .1), 1]
        v = n["xyz".index(role[-1])] / math.hypot(*n)
        return v if code[t] in "fd" else round(v * 100) if code[t] in "bhiq" else round((v + 1) * 100)
    return bool(i % 2) if t == "bool" else big.get(t, 0) + i % 200 if code[t] not in "fd" else i + .1
def make(form, path, properties, head=(), eol="\n", per_line=99, mark=b""):
    random.seed(1)
    order = ">" if "big" in form else "<"
    lines = ["ply", "format %s 1.0" % form, "comment made for a test", *head, "element vertex 300"]
    lines += ["property " + p for p in properties] + ["element face 2", "property list uint8 int64 vertex_indices", "end_header"]
    out = bytearray(mark + (eol.join(lines) + eol).encode())
    def record(items):
        if form == "ascii":
            words = [repr(v if t not in ("float", "float32") else struct.unpack("f", struct.pack("f", v))[0]) if t != "bool" else str(int(v)) for t, v in items]
            out.extend("".join(w + (eol if k % per_line == per_line - 1 and k + 1 < len(words) else " ") for k, w in enumerate(words)).encode() + eol.encode())
        else:
            for t, v in items: out.extend(struct.pack(order + code[t], v))
    for i in range(300):
        items = []
        for p in properties:
            *kind, name = p.split()
            if kind[0] == "list":
                items += [(kind[1], i % 4)] + [(kind[2], k) for k in range(i % 4)]
            else:
                items.append((kind[0], value(kind[0], name, i)))
        record(items)
    for i in range(2): record([("uint8", 3)] + [("int64", i), ("int64", 2**62), ("int64", 7)])
    open(path, "wb").write(out)
# compares two files: only values of the named properties differ, and some of each
def compare(form, a, b, properties, names):
    a, b = open(a, "rb").read(), open(b, "rb").read()
    order = ">" if "big" in form else "<"
    start = re.search(rb"end_header(\r\n|\r|\n)", a).end() if form == "ascii" else a.index(b"end_header") + len("end_header\n")
    assert a[:start] == b[:start], "header"
    changed = dict.fromkeys(names, 0)
    if form == "ascii":
        a, b = (re.split(rb"(\s+)", t[start:]) for t in (a, b))
        assert len(a) == len(b), "words"
    at = 0 if form == "ascii" else start
    for i in range(300):
        for p in properties:
            *kind, name = p.split()
            if form == "ascii":
                count = 1 + i % 4 if kind[0] == "list" else 1
                same = a[at:at + 2 * count] == b[at:at + 2 * count]
                at += 2 * count
            else:
                size = struct.calcsize(code[kind[1]]) + i % 4 * struct.calcsize(code[kind[2]]) if kind[0] == "list" else struct.calcsize(code[kind[0]])
                same = a[at:at + size] == b[at:at + size]
                at += size
            assert same or name in changed, (i, name)
            changed[name] = changed.get(name, 0) + (not same)
    assert a[at:] == b[at:], "faces"
    assert all(changed[n] > 20 for n in names), changed
# the normals of a binary file: their lengths
def lengths(path, properties, names):
    a = open(path, "rb").read()
    at = a.index(b"end_header") + len("end_header\n")
    for i in range(300):
        n = []
        for p in properties:
            t, name = p.split()
            v, = struct.unpack_from("<" + code[t], a, at)
            at += struct.calcsize(code[t])
            if name in names: n.append(v)
        yield math.hypot(*n)
END
cases() { # cases name names-that-change property... : in ASCII and both byte orders
  local name=$1 names=$2 form
  shift 2
  for form in ascii binary_little_endian binary_big_endian; do
    python3 -c "import ply, sys; ply.make('$form', '$name.ply', sys.argv[1:])" "$@" || exit
    check "$name, $form, nothing moves" bash -c "'$program' $name.ply same.ply -q --iterations 0 && cmp $name.ply same.ply"
    check "$name, $form, without noise" bash -c "'$program' $name.ply same.ply -q --noise 0 && cmp $name.ply same.ply"
    check "$name, $form, a run" bash -c "'$program' $name.ply out.ply -q --noise ${noise:-0.02} && python3 -c \"import ply, sys; ply.compare('$form', '$name.ply', 'out.ply', sys.argv[2:], sys.argv[1].split(','))\" $names $(printf "'%s' " "$@")"
  done
}
xyz=("float x" "float y" "float z")
cases long_types x,y,z "int64 id" "${xyz[@]}" "uint64 key" "bool flag" "int8 a" "uint8 b" "int16 c" "uint16 d" "int32 e" "uint32 f" "float32 g" \
  "float64 h" "list int64 uint64 keys"
cases long_names x,y,z "float64 x" "float32 y" "float64 z"
cases capitals X,Y,Z "uchar red" "double X" "double Y" "double Z"
cases capital_normals X,Y,Z,NX,NY,NZ "double X" "double Y" "double Z" "float NX" "float NY" "float NZ"
cases named_normals x,y,z,normal_x,normal_y,normal_z "${xyz[@]}" "float normal_x" "float normal_y" "float normal_z" "bool last"
cases small_and_capital x,y,z "int X" "int Y" "int Z" "${xyz[@]}"
cases char_normals x,y,z,nx,ny,nz "${xyz[@]}" "char nx" "char ny" "char nz"
cases byte_normals x,y,z "${xyz[@]}" "uchar nx" "uchar ny" "uchar nz"
check "new normals beside them have another name" bash -c "'$program' byte_normals.ply n.ply -q --noise 0.02 --normals && '$program' -n n.ply | grep -q 'nx 4, ny 5, nz 6' && '$program' n.ply n.csv -q --iterations 0 && head -1 n.csv | grep -qx x,y,z,nx,ny,nz,other_nx,other_ny,other_nz"
noise=200 cases int_points x,y,z "int x" "int y" "int z" "uint64 key"
noise=20 cases short_points x,y,z "int16 x" "int16 y" "int16 z"
noise=2e10 cases int64_points x,y,z "int64 x" "int64 y" "int64 z"

check "integer normals keep their length" python3 -c "
import ply
ply.make('binary_little_endian', 'n.ply', p := ['float x', 'float y', 'float z', 'char nx', 'char ny', 'char nz'])
import subprocess; subprocess.run(['$program', 'n.ply', 'out.ply', '-q', '--noise', '.02'], check=True)
for a, b in zip(ply.lengths('n.ply', p, {'nx', 'ny', 'nz'}), ply.lengths('out.ply', p, {'nx', 'ny', 'nz'})): assert abs(a - b) < 1.5 and a > 90, (a, b)"
check "rounding is told" bash -c "'$program' int_points.ply out.ply 2>&1 > /dev/null | grep -q 'coordinates are integers'"
check "in another format nothing is rounded" bash -c "'$program' int_points.ply out.xyz -q --noise 200 && cut -d' ' -f3 out.xyz | grep -q '\.'"
check "integers of 64 bits become text" bash -c "'$program' long_types.ply out.csv -q --iterations 0 && sed -n '1p;2p' out.csv | cut -d, -f4,5 | diff - <(printf 'id,key\n-9223372036854775808,18446744073709551315\n')"
check "and come back" bash -c "'$program' out.csv back.ply -q --iterations 0 && '$program' back.ply back.csv -q --iterations 0 && cmp out.csv back.csv && grep -aq '^property uint64 key' back.ply"

# ---- lines

properties="['int64 id', 'float x', 'list uchar int marks', 'float y', 'float z', 'uchar last']"
for per_line in 1 2 4; do for eol in '\n' '\r\n' '\r'; do
  python3 -c "import ply; ply.make('ascii', 'broken.ply', $properties, eol='$eol', per_line=$per_line)"
  check "$per_line values in a line that ends with $eol, nothing moves" bash -c "'$program' broken.ply same.ply -q --iterations 0 && cmp broken.ply same.ply"
  check "and a run" bash -c "'$program' broken.ply out.ply -q --noise 0.02 && python3 -c \"import ply; ply.compare('ascii', 'broken.ply', 'out.ply', $properties, ['x', 'y', 'z'])\""
done; done
python3 -c "
import ply
head = ['element camera 2', 'property list uchar int ids', 'property double focus']
ply.make('ascii', 'camera.ply', $properties, head=head)
text = open('camera.ply').read().replace('end_header\n', 'end_header\n3\n1 2\n3\n.5\n0 .6\n')
open('camera.ply', 'w').write(text)"
check "an element before the points over several lines" bash -c "'$program' camera.ply same.ply -q --iterations 0 && cmp camera.ply same.ply && '$program' -n camera.ply | grep -q '^points *300$'"
python3 -c "
import ply, struct
ply.make('ascii', 'marked.ply', $properties, mark=b'\xef\xbb\xbf')
ply.make('binary_little_endian', 'cr.ply', ['uchar first', 'float x', 'float y', 'float z'], eol='\r')
b = bytearray(open('cr.ply', 'rb').read())
at = b.index(b'end_header\r') + 11
b[at] = 10 # looks like the second half of a line end
open('cr.ply', 'wb').write(b)"
for file in marked cr; do
  check "$file.ply, nothing moves" bash -c "'$program' $file.ply same.ply -q --iterations 0 && cmp $file.ply same.ply"
  check "$file.ply in a stream" bash -c "'$program' - - -q --iterations 0 < $file.ply | cmp - $file.ply"
  check "$file.ply, normals" bash -c "'$program' $file.ply n.ply -q --noise 0.02 --normals && '$program' n.ply same.ply -q --iterations 0 && cmp n.ply same.ply && ! cmp -s n.ply $file.ply"
done
check "a record that is not complete" fails_with 2 "not a complete PLY file: it ends after 1 of 2 times vertex" bash -c "
  printf 'ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n1\n2\n' > no_z.ply; '$program' no_z.ply no.ply"
check "failed runs leave no file" bash -c '! ls no.* *.part 2> /dev/null'
echo "all checks passed"
