# SPDX-License-Identifier: GPL-3.0-or-later
# What the tests of the program balanced-flow-smooth share
. "$(dirname "$0")/../program_test.sh"

# the words of the lines from one word on, without comments
words_from() { sed 's/\r//; /^#/d' "$2" | cut -d' ' -f"$1"-; }
# some of the first three words of the lines differ
moved() { [ "$(cut -d' ' -f1-3 "$1" | paste - <(cut -d' ' -f1-3 "$2") | awk '$1 != $4 || $2 != $5 || $3 != $6' | wc -l)" -ge 1 ]; }

patch() { # patch FROM TO PLACE FORMAT VALUE: one value differs
  python3 -c "
import struct, sys
b = bytearray(open('$1', 'rb').read())
struct.pack_into('<$4', b, $3, $5)
open('$2', 'wb').write(b)"
}
refused() { # refused "what" "message" FILE: the file stays, and no other comes to be
  cp "$3" before
  check "$1" fails_with 2 "cannot read $3: $2" "$program" "$3" "no.${3##*.}"
  check "$1, in place" fails_with 2 "cannot read $3: $2" "$program" -i "$3"
  check "$1, it stays" cmp "$3" before
  check "$1, standard output is empty" bash -c "[ -z \"\$('$program' '$3' - 2> /dev/null)\" ]"
}

cat > colors.xyz <<'END'
# x y z r g b label
0 0 0.1 255 0 12 3
1 0 0 254 1 13 3
0 1 -0.1 253 2 14 4
1 1 0 252 3 15 4
0.5 0.5 0.25 251 4 16 5
2 0 0.1 250 5 17 5
END
# what makes six points move; their noise cannot be estimated
few="-k 4 --curvature covariance"
