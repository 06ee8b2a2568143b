#!/usr/bin/python3
"""What calling the friction model from Python costs, beside the same solves in C++.

    ./run python bench/python/tensions.py

Builds its half in C++ (solves.cpp) beside the module, and prints for some routings, on one core
and in time of the processor: one call of Routing.tensions and what it takes above one solve in
C++; one solve in a table of reeve.tensions with two coefficients that vary, the same in a loop in
C++, and the rate of the table as a share of the loop's. Both have to find the same tensions.
"""

import math
import subprocess
import sys
import tempfile
import time
import timeit
from pathlib import Path

import numpy as np
import reeve

SAMPLES = 200_000
WORDS = ["M-1-T-2-F", "1-P-2-P-1", "1-P-2-P-3-P-4-P-5-P-1", "M-1-T-2-F+M-3b-P-4-F+M-5-M",
         "M-Y1+1x-Y1-2x"]


def best(work, number):
    return min(timeit.repeat(work, timer=time.process_time, number=number, repeat=5)) / number


def in_cpp(mu):
    """Of each routing: seconds of a single solve, seconds of one in the loop, sum of tensions."""
    build = Path(reeve.__file__).parents[2]
    subprocess.run(["cmake", "--build", build, "--target", "reeve_solves"], check=True,
                   stdout=subprocess.DEVNULL)
    with tempfile.NamedTemporaryFile() as samples:
        mu.tofile(samples)
        samples.flush()
        command = [build / "bin/reeve_solves", samples.name, *WORDS]
        lines = subprocess.run(command, check=True, capture_output=True, text=True).stdout
    return {word: tuple(map(float, rest)) for word, *rest in map(str.split, lines.splitlines())}


def in_python(word, mu):
    hardware = reeve.Hardware()
    routing = reeve.Routing(word)

    def table():
        return reeve.tensions(routing, hardware, held=[1], tube_mu=mu, sheath_mu=mu, threads=1,
                              named=False)

    call = best(lambda: routing.tensions(hardware, held=[1]), 20_000)
    return call, best(table, 1) / SAMPLES, table().sum()


def main():
    mu = np.random.default_rng(1).uniform(0.05, 0.2, SAMPLES)
    cpp = in_cpp(mu)
    print(f"{'routing':30} {'call, us':>9} {'above C++':>9} {'in a table, us':>14} "
          f"{'in C++, us':>10} {'solves/s':>9} {'of C++':>6}")
    for word in WORDS:
        single, looped, expected = cpp[word]
        call, solve, found = in_python(word, mu)
        if not math.isclose(found, expected, rel_tol=1e-12):
            sys.exit(f"{word}: sums of tensions differ, {found} in Python and {expected} in C++")
        print(f"{word:30} {call * 1e6:9.2f} {(call - single) * 1e6:9.2f} {solve * 1e6:14.3f} "
              f"{looped * 1e6:10.3f} {1 / solve:9.0f} {looped / solve:6.0%}")


if __name__ == "__main__":
    main()
