#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# LAZ: the points are those of LAS, and nothing around them is lost. The program convert_las, which is
# nothing but LASzip, makes and opens the files.
here=$(cd "$(dirname "$0")" && pwd)
. "$here/checks.sh"
make_las() { python3 "$here/make_las.py" "$@"; }

# what the test itself must do, since LASzip does not: records behind the points, and variable chunks
cat > laz.py <<'END'
import struct, sys

def parse(name):
    b = open(name, "rb").read()
    header_size, begin, vlr_count = struct.unpack_from("<HII", b, 94)
    size, count = struct.unpack_from("<HI", b, 105)
    evlrs, waveforms, rest = 0, 0, b""
    if b[25] >= 3: waveforms, = struct.unpack_from("<Q", b, 227)
    if b[25] >= 4:
        evlrs, evlr_count, count = struct.unpack_from("<QIQ", b, 235)
        if not evlr_count: evlrs = 0
    starts = [p for p in (evlrs, waveforms) if p]
    if starts: rest = b[min(starts):]
    at, vlrs = header_size, []
    for i in range(vlr_count):
        length, = struct.unpack_from("<H", b, at + 20)
        vlrs.append(b[at:at + 54 + length])
        at += 54 + length
    return dict(bytes=b, header=b[:header_size], vlrs=vlrs, gap=b[at:begin], rest=rest, begin=begin, size=size, count=count,
                evlrs=evlrs and evlrs - min(starts), waveforms=waveforms and waveforms - min(starts))

def attach(las, laz):
    """gives the compressed file what is behind the points of the other, and the places in the header"""
    a, b = parse(las), bytearray(open(laz, "rb").read())
    end = len(b)
    if a["bytes"][25] >= 3: struct.pack_into("<Q", b, 227, end + a["waveforms"] if a["rest"] and struct.unpack_from("<Q", a["bytes"], 227)[0] else 0)
    if a["bytes"][25] >= 4: struct.pack_into("<QI", b, 235, end + a["evlrs"] if a["rest"] and struct.unpack_from("<I", a["bytes"], 243)[0] else 0, struct.unpack_from("<I", a["bytes"], 243)[0])
    open(laz, "wb").write(b + a["rest"])

def without_places(header):
    h = bytearray(header)
    for at, size in (96, 4), (100, 4), (104, 1), (179, 48): h[at:at + size] = bytes(size)
    if h[25] >= 3: h[227:235] = bytes(8)
    if h[25] >= 4: h[235:243] = bytes(8)
    return bytes(h)

def compare(las, laz, *flags):
    """all but the points: of a file and its other encoding"""
    a, b = parse(las), parse(laz)
    ours = lambda vlrs: [v for v in vlrs if not v[2:18].startswith((b"laszip encoded", b"copc\0"))]
    if "copc" in flags:
        evlrs, kept, at = a["rest"], b"", 0
        for i in range(struct.unpack_from("<I", a["bytes"], 243)[0]):
            length, = struct.unpack_from("<Q", evlrs, at + 20)
            if not evlrs[at + 2:at + 18].startswith(b"copc\0"): kept += evlrs[at:at + 60 + length]
            at += 60 + length
        a["rest"] = kept + evlrs[at:]
        x, y = (bytearray(f["header"]) for f in (a, b))
        assert struct.unpack_from("<I", y, 243)[0] == struct.unpack_from("<I", x, 243)[0] - 1
        x[243:247] = y[243:247]
        a["header"], b["header"] = x, y
    assert without_places(a["header"]) == without_places(b["header"]), "header"
    assert ours(a["vlrs"]) == ours(b["vlrs"]), "VLRs"
    assert a["gap"] == b["gap"], "padding"
    assert a["rest"] == b["rest"] if a["rest"] else True, "EVLRs"
    assert a["waveforms"] == b["waveforms"] or "copc" in flags, "waveforms"
    assert (b["bytes"][104] & 128) / 128 == laz.endswith("z"), "compression"

def points(a, b):
    """the same records, in two uncompressed files"""
    a, b = parse(a), parse(b)
    assert (a["size"], a["count"]) == (b["size"], b["count"])
    length = a["size"] * a["count"]
    assert a["bytes"][a["begin"]:a["begin"] + length] == b["bytes"][b["begin"]:b["begin"] + length], "points"

globals()[sys.argv[1]](*sys.argv[2:])
END

for version in 1.0 1.1 1.2 1.3 1.4; do
  case $version in 1.0 | 1.1) last=1 ;; 1.2) last=3 ;; 1.3) last=5 ;; 1.4) last=10 ;; esac
  for format in $(seq 0 $last); do
    file=${version}_$format
    make_las $file.las version=$version format=$format
    "$convert_las" $file.las $file.laz && python3 laz.py attach $file.las $file.laz || exit 1
    check "nothing moves in 0 iterations: $file" "$program" $file.laz same.laz -q --iterations 0
    check "the bytes of $file are the same" cmp $file.laz same.laz
    check "a run on $file" bash -c "'$program' $file.laz out.laz -q && '$program' $file.las out.las -q"
    check "LASzip reads $file" "$convert_las" out.laz plain.las
    check "the points of $file become those of LAS" python3 laz.py points plain.las out.las
    check "they are compressed" python3 laz.py compare out.laz out.laz
    check "the rest of $file stays" python3 laz.py compare $file.laz out.laz
    check "LAS to LAZ: $file" bash -c "'$program' $file.las as.laz -q && python3 laz.py compare $file.las as.laz && '$convert_las' as.laz plain.las"
    check "the points of $file as LAZ are those of LAS" python3 laz.py points plain.las out.las
    check "LAZ to LAS: $file" bash -c "'$program' $file.laz as.las -q && python3 laz.py compare $file.laz as.las && python3 laz.py points as.las out.las"
    check "LAS to LAZ to LAS: $file" bash -c "'$program' $file.las as.laz -q --iterations 0 && '$program' as.laz as.las -q --iterations 0 && python3 laz.py compare $file.las as.las && python3 laz.py points as.las $file.las"
  done
done
make_las many.las format=7 points=120000 evlrs=2
"$convert_las" many.las many.laz && python3 laz.py attach many.las many.laz
check "several chunks" bash -c "'$program' many.laz out.laz -q && '$program' many.las out.las -q && '$convert_las' out.laz plain.las && python3 laz.py points plain.las out.las"

# ---- streams and places

file=1.4_7.laz
"$program" $file out.laz -q
check "a stream" bash -c "'$program' - - -q < $file | cmp - out.laz"
check "a pipe" bash -c "cat $file | '$program' - - -q | cmp - out.laz"
check "in place" bash -c "cp $file place.laz && '$program' -i place.laz -q && cmp place.laz out.laz"
check "LAZ under the name of LAS stays LAZ in place" bash -c "cp $file place.las && '$program' -i place.las -q && cmp place.las out.laz"
check "LAZ into a stream" bash -c "'$program' 1.4_7.las - --output-format laz -q > stream.laz && python3 laz.py compare 1.4_7.las stream.laz"
check "nothing is spooled for long" bash -c "mkdir spool && TMPDIR=\$PWD/spool '$program' - - -q < $file > stream.laz && rmdir spool"
check "other formats become LAZ" bash -c "'$program' '$data/points_3/hippo1.ply' hippo.laz -q && '$convert_las' hippo.laz hippo.las"
check "a full disk" bash -c "'$program' $file - > /dev/full 2> full.log; [ \$? = 2 ] && grep -q 'cannot write standard output' full.log"

# ---- COPC is LAZ with records that tell where the points are

make_las copc.las format=7 copc=1
"$convert_las" copc.las some.copc.laz && python3 laz.py attach copc.las some.copc.laz
check "COPC is LAZ, with a note" fails_with 0 "warning: this is COPC: it is written as LAZ without the records of COPC, unless no point changes" "$program" some.copc.laz out.laz
check "its records go, all others stay" python3 laz.py compare some.copc.laz out.laz copc
check "and the points are those of LAS" bash -c "'$convert_las' out.laz plain.las && '$program' copc.las out.las -q && python3 laz.py points plain.las out.las"
check "no COPC is left" bash -c "! grep -aq copc out.laz"
check "COPC in which nothing moves stays COPC" bash -c "'$program' some.copc.laz same.laz -q --iterations 0 && cmp some.copc.laz same.laz"

# ---- files that lie

size=$(stat -c %s 1.2_3.laz) begin=$(python3 -c "import struct; print(struct.unpack_from('<I', open('1.2_3.laz', 'rb').read(), 96)[0])")
for part in $((begin + 4)) $((begin + 1000)) $((size - 1)); do
  head -c $part 1.2_3.laz > bad.laz
  refused "$part of $size bytes" "the " bad.laz
done
head -c $((begin + 1000)) 1.2_3.laz > bad.laz
refused "points that are cut" "the compressed points tell that their chunk table begins at byte " bad.laz
patch 1.2_3.laz bad.laz $begin q 5
refused "a table before the points" "the compressed points tell that their chunk table begins at byte 5" bad.laz
patch 1.2_3.laz bad.laz $begin q $((begin + 100))
refused "a table within the points" "there is no chunk table of the compressed points at byte $((begin + 100))" bad.laz
patch 1.2_3.laz bad.laz 107 I 60000
refused "counts that differ" "the header announces 60000 points, but the chunk table at byte " bad.laz
patch 1.2_3.laz bad.laz 107 I 3000
refused "more points than there are" "the compressed points are not complete: number " bad.laz
patch 1.2_3.laz bad.laz 105 H 50
refused "records of another size" "the record \"laszip encoded\" does not fit records of point format 3 with 50 bytes" bad.laz
python3 - <<'END'
import struct
b = bytearray(open("1.4_8.laz", "rb").read())
at = b.index(b"laszip encoded") + 52 + 34 # its fields: two kinds of extra bytes
for i in range(struct.unpack_from("<H", b, at - 2)[0]): struct.pack_into("<H", b, at + 6 * i, 14 if i else 10)
open("bad.laz", "wb").write(b)
END
refused "a field that comes twice" "the record \"laszip encoded\" does not fit records of point format 8 with 45 bytes" bad.laz
python3 - <<'END'
b = bytearray(open("1.2_3.laz", "rb").read())
b[b.index(b"laszip encoded")] = 120
open("bad.laz", "wb").write(b)
END
refused "no record of LASzip" "the points are compressed, but there is no complete record \"laszip encoded\"" bad.laz
python3 - <<'END'
# a compression that is not known, with other records behind that which tells it
import struct
b = bytearray(open("1.2_3.laz", "rb").read())
begin, = struct.unpack_from("<I", b, 96)
at = b.index(b"laszip encoded") - 2
record = b[at:at + 54 + struct.unpack_from("<H", b, at + 20)[0]]
struct.pack_into("<H", record, 54 + 2, 9)
head = struct.unpack_from("<H", b, 94)[0]
open("bad.laz", "wb").write(b[:head] + record + b[head:at] + b[at + len(record):])
END
refused "an unknown compression" "the compressed points can not be read (" bad.laz
check "failed runs leave no file" bash -c '! ls no.* *.part 2> /dev/null'
echo "all checks passed"
