"""Tables: columns with names and units."""

from __future__ import annotations

import csv
import html
import io
import json
import os
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any, TypeAlias

from . import _core
from .errors import Diagnostic, answer, diagnostics

if TYPE_CHECKING:
    from numpy.typing import NDArray

    Array: TypeAlias = NDArray[Any]
else:
    # Without numpy, in Pyodide, a column is no array.
    Array = Any

Column: TypeAlias = tuple[str, str, str, str, Any]
"""Name, unit, label, kind (numbers, truths or texts), and values: bytes, or a list of texts."""

_SHOWN = 5
"""Number of rows that a notebook shows of each end of a long table."""


class Table:
    """Columns with names and units, as a run or a sweep gives them.

    ``table["y"]`` is a column as an array of numpy that cannot be written; ``len(table)`` is the number of rows, and ``dict(table)``
    has all arrays. A notebook shows its first and last rows. ``numpy.asarray(table)`` is a structured array, ``pandas.DataFrame(dict(table))``
    a frame without units. Arrays and Arrow share one memory. A number without a value is NaN, in Arrow null. Without numpy, in Pyodide, a
    column is a `memoryview` of its numbers, or a list of texts.
    """

    __slots__ = ("_columns", "ended", "notices")

    notices: list[Diagnostic]
    """Warnings about the run, such as a step that is too long, or about runs of a sweep that could not be computed."""
    ended: str | None
    """Message of the event that ended the run before its time."""

    def __init__(self, columns: list[Column], notices: list[Diagnostic], ended: str | None) -> None:
        self._columns = columns
        self.notices = notices
        self.ended = ended

    def __reduce__(self) -> Any:
        return Table, (self._columns, self.notices, self.ended)

    @property
    def columns(self) -> list[str]:
        return [column[0] for column in self._columns]

    @property
    def units(self) -> dict[str, str]:
        """Unit of each column; empty for pure numbers."""
        return {column[0]: column[1] for column in self._columns}

    @property
    def labels(self) -> dict[str, str]:
        """Label of each column that the author has given one."""
        return {column[0]: column[2] for column in self._columns if column[2]}

    def keys(self) -> list[str]:
        return self.columns

    def __getitem__(self, name: str) -> Array:
        for column in self._columns:
            if column[0] == name:
                return _array(column)
        near = answer(_core.call("nearest", [], json.dumps([name, self.columns]), [])[0])
        hint = f"; did you mean `{near}`?" if near else ""
        raise KeyError(f"there is no column `{name}`{hint}")

    def values(self) -> list[Array]:
        return [_array(column) for column in self._columns]

    def items(self) -> list[tuple[str, Array]]:
        return list(zip(self.columns, self.values()))

    def __eq__(self, other: object) -> bool:
        """True if both have the same columns, units, labels and values, to the last bit."""
        return isinstance(other, Table) and self._columns == other._columns

    __hash__ = None  # type: ignore[assignment]

    def __contains__(self, name: object) -> bool:
        return name in self.columns

    def __iter__(self) -> Iterator[str]:
        return iter(self.columns)

    def __len__(self) -> int:
        if not self._columns:
            return 0
        *_, kind, values = self._columns[0]
        return len(values) // 8 if kind == "numbers" else len(values)

    def __repr__(self) -> str:
        return f"<Table of {len(self)} rows: {', '.join(map(_heading, self._columns))}>"

    def _repr_html_(self) -> str:
        rows = list(zip(*self.values()))
        gap = [] if len(rows) <= 2 * _SHOWN else [["…"] * len(self._columns)]
        shown = [*rows[:_SHOWN], *gap, *rows[-_SHOWN:]] if gap else rows
        head = "".join(f"<th>{html.escape(_heading(column))}</th>" for column in self._columns)
        body = "".join("<tr>" + "".join(f"<td>{html.escape(_shown(value))}</td>" for value in row) + "</tr>" for row in shown)
        notes = "".join(f"<p>{html.escape(str(note))}</p>" for note in [*self.notices, *filter(None, [self.ended])])
        return f"<table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table><p>{len(rows)} rows</p>{notes}"

    def to_csv(self, path: str | os.PathLike[str] | None = None) -> str | None:
        """Writes a file with the headings ``y [m]``, all digits, and an empty cell without a value; without ``path`` its text is returned."""
        if path is not None:
            with open(path, "w", encoding="utf-8", newline="") as file:
                self._write(file)
            return None
        text = io.StringIO(newline="")
        self._write(text)
        return text.getvalue()

    def _write(self, file: Any) -> None:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(map(_heading, self._columns))
        writer.writerows(map(_cell, row) for row in zip(*(values.tolist() if hasattr(values, "tolist") else values for values in self.values())))

    def __array__(self, dtype: Any = None, copy: bool | None = None) -> Any:
        """Structured array with a field for each column."""
        import numpy

        arrays = self.values()
        fields = [(name, values.dtype) for name, values in zip(self.columns, arrays)]
        found = numpy.empty(len(self), fields)
        for (name, _), values in zip(fields, arrays):
            found[name] = values
        return found if dtype is None else found.astype(dtype)

    def to_pandas(self, *, headings: bool = False) -> Any:
        """DataFrame of pandas, with ``attrs["units"]``; with ``headings`` its columns are called ``y [m]``."""
        import pandas

        name = _heading if headings else (lambda column: column[0])
        frame = pandas.DataFrame({name(column): _array(column) for column in self._columns})
        frame.attrs["units"] = self.units
        return frame

    def to_xarray(self) -> Any:
        """Dataset of xarray along the first column, with units in the attributes."""
        import xarray

        if not self._columns:
            raise ValueError("the table has no columns")
        along = self._columns[0][0]
        first, *others = [(column[0], (along, _array(column), {"units": column[1]})) for column in self._columns]
        return xarray.Dataset(dict(others), dict([first]))

    def to_arrow(self) -> Any:
        """Table of pyarrow, with units in the metadata of its fields. Not in Pyodide."""
        import pyarrow

        return pyarrow.table(self)

    if hasattr(_core, "arrow_stream"):

        def __arrow_c_stream__(self, requested_schema: object | None = None) -> object:
            # A consumer may ask for another schema; the protocol allows to answer with one's own.
            return _core.arrow_stream(self._columns, len(self))


def _heading(column: Column) -> str:
    """Name and unit, ``y' [m/s]``; only the name without a unit."""
    return f"{column[0]} [{column[1]}]" if column[1] else column[0]


def _cell(value: Any) -> Any:
    """Value in a file: nothing for NaN, and truths as 0 and 1."""
    if isinstance(value, bool):
        return int(value)
    return "" if value != value else value


def _shown(value: Any) -> str:
    return f"{value:.6g}" if isinstance(value, float) else str(value)


def _array(column: Column) -> Any:
    *_, kind, values = column
    try:
        import numpy
    except ImportError:
        return values if kind == "texts" else memoryview(values).cast("d" if kind == "numbers" else "?")
    if kind == "texts":
        return numpy.array(values, "O")
    return numpy.frombuffer(values, "f8" if kind == "numbers" else "?")


def filled(columns: Iterable[Column], buffers: Iterator[bytes]) -> list[Column]:
    """Columns of a reply with their values."""
    return [(*column[:4], column[4] if column[3] == "texts" else next(buffers)) for column in columns]


def table(value: Any, buffers: Iterator[bytes]) -> Table:
    """The table in a reply."""
    return Table(filled(value["columns"], buffers), diagnostics(value["notices"]), value["ended"])
