"""Tables for pandas, Arrow and pickle."""

import pickle

import numpy
import pandas
import pyarrow

import meniscus

WORDS = """---
until: 3 [s]
step: 1
---

```model
parameter v = 1 [m/s]
x' = v
x(0) = 0 [cm]
late = t > 1 [s]
kind = if late then "late" else "early"
```
"""


def test_a_table_is_a_frame_with_units(damped):
    table = damped.run(until=0.01)
    frame = table.to_pandas()
    assert list(frame.columns) == table.columns and frame.attrs["units"]["x"] == "cm"
    assert (frame["x"].to_numpy() == table["x"]).all()
    assert "x [cm]" in table.to_pandas(headings=True)


def test_a_table_is_a_dataset_with_units(damped):
    table = damped.run(until=0.01)
    data = table.to_xarray()
    assert data["x"].dims == ("t",) and data["x"].attrs["units"] == "cm" and data["t"].attrs["units"] == "s"
    assert (data["x"].to_numpy() == table["x"]).all()


def test_arrow_shares_the_memory_and_has_units():
    table = meniscus.open(WORDS).run()
    arrow = table.to_arrow()
    assert arrow.column_names == table.columns
    assert arrow.schema.field("x").metadata[b"unit"] == table.units["x"].encode()
    numbers = arrow.column("t").chunk(0).buffers()[1]
    assert numbers.address == table["t"].ctypes.data
    assert arrow.column("late").to_pylist() == [False, False, True, True] == list(table["late"])
    assert arrow.column("kind").to_pylist() == ["early", "early", "late", "late"] == list(table["kind"])
    del table
    assert arrow.column("t").to_pylist() == [0.0, 1.0, 2.0, 3.0]


def test_arrow_has_null_where_there_is_no_value(damped):
    table = meniscus.Table([("a", "m", "", "numbers", numpy.array([1.0, numpy.nan]).tobytes())], [], None)
    assert pyarrow.table(table).column("a").to_pylist() == [1.0, None]
    assert numpy.isnan(table["a"][1])


def test_documents_tables_errors_and_fits_pickle(damped):
    again = lambda value: pickle.loads(pickle.dumps(value))
    assert again(damped) == damped and hash(again(damped)) == hash(damped)
    assert again(damped).run()["x"].tobytes() == damped.run()["x"].tobytes()
    table = meniscus.open(WORDS).run()
    copy = again(table)
    assert copy.units == table.units and all((copy[name] == table[name]).all() for name in table)
    try:
        damped.run(x_0="100 cm")
    except meniscus.SettingError as error:
        assert str(again(error)) == str(error) and again(error).diagnostics[0].message == error.diagnostics[0].message
    fit = damped.fit(damped.run(columns="t, x"), "x")
    assert again(fit).summary == fit.summary and str(again(fit)) == str(fit)
