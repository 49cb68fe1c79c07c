"""Measured data: columns of numbers, with their units, from the containers that users have."""

from __future__ import annotations

import math
import os
from array import array
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from .errors import SettingError

Column = tuple[str, Any, "str | None"]
"""Name, values, and unit if the container states one."""


def records(data: Any, observed: Any, arrays: list[bytes]) -> list[dict[str, Any]]:
    """One record, or several. Arrays are added to those of the request. ``observed``: the argument ``observe``."""
    several = isinstance(data, Iterable) and not isinstance(data, (str, bytes, os.PathLike)) and not _has_columns(data)
    if several and hasattr(data, "ndim"):
        raise SettingError(f"data: an array has no names of columns: pass {{'t [s]': data[:, 0], 'y [m]': data[:, 1]}}{_OR_A_FILE}")
    if isinstance(observed, Mapping):
        observed = observed.values()
    measured = {observed} if isinstance(observed, str) else set(observed or [])
    return [_record(one, measured, arrays) for one in (data if several else [data])]


_OR_A_FILE = ", or the path of a file"


def _record(data: Any, measured: set[Any], arrays: list[bytes]) -> dict[str, Any]:
    if not _has_columns(data):
        try:
            return {"file": os.fspath(data)}
        except TypeError:
            raise SettingError(f"data: {type(data).__name__} has no columns: pass a dictionary of arrays by name{_OR_A_FILE}") from None
    headings = []
    for name, values, unit in _columns(data):
        numbers, own, are_truths = _numbers(name, values)
        if are_truths and name in measured:
            raise SettingError(f"data: column `{name}` has truths, which cannot be fitted; `exclude` takes such a column")
        arrays.append(numbers)
        headings.append((_heading(name, own or unit), len(arrays) - 1))
    return {"columns": headings}


def _has_columns(data: Any) -> bool:
    names = getattr(getattr(data, "dtype", None), "names", None)
    return hasattr(data, "keys") or hasattr(data, "__arrow_c_stream__") or hasattr(data, "to_dataset") or bool(names)


def _columns(data: Any) -> Iterator[Column]:
    """Columns of a dictionary, a `Table`, pandas, xarray, Arrow, polars, or a structured array."""
    if hasattr(data, "to_dataset"):
        data = data.to_dataset(name=data.name or "value")
    if hasattr(data, "to_frame") and hasattr(data, "index"):
        data = data.to_frame()
    if hasattr(data, "data_vars"):
        for name in [*data.coords, *data.data_vars]:
            if data[name].ndim or name in data.data_vars:
                yield str(name), data[name], data[name].attrs.get("units")
    elif hasattr(data, "keys"):
        units = getattr(data, "units", None)
        units = units if isinstance(units, Mapping) else getattr(data, "attrs", {}).get("units", {})
        # The index of a frame is a column if it has a name.
        index = getattr(data, "index", None)
        for name in getattr(index, "names", []):
            if name is not None:
                yield str(name), index.get_level_values(name), units.get(name)
        for name in data.keys():
            yield str(name), data[name], units.get(name)
    elif hasattr(data, "__arrow_c_stream__"):
        try:
            import pyarrow
        except ImportError:
            raise SettingError("data: tables of Arrow need pyarrow: `pip install pyarrow`, or pass a dictionary of arrays") from None
        table = pyarrow.table(data)
        for field, values in zip(table.schema, table.columns):
            unit = (field.metadata or {}).get(b"unit")
            yield field.name, values, unit and unit.decode()
    else:
        for name in data.dtype.names:
            yield name, data[name], None


def _heading(name: str, unit: str | None) -> str:
    """Name with its unit. A unit in the name must be the stated one."""
    stated = name[name.rindex("[") + 1 : -1].strip() if name.endswith("]") and "[" in name else None
    if not unit or stated == unit:
        return name
    if stated is not None:
        raise SettingError(f"data: the name `{name}` and the values ({unit}) state different units: leave one out")
    return f"{name} [{unit}]"


def is_quantity(value: Any) -> bool:
    """True for a number or an array of Pint."""
    return hasattr(value, "magnitude") and hasattr(value, "units")


def unit_text(unit: Any) -> str:
    """Text of a unit of Pint."""
    return format(unit, "~C").replace("**", "^")


def numbers(name: str, values: Any) -> bytes:
    """Numbers of 8 bytes, without a value NaN. Raises `SettingError` if they are none, or have a unit."""
    found, unit, are_truths = _numbers(name, values)
    if unit or are_truths:
        raise SettingError(f"{name}: {unit or 'truths'} where bare numbers are expected")
    return found


def _numbers(name: str, values: Any) -> tuple[bytes, str | None, bool]:
    """Numbers of 8 bytes, their unit if the values have one, and true if they are truths."""
    unit = None
    dtype = getattr(values, "dtype", None)
    if is_quantity(values):
        unit, values = unit_text(values.units), values.magnitude
    elif is_quantity(getattr(values, "pint", None)):
        unit, values = unit_text(values.pint.units), values.pint.magnitude
    elif getattr(dtype, "tz", None) is not None:
        values = getattr(values, "dt", values).tz_convert(None)
    try:
        import numpy
    except ImportError:
        return _listed(name, values), unit, False
    if isinstance(values, (list, tuple)) and any(map(is_quantity, values)):
        values = numpy.fromiter(values, "O", len(values))
    found = values if isinstance(values, numpy.ma.MaskedArray) else numpy.asarray(values)
    if found.dtype.kind == "O":
        found, own = _objects(name, found)
        unit = unit or own
    if found.ndim != 1:
        raise SettingError(f"{name}: {found.ndim} dimensions; a column has one")
    kind = found.dtype.kind
    if kind in "mM":
        # Times of day and dates count from the first row.
        since = numpy.ma.compressed(found[~numpy.isnat(found)])[:1] if kind == "M" else []
        found = (found - since[0] if len(since) else found) / numpy.timedelta64(1, "s")
        unit = "s"
    elif kind not in "biuf":
        words = {"c": "complex numbers; pass their real or imaginary part", "U": "texts", "S": "texts"}
        raise SettingError(f"{name}: {words.get(kind, found.dtype)}: no numbers; leave the column out")
    if isinstance(found, numpy.ma.MaskedArray):
        found = found.astype("f8").filled(numpy.nan)
    return found.astype("f8").tobytes(), unit, kind == "b"


def _listed(name: str, values: Any) -> bytes:
    """Numbers without numpy."""
    try:
        return array("d", [math.nan if value is None else value for value in values]).tobytes()
    except TypeError:
        raise SettingError(f"{name}: no numbers") from None


def _objects(name: str, values: Any) -> tuple[Any, str | None]:
    """Array of the numbers or dates in an array of objects, and their unit."""
    import numpy

    mask = numpy.ma.getmaskarray(values) if isinstance(values, numpy.ma.MaskedArray) else None
    found = [None if mask is not None and mask[place] else value for place, value in enumerate(values)]
    # None, and the missing values of pandas.
    found = [None if type(value).__name__ in ("NAType", "NaTType") else value for value in found]
    known = [value for value in found if value is not None]
    if any(hasattr(value, "nominal_value") for value in known):
        way = f"pass unumpy.nominal_values(..), and unumpy.std_devs(..) as a column that error={{'{name}': ..}} names"
        raise SettingError(f"{name}: numbers with errors: {way}")
    if known and all(map(is_quantity, known)):
        unit = known[0].units
        return numpy.array([math.nan if value is None else value.to(unit).magnitude for value in found], "f8"), unit_text(unit)
    if known and all(hasattr(value, "isoformat") for value in known):
        return numpy.array(found, "datetime64[us]"), None
    if any(isinstance(value, (str, bytes)) for value in known):
        raise SettingError(f"{name}: texts: no numbers; leave the column out")
    try:
        return numpy.array([math.nan if value is None else float(value) for value in found], "f8"), None
    except TypeError:
        raise SettingError(f"{name}: {type(known[0]).__name__}: no numbers; leave the column out") from None
