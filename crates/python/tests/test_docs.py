"""The examples of docs/python.md run."""

import re
import sys
import types

import numpy
import pytest

import meniscus
from conftest import ROOT

BLOCKS = re.findall(r"```python\n(.*?)```", (ROOT / "docs" / "python.md").read_text(encoding="utf-8"), re.DOTALL)


@pytest.mark.parametrize("block", [block for block in BLOCKS if "dask" not in block and "ray" not in block.split()])
def test_an_example_runs(block, tmp_path, monkeypatch):
    linear, quadratic = (meniscus.open(ROOT / "simulations" / "theories" / name) for name in ["linear.md", "quadratic.md"])
    run = linear.run(columns="t, y", until=8)
    run.to_pandas(headings=True).to_csv(tmp_path / "run3.txt", index=False)
    monkeypatch.chdir(tmp_path)
    for folder in ["simulations"]:
        (tmp_path / folder).symlink_to(ROOT / folder, target_is_directory=True)
    drawn = []
    figures = types.SimpleNamespace(plot=lambda *data: drawn.append(data), xlabel=lambda name: None, ylabel=lambda name: None)
    monkeypatch.setitem(sys.modules, "matplotlib", types.SimpleNamespace(pyplot=figures))
    monkeypatch.setitem(sys.modules, "matplotlib.pyplot", figures)
    document = linear if "fit(" in block else meniscus.open(ROOT / "simulations" / "utube.md")
    names = {"meniscus": meniscus, "document": document, "linear": linear, "quadratic": quadratic, "t": run["t"], "y": run["y"]}
    # Fewer growth rates, which is quicker.
    block = block.replace("4, 1000)", "4, 200)")
    exec(compile(block, "docs/python.md", "exec"), names)
    if drawn:
        assert len(drawn) == 20 and all(numpy.isfinite(data[1]).all() and len(data[0]) == 200 for data in drawn)
        # A fixed point below 3, two values up to 3.449, chaos at 4: as R. M. May, Nature 261 (1976), 459.
        for growth, values in [(2.9, 1), (3.3, 2), (3.5, 4)]:
            place = numpy.argmin(abs(drawn[0][0] - growth))
            assert len({round(float(data[1][place]), 6) for data in drawn}) == values
