# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks and converts the arguments of the functions for the compiled part. What a value must be, other than
its type and the shape of an array, is checked by the library."""

from __future__ import annotations

import operator

import numpy as np


def core_arguments(points, normals, k, noise, scans, constrained, neighbor_radius, number_of_iterations,
                   number_of_relaxation_steps, sharpness_angle, step_length, update_period, flow, curvature,
                   block_size, threads, callback):
    """All arguments of the compiled part, without places for results."""
    points = _rows("points", points)
    n = len(points)
    noise, noise_of_each = _noise(noise, n)
    if callback is not None and not callable(callback):
        raise TypeError(f"callback is {callback!r}, but must be callable")
    return {
        "points": points,
        "normals": None if normals is None else _normals(normals, points),
        "out": None,
        "out_normals": None,
        "k": None if k is None else _whole_number("k", k, 2),
        "noise": noise,
        "noise_of_each": noise_of_each,
        "scans": None if scans is None else _scans(scans, n),
        "constrained": None if constrained is None else _constrained(constrained, n),
        "neighbor_radius": _number("neighbor_radius", neighbor_radius),
        "number_of_iterations": _optional(_whole_number, "number_of_iterations", number_of_iterations),
        "number_of_relaxation_steps": _whole_number("number_of_relaxation_steps", number_of_relaxation_steps),
        "sharpness_angle": _optional(_number, "sharpness_angle", sharpness_angle),
        "step_length": _optional(_number, "step_length", step_length),
        "update_period": _whole_number("update_period", update_period),
        "flow": _name("flow", flow),
        "curvature": _name("curvature", curvature),
        "block_size": _whole_number("block_size", block_size),
        "threads": 0 if threads is None else _whole_number("threads", threads, 1),
        "callback": callback,
    }


def new_arrays(arguments, out, out_normals):
    """Adds the places for the results to the arguments, and returns them as a list."""
    if out_normals is not None and arguments["normals"] is None:
        raise ValueError("out_normals is given, but normals is not")
    results = []
    for name, array, like in (("out", out, arguments["points"]),
                              ("out_normals", out_normals, arguments["normals"])):
        if like is not None:
            arguments[name] = np.empty_like(like, subok=False) if array is None else _out(name, array, like)
            results.append(arguments[name])
    return results


def _optional(convert, name, value):
    return None if value is None else convert(name, value)


def _array(name, value):
    if isinstance(value, np.ma.MaskedArray):
        raise TypeError(f"{name} is a masked array: pass the valid elements as an array")
    return np.asarray(value)


def _rows(name, value):
    """An array of native float64 or float32 with the shape (n, 3)."""
    array = _array(name, value)
    dtype = array.dtype
    if dtype.kind in "iu":
        dtype = np.dtype(np.float64)
    elif dtype.kind == "f" and dtype.itemsize <= 8:
        dtype = np.dtype(np.float64 if dtype.itemsize == 8 else np.float32)
    else:
        raise TypeError(f"{name} has the dtype {dtype}, but must have float64 or float32")
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name} has the shape {array.shape}, but must have the shape (n, 3)")
    return array.astype(dtype, copy=False)


def _normals(value, points):
    normals = _rows("normals", value).astype(points.dtype, copy=False)
    if len(normals) != len(points):
        raise ValueError(f"normals has the shape {normals.shape}, but must have that of points, "
                         f"{points.shape}")
    return normals


def _out(name, array, like):
    if not isinstance(array, np.ndarray) or isinstance(array, np.ma.MaskedArray):
        raise TypeError(f"{name} is of the type {type(array).__name__}, but must be an array")
    if array.shape != like.shape:
        raise ValueError(f"{name} has the shape {array.shape}, but must have {like.shape}")
    if array.dtype != like.dtype:
        raise ValueError(f"{name} has the dtype {array.dtype}, but must have {like.dtype}")
    if not array.flags.writeable:
        raise ValueError(f"{name} is read-only")
    return array


def _of_each(name, array, n):
    if array.shape != (n,):
        raise ValueError(f"{name} has the shape {array.shape}, but must have the shape ({n},), one for "
                         "each point")
    return array


def _noise(value, n):
    """The noise of all points, or an array with that of each, and None for the other."""
    if value is None or np.ndim(value) == 0:
        return _optional(_number, "noise", value), None
    array = _of_each("noise", _array("noise", value), n)
    if array.dtype.kind not in "fiu":
        raise TypeError(f"noise has the dtype {array.dtype}, but must be numbers")
    return None, np.ascontiguousarray(array, np.float64)


def _scans(value, n):
    array = _of_each("scans", _array("scans", value), n)
    if array.dtype.kind not in "iu" and n != 0:
        raise TypeError(f"scans has the dtype {array.dtype}, but must be integers")
    bad = np.flatnonzero((array < 0) | (array > 0xFFFFFFFF))
    if len(bad) != 0:
        raise ValueError(f"scans[{bad[0]}] is {array[bad[0]]}, but must be from 0 to 2**32 - 1")
    return np.ascontiguousarray(array, np.uint32)


def _constrained(value, n):
    array = _of_each("constrained", _array("constrained", value), n)
    if array.dtype.kind != "b" and n != 0:
        raise TypeError(f"constrained has the dtype {array.dtype}, but must be bool")
    return np.ascontiguousarray(array, bool)


def _number(name, value):
    try:
        if not isinstance(value, (str, bytes)):
            return float(value)
    except TypeError:
        pass
    raise TypeError(f"{name} is {value!r}, but must be a number")


def _whole_number(name, value, least=0):
    try:
        number = operator.index(value)
    except TypeError:
        raise TypeError(f"{name} is {value!r}, but must be a whole number") from None
    if not least <= number < 2**31:
        raise ValueError(f"{name} is {number}, but must be from {least} to {2**31 - 1}")
    return number


def _name(name, value):
    if not isinstance(value, str):
        raise TypeError(f"{name} is {value!r}, but must be a string")
    return value
