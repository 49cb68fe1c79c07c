"""The compiled part of the package in Pyodide: a module of WebAssembly, called through JavaScript."""

import os
import pathlib

try:
    from js import Float64Array, Object
    from pyodide.code import run_js
    from pyodide.ffi import create_proxy, to_js
    from pyodide_js import checkInterrupt
except ImportError as error:
    raise ImportError("this wheel of meniscus is for Pyodide; on a computer install the wheel for its system") from error

_FOLDER = pathlib.Path(__file__).parent


class _Surroundings:
    """What the module asks of Python."""

    def read(self, path):
        try:
            with open(path, "rb") as file:
                return to_js(file.read())
        except OSError as error:
            return error.strerror or str(error)

    def is_folder(self, path):
        return os.path.isdir(path)

    def names(self, folder):
        try:
            return to_js([entry.name for entry in os.scandir(folder)])
        except OSError:
            return to_js([])

    def player(self):
        path = _FOLDER / "shipped" / "player.html"
        return path.read_text(encoding="utf-8") if path.exists() else None

    def go_on(self):
        checkInterrupt()


def _load():
    module = run_js((_FOLDER / "core.js").read_text(encoding="utf-8") + "\nwasm_bindgen")
    # Compiled at once, as `import` must: browsers allow that for modules of this size, also outside workers.
    module.initSync(to_js({"module": (_FOLDER / "core.wasm").read_bytes()}, dict_converter=Object.fromEntries))
    return module


_module = _load()
_surroundings = create_proxy(_Surroundings())
__version__ = _module.version()
BITS = _module.bits()


class Opened:
    """A document in the module."""

    def __init__(self, number):
        self.number = number

    def __del__(self):
        _module.close(self.number)


def open_document(request):
    """The opened document, or None, and the reply."""
    number, reply, _ = _module.open(_surroundings, request)
    return (Opened(number) if number else None), reply


def call(name, documents, request, numbers):
    """The reply to a request: JSON, and the bytes of its arrays."""
    arrays = to_js([Float64Array.new(to_js(memoryview(array)).buffer) for array in numbers])
    reply, buffers = _module.call(_surroundings, name, to_js([document.number for document in documents]), request, arrays)
    return reply, [buffer.to_bytes() for buffer in buffers]
