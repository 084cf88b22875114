# SPDX-License-Identifier: GPL-3.0-or-later
"""Which arrays the functions take, and what they return."""

import numpy as np
import pytest

import balanced_flow as bf
from clouds import distances, sphere

DTYPES = [np.float64, np.float32]


def layouts(points):
    """The same points in arrays of all kinds"""
    n = len(points)
    yield "Fortran order", np.asfortranarray(points)
    wide = np.full((2 * n, 7), np.nan, points.dtype)
    wide[::2, 1:6:2] = points
    yield "every other row and column", wide[::2, 1:6:2]
    yield "negative strides", np.ascontiguousarray(points[::-1, ::-1])[::-1, ::-1]
    packed = np.zeros(n, np.dtype([("label", "u1"), ("point", points.dtype, 3)]))
    packed["point"] = points
    yield "field of a packed record, not aligned", packed["point"]
    swapped = points.astype(points.dtype.newbyteorder())
    yield "other byte order", swapped
    frozen = points.copy()
    frozen.flags.writeable = False
    yield "read-only", frozen


@pytest.mark.parametrize("dtype", DTYPES)
def test_noise_is_removed_and_the_input_stays(dtype):
    points = sphere(4000, dtype=dtype)
    before = points.copy()
    smoothed = bf.smooth(points)
    assert np.array_equal(points, before)
    assert type(smoothed) is np.ndarray
    assert smoothed.dtype == dtype and smoothed.shape == points.shape
    assert not np.shares_memory(smoothed, points)
    assert distances(smoothed).mean() < 0.5 * distances(points).mean()


@pytest.mark.parametrize("dtype", DTYPES)
def test_the_layout_does_not_matter(dtype):
    points = sphere(3000, dtype=dtype)
    normals = (points / 2).astype(dtype)
    expected, expected_normals = bf.smooth(points, normals)
    for name, array in layouts(points):
        before = array.copy()
        smoothed, new_normals = bf.smooth(array, normals)
        assert smoothed.dtype == dtype, name
        assert np.array_equal(smoothed, expected), name
        assert np.array_equal(new_normals, expected_normals), name
        assert np.array_equal(array, before), name
    for name, array in layouts(normals):
        smoothed, new_normals = bf.smooth(points, array)
        assert np.array_equal(smoothed, expected), name
        assert np.array_equal(new_normals, expected_normals), name


@pytest.mark.parametrize("dtype", DTYPES)
def test_out_of_any_layout_receives_the_result(dtype):
    points = sphere(3000, dtype=dtype)
    expected, expected_normals = bf.smooth(points, points)
    for name, out in layouts(points):
        if not out.flags.writeable or not out.dtype.isnative:
            continue
        out_normals = np.empty_like(points, order="F")
        results = bf.smooth(points, points, out=out, out_normals=out_normals)
        assert results[0] is out and results[1] is out_normals, name
        assert np.array_equal(out, expected), name
        assert np.array_equal(out_normals, expected_normals), name


def test_in_place():
    points = sphere(3000)
    expected = bf.smooth(points)
    for shift in (0, 1):  # also where the places only overlap
        memory = np.empty((3001, 3))
        memory[:3000] = points
        out = memory[shift:3000 + shift]
        assert bf.smooth(memory[:3000], out=out) is out
        assert np.array_equal(out, expected)
    columns = np.hstack([points, points])
    bf.smooth(columns[:, :3], columns[:, 3:], out=columns[:, :3], out_normals=columns[:, 3:])
    both = bf.smooth(points, points)
    assert np.array_equal(columns, np.hstack(both))


def test_what_is_beside_out_stays():
    points = sphere(3000)
    memory = np.full((3000, 6), 7.0)
    bf.smooth(points, out=memory[:, 1:4])
    assert np.all(memory[:, [0, 4, 5]] == 7.0)


def test_other_numbers_become_floats():
    points = np.round(sphere(2000) * 1000).astype(np.int32)
    smoothed = bf.smooth(points)
    assert smoothed.dtype == np.float64
    assert np.array_equal(smoothed, bf.smooth(points.astype(np.float64)))
    assert np.array_equal(smoothed, bf.smooth(points.tolist()))
    half = sphere(2000, dtype=np.float16)
    assert np.array_equal(bf.smooth(half), bf.smooth(half.astype(np.float32)))


def test_normals_of_another_dtype():
    points = sphere(2000, dtype=np.float32)
    normals = points.astype(np.float64)
    smoothed, new_normals = bf.smooth(points, normals)
    assert new_normals.dtype == np.float32
    assert np.array_equal(smoothed, bf.smooth(points, points)[0])


def test_normals_are_those_of_the_surface_and_keep_their_side():
    points = sphere(4000)
    for normals, sign in ((points, 1), (-3 * points, -1)):
        smoothed, new_normals = bf.smooth(points, normals)
        assert np.allclose(np.linalg.norm(new_normals, axis=1), 1)
        assert np.all(np.sum(smoothed * new_normals, axis=1) * sign > 0.9)
    unknown = np.zeros_like(points)
    unknown[::2] = np.nan
    smoothed, new_normals = bf.smooth(points, unknown)
    assert np.array_equal(smoothed, bf.smooth(points))
    assert np.all(np.abs(np.sum(smoothed * new_normals, axis=1)) > 0.9)


def test_few_points():
    assert bf.smooth(np.zeros((0, 3))).shape == (0, 3)
    assert bf.estimate_noise(np.zeros((0, 3))) == 0
    points, normals = bf.smooth(np.zeros((0, 3), np.float32), np.zeros((0, 3)))
    assert points.shape == normals.shape == (0, 3) and normals.dtype == np.float32
    assert np.array_equal(bf.smooth([[1, 2, 3]]), [[1, 2, 3]])
    assert len(bf.smooth(np.zeros((0, 3)), noise=[], scans=[], constrained=[])) == 0
