"""What is to be known of a component's class before it runs."""

import importlib
import inspect
import math
import os


def _declared(cls, kind):
    """Declarations of a class and those that it derives from, later ones in earlier ones' places."""
    found = {}
    for each in reversed(cls.__mro__):
        for entry in each.__dict__.get(kind, ()):
            found[entry[0]] = entry
    return list(found.values())


def fields_of(cls, level=""):
    """(name, default, type, doc, levels) of the data that a level has."""
    return [field for field in _declared(cls, "_declared_data")
            if "all" in field[4] or not level or level in field[4]]


def properties_of(cls):
    """(attribute, default, name, type, doc)"""
    return _declared(cls, "_declared_properties")


def levels_of(cls):
    """(name, classpath or None, doc, default)"""
    return _declared(cls, "_declared_levels")


def services_of(cls):
    """Name of a service -> method of the class."""
    found = {}
    for name in dir(cls):
        method = inspect.getattr_static(cls, name)
        if hasattr(method, "_morse_service"):
            found[method._morse_service] = method
    return found


def load(classpath):
    """The class of a path "package.module.Class". Raises what the import raises."""
    module, _, name = classpath.rpartition(".")
    if not module:
        raise ImportError("%r names no class: it must be package.module.Class" % classpath)
    return getattr(importlib.import_module(module), name)


def level_class(cls, level):
    """The class that has a level, and the level's name: the one as delivered where `level` is ""."""
    levels = levels_of(cls)
    for name, path, _, default in levels:
        if name == level or (not level and default):
            return (load(path) if path else cls), name
    return cls, level if not levels else (level or levels[0][0])


def _plain(value):
    """What JSON can say of a value."""
    if isinstance(value, float) and not math.isfinite(value):
        return None
    if isinstance(value, (bool, int, float, str)) or value is None:
        return value
    if isinstance(value, dict):
        return {str(key): _plain(item) for key, item in value.items()}
    if isinstance(value, (list, tuple)):
        return [_plain(item) for item in value]
    return str(value)


def _parameters(method):
    parameters = list(inspect.signature(method).parameters.values())[1:]
    return [{"name": one.name, "optional": one.default is not inspect.Parameter.empty}
            for one in parameters
            if one.kind in (inspect.Parameter.POSITIONAL_ONLY,
                            inspect.Parameter.POSITIONAL_OR_KEYWORD)]


def _list_of_services(cls):
    return [{"name": name, "parameters": _parameters(method),
             "asynchronous": method._morse_asynchronous}
            for name, method in sorted(services_of(cls).items())]


def describe(classpath, level=""):
    """What a scenario says of the component: its `own`, without kind and path."""
    cls, level = level_class(load(classpath), level)
    return cls, {
        "language": "python", "code": cls.__module__ + "." + cls.__qualname__, "level": level,
        "data": {name: _plain(value) for name, value, *_ in fields_of(cls, level)},
        "properties": {name: _plain(value) for _, value, name, *_ in properties_of(cls)
                       if isinstance(value, (bool, int, float, str))},
        "services": _list_of_services(cls)}


def describe_overlay(classpath, settings):
    """The class of an overlay, and what a scenario says of it, without its path."""
    cls = load(classpath)
    return cls, {"code": cls.__module__ + "." + cls.__qualname__, "settings": _plain(settings),
                 "services": _list_of_services(cls)}


def source_folder(cls):
    """The folder that has to be on Python's path for the class to be found."""
    file = os.path.abspath(inspect.getfile(cls))
    folder = os.path.dirname(file)
    # Packages have their own names in the module's; the file's own may be __init__.py.
    ups = cls.__module__.count(".") + (os.path.basename(file) == "__init__.py")
    for _ in range(ups):
        folder = os.path.dirname(folder)
    return folder
