# SPDX-License-Identifier: GPL-3.0-or-later
# Processes that are killed, disks that are full, files that are damaged: the right result, or none.
. "$(dirname "$0")/checks.sh"

trials=${KILLS:-8}
check "in memory" "$smooth" -q scan.xyz expected.xyz
start=$(date +%s%N)
check "blocks" "$blocks" run -q --block-size 3000 whole scan.xyz
duration=$((($(date +%s%N) - start) / 1000000))

RANDOM=7
for ((trial = 1; trial <= trials; ++trial)); do
  rm -rf killed
  for kill in 1 2; do # the second run goes on, and is killed, too
    "$blocks" run -q --jobs $((trial % 2 + 1)) --block-size 3000 killed scan.xyz > killed.log 2>&1 &
    process=$!
    sleep $(awk "BEGIN { print $RANDOM / 32768 * $duration / 1000 }")
    kill -KILL $process 2> /dev/null
    wait $process 2> /dev/null
  done
  check "killed, $trial" "$blocks" run -q --block-size 3000 killed scan.xyz
  check "killed, $trial, the result" cmp killed/smoothed/scan.xyz expected.xyz
done

check "interrupted" bash -c "'$blocks' run -q --block-size 1000 stopped scan.xyz & sleep .3; kill -INT \$!; wait \$!; s=\$?; [ \$s = 130 ] || [ \$s = 0 ]"
check "interrupted, gone on" "$blocks" run -q --block-size 1000 stopped scan.xyz
check "interrupted, the result" cmp stopped/smoothed/scan.xyz expected.xyz

# two processes on one block
check "plan" "$blocks" plan -q --block-size 3000 both scan.xyz
"$blocks" smooth -q both 1 & "$blocks" smooth -q both 1
check "two processes on one block" wait $!
check "the others" "$blocks" run -q both
check "two processes on one block, the result" cmp both/smoothed/scan.xyz expected.xyz

# a disk that is full: files may not become larger
plan_on_small_disk() { (trap '' XFSZ; ulimit -f 100; "$blocks" plan -q --block-size 3000 full scan.xyz); }
check "disk full" fails_with 2 "File too large" plan_on_small_disk
check "disk no longer full" "$blocks" run -q --block-size 3000 full scan.xyz
check "disk no longer full, the result" cmp full/smoothed/scan.xyz expected.xyz
rm -r full/results/* full/smoothed
smooth_on_small_disk() { (trap '' XFSZ; ulimit -f 8; "$blocks" smooth -q full 0); }
check "disk full, a block" fails_with 2 "" smooth_on_small_disk
check "disk full, no result" [ ! -e full/results/0.result ]
check "disk full, nothing is left" [ -z "$(ls full/results)" ]

# damage
damage() { # damage FILE [BYTE]: one bit of it, by default in the middle; bytes count from the end
  python3 -c "
b = bytearray(open('$1', 'rb').read())
b[-${2:-len(b) // 2}] ^= 64
open('$1', 'wb').write(b)"
}
damaged() { rm -rf damaged && cp -r whole damaged; }
damaged && rm damaged/results/* && damage damaged/blocks/0.points
check "damaged points" fails_with 2 "0.points is damaged" "$blocks" smooth -q damaged 0
damaged && rm damaged/results/* && truncate -s -8 damaged/blocks/0.points
check "points that are cut off" fails_with 2 "0.points is damaged" "$blocks" smooth -q damaged 0
for byte in 1 2 8 9 16 40 5000; do # a record ends with the number of the point
  damaged && damage damaged/results/0.result $byte
  check "a damaged result, byte $byte" fails_with 2 "0.result is damaged" "$blocks" join -q damaged
done
damaged && truncate -s -8 damaged/results/0.result
check "a result that is cut off" fails_with 2 "0.result can not be used: it is not complete" "$blocks" join -q damaged
damaged && damage damaged/pages
check "a damaged index" fails_with 2 "its index of pages is damaged" "$blocks" status damaged
damaged && sed -i 's/"layout": 1/"layout": 0/' damaged/manifest.json
check "another version" fails_with 2 "it is of another version" "$blocks" status damaged
damaged && "$blocks" plan -q --block-size 2000 other scan.xyz && cp whole/results/0.result other/results/
check "a result of another plan" fails_with 2 "it is of another plan" "$blocks" smooth -q other 0

# an input that is no longer what it was
cp scan.xyz input.xyz
check "plan of an input" "$blocks" plan -q --block-size 3000 changed input.xyz
sed -i '1s/^./9/' input.xyz
check "an input that changed" fails_with 2 "was changed since it was planned" "$blocks" run -q changed
check "an input that changed, plan" fails_with 2 "was changed since it was planned" "$blocks" plan -q --block-size 3000 changed input.xyz
rm input.xyz
check "an input that is gone" fails_with 2 "input.xyz: No such file" "$blocks" run -q changed
