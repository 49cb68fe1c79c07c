"""Simulations of oscillations from text documents: runs, sweeps and fits with units.

A value is a number in the declared unit of the parameter, a text with its own unit (``"3 cm"``), or a quantity of Pint. Results are
in the declared units. Long work releases the lock of the interpreter and can be interrupted.
"""

import pathlib as _pathlib

# The distribution is named otherwise than the package: another project has its name on PyPI.
_OTHER = next(_pathlib.Path(__file__).parent.parent.glob("meniscus-*.dist-info"), None)
if _OTHER is not None:
    raise ImportError(
        f"{_OTHER.name} is another distribution with a package `meniscus`, installed in the same place: "
        "pip uninstall meniscus meniscus-lab, then pip install meniscus-lab"
    )

from ._core import BITS, __version__
from .document import Document, check, open, rank
from .errors import Diagnostic, DocumentError, MeniscusError, MissingFileError, RunError, SettingError
from .fit import Estimate, Fit
from .gallery import gallery
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
    "gallery",
    "open",
    "rank",
]

# Messages and pickles name the package, not its files.
for _public in [Diagnostic, Document, DocumentError, Estimate, Fit, MeniscusError, MissingFileError, RunError, SettingError, Table, check, gallery, open, rank]:
    _public.__module__ = __name__
