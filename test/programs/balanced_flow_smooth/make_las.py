# SPDX-License-Identifier: GPL-3.0-or-later
# Makes LAS files of all versions and point formats, with everything that a file may have around its
# points, and knows nothing of our readers:  make_las.py FILE version=1.4 format=7 [name=value ...]
# Values (in brackets their defaults): points [300], extra bytes of each point [7], vlrs [2], evlrs [2 in
# LAS 1.4], padding of the header, in front of the points and behind them [3], waveforms [1 if the format
# has them], evlr_size [70000] of the first extended record, copc [0], east [512000] and north [5412000] of the offset, scale [0.001], seed [1].
import random, struct, sys

options = dict(word.split("=", 1) for word in sys.argv[2:])
minor = int(options.get("version", "1.4")[2:])
point_format = int(options.get("format", 7))
def number(name, default): return int(options.get(name, default))
random.seed(number("seed", 1))
count, extra, padding = number("points", 300), number("extra", 7), number("padding", 3)
scale = float(options.get("scale", .001))
offset = float(options.get("east", 512000)), float(options.get("north", 5412000)), 100.
size = (20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67)[point_format]
has_waveforms = number("waveforms", point_format in (4, 5, 9, 10) and minor >= 3)
header_size = (227, 227, 227, 235, 375)[minor] + padding
noise = lambda n: bytes(random.randrange(256) for _ in range(n))

def vlr(user, record, data, extended=False):
    head = struct.pack("<H16sH", 0xAABB if minor == 0 else 0, user, record)
    return head + struct.pack("<Q" if extended else "<H", len(data)) + struct.pack("<32s", b"by hand") + data

vlrs = [vlr(b"made by hand", 7 + i, noise(20 * i)) for i in range(number("vlrs", 2))]
if number("copc", 0):
    vlrs.insert(0, vlr(b"copc", 1, noise(160)))
if extra:
    def described(kind, name, options=0, factor=0., shift=0.):
        return struct.pack("<HBB32s76xd16xd16x32s", 0, kind, options, name, factor, shift, b"of a test")
    if extra >= 6: # the rest is not described
        vlrs.append(vlr(b"LASF_Spec", 4, described(9, b"Reflectance") + described(3, b"Scaled value", 24, .5, 10.)))
size += extra

points = bytearray()
low, high = [10**10] * 3, [-10**10] * 3
for i in range(count):
    x, y, z = i % 20 / 4, i // 20 / 4, random.gauss(0, .05)
    place = [round(v / scale) for v in (x, y, z)]
    for c in range(3):
        low[c], high[c] = min(low[c], place[c]), max(high[c], place[c])
    record = struct.pack("<iii", *place) + noise(size - 12)
    if extra >= 6:
        record = record[:size - extra] + struct.pack("<fH", i / 8, i % 65536) + record[size - extra + 6:]
    points += record

before = b"".join(vlrs)
begin = header_size + len(before) + padding
end = begin + len(points) + padding
evlrs = [vlr(b"beyond the points", 50 + i, noise(number("evlr_size", 70000) if i == 0 else 5), True) for i in range(number("evlrs", 2 if minor >= 4 else 0))]
if number("copc", 0):
    evlrs.insert(1, vlr(b"copc", 1000, noise(500), True))
after = b"".join(evlrs)
waveforms = 0
if has_waveforms:
    waveforms = end + len(after)
    packets = vlr(b"LASF_Spec", 65535, noise(1000), True)
    if minor >= 4:
        evlrs.append(packets)
    after += packets

header = bytearray(header_size)
struct.pack_into("<4sHHIHH8sBB32s32sHHHIIBHI", header, 0, b"LASF", 7, 1 | (2 if has_waveforms else 0), 1, 2, 3, b"12345678", 1, minor,
                 b"scanner", b"test", 33, 2024, header_size, begin, len(vlrs), point_format, size,
                 count if point_format < 6 else 0)
if minor < 4: struct.pack_into("<I", header, 107, count)
struct.pack_into("<5I", header, 111, *([count, 0, 0, 0, 0] if point_format < 6 else [0] * 5))
struct.pack_into("<6d", header, 131, *([scale] * 3 + list(offset)))
bounds = [v for c in range(3) for v in (high[c] * scale + offset[c] + 1, low[c] * scale + offset[c] - 1)]  # too wide
struct.pack_into("<6d", header, 179, *bounds)
if minor >= 3: struct.pack_into("<Q", header, 227, waveforms)
if minor >= 4: struct.pack_into("<QIQ15Q", header, 235, end if evlrs else 0, len(evlrs), count, count, *([0] * 14))
header[header_size - padding:] = noise(padding)
with open(sys.argv[1], "wb") as out:
    out.write(header + before + noise(padding) + points + noise(padding) + after)
    if not evlrs and not waveforms: out.write(noise(padding))
