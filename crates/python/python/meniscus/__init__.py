"""Simulations of oscillations from text documents: runs, sweeps and fits with units.

A value is a number in the declared unit of the parameter, a text with its own unit (``"3 cm"``), or a quantity of Pint. Results are
in the declared units. Long work releases the lock of the interpreter and can be interrupted.
"""

from ._core import BITS, __version__
from .document import Document, check, open, rank
from .errors import Diagnostic, DocumentError, MeniscusError, MissingFileError, RunError, SettingError
from .fit import Estimate, Fit
from .table import Table

__all__ = [
    "BITS",
    "Diagnostic",
    "Document",
    "DocumentError",
    "Estimate",
    "Fit",
    "MeniscusError",
    "MissingFileError",
    "RunError",
    "SettingError",
    "Table",
    "__version__",
    "check",
    "open",
    "rank",
]

# Messages and pickles name the package, not its files.
for _public in [Diagnostic, Document, DocumentError, Estimate, Fit, MeniscusError, MissingFileError, RunError, SettingError, Table, check, open, rank]:
    _public.__module__ = __name__
