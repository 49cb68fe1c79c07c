"""Runs: closed forms, units, columns, and the bits of the program."""

import os
import signal
import threading

import numpy
import pint
import pytest

import meniscus
from conftest import ROOT

# No events, many events, discrete time, a stiff method, a family with texts, drawn tables, random draws.
SHIPPED = ["utube", "pendulum", "bouncing-ball", "logistic-map", "van-der-pol", "chain", "two-tanks", "stick-slip", "random-walk"]


def closed_form(t, gamma, omega, x_0):
    shifted = numpy.sqrt(omega**2 - gamma**2)
    return x_0 * numpy.exp(-gamma * t) * (numpy.cos(shifted * t) + gamma / shifted * numpy.sin(shifted * t))


@pytest.mark.parametrize("method", ["rk4", "dormand-prince"])
def test_a_run_is_the_closed_form(damped, method):
    for gamma in [0.0, 0.3, 4.0]:
        table = damped.run(gamma=gamma, method=method, tolerance=1e-10)
        assert table.units == {"t": "s", "x": "cm", "x'": "cm/s"} or table.units["x"] == "cm"
        assert numpy.abs(table["x"] - closed_form(table["t"], gamma, 10.0, 2.0)).max() < 1e-6


@pytest.mark.parametrize("name", SHIPPED)
def test_a_run_has_the_bits_of_the_program(program, name):
    path = ROOT / "simulations" / f"{name}.md"
    head, rows = program("run", path)
    table = meniscus.open(path).run()
    unit = lambda name: f" [{table.units[name]}]" if table.units[name] else ""
    assert head == [name + unit(name) for name in table.columns]
    for place, column in enumerate(table.columns):
        values, texts = table[column], [row[place] for row in rows]
        assert len(values) == len(texts)
        if values.dtype == float:
            expected = numpy.array([float(text) if text else numpy.nan for text in texts])
            assert values.tobytes() == expected.tobytes() or numpy.array_equal(values, expected, equal_nan=True), column
        elif values.dtype == bool:
            assert list(values) == [text == "true" for text in texts]
        else:
            assert list(values) == texts


@pytest.mark.parametrize(
    "given, centimetres",
    [
        (pint.UnitRegistry().Quantity(30, "mm"), 3.0),
        (3, 3.0), (3.5, 3.5), (numpy.float32(3), 3.0), ("3", 3.0), ("30 mm", 3.0), ("30 [mm]", 3.0), ("0.03 m", 3.0), ("2*1.5 [cm]", 3.0),
    ],
)
def test_values_have_the_declared_unit_or_their_own(damped, given, centimetres):
    assert damped.run(x_0=given, until="10 ms")["x"][0] == pytest.approx(centimetres, abs=1e-15)
    assert damped.run(set={"x_0": given}, until=0.01)["x"][0] == pytest.approx(centimetres, abs=1e-15)


def test_settings_choose_columns_start_and_switches(damped):
    table = damped.run(until=1, columns=["x", "gamma"], start={"x": "5 cm"}, damped=False, gamma=2)
    assert table.columns == ["x", "gamma"]
    assert len(table) == 1001 and set(table["gamma"]) == {2.0}
    assert numpy.abs(table["x"] - closed_form(numpy.arange(1001) * 0.001, 0.0, 10.0, 5.0)).max() < 1e-6
    assert "x" in table and "y" not in table and list(table) == table.keys()
    with pytest.raises(ValueError):
        table["x"][0] = 1.0


def test_threads_run_side_by_side_with_the_same_bits(damped):
    expected = damped.run(method="dormand-prince")["x"].tobytes()
    found = [None] * 8

    def one(place):
        found[place] = damped.run(method="dormand-prince")["x"].tobytes()

    threads = [threading.Thread(target=one, args=(place,)) for place in range(8)]
    [thread.start() for thread in threads]
    [thread.join() for thread in threads]
    assert found == [expected] * 8


def test_a_long_run_leaves_the_interpreter_to_other_threads_and_can_be_interrupted(damped):
    interrupt = threading.Timer(0.1, lambda: os.kill(os.getpid(), signal.SIGINT))
    interrupt.start()
    with pytest.raises(KeyboardInterrupt):
        damped.run(until=1e9, columns="t")
