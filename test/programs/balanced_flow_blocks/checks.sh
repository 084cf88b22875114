# SPDX-License-Identifier: GPL-3.0-or-later
# What the tests of the program balanced-flow-blocks share; $smooth is the program balanced-flow-smooth.
. "$(dirname "$0")/../program_test.sh"
blocks=$program

number_of_blocks() { "$blocks" status --json "$1" | sed -n 's/.*"blocks": \([0-9]*\).*/\1/p' | head -n 1; }
same_tree() { diff -r "$1" "$2"; }

# A long strip: blocks do not need all of it. Points of several densities, with a few far away, and duplicates
python3 - <<'END'
import random
random.seed(3)
with open("scan.xyz", "w") as out:
    for i in range(2400):
        for j in range(8):
            u, v = i + random.random(), j + random.random()
            x = u / 100 * (1 + u / 4000)
            print(f"{x:.6f} {v / 100:.6f} {.3 * (x % 1) ** 2 + random.gauss(0, .004):.6f} {i} word{j}", file=out)
    for far in (200, -3000):
        print(f"{far} {far} 5 -1 far", file=out)
END
sed -n '1~5p' scan.xyz > again.xyz && cat again.xyz >> scan.xyz # duplicates, far away in the file
