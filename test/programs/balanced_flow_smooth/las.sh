#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# LAS and LAZ: scales, offsets, projection and all dimensions but X, Y, Z stay, as the program pdal
# sees them. For programs that are built with PDAL, where there is a program pdal as well.
. "$(dirname "$0")/checks.sh"

awk 'BEGIN {
  srand(1)
  print "X Y Z Intensity ReturnNumber NumberOfReturns Classification ScanAngleRank UserData PointSourceId GpsTime Red Green Blue Infrared Reflectance Number"
  for (i = 0; i < 3000; ++i)
    printf "%.3f %.3f %.3f %d %d %d %d %d %d %d %.7f %d %d %d %d %g %d\n", 512345 + i % 60 / 4, 5412345 + int(i / 60) / 4,
      123 + (rand() + rand() + rand() - 1.5) / 5, 65535 - i, 1 + i % 3, 3, i % 20, i % 90 - 45, i % 256, i % 1000,
      3e8 + i / 1e4, i * 21, 65535 - i, i, 7 * i, i / 8, 4294967295 - i
}' > points.txt
make_las() { # make_las file options...
  pdal translate -r readers.text -w writers.las points.txt "$@" --writers.las.scale_x=0.001 --writers.las.scale_y=0.001 \
    --writers.las.scale_z=0.0005 --writers.las.offset_x=512000 --writers.las.offset_y=5412000 --writers.las.offset_z=100 \
    --writers.las.system_id=scanner --writers.las.software_id=test --writers.las.filesource_id=7
}
extra='--writers.las.extra_dims=Reflectance=float,Number=uint32,Infrared=uint16'
make_las new.las --writers.las.minor_version=4 --writers.las.dataformat_id=8 --writers.las.a_srs=EPSG:25832 \
  --writers.las.extra_dims=Reflectance=float,Number=uint32 || exit 1
make_las old.las --writers.las.minor_version=2 --writers.las.dataformat_id=3 $extra
make_las new.laz --writers.las.minor_version=4 --writers.las.dataformat_id=7 --writers.las.compression=true $extra
order=Intensity,ReturnNumber,NumberOfReturns,ScanDirectionFlag,EdgeOfFlightLine,Classification,ScanAngleRank,UserData,PointSourceId,GpsTime,Red,Green,Blue,Infrared,Reflectance,Number
to_text() { # to_text file dimensions
  pdal translate -r readers.las --readers.las.use_eb_vlr=true -w writers.text "$1" "$1.txt" --writers.text.order="$2" \
    --writers.text.keep_unspecified=false --writers.text.precision=9 && cat "$1.txt"
}
# the header, without what follows from the points or the name
header() {
  pdal info --metadata "$1" | grep -vE '"(filename|m(ax|in)[xyz]|now|file_size|metadata)"' | grep -v '"data":'
}
for file in new.las old.las new.laz; do
  out=out_$file
  check "a run on $file" "$program" $file $out -q
  check "all other dimensions of $file stay" cmp <(to_text $file $order) <(to_text $out $order)
  check "its header stays" diff <(header $file) <(header $out)
  to_text $file X,Y,Z > before.txt
  to_text $out X,Y,Z > after.txt
  check "its points move, not far" bash -c "paste -d, before.txt after.txt | sed 1d | awk -F, '{ d = (\$1-\$4)^2 + (\$2-\$5)^2 + (\$3-\$6)^2; if (d > 1) exit 1; if (d > 0) ++n } END { exit n < 2000 }'"
  check "nothing moves in 0 iterations" "$program" $file same_$file -q --iterations 0
  check "no point is rounded" cmp before.txt <(to_text same_$file X,Y,Z)
done
check "LAZ is compressed" bash -c "[ \$(stat -c %s out_new.laz) -lt \$((\$(stat -c %s out_new.las) / 2)) ]"
check "LAZ from LAS" bash -c "'$program' new.las as.laz -q && [ \$(stat -c %s as.laz) -lt \$((\$(stat -c %s new.las) / 2)) ]"
check "a stream" bash -c "'$program' - - -q < new.las > stream.las && cmp stream.las out_new.las"
check "LAS in place" bash -c "cp new.las place.las && '$program' -i place.las -q && cmp place.las out_new.las"
check "normals become dimensions" "$program" new.las n.las -q --normals
check "they are unit vectors" bash -c "pdal translate n.las n.txt -w writers.text --writers.text.order=NormalX,NormalY,NormalZ --writers.text.keep_unspecified=false --writers.text.precision=9 && sed 1d n.txt | awk -F, '{ d = \$1^2 + \$2^2 + \$3^2 - 1; if (d * d > 1e-8) exit 1 }'"
check "LAS to PLY" bash -c "'$program' new.las new.ply -q --iterations 0 && grep -aq '^property ushort Intensity' new.ply && grep -aq '^property double GpsTime' new.ply"
check "and back" bash -c "'$program' new.ply back.las -q --iterations 0"
check "the values are still there" cmp <(to_text back.las Intensity,GpsTime,Red,Classification,Reflectance,Number) <(to_text new.las Intensity,GpsTime,Red,Classification,Reflectance,Number)
head -c 50000 new.las > truncated.las
head -c 300 points.txt > text.las
for file in truncated.las text.las; do
  check "$file is refused" fails_with 2 "cannot read $file" "$program" $file no.las
done
check "what the header does not describe is not lost without a word" bash -c "
  python3 -c \"
b = bytearray(open('old.las', 'rb').read())
i = b.index(b'LASF_Spec')
b[i + 8] = 120
open('bare.las', 'wb').write(b)\""
check "extra bytes without a description" fails_with 2 "PDAL would lose them" "$program" bare.las no.las
check "failed runs leave no file" bash -c '! ls no.* *.part 2> /dev/null'
echo "all checks passed"
