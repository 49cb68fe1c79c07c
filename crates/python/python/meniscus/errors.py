"""Errors, and what is wrong with documents, arguments and runs."""

from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Sequence
from typing import Any, Literal

from . import _core


class Diagnostic:
    """Something that is wrong with a document, an argument or a run: where, why, and what to do."""

    severity: Literal["error", "warning"]
    code: str
    """Stable code, such as ``unknown-name``; empty for a wrong argument."""
    message: str
    remedy: str
    """What to do; empty if nothing is known."""
    notes: list[str]
    file: str
    """File or argument in which it is."""
    line: int | None
    """Line, from 1; ``None`` without a place."""
    column: int | None
    """Column in characters, from 1; ``None`` without a place."""
    text: str
    """The text at the place; empty without a place."""

    def __init__(self, **fields: Any) -> None:
        self.__dict__ = fields

    def _described(self) -> str:
        """Message, place and remedy."""
        place = "" if self.line is None else f"{self.file}:{self.line}:{self.column}: "
        return "\n  ".join([place + self.message, *self.notes, *filter(None, [self.remedy])])

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Diagnostic) and self.__dict__ == other.__dict__

    def __hash__(self) -> int:
        return hash((self.message, self.file, self.line, self.column))

    def __str__(self) -> str:
        return f"{self.severity}: {self._described()}"

    def __repr__(self) -> str:
        return f"<Diagnostic {self}>"


class MeniscusError(Exception):
    """Base of the errors of this package. The message says what happened, where, and what to do."""

    def __init__(self, message: str = "", diagnostics: Iterable[Diagnostic] = ()) -> None:
        super().__init__(message)
        self.diagnostics: list[Diagnostic] = list(diagnostics)


class DocumentError(MeniscusError):
    """A document has errors."""


class SettingError(MeniscusError):
    """An argument is wrong, or a file cannot be read."""


class MissingFileError(SettingError, FileNotFoundError):
    """There is no such file."""


class RunError(MeniscusError):
    """A run cannot start or continue."""


_EXCEPTIONS: dict[str, type[BaseException]] = {
    error.__name__: error for error in [DocumentError, SettingError, RunError, ValueError, TypeError, KeyboardInterrupt]
}


# Made once, and without a look for circles, which requests do not have: of a short sweep JSON is a tenth of the time.
_written = json.JSONEncoder(check_circular=False).encode
_read = json.JSONDecoder().raw_decode


def answer(reply: str, paths: Iterable[str] = ()) -> Any:
    """The answer in a reply, or the exception that it stands for. ``paths``: the files of the request."""
    value, _ = _read(reply)
    if isinstance(value, dict) and "error" in value:
        error, found = _EXCEPTIONS[value["error"]], diagnostics(value["diagnostics"])
        if not issubclass(error, MeniscusError):
            raise error(value["message"])
        if error is SettingError and not all(map(os.path.exists, paths)):
            error = MissingFileError
        # Warnings are among the diagnostics, not in the message.
        raise error("\n".join(one._described() for one in found if one.severity == "error"), found)
    return value


def asked(
    name: str, documents: list[_core.Opened], request: object, numbers: Sequence[bytes] = (), paths: Iterable[str] = ()
) -> tuple[Any, Iterator[bytes]]:
    """Answer of the compiled part, and the bytes of its arrays. ``paths``: the files of the request."""
    reply, buffers = _core.call(name, documents, _written(request), numbers)
    return answer(reply, paths), iter(buffers)


def diagnostics(found: Iterable[dict[str, Any]]) -> list[Diagnostic]:
    return [Diagnostic(**fields) for fields in found]
