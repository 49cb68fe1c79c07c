"""A site of JupyterLite that needs no network: Pyodide of tests/pyodide, and wheels of pure Python."""

import hashlib
import importlib.metadata
import json
import shutil
import subprocess
import sys

from conftest import ROOT

# Packages of Pyodide that the kernel of JupyterLite loads, and those that a notebook with a widget installs.
KERNEL = ["micropip", "packaging", "ipython", "jedi", "traitlets"]
WIDGETS = ["anywidget", "comm", "ipywidgets", "jupyterlab_widgets", "psygnal", "typing_extensions"]
SETTINGS = {"pyodideUrl": "./pyodide/pyodide.mjs", "disablePyPIFallback": True}


def site(folder, content, wheel):
    """Builds the site with the files of `content`, where `%pip install` finds `wheel`. Returns its folder."""
    settings = {"litePluginSettings": {"@jupyterlite/pyodide-kernel-extension:kernel": SETTINGS}}
    lite = {"jupyter-lite-schema-version": 0, "jupyter-config-data": settings}
    (folder / "jupyter-lite.json").write_text(json.dumps(lite))
    wheels, built = folder / "wheels", folder / "site"
    download(wheels, [f"{name}=={importlib.metadata.version(name)}" for name in WIDGETS])
    words = ["--lite-dir", folder, "--contents", content, "--output-dir", built]
    for path in [*sorted(wheels.iterdir()), wheel]:
        words += ["--piplite-wheels", path]
    # It notes what it has built in the current folder.
    run("jupyterlite_core", "build", *words, where=folder)
    pyodide(built / "pyodide")
    return built


def pyodide(folder):
    """Copies Pyodide, with the packages that the kernel loads."""
    source = ROOT / "tests" / "pyodide" / "node_modules" / "pyodide"
    shutil.copytree(source, folder)
    lock = json.loads((source / "pyodide-lock.json").read_text())
    known, needed, asked = lock["packages"], {}, list(KERNEL)
    while asked:
        name = asked.pop().lower().replace("_", "-")
        if name not in needed:
            needed[name] = known[name]
            asked += known[name]["depends"]
    download(folder, [f"{name}=={package['version']}" for name, package in needed.items()])
    for package in needed.values():
        # The same files as Pyodide's, packed by others.
        package["sha256"] = hashlib.sha256((folder / package["file_name"]).read_bytes()).hexdigest()
    (folder / "pyodide-lock.json").write_text(json.dumps({**lock, "packages": needed}))


def download(folder, packages):
    """Downloads wheels of pure Python."""
    choice = ["--no-deps", "--only-binary=:all:", "--platform", "any", "--python-version", "3.14", "--dest", folder]
    run("pip", "download", "--quiet", *choice, *packages)


def run(module, *words, where=None):
    done = subprocess.run([sys.executable, "-m", module, *map(str, words)], capture_output=True, text=True, timeout=600, cwd=where)
    assert done.returncode == 0, done.stdout + done.stderr
