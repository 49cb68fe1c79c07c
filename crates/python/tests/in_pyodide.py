"""What is different in Pyodide, run there by ``test_pyodide.py``; then all results of ``everywhere.py`` as JSON."""

import json
import sys

import js

import everywhere
import meniscus
from meniscus import _core

damped = meniscus.open(everywhere.DAMPED)

# Columns without numpy.
assert "numpy" not in sys.modules
table = damped.run()
assert isinstance(table["x"], memoryview) and table["x"].readonly and table["x"][0] == 2.0
assert table["fast"].tolist()[0] is False and table["side"][0] == "right"

# The module forgets documents that Python has forgotten.
numbers = [meniscus.open(everywhere.DAMPED)._opened.number for _ in range(3)]
assert numbers == numbers[:1] * 3

# A run can be interrupted.
js.interruptAfter(100)
try:
    damped.run(until=1e9, columns="t")
    raise AssertionError("it came to its end")
except KeyboardInterrupt:
    pass
assert len(damped.run()) == len(table)

assert not hasattr(table, "__arrow_c_stream__")
print(json.dumps(everywhere.results("/tmp")))
