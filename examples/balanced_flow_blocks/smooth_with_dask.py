#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Smooths the blocks of a planned directory on a Dask cluster, and joins them.

    balanced-flow-blocks plan DIR tiles/
    smooth_with_dask.py DIR                              # a local cluster
    smooth_with_dask.py DIR --scheduler tcp://host:8786  # one that runs

All workers see DIR under the same path, and have the program. No point travels through Python: a task is one
command, and its result a file. A task whose worker is lost is done by another worker.
"""
import argparse
import json
import subprocess
import sys
import time

from distributed import Client, LocalCluster, as_completed


def smooth(program, threads, directory, block):
    """Smooths one block; runs on a worker. What is done is not done again."""
    done = subprocess.run([program, "smooth", directory, str(block), "--quiet", "--threads", str(threads)],
                          stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode != 0:
        message = done.stdout.decode(errors="replace").strip()
        raise RuntimeError(f"block {block}: {message or f'exit status {done.returncode}'}")
    return block


def arguments():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("directory", metavar="DIR", help="a directory that was planned")
    parser.add_argument("--scheduler", metavar="ADDRESS", help="of a cluster that runs; else one is started here")
    parser.add_argument("--scheduler-file", metavar="FILE", help="which tells this address")
    parser.add_argument("--workers", metavar="N", type=int, default=2, help="of the cluster that is started, 2")
    parser.add_argument("--threads", metavar="N", type=int, default=1, help="of each block, 1")
    parser.add_argument("--retries", metavar="N", type=int, default=3, help="of blocks that fail, 3")
    parser.add_argument("--program", metavar="PATH", default="balanced-flow-blocks", help="on the workers")
    parser.add_argument("--no-join", action="store_true", help="leave the last step to the caller")
    return parser.parse_args()


def connect(options):
    if options.scheduler_file:
        return Client(scheduler_file=options.scheduler_file)
    if options.scheduler:
        return Client(options.scheduler)
    return Client(LocalCluster(n_workers=options.workers, threads_per_worker=1, processes=True,
                               dashboard_address=None))


def smooth_all(client, options, count):
    """Submits all blocks, and shows how far they are.

    Returns the messages of those that failed."""
    futures = client.map(smooth, [options.program] * count, [options.threads] * count,
                         [options.directory] * count, range(count), pure=False, retries=options.retries)
    start, failures = time.monotonic(), []
    for done, future in enumerate(as_completed(futures), 1):
        if future.status == "error":
            failures.append(str(future.exception()))
        seconds = time.monotonic() - start
        left = seconds / done * (count - done)
        print(f"\r{done} of {count} blocks, {seconds:.0f} s, about {left:.0f} s left ", end="",
              file=sys.stderr, flush=True)
    print(file=sys.stderr)
    return failures


def main():
    options = arguments()
    status = subprocess.run([options.program, "status", options.directory, "--json"], stdout=subprocess.PIPE)
    if status.returncode != 0:
        return status.returncode
    with connect(options) as client:
        failures = smooth_all(client, options, json.loads(status.stdout)["blocks"])
    for failure in failures:
        print(failure, file=sys.stderr)
    if failures:
        return 2
    return 0 if options.no_join else subprocess.run([options.program, "join", options.directory]).returncode


if __name__ == "__main__":
    sys.exit(main())
