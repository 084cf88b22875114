#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Text of all kinds: what tells which columns are coordinates and normals, and that all else stays.
. "$(dirname "$0")/checks.sh"
rm colors.xyz

# ---- files: 300 points of a rough plane, in each dialect

cat > make_text.py <<'END'
import math, random
random.seed(1)
def point(i): return ["%.4f" % (i % 20 / 20), "%.4f" % (i // 20 / 20), "%.6f" % random.gauss(0, .02)]
def normal(i):
    n = [random.gauss(0, .2), random.gauss(0, .2), 1]
    return ["%.6f" % (c / math.hypot(*n)) for c in n]
points = [point(i) for i in range(300)]
normals = [normal(i) for i in range(300)]
normals[7] = ["0", "0", "0"]
normals[8] = ["nan", "NaN", "nan"]
rest = [[str(i), "tree"] for i in range(300)]
rgb = [["1", "0", "0"] for i in range(300)]
def write(name, rows, sep=" ", eol="\n", head="", end=None):
    text = head + "".join(sep.join(r) + eol for r in rows)
    if end is not None: text = text[:-len(eol)] + end
    open(name, "wb").write(text.encode())
def zipped(*parts): return [sum(t, []) for t in zip(*parts)]
pn = zipped(points, normals)
write("plain.xyz", points)
write("labels.xyz", zipped(points, rgb))
write("real_labels.xyz", zipped(points, [["1.0", "0.0", "0.0"]] * 300))
write("cr.xyz", points, eol="\r")
write("cr_open.asc", zipped(points, rest), eol="\r", end="")
write("crlf.txt", zipped(points, rest), eol="\r\n")
write("crcrlf.txt", points, eol="\r\r\n")
write("bom.xyz", points, head="\ufeff")
write("bom_header.csv", points, sep=",", head="\ufeffx,y,z\n")
write("comma.csv", zipped(points, rest), sep=",", head="X,Y,Z,Id,Kind\n")
write("comma_blank.csv", zipped(points, rest), sep=", ", eol="\r\n", head="x, y, z, id, kind\r\n")
write("quoted.csv", [['"%s"' % p for p in r] + ['"a ""b""; c # d"'] for r in points], sep=",",
      head='"X [m]","Y [m]","Z [m]","Name of it"\n')
write("trailing.csv", [r + [""] for r in points], sep=",", head="x,y,z\n")
write("empty_cells.csv", [r + ["", "", str(i)] for i, r in enumerate(points)], sep=";", head="x;y;z;a;b;c\n", end="\n;;;;;\n")
write("semicolon.asc", zipped(rest, points), sep=";", eol="\r", head="id;kind;x;y;z\r")
write("tab.txt", [r + ["", "old tree"] for r in points], sep="\t", head="x\ty\tz\tempty\tname\n")
write("comment.csv", points, sep=",", head="# made by hand\n// x, y, z\n\n")
write("normals.pwn", pn)
write("normals.xyzn", pn, sep="\t")
write("normals.csv", zipped(points, rgb, normals), sep=",", head="X,Y,Z,R,G,B,Nx,Ny,Nz\n")
write("cloudcompare.asc", zipped(points, rgb, normals), head="//X Y Z R G B Nx Ny Nz\n300\n")
write("count_first.txt", zipped(normals, points), head="300\nnormal_x normal_y normal_z x y z\n")
write("no_header.xyz", pn)
pts = zipped(points, [["-100", "255", "0", "7"]] * 300)
write("one.pts", pts, head="300\n", eol="\r\n")
text = ""
for begin, end in (0, 100), (100, 100), (100, 220), (220, 300):
    text += "%d\n" % (end - begin) + "".join(" ".join(r) + "\n" for r in pts[begin:end])
open("scans.pts", "w").write(text)
END
python3 make_text.py

# Compares two texts cell by cell, on its own: only the cells of some columns may differ, and some of each do.
cat > compare_text.py <<'END'
import re, sys
a, b = (open(f, "rb").read().decode("utf-8-sig") for f in sys.argv[1:3])
sep, columns = sys.argv[3].encode().decode("unicode_escape"), [int(c) - 1 for c in sys.argv[4].split(",")]
a, b = (re.split("(\r|\n|" + (" +" if sep == " " else sep) + ")", t) for t in (a, b))
assert len(a) == len(b), "number of cells"
column, changed = 0, {c: 0 for c in columns}
for v, w in zip(a, b):
    if v != w:
        assert column in changed, (column, v, w)
        around = [re.sub(r"[-+.\dae]|nan", "", c) for c in (v, w)] # quotes, blanks
        assert around[0] == around[1] and abs(float(v.strip(' "')) - float(w.strip(' "'))) < 2, (v, w)
        changed[column] += 1
    if v in ("\n", "\r"): column = 0
    elif v and v.strip(" ") == sep.strip(" "): column += 1
assert all(n > 20 for n in changed.values()), changed
END
for file in *.xyz *.txt *.asc *.csv *.pts *.pwn *.xyzn; do
  check "$file, nothing moves" bash -c "'$program' $file same.$file -q --iterations 0 && cmp $file same.$file"
  check "$file, without noise" bash -c "'$program' $file same.$file -q --noise 0 && cmp $file same.$file"
done
rm -f same.*
only_changes() { # only_changes file separator columns
  "$program" "$1" "out.$1" -q --noise 0.02 && python3 compare_text.py "$1" "out.$1" "$2" "$3"
}
for file in plain.xyz cr.xyz cr_open.asc crlf.txt bom.xyz one.pts labels.xyz real_labels.xyz no_header.xyz scans.pts; do
  check "only x, y, z of $file change" only_changes $file " " 1,2,3
done
for file in bom_header comma comma_blank quoted trailing comment; do
  check "only x, y, z of $file.csv change" only_changes $file.csv , 1,2,3
done
check "only x, y, z change between semicolons" only_changes empty_cells.csv ";" 1,2,3
check "only x, y, z change where the header has them" only_changes semicolon.asc ";" 3,4,5
check "only x, y, z change between tabs" only_changes tab.txt '\t' 1,2,3
check "points and normals of PWN change" only_changes normals.pwn " " 1,2,3,4,5,6
check "points and normals of XYZN change" only_changes normals.xyzn '\t' 1,2,3,4,5,6
check "normals are where the header has them" only_changes normals.csv , 1,2,3,7,8,9
check "normals are where a comment has them" only_changes cloudcompare.asc " " 1,2,3,7,8,9
check "normals are where the header after the number has them" only_changes count_first.txt " " 1,2,3,4,5,6

# ---- line ends: as many points, and as many lines

for file in cr.xyz cr_open.asc semicolon.asc crlf.txt crcrlf.txt; do
  check "$file has 300 points" bash -c "'$program' -n $file | grep -q '^points *300$'"
done
check "points do not depend on line ends" cmp <(tr '\r' '\n' < out.cr.xyz) out.plain.xyz

# ---- normals, and what says so

says() { # says file "part of the summary" options...
  local file=$1 part=$2
  shift 2
  "$program" -n "$file" "$@" 2>&1 | grep -qF -- "$part" || { "$program" -n "$file" "$@"; return 1; }
}
check "the order tells" says labels.xyz "x 1, y 2, z 3, by their order"
check "the header tells" says normals.csv "x 1, y 2, z 3, nx 7, ny 8, nz 9, by the header in line 1"
check "a comment tells" says cloudcompare.asc "nx 7, ny 8, nz 9, by the comment in line 1"
check "the option tells" says no_header.xyz "nx 4, ny 5, nz 6, by --columns" --columns x,y,z,nx,ny,nz
(echo "# x y z"; cat normals.pwn) > commented.pwn
check "a comment on the points leaves PWN its normals" says commented.pwn "nx 4, ny 5, nz 6"
check "unknown normals are counted" says normals.pwn "2 normals are null or not finite"
check "what looks like normals is told" says no_header.xyz "columns 4 to 6 look like normals"
check "JSON tells" bash -c "'$program' -n normals.csv --json | python3 -c \"
import json, sys
f = json.load(sys.stdin)['files'][0]
assert f['columns'] == dict(x=1, y=2, z=3, nx=7, ny=8, nz=9) and f['normals'] and f['unknown_normals'] == 2, f
assert f['columns_source'] == 'the header in line 1', f\""
check "the option makes normals of columns" bash -c "'$program' no_header.xyz by_option.xyz -q --noise 0.02 --columns x,y,z,nx,ny,nz && cmp by_option.xyz out.normals.pwn"
check "the option overrules a header" bash -c "'$program' normals.csv by_option.csv -q --noise 0.02 --columns x,y,z && python3 compare_text.py normals.csv by_option.csv , 1,2,3"
check "unknown normals stay" cmp <(sed -n 8,9p normals.pwn | cut -d' ' -f4-) <(sed -n 8,9p out.normals.pwn | cut -d' ' -f4-)
check "or are filled on request" bash -c "'$program' normals.pwn filled.pwn -q --noise 0.02 --normals && ! cut -d' ' -f4- filled.pwn | grep -qiE 'nan|^0 0 0' && [ \$(wc -l < filled.pwn) = 300 ]"
check "one unknown normal does not hide the others" bash -c "awk '{ d = \$4^2 + \$5^2 + \$6^2 - 1; if (d * d < 1e-12) ++n } END { exit n != 298 }' out.normals.pwn"
check "new normals get their names" bash -c "'$program' comma.csv n.csv -q --noise 0.02 --normals && head -1 n.csv | grep -qx 'X,Y,Z,nx,ny,nz,Id,Kind'"
check "and are found again" says n.csv "x 1, y 2, z 3, nx 4, ny 5, nz 6, by the header"
check "also between quotes" bash -c "'$program' quoted.csv n.csv -q --noise 0.02 --normals && head -1 n.csv | grep -qx '\"X \[m\]\",\"Y \[m\]\",\"Z \[m\]\",nx,ny,nz,\"Name of it\"' && '$program' n.csv same.csv -q --iterations 0 && cmp n.csv same.csv"

# ---- conversions

"$program" normals.csv named.ply -q --iterations 0
check "names become properties" diff <(sed '/end_header/q' named.ply | grep -a '^property' | cut -d' ' -f3 | tr '\n' ' ') <(printf 'x y z nx ny nz R G B ')
check "and names of columns" bash -c "'$program' named.ply named.csv -q --iterations 0 && head -1 named.csv | grep -qx x,y,z,nx,ny,nz,R,G,B"
check "PTS has names by its definition" bash -c "'$program' one.pts pts.ply -q --iterations 0 && grep -aq '^property int intensity' pts.ply && grep -aq '^property int blue' pts.ply"
check "PTS begins with the number of points" bash -c "'$program' plain.xyz new.pts -q && [ \$(head -1 new.pts) = 300 ]"
check "scans that are joined are told" fails_with 0 "warning: the division into scans can not be kept" "$program" scans.pts joined.ply
check "no PWN without normals" fails_with 2 "--normals adds them" "$program" plain.xyz no.pwn
printf 'x y z id time big mixed\n' > digits.txt
for i in 1 2 3 4; do echo "$i 100000 300000.5 $((9007199254740993 + i)) 1e5 1844674407370955161$i $((9007199254740993 + i)).5"; done >> digits.txt
check "integers keep all digits" bash -c "'$program' digits.txt digits.ply -q --iterations 0 && '$program' digits.ply digits.csv -q --iterations 0 && cut -d, -f1-6 digits.csv | sed 1d | diff - <(sed 1d digits.txt | cut -d' ' -f1-6 | sed 's/1e5/100000/' | tr ' ' ,)"
check "digits that are lost are told" bash -c "'$program' digits.txt digits.ply --iterations 0 2>&1 | grep -q 'warning: all digits of mixed can not be kept'"
check "and only these" bash -c "! '$program' digits.txt digits.ply --iterations 0 2>&1 | grep -E 'all digits of (id|time|big)'"

# ---- what is refused

iconv -f UTF-8 -t UTF-16 plain.xyz > utf16.xyz
iconv -f UTF-8 -t UTF-16LE plain.xyz > utf16le.xyz
iconv -f UTF-8 -t UTF-16BE plain.xyz > utf16be.csv
iconv -f UTF-8 -t UTF-16LE named.csv > utf16.dat
for file in utf16.xyz utf16le.xyz utf16be.csv; do
  check "$file" fails_with 2 "text in UTF-16, which is not supported: convert it to UTF-8" "$program" $file no.xyz
done
check "UTF-16 in a stream" bash -c "'$program' - - < utf16.dat 2>&1 | grep -q 'text in UTF-16'"
printf '1,5;2,5;3,5\n' > decimal.csv
printf 'easting,northing,height\n1,2,3\n' > names.csv
printf 'x,y,z\n1,2,3,4\n' > few_names.csv
printf 'x,y,z,a,b\n1,2,3\n' > many_names.csv
printf 'x,X,y,z\n1,2,3,4\n' > two_x.csv
printf '2\n0 0 0\n1 0 0\n2\n0 1 0\n' > short_scan.pts
check "decimal commas" fails_with 2 'is not a number' "$program" decimal.csv no.xyz
check "decimal commas in a column" fails_with 2 '"2,5" is not a number: decimals need a point' bash -c "echo '1;2,5;3;4;5' > decimal2.csv; '$program' decimal2.csv no.xyz"
check "a header without x" fails_with 2 "line 1: \"easting\" is not a number, and as names of columns x, y and z are missing (--columns" "$program" names.csv no.xyz
check "which the option tells" "$program" -n names.csv -q --columns x,y,z
check "too few names" fails_with 2 "line 1: 3 names, but the next line has 4 columns" "$program" few_names.csv no.xyz
check "too many names" fails_with 2 "5 names of columns, but there are 3 columns" "$program" many_names.csv no.xyz
check "x twice" fails_with 2 "x, y and z" "$program" two_x.csv no.xyz
check "a scan of PTS that is not complete" fails_with 2 "line 4 announces 2 points, but there are 1" "$program" short_scan.pts no.xyz
check "columns without z" fails_with 1 '--columns is "x,y": x, y and z must be there' "$program" plain.xyz no.xyz --columns x,y
check "part of a normal" fails_with 1 "nx, ny and nz must be there together" "$program" plain.xyz no.xyz --columns x,y,z,nx
check "columns of a PLY" fails_with 2 "--columns is for text, but the format is ply" "$program" named.ply no.xyz --columns x,y,z
cp plain.xyz plain.pwn
check "PWN without normals" fails_with 2 "PWN has normals in columns 4 to 6, but there are 3 columns" "$program" plain.pwn no.xyz

# ---- streams whose text looks like another format

(echo "# OFF the coast"; cat plain.xyz) > coast.xyz
printf 'plywood 1 2\n0 0 0\n' > plywood.txt
check "OFF in a comment is no OFF" bash -c "'$program' - - -q --iterations 0 < coast.xyz | cmp - coast.xyz"
check "it is XYZ" bash -c "'$program' -n - --json < coast.xyz | grep -q '\"format\": \"xyz\"'"
check "a word that begins with ply is no PLY" bash -c "'$program' -n - < plywood.txt 2>&1 | grep -q 'is not a number'"
check "failed runs leave no file" bash -c '! ls no.* *.part 2> /dev/null'
echo "all checks passed"
