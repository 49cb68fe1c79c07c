"""Results of the package as texts by name, the same wherever Python runs. ``test_pyodide.py`` compares those of Pyodide with those of
this Python. Nothing but the package and the standard library is used, and the current folder is that of the project."""

import array
import hashlib
import json
import math
import pathlib
import pickle

import meniscus

SIMULATIONS = pathlib.Path("simulations")

OSCILLATION = """---
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

MORE = """x'(0) = 0
fast = abs(x') > 0.1 [m/s]
side = if x > 0 [m] then "right" else "left"
"""

DAMPED = OSCILLATION.replace("step: 0.001", "step: 0.01").replace("x'(0) = 0\n", MORE)

RUNAWAY = "```model\nparameter a = 1 [1/(m s)]\nx' = a*x^2\nx(0) = 1 [m]\n```\n"


def told(table):
    """Columns, units, labels, notices, and the bits of all values."""
    bits = hashlib.sha256()
    for name in table:
        values = table[name]
        are_texts = len(values) and isinstance(values[0], str)
        bits.update(repr(list(values)).encode() if are_texts else bytes(values))
    about = [table.columns, table.units, table.labels, len(table), table.ended, [str(notice) for notice in table.notices]]
    return f"{json.dumps(about)} {bits.hexdigest()}"


def fitted(fit):
    curves = [told(curve) for curve in fit.curves]
    return f"{fit}\n{json.dumps(fit.summary)}\n{fit.parameters} {fit.derived} {curves}"


def refused(work):
    """The exception of work that cannot be done."""
    try:
        work()
    except Exception as error:
        places = [(one.code, one.file, one.line, one.column, one.text) for one in getattr(error, "diagnostics", [])]
        return f"{type(error).__name__}: {error} {places}"
    raise AssertionError("it was done")


def runs():
    for path in sorted(SIMULATIONS.glob("**/*.md")):
        # Translations have a dot before their language.
        if "." not in path.stem:
            document = meniscus.open(path)
            yield f"run {path.stem}", told(document.run())
            yield f"about {path.stem}", f"{document} {document.parameters} {document.units} {list(map(str, document.check()))}"
    tube = meniscus.open(str(SIMULATIONS / "utube.md"))
    yield "settings", told(tube.run(b="200 kg/s", h_l=4, until=20, columns="t, y, b", start={"y'": "5 cm/s"}, method="rk4", step="10 ms"))
    yield "claims", str(tube.check(claims=True))
    yield "page", hashlib.sha256(tube.page().encode()).hexdigest()


def sweeps():
    tube, keep = meniscus.open(SIMULATIONS / "utube.md"), ["maximum(y) from 2 [s] in [cm]", "y at end"]
    grid = {"b": array.array("d", range(0, 401, 25)), "h_l": "2..4 [m] step 0.5"}
    yield "grid", told(tube.sweep(grid, keep))
    yield "shard", told(tube.sweep(grid, keep, shard=(2, 3)))
    yield "halton", told(tube.sweep(["b in 0..400", "h_l in 2..4"], keep, halton=100))
    yield "random", told(tube.sweep({"b": "0..400"}, keep, random=50, seed=7, until=3))
    yield "words", told(meniscus.open(DAMPED).sweep({"damped": ["on", "off"], "x_0": ["20 mm", 3]}, "x at end", gamma=1.5))
    yield "missing", told(meniscus.open(RUNAWAY).sweep({"a": [0.1, 1]}, "x at end", until=5))


def fits(scratch):
    damped = meniscus.open(DAMPED)
    run = damped.run(gamma=0.7, omega=12, x_0=4, columns="t, x")
    # Errors that look random and are the same everywhere.
    measured = [x + 0.02 * math.fmod(7919 * place, 101) / 101 for place, x in enumerate(run["x"].tolist())]
    record = {"t [s]": run["t"].tolist(), "x [cm]": measured}
    yield "fit", fitted(damped.fit(record, "x"))
    yield "profile", fitted(damped.fit(record, "x", fix={"omega": 12}, bounds={"gamma": (0.1, None)}, profile=True))
    yield "several", fitted(damped.fit([record, run], {"x": "x"}, share="gamma, omega", loss="huber", until="1.5 s"))
    path = pathlib.Path(scratch) / "record.csv"
    path.write_text("t [s],x [cm]\n" + "".join(f"{t!r},{x!r}\n" for t, x in zip(record["t [s]"], measured)))
    yield "file", fitted(damped.fit(path, "x")).replace(str(path), "FILE")
    other = meniscus.open(DAMPED.replace("-2*gamma*x'", "-0.1*gamma*x'"))
    for fit in meniscus.rank(record, [other, damped], "x", predict_from=1.2):
        yield f"ranked {fit['place']}", fitted(fit)


def pickles():
    again = lambda value: pickle.loads(pickle.dumps(value))
    damped = meniscus.open(DAMPED)
    table = damped.run()
    assert again(damped) == damped and told(again(table)) == told(table)
    fit = damped.fit(damped.run(columns=["t", "x"]), "x")
    assert fitted(again(fit)) == fitted(fit)
    yield "pickled", told(again(damped).run())


def errors():
    damped = meniscus.open(DAMPED)
    yield "findings", str(meniscus.check(DAMPED.replace("-2*gamma*x'", "-2*gmma*x'")))
    yield "document", refused(lambda: meniscus.open(DAMPED.replace("-2*gamma*x'", "-2*gmma*x'")))
    yield "run", refused(lambda: meniscus.open(RUNAWAY).run(until=5))
    yield "file", refused(lambda: meniscus.open(SIMULATIONS / "missing.md"))
    yield "folder", refused(lambda: meniscus.open(SIMULATIONS))
    yield "record", refused(lambda: damped.fit("missing.csv", "x"))
    yield "column", refused(lambda: damped.run()["xx"])
    for settings in [{"x0": 1}, {"x_0": "3 kg"}, {"x_0": 100}, {"until": -1}, {"method": "rk5"}, {"set": 3}, {"x_0": [object]}, {"seat": 3}]:
        yield f"refused {list(settings)}", refused(lambda: damped.run(**settings))
    for over, options in [({"gamma": "0..4"}, {}), ({"gama": [1.0]}, {}), ({"gamma": [9.0]}, {}), ({"gamma": [1]}, {"shard": (4, 3)})]:
        yield f"refused {over} {options}", refused(lambda: damped.sweep(over, "x at end", **options))


def results(scratch):
    """All results. ``scratch``: a folder for files."""
    parts = {"runs": runs(), "sweeps": sweeps(), "fits": fits(scratch), "pickles": pickles(), "errors": errors()}
    return {f"{part}: {name}": result for part, found in parts.items() for name, result in found}
