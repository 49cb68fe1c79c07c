"""The notebooks of the documentation run, and the widget works in JupyterLab."""

import os
import pathlib
import shutil
import socket
import subprocess
import sys
import time
import urllib.request

import nbclient
import nbformat
import pytest

import meniscus
from conftest import DAMPED, ROOT

NOTEBOOKS = sorted((ROOT / "docs" / "notebooks").glob("*.ipynb"))

# Python answers each change of the damping with another displacement.
CELLS = [
    f"import meniscus\nwidget = meniscus.open({DAMPED!r}).widget(height=500)\nwidget",
    """def answer(change):
    asked = 2 + change.new["gamma"]
    if abs(change.new["x_0"] - asked) > 1e-9:
        widget.set(x_0=asked)

widget.observe(answer, "parameters")""",
    "widget.set(omega=20)",
]


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(path, tmp_path):
    folder = tmp_path / "docs" / "notebooks"
    folder.mkdir(parents=True)
    (tmp_path / "simulations").symlink_to(ROOT / "simulations", target_is_directory=True)
    notebook = nbformat.read(path, as_version=4)
    nbclient.NotebookClient(notebook, timeout=900, resources={"metadata": {"path": str(folder)}}).execute()


def test_a_page_has_the_document(damped):
    page = damped.page()
    assert page.startswith("<!doctype html>") and "<title>Damped oscillation</title>" in page
    assert meniscus.open(damped.text) == damped


def test_a_widget_has_the_parameters(damped):
    widget = damped.widget(height=300)
    assert (widget.height, widget.title) == (300, "Damped oscillation")
    assert widget.parameters == {"gamma": 0.3, "omega": 10, "x_0": pytest.approx(2), "damped": "on"}
    widget.set(gamma=0.5)
    assert widget.parameters["gamma"] == 0.5 and widget.parameters["omega"] == 10


def test_the_widget_says_what_it_needs(damped):
    code = "import sys; sys.modules['anywidget'] = None; import meniscus; meniscus.open(sys.stdin.read()).widget()"
    done = subprocess.run([sys.executable, "-c", code], input=damped.text, capture_output=True, text=True)
    assert "the widget needs anywidget: pip install anywidget" in done.stderr


def test_a_slider_reaches_python_and_python_a_slider(tmp_path):
    browser = os.environ.get("CHROME")
    if browser is None:
        pytest.fail("CHROME names no browser")
    cells = [nbformat.v4.new_code_cell(cell) for cell in CELLS]
    kernel = {"kernelspec": {"name": "python3", "display_name": "Python 3", "language": "python"}}
    nbformat.write(nbformat.v4.new_notebook(cells=cells, metadata=kernel), tmp_path / "widget.ipynb")
    with socket.socket() as free:
        free.bind(("127.0.0.1", 0))
        port = free.getsockname()[1]
    address = f"http://127.0.0.1:{port}"
    settings = [f"--ServerApp.root_dir={tmp_path}", f"--ServerApp.port={port}", "--IdentityProvider.token=", "--allow-root"]
    settings += ["--LabApp.news_url=None", "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate"]
    own = {name: str(tmp_path / name) for name in ["JUPYTER_CONFIG_DIR", "JUPYTER_RUNTIME_DIR", "JUPYTERLAB_SETTINGS_DIR"]}
    server = [sys.executable, "-m", "jupyterlab", "--no-browser", *settings]
    with open(tmp_path / "log", "w") as log, subprocess.Popen(server, stdout=log, stderr=log, env={**os.environ, **own}) as running:
        try:
            wait_for(address, tmp_path / "log")
            script = pathlib.Path(__file__).with_name("jupyterlab.mjs")
            done = subprocess.run([shutil.which("node"), script, browser, address], capture_output=True, text=True, timeout=300)
            print(done.stdout)
            assert done.returncode == 0, done.stdout + done.stderr
        finally:
            running.terminate()


def wait_for(address, log):
    for _ in range(600):
        try:
            urllib.request.urlopen(f"{address}/api").close()
            return
        except OSError:
            time.sleep(0.1)
    pytest.fail(f"JupyterLab does not answer:\n{log.read_text()}")
