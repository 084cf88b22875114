#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# PCD of all kinds: only coordinates and normals change. The files are made and compared by a script that
# knows nothing of our readers.
here=$(cd "$(dirname "$0")" && pwd)
. "$here/checks.sh"
export PYTHONPATH=$here PYTHONDONTWRITEBYTECODE=1
python() { python3 -c "from pcd_files import *
$1"; }
make() { python "make($1)"; } # make "'FILE', 'KIND', 'FIELDS', ..."
kinds="ascii binary"
[ "${WITH_LZF:-yes}" = yes ] && kinds="$kinds binary_compressed"

cases() { # cases NAME CHANGING_FIELDS FIELDS [MORE]: in all kinds
  local name=$1 changing=$2 fields=$3 more=${4:-} kind
  for kind in $kinds; do
    make "'$name.pcd', '$kind', '$fields'${more:+, $more}"
    check "$name, $kind, nothing moves" bash -c "'$program' $name.pcd same.pcd -q --iterations 0 && cmp $name.pcd same.pcd"
    check "$name, $kind, without noise" bash -c "'$program' $name.pcd same.pcd -q --noise 0 && cmp $name.pcd same.pcd"
    check "$name, $kind, a run" "$program" $name.pcd out.pcd -q --noise "${noise:-0.02}"
    check "$name, $kind, only points move" python "compare('$name.pcd', 'out.pcd', '$changing'.split())"
    check "$name, $kind, a stream" bash -c "'$program' - - -q --noise ${noise:-0.02} < $name.pcd | cmp - out.pcd"
  done
}
xyz="x:F4 y:F4 z:F4"
normals="normal_x:F4 normal_y:F4 normal_z:F4"
all="i1:I1 u1:U1 i2:I2 u2:U2 i4:I4 u4:U4 i8:I8 u8:U8 f4:F4 f8:F8"
cases plain "x y z" "$xyz"
cases doubles "x y z" "stamp:F8 x:F8 y:F8 z:F8"
cases capitals "X Y Z" "X:F4 Y:F8 Z:F4"
cases colors "x y z" "$xyz rgb:F4"
cases colors_first "x y z" "rgba:U4 $xyz rgb:F4"
cases with_normals "x y z normal_x normal_y normal_z" "normal_y:F4 $xyz normal_z:F4 normal_x:F4 curvature:F4"
cases types "x y z" "$all z:F8 ring:U2 y:F4 x:F4"
cases padded "x y z" "$xyz _:U1:4 intensity:F4 _:U1:12 t:U4 _:F3:2"
cases counts "x y z" "fpfh:F4:33 x:F4 y:F4 _:U1:2 z:F4 marks:U8:3"
noise=200 cases integers "x y z" "x:I4 y:I4 z:I4 id:U8"
cases integer_normals "x y z normal_x normal_y normal_z" "$xyz normal_x:I1 normal_y:I1 normal_z:I1"
cases version_5 "x y z" "$xyz" "VERSION='.5', COUNT=None, VIEWPOINT=None"
cases version_6 "x y z" "$xyz" "VERSION='0.6', head='# a comment', VIEWPOINT=None"
cases columns "x y z" "$xyz" "FIELDS=None, COLUMNS='x y z', HEIGHT=None, POINTS=None"
cases organized "x y z" "$xyz rgb:F4" "width=20, height=15, holes=[0, 7, 8, 150, 299]"
cases column "x y z" "$xyz" "width=1, height=300, holes=[5]"
cases returns "x y z" "$xyz" 'eol="\r\n"'
cases old_returns "x y z" "u1:U1 $xyz" 'eol="\r"'
kinds=${kinds#ascii } cases more "x y z" "$xyz" "rest=b'more than is known'"

# ---- normals, invalid points, the scanner

for kind in $kinds; do
  make "'n.pcd', '$kind', 'id:U8 $xyz _:U1:3 rgb:F4'"
  check "$kind, normals are added" "$program" n.pcd out.pcd -q --noise 0.02 --normals
  check "$kind, and nothing else" python "
a, b = read('n.pcd'), read('out.pcd')
assert b[1]['FIELDS'] == 'id x y z normal_x normal_y normal_z _ rgb'.split() and b[1]['TYPE'] == list('UFFFFFFUF') and b[1]['SIZE'] == list('844444414') and b[1]['COUNT'] == list('111111131'), b[1]
for r, s in zip(a[3], b[3]):
    assert r[0] == s[0] and r[4:] == s[7:]
    assert abs(math.hypot(*(value(c, f) for c, f in zip(s[4:7], b[2][4:7]))) - 1) < 1e-5"
  check "$kind, and read again" bash -c "'$program' out.pcd same.pcd -q --iterations 0 && cmp out.pcd same.pcd && '$program' -n out.pcd | grep -q 'nx 5, ny 6, nz 7, by the names of the fields'"

  scanner="VIEWPOINT='0.5 0.5 9 1 0 0 0'"
  make "'holes.pcd', '$kind', '$xyz rgb:F4', width=20, height=15, holes=[0, 7, 8, 150, 299], $scanner"
  make "'flat.pcd', '$kind', '$xyz rgb:F4', holes=[0, 7]"
  python "
fields = fields_of('$xyz rgb:F4')
rows = [r for i, r in enumerate(rows_of(fields, 300, 20)) if i not in (0, 7, 8, 150, 299)]
make('valid.pcd', '$kind', '$xyz rgb:F4', width=295, rows=rows, $scanner)"
  check "$kind, a grid keeps its places" bash -c "'$program' -n holes.pcd | grep -q '^invalid points *5, kept' && '$program' -n holes.pcd | grep -q '^points *295$'"
  check "$kind, a grid, an error on request" fails_with 2 "cannot read holes.pcd: points[0] is (" "$program" holes.pcd no.pcd --invalid error
  check "$kind, without a grid an error" fails_with 2 "cannot read flat.pcd: points[0] is (" "$program" flat.pcd no.pcd
  check "$kind, without a grid, kept" bash -c "'$program' flat.pcd same.pcd -q --iterations 0 --invalid keep && cmp flat.pcd same.pcd"
  check "$kind, dropped" bash -c "'$program' holes.pcd out.pcd -q --noise 0.02 --invalid drop && '$program' valid.pcd expected.pcd -q --noise 0.02"
  check "$kind, it is no grid then, and all else is as if they had never been" python "
a, b = read('out.pcd'), read('expected.pcd')
assert a == b and a[1]['WIDTH'] == a[1]['POINTS'] == ['295'] and a[1]['HEIGHT'] == ['1']"

  check "$kind, dropped beside new normals" bash -c "'$program' holes.pcd out.pcd -q --noise 0.02 --normals --invalid drop && '$program' valid.pcd expected.pcd -q --noise 0.02 --normals"
  check "$kind, the same" python "assert read('out.pcd') == read('expected.pcd')"

  for side in 9 -9; do
    make "'side.pcd', '$kind', '$xyz', VIEWPOINT='0.5 0.5 $side 1 0 0 0'"
    check "$kind, normals look at the scanner at $side" bash -c "'$program' side.pcd n.csv -q --noise 0.02 --normals && sed 1d n.csv | awk -F, '\$6 * $side < .5 { exit 1 }' && [ \$(wc -l < n.csv) = 301 ]"
  done
  python "
fields = fields_of('$xyz')
rows = rows_of(fields, 300, 20)
for r in rows: r[2][0] -= 5
make('camera.pcd', '$kind', '$xyz', width=20, height=15, rows=rows)"
  check "$kind, a grid was seen from the origin" bash -c "'$program' camera.pcd n.csv -q --noise 0.02 --normals && sed 1d n.csv | awk -F, '\$6 < .5 { exit 1 }'"
done

# ---- from and to other formats

make "'all.pcd', 'binary', '$xyz rgb:F4 i8:I8 u8:U8 _:U1:3 hist:F4:2 u2:U2'"
check "to CSV, with all numbers" bash -c "'$program' all.pcd all.csv -q --iterations 0 && sed -n '1p;5p' all.csv | cut -d, -f4- | diff - <(printf 'blue,green,red,i8,u8,hist_1,hist_2,u2\n121,0,128,-9223372036854775805,18446744073709550620,3.5,4.5,3\n')"
check "to PLY and back" bash -c "'$program' all.pcd all.ply -q --iterations 0 && grep -aq '^property uchar red' all.ply && '$program' all.ply back.pcd -q --iterations 0 && '$program' back.pcd back.ply -q --iterations 0 && '$program' back.ply back.csv -q --iterations 0 && diff <(cut -d, -f4- all.csv | tr , '\n' | sort) <(cut -d, -f4- back.csv | tr , '\n' | sort)"
check "colors are one field" python "
a, b = read('all.pcd'), read('back.pcd')
assert b[1]['FIELDS'] == 'x y z rgb i8 u8 hist_1 hist_2 u2'.split() and b[1]['TYPE'] == list('FFFFIUFFU'), b[1]
for r, s in zip(a[3], b[3]): assert r[:3] == s[:3] and r[3][:3] == s[3][:3] and r[4:6] == s[4:6]"
sed 's/r g b/red green blue/' colors.xyz > names.xyz
check "colors of text, too" bash -c "'$program' names.xyz colors.pcd -q --iterations 0 && head -3 colors.pcd | grep -aqx 'FIELDS x y z rgb label' && '$program' colors.pcd out.csv -q --iterations 0 && sed -n 3p out.csv | grep -qx '1,0,0,13,1,254,3'"
printf '# x y z red green blue\n0 0 0 1 2 300\n' > wide.xyz
check "but no colors that do not fit" bash -c "'$program' wide.xyz wide.pcd -q --iterations 0 && head -3 wide.pcd | grep -aqx 'FIELDS x y z red green blue'"
printf '# x y z red green blue alpha\n0 0 0 1 2 3 4\n' > alpha.xyz
check "colors with alpha" bash -c "'$program' alpha.xyz alpha.pcd -q --iterations 0 && tail -c 4 alpha.pcd | od -An -tu1 | grep -q '3 *2 *1 *4'"
check "normals and doubles" bash -c "'$program' all.pcd normals.ply -q --noise 0.02 --normals && '$program' normals.ply normals.pcd -q --iterations 0 && head -3 normals.pcd | grep -aq '^FIELDS x y z normal_x normal_y normal_z rgb'"
make "'moved.pcd', 'ascii', '$xyz', width=20, height=15, VIEWPOINT='1 2 3 1 0 0 0', holes=[3]"
for loss in "the grid of the points" "the place of the scanner"; do
  check "$loss is lost, with a warning" bash -c "'$program' moved.pcd out.ply --iterations 0 2>&1 | grep -q 'warning: $loss can not be kept'"
done

# ---- files that lie

bad() { # bad "message" "'KIND', 'FIELDS', ..."
  make "'bad.pcd', $2"
  refused "$2" "$1" bad.pcd
}
for kind in $kinds; do
  bad 'line 10: POINTS 301 is not WIDTH 300 times HEIGHT 1' "'$kind', '$xyz', POINTS=301"
  bad 'line 10: POINTS 300 is not WIDTH 4294967296 times HEIGHT 4294967296' "'$kind', '$xyz', WIDTH=2**32, HEIGHT=2**32, POINTS=300"
  bad 'line 4: SIZE has 2 values, not 3' "'$kind', '$xyz', SIZE='4 4'"
  bad 'line 4: SIZE 2 of z is not known for TYPE F' "'$kind', '$xyz', SIZE='4 4 2'"
  bad 'line 4: SIZE 3 of k is not known for TYPE U' "'$kind', '$xyz k:U3'"
  bad 'line 4: SIZE 0 of y is not known for TYPE F' "'$kind', '$xyz', SIZE='4 0 4'"
  bad 'line 4: "four" is not a natural number' "'$kind', '$xyz', SIZE='4 four 4'"
  bad 'line 5: TYPE B of y is not known (I, U, F)' "'$kind', '$xyz', TYPE='F B F'"
  bad 'line 6: COUNT of x is 2, but coordinates and normals are single numbers' "'$kind', 'x:F4:2 y:F4 z:F4'"
  bad 'line 6: COUNT of k is 0' "'$kind', '$xyz k:F4', COUNT='1 1 1 0'"
  bad 'the file is too short for 99999999 values of k' "'$kind', '$xyz k:F4', COUNT='1 1 1 99999999'"
  bad 'line 7: "-300" is not a natural number' "'$kind', '$xyz', WIDTH=-300"
  bad 'line 2: VERSION .8 of PCD is not known' "'$kind', '$xyz', VERSION='.8'"
  bad 'line 11: DATA morse is not known' "'$kind', '$xyz', DATA='morse'"
  bad 'line 9: VIEWPOINT has 3 values, not 7' "'$kind', '$xyz', VIEWPOINT='0 0 0'"
  bad 'line 9: "up" is not a number' "'$kind', '$xyz', VIEWPOINT='0 0 0 1 0 0 up'"
  bad 'line 11: "COLOR" is not known' "'$kind', '$xyz', COLOR=1"
  bad 'line 11: a second line COLUMNS' "'$kind', '$xyz', COLUMNS='x y z'"
  bad 'the header has no SIZE' "'$kind', '$xyz', SIZE=None"
  bad 'the header has no FIELDS' "'$kind', '$xyz', FIELDS=None"
  bad 'the header has neither WIDTH nor POINTS' "'$kind', '$xyz', WIDTH=None, POINTS=None"
  bad 'x, y and z must be there' "'$kind', 'x:F4 y:F4 k:F4'"
  bad 'there are two properties called x' "'$kind', '$xyz x:F4'"
  bad 'nx, ny and nz must be there together' "'$kind', '$xyz normal_x:F4'"
  bad 'there are no points in it' "'$kind', '$xyz', width=0"
done
bad 'line 311: there are more points than the 299 of the header' "'ascii', '$xyz', WIDTH=299, POINTS=299"
bad 'the file ends after 300 of 301 points' "'ascii', '$xyz', WIDTH=301, POINTS=301"
bad 'the file ends after 300 of 301 points of 12 bytes' "'binary', '$xyz', WIDTH=301, POINTS=301"
make "'more.pcd', 'binary', '$xyz', rest=b'more than is known'"
check "bytes behind the points are told" bash -c "'$program' more.pcd out.pcd 2>&1 > /dev/null | grep -q 'warning: 18 bytes behind the points are kept as they are'"
make "'bad.pcd', 'ascii', '$xyz'"
sed -i '20s/ [^ ]*$//' bad.pcd
refused "a line without z" "line 20: 2 columns, but 3 are expected" bad.pcd
sed -i '20s/$/ five/' bad.pcd
refused "a word" 'line 20: "five" is not a number' bad.pcd
head -5 plain.pcd > bad.pcd
refused "half a header" "the file ends in the header, before DATA" bad.pcd
printf '1 2 3\n4 5 6\n' > bad.pcd
refused "no header" "line 1: this is not a PCD file, which begins with VERSION" bad.pcd
if [ "${WITH_LZF:-yes}" = yes ]; then
  bad 'the compressed points have 3600 bytes, but the header tells of 301 points of 12 bytes' "'binary_compressed', '$xyz', WIDTH=301, POINTS=301"
  cases left_out "x y z" "$xyz _:U1:4 rgb:F4" "pads=False"
  make "'good.pcd', 'binary_compressed', '$xyz'"
  python "
b = bytearray(open('good.pcd', 'rb').read())
at = b.index(b'compressed\n') + 11
def put(name, place, value):
    c = bytearray(b)
    struct.pack_into('<I', c, place, value)
    open(name, 'wb').write(c)
put('long.pcd', at, 10**9)
put('size.pcd', at + 4, 3601)
put('less.pcd', at, 20)
put('bits.pcd', at + 40, 0xffffffff)
open('cut.pcd', 'wb').write(b[:-1])
open('none.pcd', 'wb').write(b[:at + 7])"
  refused "a length beyond the file" "the file ends after" long.pcd
  refused "another size" "the compressed points have 3601 bytes, but the header tells of 300 points of 12 bytes" size.pcd
  refused "too few bytes" "20 bytes of LZF are no 3600 bytes of points" less.pcd
  refused "other bits" "the compressed points are damaged" bits.pcd
  refused "a file that is cut off" "the file ends after" cut.pcd
  refused "no sizes" "the file ends before the sizes of the compressed points" none.pcd
else
  make "'good.pcd', 'binary_compressed', '$xyz'"
  refused "without the library" "binary_compressed PCD needs liblzf, which this program was built without: install it (liblzf-dev" good.pcd
fi
check "failed runs leave no file" bash -c '! ls no.* *.part 2> /dev/null'
echo "all checks passed"
