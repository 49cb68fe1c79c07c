"""The package for Pyodide gives the same results as this one."""

import json
import shutil
import subprocess
import sys
import zipfile

import everywhere
from conftest import ROOT


def test_pyodide_gives_the_same_results(pyodide_wheel, tmp_path, monkeypatch):
    monkeypatch.chdir(ROOT)
    script = ROOT / "tests" / "pyodide" / "run.mjs"
    program = ROOT / "crates" / "python" / "tests" / "in_pyodide.py"
    done = subprocess.run([shutil.which("node"), script, pyodide_wheel, ROOT, program], capture_output=True, text=True, timeout=600)
    assert done.returncode == 0, done.stdout[-2000:] + done.stderr[-4000:]
    found, expected = json.loads(done.stdout), everywhere.results(tmp_path)
    assert list(found) == list(expected) and len(found) > 100
    for name, result in expected.items():
        assert found[name] == result, name


def test_the_wheel_has_what_it_lists(pyodide_wheel):
    with zipfile.ZipFile(pyodide_wheel) as archive:
        assert archive.testzip() is None
        [record] = [name for name in archive.namelist() if name.endswith("/RECORD")]
        listed = [line.split(",")[0] for line in archive.read(record).decode().splitlines()]
        assert sorted(listed) == sorted(archive.namelist())
        assert "meniscus/core.wasm" in listed and not any(name.endswith(".so") for name in listed)


def test_the_wheel_says_where_it_belongs(pyodide_wheel, tmp_path):
    with zipfile.ZipFile(pyodide_wheel) as archive:
        archive.extractall(tmp_path)
    done = subprocess.run([sys.executable, "-c", "import meniscus"], capture_output=True, text=True, cwd=tmp_path)
    assert "this wheel of meniscus is for Pyodide" in done.stderr
