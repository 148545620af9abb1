"""What MORSE's Python client, pymorse, needs to run with today's Python. No file of it is changed.

Since Python 3.8 its close() fails: it looks at all attributes of a component, and one of them is the
component's class, whose lazy_init it calls without an object. Python before 3.8 let that pass.
Since Python 3.12 asyncore and asynchat are gone, which it needs to be imported.

This file needs nothing but Python's own library, so that it can be loaded from anywhere.
"""

import importlib.abc
import importlib.util
import os
import sys

_CLIENT = "pymorse.pymorse"


def patch_component(component_class):
    """Lets the attributes of a component be looked at, whatever they are."""
    if getattr(component_class, "_ccmorse_shim", False):
        return

    def getattribute(self, name):
        value = object.__getattribute__(self, name)
        if not isinstance(value, type) and hasattr(value, "lazy_init"):
            value.lazy_init()
        return value

    component_class.__getattribute__ = getattribute
    component_class._ccmorse_shim = True


def patch(module):
    """`module` is pymorse.pymorse, just imported."""
    patch_component(module.Component)
    # Tests run at the same time need a port each (morse.testing sets this).
    port = os.environ.get("CCMORSE_PORT")
    if port and port != "0":
        module.Morse.__init__.__defaults__ = ("localhost", int(port))


def set_port(port):
    """What Morse() connects to when it is told nothing, from now on."""
    os.environ["CCMORSE_PORT"] = str(port)
    if _CLIENT in sys.modules:
        patch(sys.modules[_CLIENT])


class _Finder(importlib.abc.MetaPathFinder):
    """Finds what others would, and patches pymorse once it is loaded."""

    def find_spec(self, fullname, path=None, target=None):
        if fullname != _CLIENT:
            return None
        for finder in sys.meta_path:
            if isinstance(finder, _Finder) or not hasattr(finder, "find_spec"):
                continue
            spec = finder.find_spec(fullname, path, target)
            if spec is not None and spec.loader is not None:
                spec.loader = _Loader(spec.loader)
                return spec
        return None


class _Loader(importlib.abc.Loader):
    def __init__(self, loader):
        self._loader = loader

    def create_module(self, spec):
        return self._loader.create_module(spec)

    def exec_module(self, module):
        self._loader.exec_module(module)
        patch(module)

    def __getattr__(self, name):
        return getattr(self._loader, name)


def _provide(name):
    """Our own module of this name, where Python has none any more."""
    if importlib.util.find_spec(name) is None:
        folder = os.path.join(os.path.dirname(os.path.abspath(__file__)), "removed")
        spec = importlib.util.spec_from_file_location(name, os.path.join(folder, name + ".py"))
        module = importlib.util.module_from_spec(spec)
        sys.modules[name] = module
        spec.loader.exec_module(module)


def install():
    """To be called before pymorse is imported; after that it does no harm."""
    if _CLIENT in sys.modules:
        patch(sys.modules[_CLIENT])
    elif not any(isinstance(finder, _Finder) for finder in sys.meta_path):
        sys.meta_path.insert(0, _Finder())
    for name in ("asyncore", "asynchat"):
        if sys.version_info >= (3, 12) and name not in sys.modules:
            _provide(name)
