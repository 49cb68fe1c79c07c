"""Results of fits."""

from __future__ import annotations

import html
import math
from collections.abc import Iterator
from typing import Any

from .table import Table, filled


class Estimate:
    """A fitted number with its standard error, in its unit. ``float(estimate)`` is its value."""

    __slots__ = ("stderr", "unit", "value")

    value: float | None
    """Value; ``None`` if the data do not determine it."""
    stderr: float | None
    """Standard error; also right for residuals that are correlated in time."""
    unit: str

    def __init__(self, value: float | None, stderr: float | None, unit: str) -> None:
        self.value = value
        self.stderr = stderr
        self.unit = unit

    def __reduce__(self) -> Any:
        return Estimate, (self.value, self.stderr, self.unit)

    def __float__(self) -> float:
        return math.nan if self.value is None else self.value

    def __repr__(self) -> str:
        value = "not determined" if self.value is None else self.value
        error = "" if self.stderr is None else f" ± {self.stderr}"
        return f"<Estimate {value}{error}{' ' + self.unit if self.unit else ''}>"


class Fit:
    """A fit. ``print(fit)`` shows it as the command line does."""

    __slots__ = ("_text", "curves", "summary")

    summary: dict[str, Any]
    """All results, with the keys of ``meniscus fit --format json`` and ``meniscus rank --format json``."""
    curves: list[Table]
    """For each observed quantity of each record: time, measured, fitted, residual, and whether the row was fitted."""

    def __init__(self, summary: dict[str, Any], text: str, curves: list[Table]) -> None:
        self.summary = summary
        self._text = text
        self.curves = curves

    def __reduce__(self) -> Any:
        return Fit, (self.summary, self._text, self.curves)

    @property
    def parameters(self) -> dict[str, Estimate]:
        """Fitted parameters that hold for all records."""
        return self._estimates("parameters")

    @property
    def derived(self) -> dict[str, Estimate]:
        """Quantities that follow from the parameters."""
        return self._estimates("derived")

    def _estimates(self, key: str) -> dict[str, Estimate]:
        estimates = {}
        for name, entry in self.summary.get(key, {}).items():
            robust = entry["stderr_hac"]
            error = entry["stderr"] if robust is None else robust
            estimates[name] = Estimate(entry["value"], error, entry["unit"])
        return estimates

    def __getitem__(self, key: str) -> Any:
        return self.summary[key]

    def __str__(self) -> str:
        return self._text

    def _repr_html_(self) -> str:
        return f"<pre>{html.escape(self._text)}</pre>"

    def __repr__(self) -> str:
        return f"<Fit of {self['title']}>"


def fit(value: Any, buffers: Iterator[bytes]) -> Fit:
    """The fit in a reply."""
    curves = [Table(filled(columns, buffers), [], None) for columns in value["curves"]]
    return Fit(value["summary"], value["text"], curves)
