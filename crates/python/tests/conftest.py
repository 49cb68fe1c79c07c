"""What the tests share: documents, and the program for comparison."""

import csv
import io
import os
import pathlib
import subprocess

import pytest

import meniscus
from everywhere import OSCILLATION as DAMPED

ROOT = pathlib.Path(__file__).parents[3]

@pytest.fixture
def damped():
    return meniscus.open(DAMPED)


@pytest.fixture
def program(tmp_path):
    """Runs the program on a document and returns its table: headings and rows of texts."""
    path = os.environ.get("MENISCUS")
    if path is None:
        pytest.fail("MENISCUS names no program; `cargo build -p meniscus` builds it")

    def table(*words):
        done = subprocess.run([path, *map(str, words)], capture_output=True, text=True, cwd=ROOT)
        assert done.returncode == 0, done.stderr
        head, *rows = csv.reader(io.StringIO(done.stdout))
        return head, rows

    return table


@pytest.fixture(scope="session")
def pyodide_wheel():
    """The wheel for Pyodide."""
    path = os.environ.get("PYODIDE_WHEEL")
    if path is None:
        pytest.fail("PYODIDE_WHEEL names no wheel; `cargo xtask python` builds it")
    return path
