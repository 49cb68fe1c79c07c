"""The widget, in Python and where a person uses it: JupyterLab, JupyterLite, marimo."""

import contextlib
import functools
import html
import http.server
import os
import pathlib
import re
import shutil
import socket
import subprocess
import sys
import threading
import time
import urllib.request

import nbformat
import pytest

import lite
import meniscus
from conftest import DAMPED

WIDGET = f"import meniscus\nwidget = meniscus.open({DAMPED!r}).widget(height=500)"
# Python answers each change of the damping with another displacement.
ANSWER = """def answer(change):
    asked = 2 + change.new["gamma"]
    if abs(change.new["x_0"] - asked) > 1e-9:
        widget.set(x_0=asked)

widget.observe(answer, "parameters")"""
MOVE = "widget.set(omega=20)"
MARIMO = '''import marimo
app = marimo.App()

@app.cell
def _():
{widget}
{answer}
    widget
    return (widget,)

@app.cell
def _(widget):
    import marimo
    marimo.ui.button(label="Move", on_click=lambda _: {move})
    return
'''


def test_a_page_has_the_document(damped):
    page = damped.page()
    assert page.startswith("<!doctype html>") and "<title>Damped oscillation</title>" in page
    assert meniscus.open(damped.text) == damped


def test_a_document_in_a_cell_is_a_frame_with_its_page(damped):
    shown = damped._repr_html_()
    assert shown.startswith('<iframe title="Damped oscillation" sandbox="allow-scripts')
    assert html.unescape(re.search(r'srcdoc="([^"]*)"', shown)[1]) == damped.page()


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


def test_a_slider_reaches_python_and_python_a_slider_in_jupyterlab(tmp_path):
    notebook(tmp_path, "python3")
    port = free()
    settings = [f"--ServerApp.root_dir={tmp_path}", f"--ServerApp.port={port}", "--IdentityProvider.token=", "--allow-root"]
    settings += ["--LabApp.news_url=None", "--LabApp.check_for_updates_class=jupyterlab.NeverCheckForUpdate"]
    own = {name: str(tmp_path / name) for name in ["JUPYTER_CONFIG_DIR", "JUPYTER_RUNTIME_DIR", "JUPYTERLAB_SETTINGS_DIR"]}
    with server(tmp_path, ["jupyterlab", "--no-browser", *settings], f"http://127.0.0.1:{port}", own) as address:
        person("cells", f"{address}/lab/tree/widget.ipynb")


def test_a_slider_reaches_python_and_python_a_slider_in_jupyterlite(tmp_path, pyodide_wheel):
    content = tmp_path / "content"
    content.mkdir()
    # Pyodide's numpy, which the wheel asks for, is not among the wheels of pure Python; the package works without it.
    notebook(content, "python", "%pip install -q anywidget\nimport piplite\nawait piplite.install('meniscus-lab', deps=False)\n")
    site = lite.site(tmp_path, content, pyodide_wheel)
    handler = functools.partial(http.server.SimpleHTTPRequestHandler, directory=site)
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), handler) as running:
        threading.Thread(target=running.serve_forever, daemon=True).start()
        try:
            person("cells", f"http://127.0.0.1:{running.server_port}/lab/index.html?path=widget.ipynb")
        finally:
            running.shutdown()


def test_a_slider_reaches_python_and_python_a_slider_in_marimo(tmp_path):
    indented = {name: "\n".join("    " + line for line in code.split("\n")) for name, code in [("widget", WIDGET), ("answer", ANSWER)]}
    (tmp_path / "app.py").write_text(MARIMO.format(**indented, move=MOVE))
    port = free()
    words = ["marimo", "run", "app.py", "--headless", "--no-token", "--port", str(port)]
    with server(tmp_path, words, f"http://127.0.0.1:{port}", {"HOME": str(tmp_path)}) as address:
        person("button", address)


def notebook(folder, kernel, before=""):
    cells = [nbformat.v4.new_code_cell(cell) for cell in [f"{before}{WIDGET}\nwidget", ANSWER, MOVE]]
    kernel = {"kernelspec": {"name": kernel, "display_name": "Python", "language": "python"}}
    nbformat.write(nbformat.v4.new_notebook(cells=cells, metadata=kernel), folder / "widget.ipynb")


def person(mode, address):
    """Lets a browser do what a person does with the widget."""
    browser = os.environ.get("CHROME")
    if browser is None:
        pytest.fail("CHROME names no browser")
    script = pathlib.Path(__file__).with_name("widget.mjs")
    done = subprocess.run([shutil.which("node"), script, browser, mode, address], capture_output=True, text=True, timeout=600)
    print(done.stdout)
    assert done.returncode == 0, done.stdout + done.stderr


def free():
    with socket.socket() as one:
        one.bind(("127.0.0.1", 0))
        return one.getsockname()[1]


@contextlib.contextmanager
def server(folder, words, address, own):
    """A module of Python that serves notebooks, in a folder; its address once it answers."""
    log = folder / "log"
    words = [sys.executable, "-m", *words]
    with open(log, "w") as said, subprocess.Popen(words, stdout=said, stderr=said, cwd=folder, env={**os.environ, **own}) as running:
        try:
            for _ in range(600):
                with contextlib.suppress(OSError):
                    urllib.request.urlopen(address).close()
                    break
                time.sleep(0.1)
            else:
                pytest.fail(f"{words[2]} does not answer:\n{log.read_text()}")
            yield address
        finally:
            running.terminate()
