# SPDX-License-Identifier: GPL-3.0-or-later
# Makes, reads and compares PCD files, and knows nothing of our readers, nor of liblzf.
import math, random, re, struct

codes = dict(I1="b", U1="B", I2="h", U2="H", I4="i", U4="I", I8="q", U8="Q", F4="f", F8="d")


def lzf(data):
    out, literals, seen, i = bytearray(), bytearray(), {}, 0

    def flush():
        for k in range(0, len(literals), 32):
            run = literals[k:k + 32]
            out.append(len(run) - 1)
            out.extend(run)
        literals.clear()

    while i < len(data):
        key, at = data[i:i + 3], seen.get(data[i:i + 3], -1)
        seen[key] = i
        if len(key) < 3 or at < 0 or i - at > 8192:
            literals.append(data[i])
            i += 1
            continue
        length = 3
        while length < 264 and i + length < len(data) and data[at + length] == data[i + length]: length += 1
        flush()
        far = i - at - 1
        out.append(min(length - 2, 7) << 5 | far >> 8)
        if length >= 9: out.append(length - 9)
        out.append(far & 255)
        i += length
    flush()
    return bytes(out)


def unlzf(data):
    out, i = bytearray(), 0
    while i < len(data):
        control = data[i]
        i += 1
        if control < 32:
            out += data[i:i + control + 1]
            i += control + 1
            continue
        length = control >> 5
        if length == 7: length, i = 7 + data[i], i + 1
        at = len(out) - ((control & 31) << 8) - data[i] - 1
        i += 1
        for k in range(length + 2): out.append(out[at + k])
    return bytes(out)


def fields_of(words):  # "x:F4 _:U1:3": name, type, size, count
    fields = []
    for word in words.split():
        name, kind, count = (word.split(":") + ["1"])[:3]
        fields.append((name, kind[0], int(kind[1:]), int(count)))
    return fields


def number(name, code, i, columns, k):
    scale = {"f": 1, "d": 1, "i": 10000, "h": 1000, "q": 10**12, "b": 100}.get(code, 1)
    role = name.lower()
    if role in ("x", "y", "z"):
        v = (i % columns / 20 + .1, i // columns / 20 + .1, random.gauss(0, .02))["xyz".index(role)] * scale
    elif role.startswith("normal_"):
        n = (random.gauss(0, .1), random.gauss(0, .1), 1)
        v = n["xyz".index(role[-1])] / math.hypot(*n) * scale
    elif name in ("rgb", "rgba"):  # as a float it is NaN, with bits that count
        bits = 0xff800000 | 40 * i + 1
        return bits if code != "f" else struct.pack("<I", bits)
    else:
        return {"q": -2**63, "Q": 2**64 - 999, "I": 2**32 - 999}.get(code, 0) + i % 120 + k if code not in "fd" else i + .5 + k
    return v if code in "fd" else round(v)


# The rows of a file: for each field a list of numbers; bytes are those of a float.
def rows_of(fields, count, columns):
    random.seed(1)
    return [[[number(n, codes.get(t + str(s), "B"), i, columns, k) for k in range(c)] for n, t, s, c in fields] for i in range(count)]


def puncture(rows, fields, holes):
    places = [i for i, f in enumerate(fields) if f[0] in ("x", "y", "z")]
    for i in holes:
        for p in places[2:] if i == 7 else places: rows[i][p] = [struct.pack("<I", 0xffa00000 + i)]


def to_bytes(v, t, s): return v if isinstance(v, bytes) else struct.pack("<" + codes[t + str(s)], v) if t + str(s) in codes else bytes([v % 256]) * s


def to_word(v, t, s):
    if isinstance(v, bytes): return "nan"
    return repr(struct.unpack("f", struct.pack("f", v))[0] if t + str(s) == "F4" else v)


def make(path, kind, words, width=300, height=1, rows=None, holes=(), head=None, eol="\n", rest=b"", pads=True, **lines):
    fields = fields_of(words)
    if rows is None: rows = rows_of(fields, width * height, width if min(width, height) > 1 else 20)
    puncture(rows, fields, holes)
    values = dict(VERSION=".7", FIELDS=" ".join(f[0] for f in fields), SIZE=" ".join(str(f[2]) for f in fields), TYPE=" ".join(f[1] for f in fields),
                  COUNT=" ".join(str(f[3]) for f in fields), WIDTH=width, HEIGHT=height, VIEWPOINT="0 0 0 1 0 0 0", POINTS=len(rows), DATA=kind)
    values.update(lines)
    data = values.pop("DATA")
    text = [head or "# .PCD v.7 - Point Cloud Data file format"] + ["%s %s" % (k, v) for k, v in values.items() if v is not None] + ["DATA " + data]
    out = (eol.join(text) + eol).encode()
    if kind == "ascii":
        for row in rows: out += " ".join(to_word(v, f[1], f[2]) for f, vs in zip(fields, row) for v in vs).encode() + eol.encode()
    else:
        cells = [[b"".join(to_bytes(v, f[1], f[2]) for v in vs) for f, vs in zip(fields, row)] for row in rows]
        if kind == "binary": out += b"".join(map(b"".join, cells))
        else:
            points = b"".join(row[i] for i, f in enumerate(fields) if pads or f[0] != "_" for row in cells)
            packed = lzf(points)
            out += struct.pack("<II", len(packed), len(points)) + packed
    open(path, "wb").write(out + rest)


# The header as text, its lines, and of each point the bytes or words of its fields; what comes after them.
def read(path):
    b = open(path, "rb").read()
    found = re.search(rb"DATA (\w+)(\r\n|\r|\n)", b)
    head, kind, b = b[:found.end()], found[1].decode(), b[found.end():]
    lines = {w[0]: w[1:] for w in (l.split() for l in re.split("[\r\n]+", head.decode())) if w and w[0] != "#"}
    names = lines.get("FIELDS") or lines["COLUMNS"]
    fields = list(zip(names, lines["TYPE"], map(int, lines["SIZE"]), map(int, lines.get("COUNT", ["1"] * len(names)))))
    count = int(lines["POINTS"][0]) if "POINTS" in lines else int(lines["WIDTH"][0]) * int(lines.get("HEIGHT", ["1"])[0])
    records = []
    if kind == "ascii":
        words = re.split(rb"(\s+)", b)
        at = 0
        for i in range(count):
            records.append([])
            for f in fields:
                records[-1].append(words[at:at + 2 * f[3]])
                at += 2 * f[3]
        return head, lines, fields, records, words[at:]
    sizes = [f[2] * f[3] for f in fields]
    if kind == "binary":
        at = 0
        for i in range(count):
            records.append([])
            for s in sizes:
                records[-1].append(b[at:at + s])
                at += s
        return head, lines, fields, records, b[at:]
    packed, size = struct.unpack_from("<II", b)
    points = unlzf(b[8:8 + packed])
    if size != sum(sizes) * count: sizes = [0 if f[0] == "_" else s for f, s in zip(fields, sizes)]
    assert len(points) == size == sum(sizes) * count
    begins = [sum(sizes[:i]) * count for i in range(len(sizes))]
    records = [[points[a + i * s:a + (i + 1) * s] for a, s in zip(begins, sizes)] for i in range(count)]
    return head, lines, fields, records, b[8 + packed:]


def value(cell, field): return float(cell[0]) if isinstance(cell, list) else struct.unpack("<" + codes[field[1] + str(field[2])], cell)[0]


# Only the named fields differ, not where a point is none, and not much.
def compare(before, after, names):
    a, b = read(before), read(after)
    assert a[0] == b[0] and a[2] == b[2], "header"
    assert len(a[3]) == len(b[3]) and a[4] == b[4], "what comes after the points"
    changed = dict.fromkeys(names, 0)
    for i, (r, s) in enumerate(zip(a[3], b[3])):
        is_none = any(math.isnan(value(c, f)) for c, f in zip(r, a[2]) if f[0].lower() in ("x", "y", "z"))
        for f, c, d in zip(a[2], r, s):
            assert c == d or (f[0] in names and not is_none), (i, f[0], c, d)
            if c != d:
                changed[f[0]] += 1
                assert abs(value(c, f) - value(d, f)) <= (1 if f[1] == "F" else 10.**13), (i, c, d)
    assert all(n > 20 for n in changed.values()), changed
