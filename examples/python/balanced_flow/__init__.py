# SPDX-License-Identifier: GPL-3.0-or-later
"""Smoothing of 3D point sets by the dynamic balanced flow, for arrays of NumPy.

>>> import balanced_flow
>>> smoothed = balanced_flow.smooth(points)     # points: an array with the shape (n, 3)

`smooth` denoises points, `estimate_noise` estimates the standard deviation of their noise, and `analyze`
reports what `smooth` would find and use. The result is that of the C++ function
CGAL::balanced_flow_smooth_point_set(), bitwise.
"""

from __future__ import annotations

from . import _core
from ._arguments import core_arguments, new_arrays
from ._report import Report

__all__ = ["Canceled", "Report", "analyze", "estimate_noise", "smooth"]


class Canceled(Exception):
    """The callback returned False. Nothing was written."""


def smooth(points, normals=None, k=None, noise=None, *, scans=None, constrained=None,
           neighbor_radius=0.0, number_of_iterations=None, number_of_relaxation_steps=0,
           sharpness_angle=None, step_length=None, update_period=4, flow="balanced",
           curvature="learned", block_size=4194304, threads=None, callback=None, out=None, out_normals=None, return_report=False):
    """Denoise a point set.

    Parameters
    ----------
    points : array of float64 or float32 with the shape (n, 3)
        The points, with any strides; it may be read-only. All computation is done in double precision.
        Integers are converted to float64.
    normals : array with the shape (n, 3), optional
        Normals. They tell on which side of the surface each point was measured: layers with normals on the
        same side come together, those of a thin wall stay apart. They need not be accurate or of unit
        length; null vectors and NaN say nothing, so zeros serve if only the new normals are wanted.
    k : int, optional
        The number of neighbors of each point, at least 2; by default it suits the noise around each point.
    noise : float or array with the shape (n,), optional
        The standard deviation of the noise along the normals, in the unit of the points, for all points or
        for each; by default it is estimated around each point. Points with noise 0 do not move.
    out : array, optional
        Receives the points, and is returned; it has the shape and the dtype of the result. It may be
        `points` itself, which is then smoothed in place.
    out_normals : array, optional
        Receives the normals, and is returned.
    return_report : bool
        Whether to return a `Report`, too.
    scans : array of integers with the shape (n,), optional
        The number of the scan of each point. Without normals, layers of different scans are registration
        error and come together.
    constrained : array of bool with the shape (n,), optional
        Which points must not move; they still serve as neighbors.
    neighbor_radius : float
        Neighbors of a point are the nearest k within this radius; 0, the default, for no limit.
    number_of_iterations : int, optional
        The number of steps; by default 5, and 12 for the curvature 'covariance'.
    number_of_relaxation_steps : int
        The number of steps that then spread the points evenly along the surface, by default 0; 3 to 5 do
        most of it. Points move by up to a spacing, and what belongs to them, such as colors, with them. They
        move also where there is no noise.
    sharpness_angle : float, optional
        The angle in degrees between two planes from which on their crease is a feature; by default 60, and
        30 for the curvature 'covariance'.
    step_length : float, optional
        The length of a step; by default 0.75.
    update_period : int
        The number of steps after which the reference is replaced by the current points, by default 4; 0
        for never.
    flow : str
        'balanced' (the default), 'volume-preserving', 'well-posed', 'anisotropic' or 'curvature'.
    curvature : str
        The estimator: 'learned' (the default), 'tangent-plane', the same without what is learned, or 'covariance',
        that of the paper.
    block_size : int
        The number of points that are smoothed at a time, by default 4194304. It bounds the memory, and
        does not change the result.
    threads : int, optional
        The largest number of threads; by default that of the processors. It does not change the result.
    callback : callable, optional
        Is called with the progress, from 0.0 to 1.0, by the calling thread, at most about 20 times a
        second. If it returns False or raises an exception, nothing is written.

    Returns
    -------
    points : array
        The smoothed points, in the same order: a new array of the dtype of `points`, or `out`.
    normals : array
        Only if `normals` is given: the unit normals of the smoothed points, oriented as the given ones, of
        the dtype of the points.
    report : Report
        Only if `return_report`: what was found, used and done. Several results are a tuple.

    Raises
    ------
    ValueError
        If an array or a parameter is not as it must be, or the flow diverges; the message says where.
    TypeError
        If an argument has a wrong type.
    Canceled
        If the callback returns False.
    KeyboardInterrupt
        After Ctrl-C.

    Notes
    -----
    The interpreter's lock is released: other threads of Python run meanwhile. They must not write to the
    arrays. After any exception all arrays are as they were.

    Examples
    --------
    >>> smoothed, report = balanced_flow.smooth(points, return_report=True)
    >>> smoothed, normals = balanced_flow.smooth(points, normals)
    >>> balanced_flow.smooth(points, noise=0.002, out=points)       # in place
    """
    arguments = core_arguments(
        points, normals, k, noise, scans, constrained, neighbor_radius, number_of_iterations,
        number_of_relaxation_steps, sharpness_angle, step_length, update_period, flow, curvature, block_size,
        threads, callback)
    results = new_arrays(arguments, out, out_normals)
    report = _run(_core.smooth, arguments)
    if return_report:
        results.append(report)
    return results[0] if len(results) == 1 else tuple(results)


def analyze(points, normals=None, k=None, noise=None, *, scans=None, constrained=None,
            neighbor_radius=0.0, number_of_iterations=None, number_of_relaxation_steps=0,
            sharpness_angle=None, step_length=None, update_period=4, flow="balanced",
            curvature="learned", block_size=4194304, threads=None, callback=None):
    """Report what `smooth` would find and use, without moving any point.

    Parameters
    ----------
    points, normals, k, noise, and so on
        Those of `smooth`, except the arrays for the results.

    Returns
    -------
    Report
        Noise, spacing, numbers of neighbors and parameters. The movements, and the numbers of points that
        moved or did not, are 0.
    """
    return _run(_core.analyze, core_arguments(
        points, normals, k, noise, scans, constrained, neighbor_radius, number_of_iterations,
        number_of_relaxation_steps, sharpness_angle, step_length, update_period, flow, curvature, block_size,
        threads, callback))


def estimate_noise(points, *, threads=None):
    """Estimate the standard deviation of the noise of a point set.

    The noise is the deviation of the points from the surface that they were measured on. It is estimated
    around one point of about 18, and the median is returned. `smooth` uses the estimates around each point.

    Parameters
    ----------
    points : array of float64 or float32 with the shape (n, 3)
        The points, as for `smooth`.
    threads : int, optional
        The largest number of threads.

    Returns
    -------
    float
        The standard deviation in the unit of the points; 0.0 if there are fewer than 13 distinct points.
    """
    return analyze(points, threads=threads).noise


def _run(function, arguments):
    fields = function(arguments, arguments["points"].dtype == "float32")
    if fields is None:
        raise Canceled("canceled by the callback")
    return Report(**fields)
