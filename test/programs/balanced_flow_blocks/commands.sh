# SPDX-License-Identifier: GPL-3.0-or-later
# Blocks of all formats come out as from the program that has all points in memory.
. "$(dirname "$0")/checks.sh"

check "in memory" "$smooth" -q scan.xyz expected.xyz
check "points moved" bash -c "! cmp -s scan.xyz expected.xyz"

check "plan" "$blocks" plan -q --block-size 3000 text scan.xyz
check "planned again" "$blocks" plan -q --block-size 3000 text scan.xyz
n=$(number_of_blocks text)
check "there are several blocks" [ "$n" -ge 7 ]
for ((block = n - 1; block >= 0; --block)); do
  check "block $block" "$blocks" smooth -q text $block
done
cp text/results/0.result before
check "a block that is done is done" "$blocks" smooth -q text 0
check "its result stays" cmp before text/results/0.result
check "status" bash -c "'$blocks' status text | grep -q '$n of them smoothed'"
check "join" "$blocks" join -q text
check "text" cmp text/smoothed/scan.xyz expected.xyz

for size in 1000 8000 100000; do
  check "blocks of $size" "$blocks" run -q --block-size $size run.$size scan.xyz
  check "blocks of $size, the result" cmp run.$size/smoothed/scan.xyz expected.xyz
done
check "two processes" "$blocks" run -q --jobs 2 --block-size 2000 two scan.xyz
check "two processes, the result" cmp two/smoothed/scan.xyz expected.xyz

# tiles: some after the other, or line by line
for way in l/3 r/4; do
  mkdir tiles
  split -n $way --additional-suffix=.xyz scan.xyz tiles/
  check "tiles $way" "$blocks" run -q --block-size 3000 --output-dir out tiled tiles
  check "tiles $way, the result" cmp <(cat out/* | sort) <(sort expected.xyz)
  rm -r tiles out tiled
done

# binary PLY with normals, of float and double, and LAS
awk 'BEGIN { print "x,y,z,nx,ny,nz,intensity" } { printf "%s,%s,%s,0,%s,1,%d\n", $1, $2, $3, NR % 3 ? .1 : 0, NR % 256 }' scan.xyz > scan.csv
check "PLY" "$smooth" -q --iterations 0 scan.csv scan.ply
check "LAS" "$smooth" -q --iterations 0 scan.csv scan.las
python3 - <<'END'
import random, struct
random.seed(4)
with open("mesh.ply", "wb") as out:
    n = 5000
    out.write(f"ply\nformat binary_big_endian 1.0\ncomment odd\nelement vertex {n}\nproperty uchar red\nproperty float x\n"
              "property float y\nproperty float z\nproperty short label\nelement face 2\n"
              "property list uchar int vertex_indices\nend_header\n".encode())
    for i in range(n):
        out.write(struct.pack(">Bfffh", i % 256, i / 50, random.random(), random.gauss(0, .05), -i))
    out.write(struct.pack(">Biii", 3, 0, 1, 2) * 2)
END
for file in scan.csv scan.ply scan.las mesh.ply; do
  check "$file in memory" "$smooth" -q $file expected.$file
  check "$file" "$blocks" run -q --block-size 2500 run.$file $file
  check "$file, the result" cmp run.$file/smoothed/$file expected.$file
  check "--memory, $file" env TMPDIR=. "$smooth" -q --memory 256M --block-size 2500 $file memory.$file
  check "--memory, $file, the result" cmp memory.$file expected.$file
done
check "no directory is left" [ -z "$(ls -d balanced-flow-smooth.* 2> /dev/null)" ]
check "--memory in place" "$smooth" -q --memory 256M -i --block-size 9000 memory.scan.ply
check "--memory with --json" bash -c "'$smooth' --memory 256M --block-size 9000 --json scan.las other.las | grep -q '\"moved\": [1-9]'"
check "--memory, other parameters" bash -c "'$smooth' -q --memory 256M --block-size 3000 -k 20 --noise .003 --iterations 3 scan.xyz k.xyz &&
  '$smooth' -q -k 20 --noise .003 --iterations 3 scan.xyz expected.k.xyz && cmp k.xyz expected.k.xyz"
check "--memory, the estimator of the paper" bash -c "'$smooth' -q --memory 256M --block-size 3000 --curvature covariance scan.xyz k.xyz &&
  '$smooth' -q --curvature covariance scan.xyz expected.k.xyz && cmp k.xyz expected.k.xyz"

# invalid points
sed '100s/.*/nan nan nan 7 hole/' scan.xyz > holes.xyz
check "invalid points are refused" fails_with 2 "points[99] is (nan, nan, nan), but coordinates must be finite" \
  "$blocks" plan -q holes holes.xyz
check "invalid points in memory" "$smooth" -q --invalid keep holes.xyz expected.holes.xyz
check "invalid points are kept" "$blocks" run -q --invalid keep --block-size 4000 kept holes.xyz
check "invalid points, the result" cmp kept/smoothed/holes.xyz expected.holes.xyz

# whatever is wrong
check "no command" fails_with 1 "a command and a directory are required" "$blocks" plan
check "another command" fails_with 1 'there is no command "smoth"' "$blocks" smoth text
check "no input" fails_with 1 "takes a directory and inputs" "$blocks" plan new
check "no plan" fails_with 2 "is not a planned directory" "$blocks" smooth new 0
check "no block" fails_with 2 "there is no block $n" "$blocks" smooth text $n
check "no number" fails_with 1 '"-1x" is no number of a block' "$blocks" smooth -q text -- -1x
check "no size" fails_with 1 'but must be a size such as 512M or 2G' "$blocks" plan --memory 2X new scan.xyz
check "too small" fails_with 1 'must be at least 256M' "$smooth" --memory 1M scan.xyz new.xyz
check "--jobs without --memory" fails_with 1 'need --memory' "$smooth" --jobs 2 scan.xyz new.xyz
check "planned for other files" fails_with 2 "is planned for other files or settings" "$blocks" plan -q text scan.las
check "planned for other settings" fails_with 2 "is planned for other files or settings" "$blocks" plan -q -k 20 text scan.xyz
check "no file" fails_with 2 "cannot read none.las" "$blocks" plan -q new none.las
check "not smoothed yet" bash -c "'$blocks' plan -q late scan.xyz && '$blocks' join late 2>&1 | grep -q 'block 0 is not smoothed yet'"
check "no output over an input" fails_with 2 "is an input, too" "$blocks" plan -q --output-dir . new scan.xyz
