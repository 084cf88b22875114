# SPDX-License-Identifier: GPL-3.0-or-later
"""The results are those of the C++ function, and what the parameters promise."""

import os
import subprocess

import numpy as np
import pytest

import balanced_flow as bf
from clouds import cube, sphere

DTYPES = [np.float64, np.float32]


def of_cpp(mode, rows, tmp_path):
    """What the C++ function makes of rows of point, normal, noise, scan and constrained"""
    source, target = tmp_path / "rows", tmp_path / "smoothed"
    rows.tofile(source)
    subprocess.run([os.environ["SMOOTH_ROWS"], "float" if rows.dtype == np.float32 else "double", mode,
                    source, target], check=True, stdout=subprocess.DEVNULL)
    return np.fromfile(target, rows.dtype).reshape(-1, 6)


def make_rows(n, dtype):
    points = sphere(n, dtype=dtype)
    points[::50] = points[1::50]  # duplicates
    i = np.arange(n)
    return np.column_stack([points, -2 * points, 0.005 * (1 + i % 3), i % 2, i % 10 == 0]).astype(dtype)


@pytest.mark.skipif("SMOOTH_ROWS" not in os.environ, reason="the program is in SMOOTH_ROWS when ctest runs this")
@pytest.mark.parametrize("dtype", DTYPES)
def test_every_bit_is_that_of_the_cpp_function(dtype, tmp_path):
    rows = make_rows(8000, dtype)
    points, normals = rows[:, :3], rows[:, 3:6]
    assert np.array_equal(bf.smooth(points), of_cpp("plain", rows, tmp_path)[:, :3])
    with_numbers = bf.smooth(points, None, 30, 0.02, step_length=0.5, update_period=2, number_of_iterations=7,
                             number_of_relaxation_steps=2,
                             sharpness_angle=40, neighbor_radius=0.3)
    assert np.array_equal(with_numbers, of_cpp("numbers", rows, tmp_path)[:, :3])
    with_arrays = bf.smooth(points, normals, noise=rows[:, 6], scans=rows[:, 7].astype(np.uint8),
                            constrained=rows[:, 8] != 0)
    assert np.array_equal(np.hstack(with_arrays), of_cpp("arrays", rows, tmp_path))


@pytest.mark.parametrize("dtype", DTYPES)
def test_neither_order_nor_threads_nor_blocks_matter(dtype):
    points = sphere(6000, dtype=dtype)
    smoothed = bf.smooth(points)
    order = np.random.default_rng(3).permutation(len(points))
    assert np.array_equal(bf.smooth(points[order]), smoothed[order])
    assert np.array_equal(bf.smooth(points, threads=1), smoothed)
    assert np.array_equal(bf.smooth(points, threads=7), smoothed)
    assert np.array_equal(bf.smooth(points, block_size=1000), smoothed)


def test_float32_is_as_accurate_as_its_coordinates():
    points = sphere(5000, dtype=np.float32)
    difference = bf.smooth(points) - bf.smooth(points.astype(np.float64))
    assert np.abs(difference).max() < 1e-6


def test_constrained_points_stay():
    points = sphere(4000)
    constrained = points[:, 2] > 0.5
    smoothed, report = bf.smooth(points, constrained=constrained, return_report=True)
    assert np.array_equal(smoothed[constrained], points[constrained])
    assert report.number_of_constrained_points == constrained.sum()
    assert report.number_of_moved_points > 0


def test_where_noise_is_0_points_stay():
    points = sphere(4000)
    noise = np.where(points[:, 0] > 0, 0.0, 0.01)
    smoothed, report = bf.smooth(points, noise=noise, return_report=True)
    assert np.array_equal(smoothed[noise == 0], points[noise == 0])
    assert report.number_of_points_without_noise == np.sum(noise == 0)
    assert np.array_equal(bf.smooth(points, noise=0), points)


def test_scans_that_overlap_come_together():
    random = np.random.default_rng(8)
    ground = random.uniform(size=(8000, 3)) * [1, 1, 0]
    scans = np.arange(8000) % 2
    ground[:, 2] = 0.02 * scans + 0.001 * random.normal(size=8000)

    def offset(points):
        return points[scans == 1, 2].mean() - points[scans == 0, 2].mean()

    assert offset(bf.smooth(ground, scans=scans)) < 0.5 * offset(bf.smooth(ground))


def test_each_flow_and_estimator():
    points = cube(4000)
    flows = ("balanced", "volume-preserving", "well-posed", "anisotropic", "curvature")
    for curvature in ("learned", "tangent-plane", "covariance"):
        results = {flow: bf.smooth(points, flow=flow, curvature=curvature).tobytes() for flow in flows}
        if curvature != "covariance":  # the others have no prefilter
            assert results.pop("well-posed") == results["anisotropic"]
        assert len(set(results.values())) == len(results)
        assert points.tobytes() not in results.values()
    assert bf.smooth(points, flow="balanced", curvature="learned").tobytes() == bf.smooth(points).tobytes()


@pytest.mark.parametrize("dtype", DTYPES)
def test_the_analysis_is_what_smoothing_uses(dtype):
    points = sphere(5000, dtype=dtype)
    smoothed, report = bf.smooth(points, return_report=True)
    analysis = bf.analyze(points)
    for field in ("number_of_points", "number_of_distinct_points", "noise", "spacing", "fewest_neighbors",
                  "most_neighbors", "number_of_iterations",
                  "number_of_relaxation_steps", "filter_width", "feature_threshold"):
        assert getattr(analysis, field) == getattr(report, field), field
    assert analysis.number_of_moved_points == 0
    assert bf.estimate_noise(points) == report.noise == pytest.approx(0.01, rel=0.2)
    assert bf.analyze(points, k=20).most_neighbors == 20
    assert bf.analyze(points, noise=0.5).noise == 0.5


def test_the_report_counts_the_points():
    points = np.vstack([sphere(4000), [[50.0, 0.0, 0.0]]])
    smoothed, report = bf.smooth(points, return_report=True)
    moved = np.any(smoothed != points, axis=1)
    assert report.number_of_moved_points == moved.sum()
    assert report.moved_share == moved.mean()
    assert report.number_of_isolated_points == 1 and not moved[-1]
    assert report.number_of_points == 4001 == (
        report.number_of_moved_points + report.number_of_constrained_points + report.number_of_isolated_points
        + report.number_of_points_without_noise + report.number_of_points_at_rest)
    assert report.mean_movement == pytest.approx(np.linalg.norm(smoothed - points, axis=1).mean())
    smoothed, normals, same = bf.smooth(points, np.zeros_like(points), return_report=True)
    assert same == report and bf.analyze(points[:0]).moved_share == 0
