# SPDX-License-Identifier: GPL-3.0-or-later
"""Callbacks, Ctrl-C, and other threads of Python meanwhile."""

import _thread
import threading
import time

import numpy as np
import pytest

import balanced_flow as bf
from clouds import sphere


class Own_error(Exception):
    pass


def test_the_callback_is_told_the_progress():
    shares = []
    points = sphere(60000)
    smoothed = bf.smooth(points, callback=shares.append, threads=1)  # append returns None
    assert shares[0] == 0 and shares[-1] == 1 and shares == sorted(shares)
    assert np.array_equal(smoothed, bf.smooth(points))
    shares.clear()
    bf.analyze(points, callback=shares.append)
    assert shares[0] == 0 and shares[-1] == 1


def test_the_callback_is_called_by_the_calling_thread():
    threads = set()
    bf.smooth(sphere(20000), callback=lambda share: threads.add(threading.get_ident()))
    assert threads == {threading.get_ident()}


def stop(share, at, error):
    if share >= at:
        if error:
            raise error
        return False
    return True


@pytest.mark.parametrize("threads", [1, None])
@pytest.mark.parametrize("at", [0.0, 0.3, 1.0])
@pytest.mark.parametrize("error", [None, Own_error("own"), KeyboardInterrupt()])
def test_a_canceled_run_writes_nothing(threads, at, error):
    points = sphere(20000)
    normals = points.copy()
    before = points.copy()
    with pytest.raises(type(error) if error else bf.Canceled) as caught:
        bf.smooth(points, normals, out=points, out_normals=normals, threads=threads,
                  callback=lambda share: stop(share, at, error))
    assert error is None or caught.value is error
    assert np.array_equal(points, before) and np.array_equal(normals, before)
    with pytest.raises(type(error) if error else bf.Canceled):
        bf.analyze(points, threads=threads, callback=lambda share: stop(share, at, error))


def test_what_the_callback_returns_counts_as_true_or_false():
    points = sphere(500)
    for value in (None, True, 1, np.True_, "yes"):
        bf.smooth(points, callback=lambda share: value)
    for value in (False, 0, np.False_):
        with pytest.raises(bf.Canceled):
            bf.smooth(points, callback=lambda share: value)
    with pytest.raises(ValueError, match="ambiguous"):
        bf.smooth(points, callback=lambda share: np.zeros(2))


def test_a_callback_can_smooth():
    points = sphere(2000)
    expected = bf.smooth(points)
    inner = []
    outer = bf.smooth(points, callback=lambda share: inner.append(bf.smooth(points)))
    assert np.array_equal(outer, expected)
    assert inner and all(np.array_equal(smoothed, expected) for smoothed in inner)


@pytest.mark.parametrize("function", ["smooth", "estimate_noise"])
def test_ctrl_c_interrupts_and_leaves_the_arrays(function):
    points = sphere(400000)
    before = points.copy()

    def press_ctrl_c():
        time.sleep(0.1)
        _thread.interrupt_main()  # what the handler of Ctrl-C does

    thread = threading.Thread(target=press_ctrl_c)
    thread.start()
    has_ended = False
    with pytest.raises(KeyboardInterrupt):
        if function == "smooth":
            bf.smooth(points, out=points, threads=1)
        else:
            bf.estimate_noise(points, threads=1)
        has_ended = True
        time.sleep(60)  # would be interrupted, too
    thread.join()
    assert not has_ended
    assert np.array_equal(points, before)


def test_other_threads_run_meanwhile():
    points = sphere(60000)
    count = 0
    goes_on = True

    def work():
        nonlocal count
        while goes_on:
            count += 1
            time.sleep(1e-4)

    thread = threading.Thread(target=work)
    thread.start()
    counts = []
    try:
        for _ in range(5):
            start = count
            bf.smooth(points, threads=1)
            counts.append(count - start)
    finally:
        goes_on = False
        thread.join()
    assert min(counts) >= 5  # with the lock held it is 0 or 1, when the call begins or ends


def test_calls_of_several_threads_do_not_disturb_each_other():
    clouds = [sphere(3000 + 500 * i) for i in range(4)]
    expected = [bf.smooth(points) for points in clouds]
    results = [None] * len(clouds)

    def run(i):
        results[i] = bf.smooth(clouds[i])

    threads = [threading.Thread(target=run, args=(i,)) for i in range(len(clouds))]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert all(np.array_equal(result, wanted) for result, wanted in zip(results, expected))
