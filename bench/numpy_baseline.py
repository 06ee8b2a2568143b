#!/usr/bin/python3
"""The evaluation of designs as an engineer would script it with NumPy and SciPy.

For every tendon, grasp and direction it solves the convex problem of the tension model,

    minimise   sum_i [ L_i exp(u_i) - (E_i + e_i / eps) u_i ]
    subject to |u_l - u_r| <= phi  at each contact

(u = ln T, L lengths, e what carriage and fingers impose, eps E what stretches the tendon), over
the differences of neighbouring u with scipy's SLSQP. The common offset of u follows in closed
form: sum L T = sum E. No sliding direction goes in. The paper's friction, all lengths equal,
fingers share the travel equally, the single grasps (none held, and each one finger held).

    numpy_baseline.py check <reeve>                 largest difference to `reeve show`, TR1 ... TR7
    numpy_baseline.py rate <designs.csv> <count>    designs per second on an even sample of the
                                                    file, and the largest difference to it
"""

import csv
import json
import math
import subprocess
import sys
import time
import warnings

import numpy as np
from scipy.optimize import minimize

PHI = {"tube": 0.18 * math.pi, "bearing": 0.001 * math.pi, "sheath": 0.18 * 2 * math.pi}
# A sliding contact slips by far more than this part of the travel, so the limit is reached already;
# a smaller one only makes the problem stiffer and SLSQP less exact.
EPS = 0.02

STRAND, MOTOR, HAND = 0, 1, 2


class Tendon:
    """kind, finger, name of each segment; phi of each contact; contact k joins k and k + 1."""

    def __init__(self):
        self.kind, self.finger, self.name, self.phi = [], [], [], []
        self.closed = False
        self.sheaths = 0

    def segment(self, kind, finger, name):
        self.kind.append(kind)
        self.finger.append(finger)
        self.name.append(name)

    def finish(self):
        self.kind = np.array(self.kind)
        self.finger = np.array(self.finger)
        self.phi = np.array(self.phi)
        return self


def finger_of(token):
    return int(token.rstrip("b")) if token[0].isdigit() else 0


def letters(number):
    text = ""
    while number > 0:
        number, rest = divmod(number - 1, 26)
        text = chr(ord("a") + rest) + text
    return text


def parse(word):
    """A routing word as a list of tendons."""
    tendons, motor_sides, hand_segments = [], 0, 0
    for text in word.split("+"):
        tendon, walk = Tendon(), text.split("-")
        tendon.closed = walk[0][0].isdigit()
        if tendon.closed:
            walk = walk[:-1]
        n = len(walk)
        for i in range(n + 1 if tendon.closed else n):
            token = walk[i % n]
            if i > 0 or not tendon.closed:  # contacts of this token
                if token == "M":
                    motor_sides += 1
                    name = letters(motor_sides)
                    if i == 0:
                        tendon.segment(MOTOR, 0, name)
                    tendon.phi.append(PHI["sheath"])
                    if i > 0:
                        tendon.segment(MOTOR, 0, name)
                elif token == "P":
                    tendon.phi.append(PHI["sheath"])
                    tendon.segment(MOTOR, 0, letters(motor_sides + 1))
                    tendon.phi.append(PHI["bearing"])
                    tendon.segment(MOTOR, 0, letters(motor_sides + 2))
                    tendon.phi.append(PHI["sheath"])
                    motor_sides += 2
                elif token in ("T", "B"):
                    tendon.phi.append(PHI["tube" if token == "T" else "bearing"])
                elif token != "F":
                    tendon.phi.append(PHI["bearing" if token.endswith("b") else "tube"])
            if i == n or (not tendon.closed and i + 1 == n):
                continue
            left, right = finger_of(token), finger_of(walk[(i + 1) % n])  # the gap behind it
            if left:
                tendon.segment(STRAND, left, f"T{2 * left}")
            elif right:
                tendon.segment(STRAND, right, f"T{2 * right - 1}")
            else:
                hand_segments += 1
                tendon.segment(HAND, 0, f"h{hand_segments}")
        tendons.append(tendon.finish())
    return tendons


def impose(tendon, held, pull):
    """e and E of the segments, dl of each, and whether the tendon jams."""
    motor = tendon.kind == MOTOR
    closing = (tendon.kind == STRAND) & (tendon.finger != held)
    dl = np.zeros(len(motor))
    if not closing.any():
        return np.zeros(len(motor)), (motor == pull).astype(float), dl, True
    dl[closing] = motor.sum() / closing.sum()
    sign = 1.0 if pull else -1.0
    return sign * (motor - dl), dl if pull else motor.astype(float), dl, False


def relative_tensions(tendon, imposed, take_up):
    """Tensions up to the scale that all tendons of a routing share."""
    segments = len(imposed)
    weights = take_up + imposed / EPS
    bound = tendon.phi[: segments - 1]
    total = take_up.sum()

    def cost(d):
        w = np.concatenate(([0.0], np.cumsum(d)))
        t = np.exp(w)
        gradient = total * t / t.sum() - weights
        # dw_i / dd_k = 1 for i > k
        return total * math.log(t.sum()) - weights @ w, np.cumsum(gradient[::-1])[-2::-1]

    constraints = ()
    if tendon.closed:
        ones, last = np.ones(segments - 1), tendon.phi[-1]
        constraints = (
            {"type": "ineq", "fun": lambda d: last - d.sum(), "jac": lambda d: -ones},
            {"type": "ineq", "fun": lambda d: last + d.sum(), "jac": lambda d: ones},
        )
    found = minimize(
        cost,
        np.zeros(segments - 1),
        jac=True,
        method="SLSQP",
        bounds=np.stack((-bound, bound), axis=1),
        constraints=constraints,
        options={"ftol": 1e-11, "maxiter": 500},
    )
    t = np.exp(np.concatenate(([0.0], np.cumsum(found.x))))
    return t * total / t.sum()


def solve(tendons, held, pull):
    """Tensions at motor tension 1 and dl of every tendon's segments, and whether it jams."""
    imposed = [impose(tendon, held, pull) for tendon in tendons]
    jams = any(jam for _, _, _, jam in imposed)
    tensions, closings, motor = [], [], 0.0
    for tendon, (e, take_up, dl, jam) in zip(tendons, imposed):
        t = np.zeros(len(e)) if jams and not jam else relative_tensions(tendon, e, take_up)
        motor += t[tendon.kind == MOTOR].sum()
        tensions.append(t)
        closings.append(np.zeros(len(e)) if jams else dl)
    return [t / motor for t in tensions], closings, jams


def performance(tendons, held, pull):
    tensions, closings, jams = solve(tendons, held, pull)
    t = np.concatenate(tensions)
    dl = np.concatenate(closings)
    strand = np.concatenate([tendon.kind for tendon in tendons]) == STRAND
    work = (t * dl)[strand].sum()
    efficiency = work if pull or work == 0 else 1 / work
    return t[strand].min() / t[strand].max(), efficiency, t[strand].sum(), jams


def evaluate(word):
    """The objectives of a design, by the names of designs.csv."""
    tendons = parse(word)
    fingers = max(int(tendon.finger.max()) for tendon in tendons)
    pulls, returns = [], []
    for held in range(fingers + 1):  # 0: none is held
        pull = performance(tendons, held, True)
        release = performance(tendons, held, False)
        pulls.append(pull)
        returns.append(pull[1] * release[1])
    uniformity, efficiency, force, jams = (np.array(column) for column in zip(*pulls))
    return {
        "uniformity_mean": uniformity.mean(),
        "uniformity_worst": uniformity.min(),
        "efficiency_mean": efficiency.mean(),
        "efficiency_worst": efficiency.min(),
        "force_transmission": force.mean(),
        "jams": float(jams.sum()),
        "round_trip_efficiency": float(np.mean(returns)),
    }


def check(reeve):
    """Largest difference of any tension to `reeve show`, TR1 ... TR7, pulling and releasing."""
    worst = 0.0
    for number in range(1, 8):
        for direction in ("pull", "release"):
            command = [reeve, "show", f"TR{number}", "--format", "json", "--direction", direction]
            shown = json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)
            tendons = parse(shown["routing"])
            for grasp in shown["grasps"]:
                held = grasp["held"][0] if grasp["held"] else 0
                tensions, _, _ = solve(tendons, held, direction == "pull")
                for tendon, t in zip(tendons, tensions):
                    for name, value in zip(tendon.name, t):
                        worst = max(worst, abs(value - grasp["tensions"][name]))
    return worst


def read_sample(path, count):
    with open(path, newline="", encoding="utf-8") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return [rows[i * len(rows) // count] for i in range(min(count, len(rows)))]


def rate(path, count):
    """Designs per second, and the largest difference to the objectives in the file."""
    sample = read_sample(path, count)
    evaluate(sample[0]["routing"])  # warm up
    start = time.perf_counter()
    values = [evaluate(row["routing"]) for row in sample]
    seconds = time.perf_counter() - start
    worst = max(
        abs(value - float(row[name]))
        for row, design in zip(sample, values)
        for name, value in design.items()
    )
    return len(sample) / seconds, worst


def main():
    # SLSQP steps a rounding error out of its own bounds and is put back.
    warnings.filterwarnings("ignore", "Values in x were outside bounds")
    if sys.argv[1:2] == ["check"] and len(sys.argv) == 3:
        print(f"{check(sys.argv[2]):.1e}")
    elif sys.argv[1:2] == ["rate"] and len(sys.argv) == 4 and sys.argv[3].isdecimal():
        print("{:.6g} {:.1e}".format(*rate(sys.argv[2], int(sys.argv[3]))))
    else:
        sys.exit(__doc__)


if __name__ == "__main__":
    main()
