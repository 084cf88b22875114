# SPDX-License-Identifier: GPL-3.0-or-later
"""Noisy points for the tests, the same in each run."""

import numpy as np


def sphere(n, noise=0.01, dtype=np.float64):
    """Points on a sphere of radius 1, moved along the normals."""
    random = np.random.default_rng(5)
    directions = random.normal(size=(n, 3))
    directions /= np.linalg.norm(directions, axis=1)[:, None]
    return (directions * (1.0 + noise * random.normal(size=(n, 1)))).astype(dtype)


def cube(n, noise=0.01):
    """Points on the cube [-1, 1]^3, moved in all directions."""
    points = sphere(n, 0.0)
    points /= np.abs(points).max(axis=1)[:, None]
    return points + noise * np.random.default_rng(6).normal(size=(n, 3))


def distances(points):
    """From that sphere."""
    return np.abs(np.linalg.norm(points.astype(np.float64), axis=1) - 1.0)
