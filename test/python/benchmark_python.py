# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares the processor time of the Python module with that of the C++ function, for the same points:

    PYTHONPATH=build/release/examples/python python3 test/python/benchmark_python.py build/release/test/python/smooth_rows

Runs alternate, each in a process of its own, on one processor unless --parallel is given.
"""

import argparse
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy as np


def smooth(path, dtype):
    """What is measured, in a process of its own"""
    import balanced_flow as bf

    points = np.fromfile(path, dtype).reshape(-1, 9)[:, :3].copy()
    start = time.process_time()
    bf.smooth(points)
    print(time.process_time() - start)


def seconds(*command):
    return float(subprocess.run(command, check=True, capture_output=True, text=True).stdout)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("smooth_rows", nargs="?")
    parser.add_argument("--points", type=int, default=1000000)
    parser.add_argument("--runs", type=int, default=9)
    parser.add_argument("--parallel", action="store_true")
    parser.add_argument("--smooth", nargs=2, help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.smooth:
        return smooth(*given.smooth)
    if not given.smooth_rows:
        parser.error("the program smooth_rows is needed")
    if not given.parallel:
        os.sched_setaffinity(0, {min(os.sched_getaffinity(0))})

    from clouds import sphere
    print("| coordinates | C++, seconds | Python, seconds | median of the ratios of pairs, quartiles |\n|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder:
        path = str(pathlib.Path(folder, "rows"))
        for dtype, name in (("float64", "double"), ("float32", "float")):
            rows = np.zeros((given.points, 9), dtype)
            rows[:, :3] = sphere(given.points, 0.002, dtype)
            rows.tofile(path)
            of_cpp, of_python = [], []
            for i in range(given.runs):
                runs = [(of_cpp, [given.smooth_rows, name, "plain", path, os.devnull]),
                        (of_python, [sys.executable, __file__, "--smooth", path, dtype])]
                for times, command in runs[::-1] if i % 2 else runs:
                    times.append(seconds(*command))
            ratios = [python / cpp for python, cpp in zip(of_python, of_cpp)]
            quartiles = statistics.quantiles(ratios, n=4)
            print(f"| {name} | {statistics.median(of_cpp):.2f} | {statistics.median(of_python):.2f} | "
                  f"{quartiles[1]:.3f} ({quartiles[0]:.3f} to {quartiles[2]:.3f}) |", flush=True)


if __name__ == "__main__":
    main()
