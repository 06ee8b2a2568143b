#!/usr/bin/python3
"""What calling the friction model from Python costs.

    ./run python bench/python/tensions.py     one core, Python against the same loop in C++

Prints, for some routings and in time of the processor: one call of Routing.tensions, one solve in a table of
reeve.tensions with two coefficients that vary, and how many solves a second that is. The rate of
C++ alone is bench/tension_bench.cpp's (preset bench).
"""

import time
import timeit

import numpy as np
import reeve

SAMPLES = 200_000
WORDS = ["TR1", "TR7", "1-P-2-P-3-P-4-P-5-P-1", "M-1-T-2-F+M-3b-P-4-F+M-5-M", "M-Y1+1x-Y1-2x"]


def best(work, number):
    return min(timeit.repeat(work, timer=time.process_time, number=number, repeat=5)) / number


def main():
    hardware = reeve.Hardware()
    mu = np.random.default_rng(1).uniform(0.05, 0.2, SAMPLES)
    print(f"{'routing':30} {'call, us':>9} {'in a table, us':>15} {'solves/s':>10}")
    for word in WORDS:
        routing = reeve.Routing(word)
        call = best(lambda: routing.tensions(hardware, held=[1]), 20_000)
        table = best(
            lambda: reeve.tensions(
                routing, hardware, held=[1], tube_mu=mu, sheath_mu=mu, threads=1, named=False
            ),
            1,
        )
        rate = SAMPLES / table
        print(f"{word:30} {call * 1e6:9.2f} {table / SAMPLES * 1e6:15.3f} {rate:10.0f}")


if __name__ == "__main__":
    main()
