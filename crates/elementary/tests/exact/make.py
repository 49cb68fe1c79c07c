"""Writes the tables of exact values: `python make.py` with mpmath 1.3 or later.

A line has the bits of the arguments, the bits of the exact value rounded to the nearest number, and what the exact value is
beyond that number, in units of its last place.
"""

import math
import pathlib
import random
import struct

from mpmath import mp, mpf

mp.prec = 400
COUNT = 400
choice = random.Random(20261127)


def bits(x):
    return "%016x" % struct.unpack("<Q", struct.pack("<d", x))


def rounded(exact):
    """The number nearest to `exact`, and the difference in units of its last place."""
    number = float(exact)
    unit = mpf(math.ulp(number))
    return number, (exact - mpf(number)) / unit


def between(low, high):
    return lambda: choice.uniform(low, high)


def scale(low, high):
    """Either sign, any order of magnitude."""
    return lambda: choice.choice((1, -1)) * math.exp(choice.uniform(math.log(low), math.log(high)))


def magnitude(low, high):
    return lambda: abs(scale(low, high)())


def beside(places):
    """A few numbers from a place: where one polynomial follows on another."""

    def number():
        place = float(choice.choice(places))
        return place + choice.randint(-4, 4) * math.ulp(place)

    return number


QUARTERS = [k * mp.pi / 4 for k in (*range(1, 40), *(choice.randint(40, 127000) for _ in range(40)))]
FOLDS = [k * mp.log(2) / 2 for k in (*range(-40, 41), *range(-2000, 2000, 100)) if k]
ANGLES = [between(-0.8, 0.8), between(-10, 10), scale(1, 1e5), scale(1e-300, 1), beside(QUARTERS)]
HYPERBOLIC = [between(-0.5, 0.5), between(-5, 5), between(-22, 22), scale(1e-300, 1), beside(FOLDS)]
ANY = scale(1e-3, 1e3)


def power():
    base = magnitude(1e-300, 1e300)()
    return base, choice.uniform(-700, 700) / math.log(base)


def near_one():
    base = 1 + scale(1e-9, 0.3)()
    return base, choice.uniform(-700, 700) / math.log(base)


FUNCTIONS = {
    "sin": (mp.sin, ANGLES),
    "cos": (mp.cos, ANGLES),
    "tan": (mp.tan, ANGLES),
    "exp": (mp.exp, [between(-1, 1), between(-20, 20), between(-708, 709), between(-745, -708), beside(FOLDS)]),
    "ln": (
        mp.log,
        [between(0.5, 2), magnitude(1e-300, 1e300), lambda: 1 + scale(1e-15, 0.1)(), beside([0.5**0.5, 2**0.5, 1, 8**0.5])],
    ),
    "sinh": (mp.sinh, [*HYPERBOLIC, between(-710, 710)]),
    "cosh": (mp.cosh, [*HYPERBOLIC, between(-710, 710)]),
    "tanh": (mp.tanh, HYPERBOLIC),
    "atan": (mp.atan, [between(-1, 1), between(-4, 4), scale(1e-300, 1e300), beside([0.4375, 0.6875, 1.1875, 2.4375])]),
    "atan2": (mp.atan2, [lambda: (between(-5, 5)(), between(-5, 5)()), lambda: (ANY(), ANY())]),
    "pow": (
        mp.power,
        [power, near_one, lambda: (between(0.1, 10)(), between(-5, 5)()), lambda: (magnitude(0.1, 10)(), scale(1e-9, 1)())],
    ),
}

for name, (function, kinds) in FUNCTIONS.items():
    lines = []
    for number in range(COUNT):
        arguments = kinds[number % len(kinds)]()
        arguments = arguments if isinstance(arguments, tuple) else (arguments,)
        value, beyond = rounded(function(*map(mpf, arguments)))
        lines.append(" ".join([*map(bits, arguments), bits(value), "%.3f" % beyond]))
    pathlib.Path(__file__).with_name(name + ".txt").write_text("\n".join(lines) + "\n")
