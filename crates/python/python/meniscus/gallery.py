"""The simulations that come with the package."""

from __future__ import annotations

import os
import pathlib

_FOLDER = pathlib.Path(__file__).parent / "shipped" / "simulations"


def _files() -> dict[str, pathlib.Path]:
    """Files of the documents by name. A translation, ``utube.es.md``, has no name of its own."""
    return {path.stem: path for path in sorted(_FOLDER.rglob("*.md")) if "." not in path.stem}


def gallery() -> dict[str, str]:
    """Titles of the simulations that come with the package, by the names that `open` takes."""

    def title(path: pathlib.Path) -> str:
        lines = path.read_text(encoding="utf-8").splitlines()
        return next(line.removeprefix("title:").strip() for line in lines if line.startswith("title:"))

    return {name: title(path) for name, path in _files().items()}


def found(document: str) -> str:
    """Path of a document: of a file, else of a simulation of the gallery with this name."""
    own = None if os.path.exists(document) else _files().get(document)
    return document if own is None else os.fspath(own)
