"""What the compiled parts of the package have: of Rust on a computer, of WebAssembly and JavaScript in Pyodide."""

from collections.abc import Sequence

__version__: str

BITS: int
"""Number of the bits of all results: two programs with the same number give results that are equal to the last bit."""

class Opened:
    """An opened document."""

def open_document(request: str) -> tuple[Opened | None, str]:
    """The opened document, or ``None``, and the reply."""

def call(name: str, documents: Sequence[Opened], request: str, numbers: Sequence[bytes]) -> tuple[str, list[bytes]]:
    """The reply to a request: JSON, and the bytes of its arrays. ``numbers``: arrays of numbers of 8 bytes, in the order of the
    machine."""

def arrow_stream(columns: Sequence[tuple[str, str, str, str, object]], rows: int) -> object:
    """Capsule with the columns of a table as a stream of Arrow. Not in Pyodide."""
