"""Simulations of oscillations from text documents: runs, sweeps and fits with units.

A value is a number in the declared unit of the parameter, a text with its own unit (``"3 cm"``), or a quantity of Pint. Results are
in the declared units. Long work releases the lock of the interpreter and can be interrupted.
"""

from collections.abc import Iterator, Mapping, Sequence
from os import PathLike
from typing import Any, Literal, SupportsFloat, TypeAlias

from numpy.typing import ArrayLike, NDArray

__version__: str

Value: TypeAlias = SupportsFloat | str | bool
"""A number in the declared unit, a text with its own unit, a word of a choice, or the position of a switch."""

Data: TypeAlias = str | PathLike[str] | Table | Mapping[str, ArrayLike]
"""Measured data: a file, or columns by heading, such as ``"t [s]"``."""

class MeniscusError(Exception):
    """Base of the errors of this package. The message says what happened, where, and what to do."""

    diagnostics: list[Diagnostic]

class DocumentError(MeniscusError):
    """A document has errors."""

class SettingError(MeniscusError):
    """An argument is wrong, or a file cannot be read."""

class RunError(MeniscusError):
    """A run cannot start or continue."""

class Diagnostic:
    """Something that is wrong with a document, an argument or a run: where, why, and what to do."""

    @property
    def severity(self) -> Literal["error", "warning"]: ...
    @property
    def code(self) -> str:
        """Stable code, such as ``unknown-name``; empty for a wrong argument."""
    @property
    def message(self) -> str: ...
    @property
    def remedy(self) -> str:
        """What to do; empty if nothing is known."""
    @property
    def notes(self) -> list[str]: ...
    @property
    def file(self) -> str:
        """File or argument in which it is."""
    @property
    def line(self) -> int | None:
        """Line, from 1; ``None`` without a place."""
    @property
    def column(self) -> int | None:
        """Column in characters, from 1; ``None`` without a place."""
    @property
    def text(self) -> str:
        """The text at the place; empty without a place."""

class Table:
    """Columns with names and units, as a run or a sweep gives them.

    ``table["y"]`` is a column as an array of numpy that cannot be written; ``len(table)`` is the number of rows, and ``dict(table)``
    has all arrays. Arrays and Arrow share one memory. A number without a value is NaN, in Arrow null.
    """

    @property
    def columns(self) -> list[str]: ...
    @property
    def units(self) -> dict[str, str]:
        """Unit of each column; empty for pure numbers."""
    @property
    def labels(self) -> dict[str, str]:
        """Label of each column that the author has given one."""
    @property
    def notices(self) -> list[Diagnostic]:
        """Warnings about the run, such as a step that is too long, or about runs of a sweep that could not be computed."""
    @property
    def ended(self) -> str | None:
        """Message of the event that ended the run before its time."""
    def keys(self) -> list[str]: ...
    def __getitem__(self, name: str) -> NDArray[Any]: ...
    def __contains__(self, name: str) -> bool: ...
    def __iter__(self) -> Iterator[str]: ...
    def __len__(self) -> int: ...
    def to_pandas(self, *, headings: bool = False) -> Any:
        """DataFrame of pandas, with ``attrs["units"]``; with ``headings`` its columns are called ``y [m]``."""
    def to_xarray(self) -> Any:
        """Dataset of xarray along the first column, with units in the attributes."""
    def to_arrow(self) -> Any:
        """Table of pyarrow, with units in the metadata of its fields."""
    def __arrow_c_stream__(self, requested_schema: object | None = None) -> object: ...

class Estimate:
    """A fitted number with its standard error, in its unit. ``float(estimate)`` is its value."""

    @property
    def value(self) -> float | None:
        """Value; ``None`` if the data do not determine it."""
    @property
    def stderr(self) -> float | None:
        """Standard error; also right for residuals that are correlated in time."""
    @property
    def unit(self) -> str: ...
    def __float__(self) -> float: ...

class Fit:
    """A fit. ``print(fit)`` shows it as the command line does."""

    @property
    def parameters(self) -> dict[str, Estimate]:
        """Fitted parameters that hold for all records."""
    @property
    def derived(self) -> dict[str, Estimate]:
        """Quantities that follow from the parameters."""
    @property
    def summary(self) -> dict[str, Any]:
        """All results, with the keys of ``meniscus fit --format json`` and ``meniscus rank --format json``."""
    @property
    def curves(self) -> list[Table]:
        """For each observed quantity of each record: time, measured, fitted, residual, and whether the row was fitted."""
    def __getitem__(self, key: str) -> Any: ...

class Document:
    """A simulation: a document without errors. Documents pickle as their texts."""

    def __init__(self, texts: Sequence[tuple[str, str]]) -> None:
        """Opens texts with their names, the document first, then its translations. `open` is more convenient."""
    @property
    def title(self) -> str: ...
    @property
    def text(self) -> str: ...
    @property
    def parameters(self) -> dict[str, float | str]:
        """Values of the parameters in their declared units, or their words."""
    @property
    def units(self) -> dict[str, str]:
        """Declared units of the parameters; empty for pure numbers."""
    def page(self) -> str:
        """Page that plays the document: HTML for any browser, with the source inside."""
    def widget(self, *, height: int = 640) -> Any:
        """The document in a notebook, as a widget of ``anywidget``. Its ``parameters`` follow the sliders, and the sliders follow them.
        ``height`` in pixels."""
    def check(self, *, claims: bool = False) -> list[Diagnostic]:
        """Warnings about the document; with ``claims`` an error for each claim that its runs do not fulfil."""
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
    def fit(
        self,
        data: Data | Sequence[Data],
        observe: str | Sequence[str] | Mapping[str, str | int],
        *,
        vary: str | Sequence[str] | None = None,
        fix: Mapping[str, Value | Sequence[Value]] | None = None,
        start: Mapping[str, Value] | None = None,
        bounds: Mapping[str, str | tuple[Value | None, Value | None]] | None = None,
        share: str | Sequence[str] | None = None,
        error: Mapping[str, Value] | None = None,
        loss: Literal["least-squares", "huber", "tukey"] = "least-squares",
        begin: Value | None = None,
        until: Value | None = None,
        against: str | Sequence[str] | None = None,
        unit: Mapping[str, str] | None = None,
        seat: int | None = None,
        profile: bool = False,
    ) -> Fit:
        """Fits the document to measured data.

        ``observe``: the measured quantity, or the column of each quantity. ``vary``: names of parameters, ``t_origin`` and
        ``y_offset``; without it, those that the document states. ``fix``: parameters that are held. ``start``, ``bounds``: where
        is searched. ``share``: numbers with one value in all records. ``error``: standard errors, values or columns. ``begin``,
        ``until``: the fitted part. ``against``: the column of the independent variable. ``unit``: units of columns that a file
        does not state. ``profile``: also intervals from the profile of chi-square.
        """
    def __hash__(self) -> int: ...

def open(document: str | PathLike[str], *, translations: Sequence[str] = ()) -> Document:
    """Opens a document: a path, or its text. A path is that of a document, a translation, an exported page or a project.

    Raises `DocumentError` if it has errors.
    """

def check(document: str | PathLike[str], *, translations: Sequence[str] = ()) -> list[Diagnostic]:
    """All findings about a document, errors and warnings."""

def rank(
    data: Data | Sequence[Data],
    documents: Sequence[Document],
    observe: str | Sequence[str] | Mapping[str, str | int],
    *,
    predict_from: Value | None = None,
    vary: str | Sequence[str] | None = None,
    fix: Mapping[str, Value | Sequence[Value]] | None = None,
    start: Mapping[str, Value] | None = None,
    bounds: Mapping[str, str | tuple[Value | None, Value | None]] | None = None,
    share: str | Sequence[str] | None = None,
    error: Mapping[str, Value] | None = None,
    loss: Literal["least-squares", "huber", "tukey"] = "least-squares",
    begin: Value | None = None,
    until: Value | None = None,
    against: str | Sequence[str] | None = None,
    unit: Mapping[str, str] | None = None,
    seat: int | None = None,
) -> list[Fit]:
    """Fits several documents to the same data, best first by AICc.

    ``fit["place"]``, ``fit["delta_aicc"]`` and ``fit["weight"]`` say how they compare. With ``predict_from``, each document is also
    fitted to what is before that time alone, and ``fit["rmse_predicted"]`` is the error of its prediction after it.
    """
