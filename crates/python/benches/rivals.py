"""Times an ensemble of U-tubes by Meniscus, by numba and by SciPy in one run, and prints the ratios.

The runs are those of simulations/utube.md, m y'' + b y' + 2 rho S g y = 0, with another b for each run; the level at the end is kept.
Meniscus and numba make the same steps of Runge and Kutta; SciPy chooses its steps, as Meniscus
does with the method of the document.
"""

import math
import time
from pathlib import Path

import numba
import numpy
import scipy.integrate

import meniscus

RUNS = 4096
STEPS = 2000
STEP = 0.05
LANES = 64
DENSITY, SECTION, GRAVITY, LENGTH, LEVEL = 1000.0, 0.05, 9.8, 7.0, 0.5
STIFFNESS = 2.0 * GRAVITY / LENGTH
MASS = DENSITY * SECTION * LENGTH


@numba.njit(parallel=True)
def one_by_one(damping):
    """Levels at the end: the runs are distributed over the processors, each run is a loop of its own."""
    ends = numpy.empty_like(damping)
    for run in numba.prange(damping.size):
        friction = damping[run] / MASS
        y, v = LEVEL, 0.0
        for _ in range(STEPS):
            v_1, a_1 = v, -friction * v - STIFFNESS * y
            v_2 = v + 0.5 * STEP * a_1
            a_2 = -friction * v_2 - STIFFNESS * (y + 0.5 * STEP * v_1)
            v_3 = v + 0.5 * STEP * a_2
            a_3 = -friction * v_3 - STIFFNESS * (y + 0.5 * STEP * v_2)
            v_4 = v + STEP * a_3
            a_4 = -friction * v_4 - STIFFNESS * (y + STEP * v_3)
            y += STEP / 6.0 * (v_1 + 2.0 * v_2 + 2.0 * v_3 + v_4)
            v += STEP / 6.0 * (a_1 + 2.0 * a_2 + 2.0 * a_3 + a_4)
        ends[run] = y
    return ends


@numba.njit(parallel=True)
def in_blocks(damping):
    """Levels at the end: each step is made for 64 runs side by side, so that the compiler uses vectors."""
    ends = numpy.empty_like(damping)
    for block in numba.prange(damping.size // LANES):
        friction = damping[block * LANES : (block + 1) * LANES] / MASS
        y, v = numpy.full(LANES, LEVEL), numpy.zeros(LANES)
        for _ in range(STEPS):
            for lane in range(LANES):
                v_1, a_1 = v[lane], -friction[lane] * v[lane] - STIFFNESS * y[lane]
                v_2 = v[lane] + 0.5 * STEP * a_1
                a_2 = -friction[lane] * v_2 - STIFFNESS * (y[lane] + 0.5 * STEP * v_1)
                v_3 = v[lane] + 0.5 * STEP * a_2
                a_3 = -friction[lane] * v_3 - STIFFNESS * (y[lane] + 0.5 * STEP * v_2)
                v_4 = v[lane] + STEP * a_3
                a_4 = -friction[lane] * v_4 - STIFFNESS * (y[lane] + STEP * v_3)
                y[lane] += STEP / 6.0 * (v_1 + 2.0 * v_2 + 2.0 * v_3 + v_4)
                v[lane] += STEP / 6.0 * (a_1 + 2.0 * a_2 + 2.0 * a_3 + a_4)
        ends[block * LANES : (block + 1) * LANES] = y
    return ends


def by_scipy(damping):
    """Levels at the end, by solve_ivp."""

    def rates(_, state, friction):
        return [state[1], -friction * state[1] - STIFFNESS * state[0]]

    def end(friction):
        solution = scipy.integrate.solve_ivp(rates, (0.0, STEPS * STEP), [LEVEL, 0.0], "RK45", args=(friction,), rtol=1e-6, atol=1e-6)
        return solution.y[0, -1]

    return numpy.array([end(friction) for friction in damping / MASS])


def shortest(work, times=5):
    """Result, and shortest time in s of several repetitions."""
    work()
    best = math.inf
    for _ in range(times):
        start = time.perf_counter()
        result = work()
        best = min(best, time.perf_counter() - start)
    return result, best


def main():
    document = meniscus.open(Path(__file__).parents[3] / "simulations" / "utube.md")
    damping = numpy.linspace(0.0, 400.0, RUNS)
    fixed = {"method": "rk4", "step": STEP, "until": STEPS * STEP}
    few = damping[:: RUNS // 16]
    ends, ours = shortest(lambda: document.sweep({"b": damping}, "y at end", **fixed)["y at end"])
    chosen, adaptive = shortest(lambda: document.sweep({"b": damping}, "y at end", until=STEPS * STEP)["y at end"])
    plain, alone = shortest(lambda: one_by_one(damping))
    vectors, blocked = shortest(lambda: in_blocks(damping))
    known, scipys = shortest(lambda: by_scipy(few), 1)
    for other in [plain, vectors]:
        assert numpy.abs(other - ends).max() < 1e-9 * LEVEL, "the runs are not the same"
    assert numpy.abs(known - chosen[:: RUNS // 16]).max() < 1e-4 * LEVEL, "the runs are not the same"
    print(f"{RUNS} U-tubes of {STEPS} steps of Runge and Kutta on {numba.get_num_threads()} threads")
    rows = [
        ("meniscus, sweep", ours, ours),
        ("numba, parallel", alone, ours),
        ("numba, parallel and in blocks of 64", blocked, ours),
        ("meniscus, sweep by Dormand-Prince", adaptive, adaptive),
        ("SciPy, RK45 (16 runs, times 256)", scipys * RUNS / few.size, adaptive),
    ]
    for name, seconds, reference in rows:
        print(f"{name:<44}{1e3 * seconds:>10.2f} ms   {seconds / reference:>8.2f} times as long as meniscus")


main()
