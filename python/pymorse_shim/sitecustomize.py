"""Loaded by Python as it starts, where `ccmorse pymorse-shim` is in PYTHONPATH (docs/morse.md)."""

import importlib.util
import os
import sys

_FOLDER = os.path.dirname(os.path.abspath(__file__))


def _load(name, file):
    spec = importlib.util.spec_from_file_location(name, file)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _next_sitecustomize():
    """The one that Python would have loaded without us, say the system's."""
    for folder in sys.path:
        file = os.path.join(folder, "sitecustomize.py")
        if os.path.abspath(folder or ".") != _FOLDER and os.path.exists(file):
            _load("sitecustomize", file)
            return


# By its file, not as morse.testing: a package morse may be another one in this program.
_load("_ccmorse_pymorse_shim",
      os.path.join(os.path.dirname(_FOLDER), "morse", "testing", "pymorse_shim.py")).install()
_next_sitecustomize()
