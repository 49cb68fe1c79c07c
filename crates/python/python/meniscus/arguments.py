"""Arguments as the compiled part takes them: values as texts, numbers of arrays as bytes."""

from __future__ import annotations

import operator
import os
from collections.abc import Mapping
from typing import Any

from .data import is_quantity, numbers, unit_text
from .errors import SettingError


def text(value: Any) -> str:
    """Text of a value: a number, ``True`` and ``False`` as switches, a text, or a quantity of Pint."""
    if isinstance(value, str):
        return value
    if isinstance(value, bool):
        return "on" if value else "off"
    if is_quantity(value):
        return f"{float(value.magnitude)!r} {unit_text(value.units)}"
    try:
        return repr(float(value))
    except (TypeError, ValueError):
        raise ValueError(f"{value!r} is no number and no text") from None


def are_several(value: Any) -> bool:
    """True for a sequence of values, false for a number, a text or a single quantity."""
    if isinstance(value, str):
        return False
    try:
        len(value.magnitude if is_quantity(value) else value)
    except TypeError:
        return False
    return True


def items(name: str, given: Any) -> Any:
    """Names and values of a dictionary."""
    if not isinstance(given, Mapping):
        raise TypeError(f"{name} must be a dictionary")
    return given.items()


def by_name(name: str, given: Any) -> list[tuple[str, str | list[str]]]:
    """Values by name, each one value or several."""
    several = [(key, value, are_several(value)) for key, value in items(name, given or {})]
    return [(key, [text(one) for one in value] if many else text(value)) for key, value, many in several]


def names(given: Any) -> list[str]:
    """One text or several."""
    if given is None:
        return []
    return [given] if isinstance(given, str) else list(given)


def axes(over: Any, arrays: list[bytes]) -> list[dict[str, Any]]:
    """Parameters of a sweep with their values. Arrays are added to those of the request."""
    if not isinstance(over, Mapping):
        return [{"text": one} for one in names(over)]
    return [_axis(name, values, arrays) for name, values in over.items()]


def _axis(name: str, values: Any, arrays: list[bytes]) -> dict[str, Any]:
    if isinstance(values, str):
        return {"range": (name, values)}
    if not are_several(values):
        return {"values": (name, [text(values)])}
    # Switches, words and quantities.
    if is_quantity(values) or any(isinstance(value, (str, bool)) or is_quantity(value) or _is_truth(value) for value in values):
        return {"values": (name, [text(bool(value) if _is_truth(value) else value) for value in values])}
    arrays.append(numbers(name, values))
    return {"numbers": (name, len(arrays) - 1)}


def _is_truth(value: Any) -> bool:
    """True for a truth value of numpy."""
    return getattr(getattr(value, "dtype", None), "kind", None) == "b"


def refuse_both(over: Any, stated: Mapping[str, Any]) -> None:
    """Refuses a parameter that is both swept and set."""
    swept = list(over) if isinstance(over, Mapping) else [one.split("=")[0].strip() for one in names(over)]
    for name, _ in [*stated.get("parameters", []), *stated.get("set", [])]:
        if name in swept:
            raise SettingError(f"`{name}` is swept in `over` and set to one value, too: leave one out")


def settings(until, set, start, preset, press, draw, method, step, tolerance, seat, parameters) -> dict[str, Any]:
    """Settings of a run; those that are not stated are left out."""
    stated: dict[str, Any] = {}
    if parameters:
        stated["parameters"] = by_name("parameters", parameters)
    for name, given in [("set", set), ("start", start), ("press", press)]:
        if given is not None:
            stated[name] = by_name(name, given)
    for name, value in [("until", until), ("step", step)]:
        if value is not None:
            stated[name] = text(value)
    if preset is not None:
        stated["preset"] = names(preset)
    if draw is not None:
        stated["draw"] = [(name, os.fspath(path)) for name, path in items("draw", draw)]
    if method is not None:
        stated["method"] = method
    if tolerance is not None:
        stated["tolerance"] = float(tolerance)
    if seat is not None:
        stated["seat"] = operator.index(seat)
    return stated


def fit_settings(observe, vary, fix, tie, start, bounds, share, error, loss, begin, until, against, dates, unit, seat, exclude) -> dict[str, Any]:
    """Settings of a fit."""
    if isinstance(observe, Mapping):
        observed: list[Any] = [(quantity, str(column)) for quantity, column in observe.items()]
    else:
        observed = names(observe)
    return {
        "observe": observed,
        "vary": names(vary),
        "fix": by_name("fix", fix),
        "tie": by_name("tie", tie),
        "start": by_name("start", start),
        "bounds": [(name, _range(given)) for name, given in items("bounds", bounds or {})],
        "share": names(share),
        "error": by_name("error", error),
        "loss": loss,
        "begin": None if begin is None else text(begin),
        "until": None if until is None else text(until),
        "against": names(against),
        "dates": dates,
        "unit": by_name("unit", unit),
        "seat": None if seat is None else operator.index(seat),
        "exclude": [str(rows) for rows in (exclude if are_several(exclude) else [exclude]) if rows is not None],
    }


def _range(given: Any) -> Any:
    """A text ``1..2``, or two ends of which `None` is no bound."""
    if not are_several(given):
        return given
    low, high = given
    return [end if end is None else text(end) for end in (low, high)]
