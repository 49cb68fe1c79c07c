"""Sweeps: the rows are those of the program, of single runs, and of shares."""

import numpy
import pytest

import meniscus
from conftest import DAMPED, ROOT

KEEP = "maximum(x) from 0.5 [s] in [cm], x at end"


def test_rows_are_those_of_single_runs(damped):
    gammas = [0.1, 0.7, 3.0]
    table = damped.sweep({"gamma": gammas}, "x at end", omega="5 rad/s", method="dormand-prince")
    for gamma, end in zip(gammas, table["x at end"]):
        assert damped.run(gamma=gamma, omega="5 rad/s", method="dormand-prince")["x"][-1] == end


@pytest.mark.parametrize(
    "over, options, words",
    [
        ({"gamma": "0..4 step 0.5"}, {}, ["--over", "gamma in 0..4 step 0.5"]),
        ({"gamma": [0, 1, 2.5], "x_0": "20, 30 [mm]"}, {}, ["--over", "gamma = 0, 1, 2.5", "--over", "x_0 = 20, 30 [mm]"]),
        ({"damped": ["on", "off"]}, {"gamma": 2}, ["--over", "damped = on, off", "--set", "gamma=2"]),
        (["gamma in 0..4", "omega in 5..20"], {"halton": 9}, ["--over", "gamma in 0..4", "--over", "omega in 5..20", "--halton", "9"]),
        ({"gamma": "0..4"}, {"random": 9, "seed": 7}, ["--over", "gamma in 0..4", "--random", "9", "--seed", "7"]),
        ({"gamma": "0..4 step 0.5"}, {"shard": (2, 3)}, ["--over", "gamma in 0..4 step 0.5", "--shard", "2/3"]),
    ],
)
def test_rows_have_the_bits_of_the_program(program, tmp_path, damped, over, options, words):
    path = tmp_path / "damped.md"
    path.write_text(DAMPED)
    _, rows = program("sweep", path, "--keep", KEEP, *words)
    table = damped.sweep(over, KEEP, **options)
    for place, name in enumerate(table.columns):
        expected = [row[place] for row in rows]
        values = table[name]
        assert list(values) == ([float(text) for text in expected] if values.dtype == float else expected), name


def test_a_document_that_ships_has_the_bits_of_the_program(program):
    path = ROOT / "simulations" / "utube.md"
    _, rows = program("sweep", path, "--over", "b in 0..400 step 50", "--keep", "maximum(y) from 2 [s]")
    table = meniscus.open(path).sweep({"b": numpy.arange(0, 401, 50)}, "maximum(y) from 2 [s]")
    assert [float(row[2]) for row in rows] == list(table[table.columns[2]])


def test_shares_are_the_whole_and_prepared_sweeps_are_the_same(damped):
    whole = damped.sweep({"gamma": "0..4 step 0.25"}, KEEP)
    for _ in range(2):
        parts = [damped.sweep({"gamma": "0..4 step 0.25"}, KEEP, shard=(number, 4)) for number in range(1, 5)]
        assert numpy.concatenate([part["x at end"] for part in parts]).tobytes() == whole["x at end"].tobytes()
    other = damped.sweep({"gamma": "0..4 step 0.25"}, KEEP, until=1)
    assert other["x at end"][0] != whole["x at end"][0]


def test_wrong_sweeps_say_why(damped):
    for over, keep, message in [
        ({"gamma": "0..4"}, "x at end", "how far apart"),
        ({"gama": [1.0]}, "x at end", "did you mean `gamma`?"),
        ({"gamma": [9.0]}, "x at end", "out of range"),
        ({"gamma": [1.0]}, "z at end", "keep:1:1"),
    ]:
        with pytest.raises(meniscus.SettingError) as raised:
            damped.sweep(over, keep)
        assert message in str(raised.value)
