#!/usr/bin/python3
"""Bends of a glove's sheaths chosen with SciPy, and what scatter of friction does to them.

    ./run python examples/codesign.py

It needs SciPy (Debian: python3-scipy). The sum of bends of each sheath of TR5 is chosen so that,
with finger 1 held, uniformity times efficiency is greatest; then the friction coefficients are
drawn ten thousand times. All numbers are computed, none is measured.
"""

import numpy as np
import reeve
from scipy.optimize import minimize_scalar

TR5 = reeve.Routing("TR5")


def unevenness(angle_rad: float) -> float:
    """How far the strands are from being pulled alike, with sheaths of these bends."""
    hardware = reeve.Hardware(sheath_angle_rad=angle_rad, tube_mu=0.066, sheath_mu=0.039)
    state = TR5.tensions(hardware, held=[1])
    return 1 - state.uniformity * state.efficiency


def monte_carlo(angle_rad: float, draws: int = 10_000) -> np.ndarray:
    """Least over greatest strand tension, for friction coefficients drawn at random."""
    random = np.random.default_rng(1)
    table = reeve.tensions(
        TR5,
        reeve.Hardware(sheath_angle_rad=angle_rad),
        held=[1],
        tube_mu=random.uniform(0.05, 0.2, draws),
        sheath_mu=random.uniform(0.05, 0.2, draws),
        named=False,
    )
    # The strands come first, T1 to T4.
    strands = table[:, :4]
    return strands.min(axis=1) / strands.max(axis=1)


def main() -> None:
    found = minimize_scalar(unevenness, bounds=(3, 9), method="bounded")
    low, median, high = np.quantile(monte_carlo(found.x), [0.05, 0.5, 0.95])
    print(f"bends {found.x:.2f} rad: uniformity x efficiency {1 - found.fun:.3f}")
    print(f"uniformity over the coefficients: {median:.3f} ({low:.3f} to {high:.3f})")


if __name__ == "__main__":
    main()
