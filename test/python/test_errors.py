# SPDX-License-Identifier: GPL-3.0-or-later
"""Bad arguments: the message says which one, what it is and where; no array is written."""

import numpy as np
import pytest

import balanced_flow as bf
from clouds import sphere

N = 500
POINTS = sphere(N)


def with_value(array, place, value):
    array = np.array(array)
    array[place] = value
    return array


BAD_VALUES = [
    (dict(points=POINTS[:, :2]), ["points", "(500, 2)", "(n, 3)"]),
    (dict(points=POINTS.ravel()), ["points", "(1500,)", "(n, 3)"]),
    (dict(points=POINTS.T), ["points", "(3, 500)", "(n, 3)"]),
    (dict(points=POINTS[None]), ["points", "(1, 500, 3)"]),
    (dict(points=[]), ["points", "(0,)"]),
    (dict(points=with_value(POINTS, (17, 1), np.nan)), ["points[17]", "nan", "finite"]),
    (dict(points=with_value(POINTS, (499, 2), -np.inf)), ["points[499]", "inf"]),
    (dict(points=with_value(POINTS, (3, 0), np.nan)[::-1]), ["points[496]"]),
    (dict(normals=POINTS[:-1]), ["normals", "(499, 3)", "(500, 3)"]),
    (dict(normals=POINTS[:, 0]), ["normals", "(500,)", "(n, 3)"]),
    (dict(k=1), ["k is 1"]),
    (dict(k=-5), ["k is -5"]),
    (dict(k=2**70), ["k is 1180591620717411303424"]),
    (dict(noise=-0.5), ["noise is -0.5"]),
    (dict(noise=np.nan), ["noise is nan"]),
    (dict(noise=with_value(np.ones(N), 41, np.inf)), ["noise[41] is inf"]),
    (dict(noise=np.ones(N - 1)), ["noise", "(499,)", "(500,)"]),
    (dict(noise=np.ones((N, 1))), ["noise", "(500, 1)", "(500,)"]),
    (dict(scans=np.zeros(N + 1, int)), ["scans", "(501,)", "(500,)"]),
    (dict(scans=with_value(np.zeros(N, int), 8, -1)), ["scans[8] is -1"]),
    (dict(scans=with_value(np.zeros(N, int), 9, 2**32)), ["scans[9] is 4294967296"]),
    (dict(constrained=np.zeros((N, 3), bool)), ["constrained", "(500, 3)", "(500,)"]),
    (dict(neighbor_radius=-1), ["neighbor_radius is -1"]),
    (dict(number_of_iterations=-1), ["number_of_iterations is -1"]),
    (dict(sharpness_angle=0), ["sharpness_angle is 0", "(0, 180]"]),
    (dict(step_length=np.inf), ["step_length is inf"]),
    (dict(update_period=-2), ["update_period is -2"]),
    (dict(number_of_relaxation_steps=-1), ["number_of_relaxation_steps is -1"]),
    (dict(block_size=0), ["block_size is 0"]),
    (dict(threads=0), ["threads is 0"]),
    (dict(flow="sideways"), ["flow is 'sideways'", "'balanced'"]),
    (dict(curvature="mean"), ["curvature is 'mean'", "'tangent-plane'"]),
]
BAD_TYPES = [
    (dict(points=POINTS.astype(complex)), ["points", "complex128", "float64"]),
    (dict(points=POINTS.astype(str)), ["points", "float64"]),
    (dict(points=POINTS.astype(np.longdouble)), ["points", "longdouble", "float128", "float96"]),
    (dict(points=np.ma.masked_less(POINTS, 0)), ["points", "masked"]),
    (dict(normals=POINTS > 0), ["normals", "bool"]),
    (dict(k=20.0), ["k is 20.0", "whole number"]),
    (dict(noise="0.1"), ["noise is '0.1'", "number"]),
    (dict(noise=POINTS[:, 0] > 0), ["noise", "bool"]),
    (dict(scans=np.zeros(N)), ["scans", "float64", "integers"]),
    (dict(constrained=np.arange(N)), ["constrained", "int64", "bool"]),
    (dict(threads="many"), ["threads is 'many'"]),
    (dict(flow=3), ["flow is 3"]),
    (dict(callback=5), ["callback is 5"]),
    (dict(smoothness=1), ["smoothness"]),
]


def message_of(error, function, arguments):
    with pytest.raises(error) as caught:
        function(**{"points": POINTS, **arguments})
    return str(caught.value)


@pytest.mark.parametrize("function", [bf.smooth, bf.analyze])
@pytest.mark.parametrize("arguments, words", BAD_VALUES)
def test_bad_values(function, arguments, words):
    message = message_of(ValueError, function, arguments)
    assert all(word in message for word in words), message


@pytest.mark.parametrize("function", [bf.smooth, bf.analyze])
@pytest.mark.parametrize("arguments, words", BAD_TYPES)
def test_bad_types(function, arguments, words):
    message = message_of(TypeError, function, arguments)
    assert words[0] in message and any(word in message for word in words[1:] or words), message


def test_bad_places_for_results():
    read_only = np.zeros((N, 3))
    read_only.flags.writeable = False
    for name, extra in (("out", {}), ("out_normals", {"normals": POINTS})):
        for error, bad, words in (
                (ValueError, np.zeros((N, 4)), ["(500, 4)", "(500, 3)"]),
                (ValueError, np.zeros((N, 3), np.float32), ["float32", "float64"]),
                (ValueError, read_only, ["read-only"]),
                (TypeError, POINTS.tolist(), ["list"]),
                (TypeError, np.ma.zeros((N, 3)), ["Masked"])):
            message = message_of(error, bf.smooth, {name: bad, **extra})
            assert name in message and all(word in message for word in words), message
    assert "normals" in message_of(ValueError, bf.smooth, {"out_normals": np.zeros((N, 3))})


@pytest.mark.parametrize("arguments, words", BAD_VALUES)
def test_nothing_is_written_after_an_error(arguments, words):
    arguments = {"points": POINTS, "normals": POINTS, **arguments}
    shape = np.shape(arguments["points"])
    out, out_normals = np.full(shape, 7.0), np.full(shape, 7.0)
    with pytest.raises(ValueError):
        bf.smooth(**arguments, out=out, out_normals=out_normals)
    assert np.all(out == 7) and np.all(out_normals == 7)


def test_a_flow_that_diverges_is_an_error():
    out = np.full((N, 3), 7.0)
    with pytest.raises(ValueError, match="diverges"):
        bf.smooth(POINTS, step_length=1e200, number_of_iterations=9, flow="volume-preserving", out=out)
    assert np.all(out == 7)
