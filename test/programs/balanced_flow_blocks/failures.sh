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
  for ((i = 0; i < 100; ++i)); do # processes whose parent was killed may still be ending
    [ -z "$(find killed -name '*.part')" ] && break
    sleep .1
  done
  check "killed, $trial, nothing is left" [ "$(ls killed | tr '\n' ' ')" = "blocks lock.join lock.plan manifest.json pages results smoothed written " ]
  check "killed, $trial, no temporary file" [ -z "$(find killed -name '*.part')" ]
done

# what is complete is not written again, also when others are missing
mkdir tiles && split -n l/3 --additional-suffix=.xyz scan.xyz tiles/x
check "tiles" "$blocks" run -q --block-size 3000 tiled tiles
identities() { stat -c '%n %i %Y %Z' tiled/smoothed/*; }
identities > before && cp -r tiled/smoothed tiles.expected
check "join again" "$blocks" join -q tiled
check "nothing is written again" diff before <(identities)
rm tiled/smoothed/xab.xyz && echo >> tiled/smoothed/xac.xyz
check "join what is missing" "$blocks" join -q tiled
check "what is missing is written" same_tree tiles.expected tiled/smoothed
check "what is complete is not" diff <(grep xaa before) <(identities | grep xaa)
echo "1 0 0" >> tiled/written # the end of a line that is not complete
check "join with a damaged list" "$blocks" join -q tiled

# temporary files of killed processes are removed, and nothing else
touch tiled/smoothed/{xaa.xyz.12.part,xaa.xyz.part,xaa.xyz.1b.part,other.xyz.12.part,notes} tiled/results/{1.result.5.part,2.result.5.part}
mkdir -p tiled/sides/0.0/blocks
python3 -c "
import fcntl, time
file = open('tiled/smoothed/xaa.xyz.34.part', 'w')
fcntl.flock(file, fcntl.LOCK_EX)
print('locked', flush=True)
time.sleep(600)" > lock.log &
owner=$!
until [ -s lock.log ]; do sleep .1; done
check "join beside a process" "$blocks" join -q tiled
check "temporary files" [ "$(ls tiled/smoothed | tr '\n' ' ')" = "notes other.xyz.12.part xaa.xyz xaa.xyz.1b.part xaa.xyz.34.part xaa.xyz.part xab.xyz xac.xyz " ]
kill $owner
wait $owner 2> /dev/null
check "what is left of the normals of scans" [ ! -e tiled/sides ]
check "join after the process" "$blocks" join -q tiled
check "its temporary file" [ ! -e tiled/smoothed/xaa.xyz.34.part ]
rm tiled/results/1.result
check "a block again" "$blocks" smooth -q tiled 1
check "its temporary file is removed" [ ! -e tiled/results/1.result.5.part ]
check "that of another is not" [ -e tiled/results/2.result.5.part ]

# killed while the normals of the scans are found
python3 - <<'END'
import random
random.seed(8)
with open("scans.ptx", "w") as out:
    for at, height in (0, 5), (.01, 5):
        out.write(f"200\n50\n1 1 {height}\n1 0 0\n0 1 0\n0 0 1\n1 0 0 0\n0 1 0 0\n0 0 1 0\n{at} 0 0 1\n")
        for i in range(10000):
            out.write(f"{i // 50 / 20:.5f} {i % 50 / 20:.5f} {random.gauss(0, .01):.5f} 0.5\n")
END
check "scans" "$smooth" -q scans.ptx expected.ptx
for ((trial = 1; trial <= (trials + 3) / 4; ++trial)); do
  rm -rf scanned
  "$blocks" run -q --block-size 3000 scanned scans.ptx > killed.log 2>&1 &
  process=$!
  sleep $(awk "BEGIN { print $RANDOM / 32768 * $duration / 1000 }")
  kill -KILL $process 2> /dev/null
  wait $process 2> /dev/null
  check "scans, killed, $trial" "$blocks" run -q --block-size 3000 scanned scans.ptx
  check "scans, killed, $trial, the result" cmp scanned/smoothed/scans.ptx expected.ptx
  check "scans, killed, $trial, nothing is left" [ ! -e scanned/sides ]
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
damaged() { rm -rf damaged && cp -r whole damaged && rm damaged/written; }
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
damaged && sed -i 's/"layout": 2/"layout": 1/' damaged/manifest.json
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
