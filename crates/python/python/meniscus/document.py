"""Documents: what is run, swept and fitted."""

from __future__ import annotations

import html
import json
import operator
import os
from collections.abc import Mapping, Sequence
from os import PathLike
from typing import TYPE_CHECKING, Any, Literal, SupportsFloat, TypeAlias

from . import _core
from .arguments import axes, fit_settings, names, refuse_both, settings, text
from .data import records
from .errors import Diagnostic, answer, asked, diagnostics
from .fit import Fit, fit
from .gallery import found
from .table import Table, table

if TYPE_CHECKING:
    from numpy.typing import ArrayLike
else:
    # Without numpy, in Pyodide, any sequence.
    ArrayLike = Any

Value: TypeAlias = SupportsFloat | str | bool
"""A number in the declared unit, a text with its own unit, a word of a choice, or the position of a switch."""

Data: TypeAlias = str | PathLike[str] | Table | Mapping[str, ArrayLike] | Any
"""Measured data: a file, or columns: a dictionary by heading, such as ``"t [s]"``, a frame of pandas or polars, a dataset of xarray, a table
of Arrow, or a structured array."""

Texts: TypeAlias = Sequence[tuple[str, str]]

_MOST_RESTORED = 8
_restored: dict[tuple[tuple[str, str], ...], Document] = {}
"""Documents that were restored from pickles, the last one at the end. A worker gets the same document with each of its tasks."""


class Document:
    """A simulation: a document without errors. Documents pickle as their texts."""

    __slots__ = ("__weakref__", "_opened", "_parameters", "_texts", "_title")

    _opened: _core.Opened
    _parameters: list[tuple[str, float | str, str]]
    _texts: list[tuple[str, str]]
    _title: str

    def __init__(self, texts: Texts) -> None:
        """Opens texts with their names, the document first, then its translations. `open` is more convenient."""
        key = tuple((name, text) for name, text in texts)
        known = _restored.get(key)
        if known is None:
            self._open({"texts": key})
            if len(_restored) >= _MOST_RESTORED:
                _restored.pop(next(iter(_restored)), None)
            _restored[key] = self
        else:
            self._opened, self._title, self._texts, self._parameters = known._opened, known._title, known._texts, known._parameters

    def _open(self, source: dict[str, Any]) -> None:
        opened, reply = _core.open_document(json.dumps(source))
        value = answer(reply, _paths([source]))
        assert opened is not None
        self._opened = opened
        self._title = value["title"]
        self._texts = [(name, text) for name, text in value["texts"]]
        self._parameters = value["parameters"]

    def __reduce__(self) -> Any:
        return Document, (self._texts,)

    def __dask_tokenize__(self) -> Texts:
        return self._texts

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Document) and self._texts == other._texts

    def __hash__(self) -> int:
        return hash(self.text)

    def __repr__(self) -> str:
        return f"<Document {self.title}>"

    @property
    def title(self) -> str:
        return self._title

    @property
    def text(self) -> str:
        return self._texts[0][1]

    @property
    def parameters(self) -> dict[str, float | str]:
        """Values of the parameters in their declared units, or their words."""
        return {name: value for name, value, _ in self._parameters}

    @property
    def units(self) -> dict[str, str]:
        """Declared units of the parameters; empty for pure numbers."""
        return {name: unit for name, _, unit in self._parameters}

    def page(self) -> str:
        """Page that plays the document: HTML for any browser, with the source inside."""
        return asked("page", [self._opened], None)[0]

    def _repr_html_(self) -> str:
        """Frame that plays the document in a notebook, also in an exported one, without Python."""
        title, page = (html.escape(text) for text in (self.title, self.page()))
        style = "width: 100%; height: 640px; border: 0; display: block"
        return f'<iframe title="{title}" sandbox="allow-scripts allow-downloads" style="{style}" srcdoc="{page}"></iframe>'

    def widget(self, *, height: int = 640) -> Any:
        """The document in a notebook, as a widget of ``anywidget``. Its ``parameters`` follow the sliders, and the sliders follow them.
        ``height`` in pixels."""
        from .widget import DocumentWidget

        return DocumentWidget(_page=self.page(), title=self.title, parameters=self.parameters, height=height)

    def check(self, *, claims: bool = False) -> list[Diagnostic]:
        """Warnings about the document; with ``claims`` an error for each claim that its runs do not fulfil."""
        return diagnostics(asked("findings", [self._opened], {"claims": claims})[0])

    def run(
        self,
        *,
        until: Value | None = None,
        columns: str | Sequence[str] | None = None,
        set: Mapping[str, Value] | None = None,
        start: Mapping[str, Value] | None = None,
        preset: str | Sequence[str] | None = None,
        press: Mapping[str, Value] | None = None,
        draw: Mapping[str, str | PathLike[str]] | None = None,
        method: str | None = None,
        step: Value | None = None,
        tolerance: float | None = None,
        seat: int | None = None,
        **parameters: Value,
    ) -> Table:
        """Runs the document and returns a table with a row for each step.

        ``until``: end of the run. ``columns``: names of columns, also of constants and parameters. ``set``: parameters with the
        name of an argument. ``start``: values of variables at the start. ``preset``: presets of the document. ``press``: buttons
        with the times at which they are pressed. ``draw``: tables with files of two columns. ``method``, ``step``,
        ``tolerance``: the integration. ``seat``: the seat whose assigned values are taken.
        """
        request = {
            "columns": None if columns is None else names(columns),
            "settings": settings(until, set, start, preset, press, draw, method, step, tolerance, seat, parameters),
        }
        return table(*asked("run", [self._opened], request))

    def sweep(
        self,
        over: Mapping[str, ArrayLike | str] | str | Sequence[str],
        keep: str | Sequence[str],
        *,
        random: int | None = None,
        halton: int | None = None,
        seed: int = 1,
        shard: tuple[int, int] | None = None,
        until: Value | None = None,
        set: Mapping[str, Value] | None = None,
        start: Mapping[str, Value] | None = None,
        preset: str | Sequence[str] | None = None,
        press: Mapping[str, Value] | None = None,
        draw: Mapping[str, str | PathLike[str]] | None = None,
        method: str | None = None,
        step: Value | None = None,
        tolerance: float | None = None,
        seat: int | None = None,
        **parameters: Value,
    ) -> Table:
        """Runs the document with many values of its parameters, on all processors; a row for each run.

        ``over``: values by parameter, ``{"b": [0, 100, 200]}`` in the declared unit, or texts, ``{"b": "0..400 [kg/s] step 2"}``;
        of several, all combinations. ``keep``: numbers that are kept of each run, ``"y at end"`` or ``"maximum(y) from 2 [s]"``.
        ``random`` and ``halton``: so many samples of the ranges instead. ``shard=(3, 16)``: the third of 16 equal parts. Numbers
        of a run that could not be computed are NaN; ``notices`` of the table says why.
        """
        arrays: list[bytes] = []
        stated = settings(until, set, start, preset, press, draw, method, step, tolerance, seat, parameters)
        refuse_both(over, stated)
        request: dict[str, Any] = {
            "prepare": {"over": axes(over, arrays), "keep": names(keep), "settings": stated},
            "seed": operator.index(seed),
        }
        for name, samples in [("random", random), ("halton", halton)]:
            if samples is not None:
                request[name] = operator.index(samples)
        if shard is not None:
            request["shard"] = [operator.index(part) for part in shard]
        return table(*asked("sweep", [self._opened], request, arrays))

    def fit(
        self,
        data: Data | Sequence[Data],
        observe: str | Sequence[str] | Mapping[str, str | int],
        *,
        vary: str | Sequence[str] | None = None,
        fix: Mapping[str, Value | Sequence[Value]] | None = None,
        tie: Mapping[str, Value] | None = None,
        start: Mapping[str, Value | Sequence[Value]] | None = None,
        bounds: Mapping[str, str | tuple[Value | None, Value | None]] | None = None,
        share: str | Sequence[str] | None = None,
        error: Mapping[str, Value] | None = None,
        loss: Literal["least-squares", "huber", "tukey"] = "least-squares",
        begin: Value | None = None,
        until: Value | None = None,
        against: str | Sequence[str] | None = None,
        dates: str | None = None,
        unit: Mapping[str, str] | None = None,
        seat: int | None = None,
        exclude: int | str | Sequence[int | str] | None = None,
        profile: bool = False,
    ) -> Fit:
        """Fits the document to measured data.

        ``observe``: the measured quantity, or the column of each quantity. ``vary``: names of parameters, ``t_origin`` and
        ``y_offset``; without it, those that the document states, and the offset of the readings unless a parameter is such a
        constant. ``fix``: parameters that are held; ``{"y_offset": 0}`` leaves out the offset. ``tie``: parameters that are
        expressions of others, ``{"L2": "2*L1"}``; ``L:2`` is ``L`` in the second record. ``start``, ``bounds``: where is searched; of several starts, ``{"w": [3, 5, 8]}`` or ``{"w": "3..9 step 1"}``, the best search counts. ``share``: numbers
        with one value in all records. ``error``: standard errors, values or columns. ``begin``, ``until``: the fitted part.
        ``against``: the column of the independent variable. ``dates``: the order of dates such as 02/03/2024,
        ``day-first`` or ``month-first``. ``unit``: units of columns that a file does not state. ``exclude``:
        rows that are left out, ``17`` (from 1), ``"20..30"``, ``"t=1.5..2"``, or a column that is not 0 in them. ``profile``: also
        intervals from the profile of chi-square.
        """
        arrays: list[bytes] = []
        measured = records(data, observe, arrays)
        request = {
            "data": measured,
            "settings": fit_settings(observe, vary, fix, tie, start, bounds, share, error, loss, begin, until, against, dates, unit, seat, exclude),
            "profile": bool(profile),
        }
        value, buffers = asked("fit", [self._opened], request, arrays, _paths(measured))
        return fit(value, buffers)


def open(document: str | PathLike[str], *, translations: Sequence[str] = ()) -> Document:
    """Opens a document: a path, a name of `gallery`, or a text. A path is that of a document, a translation, an exported page or a project.
    ``translations``: texts, for a document that is given as a text.

    Raises `DocumentError` if it has errors.
    """
    opened = Document.__new__(Document)
    opened._open(_source(document, translations))
    return opened


def check(document: str | PathLike[str], *, translations: Sequence[str] = ()) -> list[Diagnostic]:
    """All findings about a document, errors and warnings. The arguments are those of `open`."""
    source = _source(document, translations)
    return diagnostics(asked("check", [], source, paths=_paths([source]))[0])


def _source(document: str | PathLike[str], translations: Sequence[str]) -> dict[str, Any]:
    """A path, or texts with names."""
    if not isinstance(document, str) or "\n" not in document:
        return {"path": found(os.fspath(document))}
    numbered = [(f"translation {number}", text) for number, text in enumerate(translations, 1)]
    return {"texts": [("document", document), *numbered]}


def _paths(sources: Sequence[dict[str, Any]]) -> list[str]:
    """Files among documents and records."""
    return [source[key] for source in sources for key in ("path", "file") if key in source]


def rank(
    data: Data | Sequence[Data],
    documents: Sequence[Document],
    observe: str | Sequence[str] | Mapping[str, str | int],
    *,
    predict_from: Value | None = None,
    vary: str | Sequence[str] | None = None,
    fix: Mapping[str, Value | Sequence[Value]] | None = None,
    tie: Mapping[str, Value] | None = None,
    start: Mapping[str, Value | Sequence[Value]] | None = None,
    bounds: Mapping[str, str | tuple[Value | None, Value | None]] | None = None,
    share: str | Sequence[str] | None = None,
    error: Mapping[str, Value] | None = None,
    loss: Literal["least-squares", "huber", "tukey"] = "least-squares",
    begin: Value | None = None,
    until: Value | None = None,
    against: str | Sequence[str] | None = None,
    dates: str | None = None,
    unit: Mapping[str, str] | None = None,
    seat: int | None = None,
    exclude: int | str | Sequence[int | str] | None = None,
) -> list[Fit]:
    """Fits several documents to the same data, best first by AICc.

    ``fit["place"]``, ``fit["delta_aicc"]`` and ``fit["weight"]`` say how they compare. With ``predict_from``, each document is also
    fitted to what is before that time alone, and ``fit["rmse_predicted"]`` is the error of its prediction after it.
    """
    arrays: list[bytes] = []
    measured = records(data, observe, arrays)
    request = {
        "data": measured,
        "settings": fit_settings(observe, vary, fix, tie, start, bounds, share, error, loss, begin, until, against, dates, unit, seat, exclude),
        "predict_from": None if predict_from is None else text(predict_from),
    }
    value, buffers = asked("rank", [document._opened for document in documents], request, arrays, _paths(measured))
    return [fit(one, buffers) for one in value]
