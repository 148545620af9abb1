"""Declarations in the body of a component's class: MORSE's add_data, add_property, add_level."""

import sys


def _declared(kind):
    return sys._getframe(2).f_locals.setdefault(kind, [])


def add_data(name, default_value, type="", doc="", level="all"):
    """A field of local_data, sent to clients or taken from them.

    `level`: the level of realism, or a list of them, that has it.
    """
    levels = level if isinstance(level, (list, tuple)) else [level]
    _declared("_declared_data").append((name, default_value, type, doc, tuple(levels)))


def add_property(python_name, default_value, name, type="", doc=""):
    """What builder scripts set by properties(NAME=...) and clients by set_property.

    The component finds it in its attribute `python_name`.
    """
    _declared("_declared_properties").append((python_name, default_value, name, type, doc))


def add_level(level_name, path, doc="", default=False):
    """A level of realism; `path` names the class that has it, None where it is this one."""
    _declared("_declared_levels").append((level_name, path, doc, default))
