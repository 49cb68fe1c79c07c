"""Containers of measured data: right, or refused with a sentence that names the way."""

import datetime
import pathlib
import typing

import numpy
import pandas
import pint
import polars
import pyarrow
import pytest
import xarray

import meniscus

UNITS = pint.UnitRegistry()
T = numpy.linspace(0.0, 0.5, 251)
OMEGA_D = numpy.sqrt(12.0**2 - 0.7**2)
X = 5.0 * numpy.exp(-0.7 * T) * (numpy.cos(OMEGA_D * T) + 0.7 / OMEGA_D * numpy.sin(OMEGA_D * T))


def _missing(values, missing=numpy.nan):
    gaps = numpy.array(values, "O" if missing is None or missing is pandas.NA else "f8")
    gaps[7:9] = missing
    return gaps


def _structured():
    array = numpy.empty(len(T), [("t [s]", "f8"), ("x [cm]", "f4")])
    array["t [s]"], array["x [cm]"] = T, X
    return array


def _masked():
    values = X.copy()
    values[40:60] = 1e9
    return numpy.ma.masked_greater(values, 1e3)


def _dataset():
    return xarray.Dataset({"x": ("t", X / 100, {"units": "m"})}, {"t": ("t", T * 1000, {"units": "ms"})})


def _arrow():
    fields = [pyarrow.field("t", pyarrow.float64(), metadata={"unit": "s"}), pyarrow.field("x", pyarrow.float64(), metadata={"unit": "mm"})]
    values = [None if place in (3, 4) else 10 * value for place, value in enumerate(X)]
    return pyarrow.table([pyarrow.array(T), pyarrow.array(values)], pyarrow.schema(fields))


def _frame():
    frame = pandas.DataFrame({"t": T, "x": X / 100})
    frame.attrs["units"] = {"t": "s", "x": "m"}
    return frame


START = datetime.datetime(2026, 2, 28, 23, 59, 59, 900000)
STAMPS = [START + datetime.timedelta(seconds=float(t)) for t in T]

GIVEN = {
    "arrays": {"t [s]": T, "x [cm]": X},
    "lists": {"t [s]": T.tolist(), "x [cm]": X.tolist()},
    "None": {"t [s]": T.tolist(), "x [cm]": [None if place == 5 else value for place, value in enumerate(X)]},
    "NaN": {"t [s]": T, "x [cm]": _missing(X)},
    "objects": {"t [s]": T, "x [cm]": _missing(X, None)},
    "float32": {"t [s]": T, "x [cm]": X.astype("f4")},
    "big-endian": {"t [s]": T.astype(">f8"), "x [cm]": X},
    "masked": {"t [s]": T, "x [cm]": _masked()},
    "Pint": {"t": T * 1000 * UNITS.ms, "x": X * UNITS.cm},
    "Pint, masked": {"t": T * UNITS.s, "x": UNITS.Quantity(_masked(), "cm")},
    "Pint, list": {"t": T, "x": [value * UNITS.cm for value in X]} | {"t": T * UNITS.s},
    "frame": pandas.DataFrame({"t [s]": T, "x [cm]": X}),
    "frame with units": _frame(),
    "frame, nullable": pandas.DataFrame({"t [s]": T, "x [cm]": pandas.array(_missing(X, pandas.NA), "Float64")}),
    "frame, named index": pandas.DataFrame({"x [cm]": X}, pandas.Index(T, name="t [s]")),
    "series": pandas.Series(X, pandas.Index(T, name="t [s]"), name="x [cm]"),
    "stamps": pandas.DataFrame({"t": pandas.to_datetime(STAMPS), "x [cm]": X}),
    "stamps of a zone": pandas.DataFrame({"t": pandas.to_datetime(STAMPS).tz_localize("America/Bogota"), "x [cm]": X}),
    "index of stamps": pandas.DataFrame({"x [cm]": X}, pandas.DatetimeIndex(STAMPS, name="t")),
    "datetime64": {"t": numpy.array(STAMPS, "datetime64[ns]"), "x [cm]": X},
    "timedelta64": {"t": (T * 1e6).round().astype("timedelta64[us]"), "x [cm]": X},
    "datetimes": {"t": STAMPS, "x [cm]": X},
    "structured": _structured(),
    "dataset": _dataset(),
    "data array": _dataset()["x"],
    "Arrow": _arrow(),
}


@pytest.mark.parametrize("name", GIVEN)
def test_data_are_taken_with_their_units_and_gaps(damped, name):
    fit = damped.fit(GIVEN[name], "x", vary=["gamma", "omega", "x_0"], start={"omega": 12})
    found = {key: fit.parameters[key].value for key in ("gamma", "omega", "x_0")}
    assert found == pytest.approx({"gamma": 0.7, "omega": 12.0, "x_0": 5.0}, rel=1e-5)


def test_polars_is_taken(damped):
    data = polars.DataFrame({"t [s]": T, "x [cm]": [*X[:5], None, *X[6:]]})
    assert damped.fit(data, "x").parameters["omega"].value == pytest.approx(12.0, rel=1e-5)


class Measured:
    """A number with an error, as the package `uncertainties` has it."""

    def __init__(self, nominal_value):
        self.nominal_value, self.std_dev = nominal_value, 0.1


REFUSED = {
    "2-D": (numpy.stack([T, X], 1), "an array has no names of columns: pass {'t [s]': data[:, 0]"),
    "3-D column": ({"t [s]": T, "x [cm]": numpy.zeros((len(T), 2, 2))}, "x [cm]: 3 dimensions; a column has one"),
    "complex": ({"t [s]": T, "x [cm]": X + 0j}, "x [cm]: complex numbers; pass their real or imaginary part"),
    "texts": ({"t [s]": T, "x [cm]": X, "who": ["a"] * len(T)}, "who: texts: no numbers; leave the column out"),
    "frame with texts": (pandas.DataFrame({"t [s]": T, "x [cm]": X, "who": "a"}), "who: texts: no numbers; leave the column out"),
    "truths": ({"t [s]": T, "x": X > 0}, "column `x` has truths, which cannot be fitted; `exclude` takes such a column"),
    "two units": ({"t [s]": T * UNITS.ms, "x [cm]": X}, "the name `t [s]` and the values (ms) state different units"),
    "errors": ({"t [s]": T, "x [cm]": [Measured(x) for x in X]}, "pass unumpy.nominal_values(..)"),
    "one number": ({"t [s]": 3.0, "x [cm]": X}, "t [s]: 0 dimensions; a column has one"),
    "number": (17, "int has no columns: pass a dictionary of arrays by name, or the path of a file"),
}


@pytest.mark.parametrize("name", REFUSED)
def test_what_is_no_data_is_refused(damped, name):
    data, expected = REFUSED[name]
    with pytest.raises(meniscus.SettingError) as refused:
        damped.fit(data, "x")
    assert expected in str(refused.value)


def test_a_column_of_truths_leaves_rows_out(damped):
    wrong = X.copy()
    wrong[20:30] += 3
    bad = numpy.zeros(len(T), "?")
    bad[20:30] = True
    fit = damped.fit({"t [s]": T, "x [cm]": wrong, "bad": bad}, "x", exclude="bad")
    assert fit.parameters["x_0"].value == pytest.approx(5.0, rel=1e-5)


def test_a_missing_file_is_one_for_python_too(damped):
    for make in (lambda: meniscus.open("nowhere.md"), lambda: meniscus.check("nowhere.md"), lambda: damped.fit(pathlib.Path("nowhere.csv"), "x")):
        with pytest.raises(FileNotFoundError) as missing:
            make()
        assert isinstance(missing.value, meniscus.SettingError) and "nowhere" in str(missing.value)


def test_sweeps_take_switches_quantities_and_one_rule(damped):
    drag = meniscus.open("```model\nswitch drag = on\nparameter b = 1 [1/s]\nx' = if drag then -b*x else 0*b*x\nx(0) = 1 [m]\n```\n")
    for truths in ([True, False], numpy.array([True, False])):
        assert drag.sweep({"drag": truths}, "x at end", until=1)["x at end"].tolist() == pytest.approx([numpy.exp(-1.0), 1.0], rel=1e-3)
    swept = drag.sweep({"b": UNITS.Quantity([60.0, 120.0], "1/minute")}, "x at end", until=1)
    assert swept["x at end"].tolist() == pytest.approx([numpy.exp(-1.0), numpy.exp(-2.0)], rel=1e-2)
    with pytest.raises(meniscus.SettingError, match="`b` is swept in `over` and set to one value, too"):
        drag.sweep({"b": [1, 2]}, "x at end", b=3)
    with pytest.raises(meniscus.SettingError, match="`b` is swept"):
        drag.sweep("b=0..1 [1/s] step 1", "x at end", set={"b": 3})


def test_tables_are_seen_written_and_compared(damped):
    table = damped.run(columns="t, x", until=1)
    assert damped.run(columns="t, x", until=1) == table != damped.run(columns="t, x", until=2)
    assert [name for name, _ in table.items()] == ["t", "x"] and len(table.values()) == 2
    assert "<th>x [cm]</th>" in table._repr_html_() and "…" in table._repr_html_() and f"{len(table)} rows" in table._repr_html_()
    array = numpy.asarray(table)
    assert array.dtype.names == ("t", "x") and (array["x"] == table["x"]).all()
    assert pandas.DataFrame(numpy.asarray(table)).equals(table.to_pandas())


def test_a_file_of_a_table_is_read_again(damped, tmp_path):
    path = tmp_path / "run.csv"
    table = damped.run(columns="t, x", until=1)
    table.to_csv(path)
    assert path.read_text(encoding="utf-8") == table.to_csv()
    assert table.to_csv().splitlines()[0] == "t [s],x [cm]"
    from_file, from_table = (damped.fit(data, "x").parameters["omega"].value for data in (path, table))
    assert from_file == from_table


def test_hints_of_types_can_be_read():
    public = [meniscus.open, meniscus.check, meniscus.rank, meniscus.Table.to_csv, meniscus.Table.__getitem__]
    for function in [*public, meniscus.Document.run, meniscus.Document.sweep, meniscus.Document.fit]:
        assert "return" in typing.get_type_hints(function)
