# SPDX-License-Identifier: GPL-3.0-or-later
# Compares two LAS files, byte by byte, and knows nothing of our readers: all bytes are the same but the
# coordinates and the bounds in the header, coordinates moved and not far, and the bounds are those of
# the points.  compare_las.py BEFORE AFTER [DISTANCE]
import struct, sys

a, b = (open(f, "rb").read() for f in sys.argv[1:3])
far = float(sys.argv[3]) if len(sys.argv) > 3 else 1.
assert len(a) == len(b), "%d and %d bytes" % (len(a), len(b))
begin, = struct.unpack_from("<I", a, 96)
size, count = struct.unpack_from("<HI", a, 105)
if a[25] >= 4: count, = struct.unpack_from("<Q", a, 247)
scale, offset = struct.unpack_from("<3d", a, 131), struct.unpack_from("<3d", a, 155)
masked = [bytearray(a), bytearray(b)]
moved, low, high = 0, [float("inf")] * 3, [-float("inf")] * 3
for i in range(count):
    at = begin + i * size
    p, q = struct.unpack_from("<3i", a, at), struct.unpack_from("<3i", b, at)
    moved += p != q
    for c in range(3):
        assert abs(p[c] - q[c]) * scale[c] < far, "point %d moved too far" % i
        low[c], high[c] = min(low[c], q[c] * scale[c] + offset[c]), max(high[c], q[c] * scale[c] + offset[c])
    for m in masked: m[at:at + 12] = bytes(12)
for m in masked: m[179:227] = bytes(48)
if masked[0] != masked[1]:
    sys.exit("byte %d differs" % next(i for i in range(len(a)) if masked[0][i] != masked[1][i]))
assert moved > count / 4, "only %d points moved" % moved
bounds = struct.unpack_from("<6d", b, 179)
assert bounds == tuple(v for c in range(3) for v in (high[c], low[c])), (bounds, high, low)
