#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes a terrain of any number of points as a binary PLY, in little memory: make_terrain.py POINTS FILE

Points are uniformly random, one per unit of area, in strips from south to north as an airborne scanner measures them, with an
intensity. There are hills of all sizes, and terraces with sharp edges. The noise is 0.4 units.
"""
import sys

import numpy as np

count, path = int(sys.argv[1]), sys.argv[2]
random = np.random.default_rng(1)
width = int(np.ceil(np.sqrt(count)))
rows = 64  # of a strip
waves = [(20.0 * 2.0**-i, 2.0 * np.pi / (2000.0 * 2.0**-i), random.uniform(0.0, 7.0, 4)) for i in range(6)]


def heights(x, y):
    z = np.zeros_like(x)
    for height, frequency, phases in waves:
        z += height * np.sin(frequency * x + phases[0]) * np.sin(frequency * y + phases[1])
        z += height * np.sin(frequency * 0.7 * (x + y) + phases[2])
    return z + 5.0 * np.floor(z / 15.0)


record = np.dtype([("x", "<f8"), ("y", "<f8"), ("z", "<f8"), ("intensity", "<u2")])
with open(path, "wb") as file:
    file.write(b"ply\nformat binary_little_endian 1.0\nelement vertex %d\nproperty double x\nproperty double y\n"
               b"property double z\nproperty ushort intensity\nend_header\n" % count)
    for begin in range(0, count, width * rows):
        n = min(width * rows, count - begin)
        points = np.empty(n, record)
        points["x"] = random.uniform(0.0, width, n)
        points["y"] = np.sort(begin / width + random.uniform(0.0, n / width, n))
        points["z"] = heights(points["x"], points["y"]) + 0.4 * random.standard_normal(n)
        points["intensity"] = random.integers(0, 65536, n)
        points.tofile(file)
