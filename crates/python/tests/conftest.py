"""What the tests share: documents, and the program for comparison."""

import csv
import io
import os
import pathlib
import subprocess

import pytest

import meniscus

ROOT = pathlib.Path(__file__).parents[3]

DAMPED = """---
title: Damped oscillation
until: 2 [s]
step: 0.001
vary: gamma, omega, x_0
---

```model
parameter gamma = 0.3 [1/s] in 0..5 "Damping rate"
parameter omega = 10 [rad/s] in 1..100 "Natural angular frequency"
parameter x_0 = 2 [cm] in 1..9 "Displacement at the start"
switch damped = on

x'' = if damped then -2*gamma*x' - omega^2*x else -omega^2*x
x(0) = x_0 in [cm] "Displacement"
x'(0) = 0
```
"""


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
