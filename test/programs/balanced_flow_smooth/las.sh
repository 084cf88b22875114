#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# LAS of all versions and point formats: only the coordinates and the bounds in the header change. The
# files are made and compared by scripts that know nothing of our readers.
here=$(cd "$(dirname "$0")" && pwd)
. "$here/checks.sh"
make_las() { python3 "$here/make_las.py" "$@"; }
only_points_move() { python3 "$here/compare_las.py" "$@"; }

for version in 1.0 1.1 1.2 1.3 1.4; do
  case $version in 1.0 | 1.1) last=1 ;; 1.2) last=3 ;; 1.3) last=5 ;; 1.4) last=10 ;; esac
  for format in $(seq 0 $last); do
    file=${version}_$format.las
    make_las $file version=$version format=$format
    check "nothing moves in 0 iterations: $file" "$program" $file same.las -q --iterations 0
    check "the bytes of $file are the same" cmp $file same.las
    check "a run on $file" "$program" $file out_$file -q
    check "only the points of $file move" only_points_move $file out_$file
  done
done
make_las bare.las format=3 version=1.2 extra=0 padding=0 vlrs=0
check "nothing around the points" bash -c "'$program' bare.las out.las -q && python3 '$here/compare_las.py' bare.las out.las"
make_las odd.las format=6 extra=5
check "extra bytes that are not described" bash -c "'$program' odd.las out.las -q && python3 '$here/compare_las.py' odd.las out.las"

# ---- streams and places

file=1.4_7.las
check "a stream" bash -c "'$program' - - -q < $file | cmp - out_$file"
check "a pipe" bash -c "cat $file | '$program' - - -q | cmp - out_$file"
check "a pipe of 1024 bytes is no error of ours" fails_with 2 "cannot read standard input: the header" bash -c "head -c 1024 $file | '$program' - -"
mkfifo fifo.las
check "a named pipe" bash -c "cat $file > fifo.las & '$program' fifo.las piped.las -q && cmp piped.las out_$file"
check "in place" bash -c "cp $file place.las && '$program' -i place.las -q && cmp place.las out_$file"
check "onto itself" bash -c "cp $file place.las && '$program' place.las place.las -q && cmp place.las out_$file"
check "one thread is all" bash -c "'$program' $file one.las -q --threads 1 && cmp one.las out_$file"
check "no spooled file is left" bash -c "mkdir spool && TMPDIR=\$PWD/spool '$program' - - -q < $file > stream.las && rmdir spool"

# ---- georeferenced and coarse: the nearest integer, and what does not move keeps its integer

make_las far.las format=6 east=5e8 north=-7e8 scale=1e-6
check "far from the origin nothing moves in 0 iterations" bash -c "'$program' far.las same.las -q --iterations 0 && cmp far.las same.las"
check "the scale is finer than a double" bash -c "'$program' far.las out.las -q && python3 '$here/compare_las.py' far.las out.las"
cat > nearest.py <<'END'
import struct, sys
# the same cloud with scales of 0.001 and of 0.02: the coarse result is the fine one, rounded to the nearest
def points(name):
    b = open(name, "rb").read()
    begin, = struct.unpack_from("<I", b, 96)
    size, = struct.unpack_from("<H", b, 105)
    s, o = struct.unpack_from("<3d", b, 131), struct.unpack_from("<3d", b, 155)
    return [[i * f + g for i, f, g in zip(struct.unpack_from("<3i", b, begin + k * size), s, o)] for k in range(300)]
las, text = points(sys.argv[1]), [list(map(float, line.split()[:3])) for line in open(sys.argv[2]) if line[0] != "#"]
worst = max(abs(p - q) for a, b in zip(las, text) for p, q in zip(a, b))
assert .006 < worst < .0100001, worst
END
make_las coarse.las format=6 scale=0.02
"$program" coarse.las coarse.xyz -q 2> /dev/null
check "a run with a coarse scale" "$program" coarse.las out.las -q
check "coordinates are rounded to the nearest" python3 nearest.py out.las coarse.xyz

# ---- what is told

check "normals have no place" fails_with 0 "warning: normals can not be added to a file of the format las" "$program" $file n.las --normals
check "but the file is written" cmp n.las out_$file

# ---- invalid points

make_las zeros.las format=7 east=0 north=0
python3 - <<'END'
import struct
b = bytearray(open("zeros.las", "rb").read())
begin, = struct.unpack_from("<I", b, 96)
size, = struct.unpack_from("<H", b, 105)
for i in range(300):
    b[begin + i * size + 14] = 0x12 if i < 10 else 0x11
    if i % 100 == 7: # (0, 0, 0), which an offset of 100 makes of it; 7 is a second return
        struct.pack_into("<3i", b, begin + i * size, 0, 0, -100000)
struct.pack_into("<15Q", b, 255, 290, 10, *[0] * 13)
open("zeros.las", "wb").write(b)
END
check "invalid points stay" bash -c "'$program' zeros.las kept.las --invalid keep --invalid-zeros -q && python3 '$here/compare_las.py' zeros.las kept.las"
check "invalid points are dropped" "$program" zeros.las dropped.las --invalid drop --invalid-zeros -q --iterations 0
cat > dropped.py <<'END'
import struct
a, b = (bytearray(open(f + ".las", "rb").read()) for f in ("zeros", "dropped"))
begin, = struct.unpack_from("<I", a, 96)
size, = struct.unpack_from("<H", a, 105)
assert struct.unpack_from("<Q3Q", b, 247) == (297, 288, 9, 0), struct.unpack_from("<Q3Q", b, 247)
shift = 3 * size
assert struct.unpack_from("<Q", b, 235)[0] == struct.unpack_from("<Q", a, 235)[0] - shift
for i in 207, 107, 7: del a[begin + i * size:begin + (i + 1) * size]
for m in a, b: m[179:227], m[235:243], m[247:375] = bytes(48), bytes(8), bytes(128)
assert a == b
END
check "with the counts in the header" python3 dropped.py
check "the file is one" bash -c "'$program' dropped.las same.las -q --iterations 0 && cmp dropped.las same.las"

# ---- another program writes to the input

make_las busy.las format=6 points=200000 evlrs=0
cp busy.las before.las
"$program" -i busy.las -q 2> busy.log &
pid=$!
until ls -l /proc/$pid/fd 2> /dev/null | grep -q busy.las || ! kill -0 $pid 2> /dev/null; do :; done
sleep 0.2
touch busy.las
wait $pid
check "a file that changes is refused" test $? = 2
check "with the reason" grep -q "cannot write busy.las: the input was changed by another program in the meantime" busy.log
check "and stays" cmp busy.las before.las

# ---- files that lie

good=1.4_7.las
size=$(stat -c %s $good)
: > empty.las
refused "an empty file" "this is not a LAS file" empty.las
printf 'LASF' > four.las
refused "four bytes" "the file ends at byte 4, within the header" four.las
head -c 300 $good > bad.las
refused "a header that is cut" "the file ends at byte 300, within the header of 378 bytes" bad.las
head -c 5000 $good > bad.las
refused "points that are cut" "the header announces 300 points of 43 bytes from byte 947 on, but the file ends at byte 5000, after 94 points" bad.las
head -c $((size - 1)) $good > bad.las
refused "an extended record that is cut" "the header announces 2 extended variable length records, but number 2, from byte 83910 on, ends beyond byte $((size - 1))" bad.las
patch $good bad.las 24 B 2
refused "a version of 2.4" "LAS 2.4 is not known, only 1.0 to 1.4" bad.las
patch $good bad.las 25 B 5
refused "a version of 1.5" "LAS 1.5 is not known" bad.las
patch $good bad.las 94 H 227
refused "a header that is too small" "the header tells its size as 227 bytes, but in LAS 1.4 it has at least 375" bad.las
patch $good bad.las 96 I 100
refused "points within the header" "the header tells that the points begin at byte 100" bad.las
patch $good bad.las 96 I 4000000000
refused "points beyond the file" "the header tells that the points begin at byte 4000000000" bad.las
patch $good bad.las 100 I 4
refused "more records than there are" "the header announces 4 variable length records, but number 4, from byte 944 on, ends beyond byte 947" bad.las
patch $good bad.las 100 I 4294967295
refused "four billion records" "the header announces 4294967295 variable length records" bad.las
patch $good bad.las 398 H 65535
refused "a record that is too long" "the header announces 3 variable length records, but number 1, from byte 378 on, ends beyond byte 947" bad.las
patch $good bad.las 104 B 11
refused "an unknown point format" "the point format 11 is not known" bad.las
patch $good bad.las 104 B 71
refused "a bit of LAZ in LAS" "the point format 71 is not known" bad.las
patch $good bad.las 105 H 35
refused "records that are too small" "the header tells that a point has 35 bytes, but those of the point format 7 have at least 36" bad.las
patch $good bad.las 107 I 299
refused "counts that differ" "the header announces 299 points at byte 107, but 300 at byte 247" bad.las
patch $good bad.las 247 Q 2**63
refused "an absurd count" "the header announces 9223372036854775808 points of 43 bytes" bad.las
patch $good bad.las 247 Q 0
refused "no points" "there are no points in it" bad.las
patch $good bad.las 131 d 0
refused "a scale of 0" "the scale of x is 0" bad.las
patch $good bad.las 171 d "float('inf')"
refused "an infinite offset" "the offset of z is inf" bad.las
patch $good bad.las 139 d 1e308
refused "coordinates that are not finite" "points[20] is (512000, inf, " bad.las
for place in 5 13846 99999999999; do
  patch $good bad.las 235 Q $place
  refused "extended records at $place" "the header tells that the extended variable length records begin at byte $place" bad.las
done
patch $good bad.las 243 I 3
refused "more extended records than there are" "the header announces 3 extended variable length records, but number 3, from byte $size on" bad.las
patch $good bad.las 13870 Q 2**64-1
refused "an extended record that is too long" "the header announces 2 extended variable length records, but number 1, from byte 13850 on, ends beyond byte $size" bad.las
patch 1.3_4.las bad.las 227 Q 300
refused "waveforms within the points" "the header tells that the waveforms begin at byte 300" bad.las

# points that smoothing moves out of what 32 bits can hold: one at the end of the range
make_las edge.las format=0 version=1.2 padding=0 vlrs=0 extra=0 evlrs=0 points=400
python3 - <<'END'
import struct
b = bytearray(open("edge.las", "rb").read())
struct.pack_into("<d", b, 131 + 16, 1e-4)
zs = [struct.unpack_from("<i", b, 227 + 20 * i + 8)[0] for i in range(400)]
for i, z in enumerate(zs): # the scan is at the upper end, where noise is cut off
    struct.pack_into("<i", b, 227 + 20 * i + 8, min(2**31 - 1, 2**31 - 1 + z * 10))
open("edge.las", "wb").write(b)
END
cp edge.las before.las
"$program" edge.las - -q --iterations 1 > stdout.las 2> edge.log
if [ $? = 2 ]; then
  check "leaving the range is told" grep -q "cannot write standard output: z of points\[[0-9]*\] is .*, which the 32 bits of LAS can not hold with a scale of" edge.log
  check "the output is not begun" test ! -s stdout.las
  check "in place, too" fails_with 2 "cannot write edge.las: z of points" "$program" -i edge.las -q --iterations 1
  check "the file stays" cmp edge.las before.las
else
  check "the points moved within the range" only_points_move edge.las stdout.las
fi

if [ "${WITH_LASZIP:-}" = no ]; then
  patch $good bad.las 104 B 0x87
  refused "LAZ in a program without LASzip" "the points are compressed (LAZ), but this program was built without LASzip: install it (liblaszip-dev" bad.las
  cp bad.las some.laz
  check "by its name" fails_with 2 "cannot read some.laz: the format laz needs LASzip, which this program was built without: install it (liblaszip-dev" "$program" some.laz no.las
  check "from a stream" fails_with 2 "cannot read standard input: the format laz needs LASzip" "$program" - no.las < some.laz
  check "as output" fails_with 2 "cannot write no.laz: the format laz needs LASzip" "$program" $good no.laz
fi

# ---- from and to other formats

"$program" $good las.ply -q --iterations 0 2> lost.txt
for property in "ushort Intensity" "uchar Classification" "double GpsTime" "ushort Red" "float Reflectance" "double Scaled_value"; do
  check "PLY gets $property" grep -aqx "property $property" las.ply
done
check "what is lost is told" fails_with 0 "warning: the header with its projection can not be kept" "$program" $good las.ply --iterations 0
check "and what is not described" fails_with 0 "warning: the 1 extra bytes of each point that are not described can not" "$program" $good las.ply --iterations 0
check "and the waveforms" fails_with 0 "warning: the waveforms can not be kept" "$program" 1.4_9.las wave.ply --iterations 0
"$program" las.ply back.las -q --iterations 0
check "from PLY to LAS and back" bash -c "'$program' back.las back.ply -q --iterations 0"
cat > values.py <<'END'
import struct, sys
# the values of each column, by its name; text made by our program from both
def columns(name):
    b = open(name, "rb").read()
    head, body = b.split(b"end_header\n", 1)
    assert b"ascii" not in head
    types = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I", "float": "f", "double": "d"}
    props = [l.split() for l in head.decode().splitlines() if l.startswith("property")]
    order = ">" if "big" in head.decode() else "<"
    record = struct.Struct(order + "".join(types[p[1]] for p in props))
    rows = list(record.iter_unpack(body))
    return {p[2]: [row[i] for row in rows] for i, p in enumerate(props)}
a, b = columns(sys.argv[1]), columns(sys.argv[2])
assert set(a) <= set(b), set(a) - set(b)
for name in a:
    if name in "xyz":
        assert max(abs(p - q) for p, q in zip(a[name], b[name])) < 1e-6, name
    else:
        assert repr(a[name]) == repr(b[name]), name
END
check "all values are still there" python3 values.py las.ply back.ply
"$program" "$data/points_3/hippo1.ply" hippo.las -q --iterations 0 2> /dev/null
check "LAS that we made is one" bash -c "'$program' hippo.las same.las -q --iterations 0 && cmp hippo.las same.las"
cat > one_scale.py <<'END'
import struct, sys
scales = struct.unpack_from("<3d", open(sys.argv[1], "rb").read(), 131)
assert len(set(scales)) == 1, scales
END
awk 'BEGIN { for (i = 0; i < 900; ++i) print i % 30, int(i / 30), 100 + (i % 7) * 1e-9 }' > flat.xyz
check "a flat cloud has room to move" bash -c "'$program' flat.xyz flat.las -q --iterations 0 && python3 one_scale.py flat.las"
check "text to LAS" bash -c "'$program' colors.xyz colors.las -q --iterations 0 && '$program' colors.las back.xyz -q --iterations 0"
(echo "# x y z nx ny nz" && cat "$data/points_3/kitten.xyz") > kitten.xyz
check "normals become extra bytes" bash -c "'$program' kitten.xyz kitten.las -q && '$program' kitten.las kitten.ply -q --iterations 0 && grep -aq '^property double other_NormalZ' kitten.ply"
printf '%s\n' "# x y z id" "0 0 0 9007199254740993" "1 0 0 -9007199254740993" "0 1 0 9223372036854775807" "1 1 1 4" > ids.xyz
check "integers of 64 bits keep their digits" bash -c "'$program' ids.xyz ids.las -q --iterations 0 && '$program' ids.las ids2.xyz -q --iterations 0 && [ \"\$(grep -o '[0-9]*$' ids.xyz | tail -4)\" = \"\$(tail -4 ids2.xyz | grep -o '[0-9]*$')\" ]"
check "which is told when they stay" fails_with 0 "the normals in its extra bytes stay as they are" "$program" kitten.las again.las
check "failed runs leave no file" bash -c '! ls no.* *.part 2> /dev/null'
echo "all checks passed"
