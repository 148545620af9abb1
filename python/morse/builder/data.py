"""What MORSE's components are: components.json, robots.json and environments.json as Python.

components.json is the one table of sensors and actuators (specs: MORSE 1.4). An entry has
    name             the builder's class
    kind             "sensor" or "actuator"
    base             the builder's class that it derives from; none: SensorCreator, ActuatorCreator
    classpath        MORSE's class that does the work
    implementations  level -> name of the class, as `simulation details` shows it
    frequency        Hz, as delivered
    levels           names of the levels of realism, "default" where there is one only
    default_level    the one of a component that chooses none
    fields           of the data: name, type, default; levels, where it has not every one
    properties       name -> default of the class
    presets          name -> value that the builder's class sets
    services         name, parameters (name and, where optional, default), asynchronous,
                     interruptible (a new call preempts)
    streams          level -> middlewares that have a form for the data; none: a generic one
    modifiers        name -> class, as alter() takes it
    exportable       may have streams
    needs            "rendering", "armature" or null
    simulated        the simulator's type of component, or null
"""

import json
import os

from morse.builder import places

_HERE = os.path.dirname(os.path.abspath(__file__))


def _load(name):
    with open(os.path.join(_HERE, name), encoding="utf-8") as file:
        return json.load(file)


COMPONENTS = {entry["name"]: entry for entry in _load("components.json")}
ROBOTS = _load("robots.json")
ENVIRONMENTS = _load("environments.json")

STREAM_MIDDLEWARES = ("socket", "ros", "yarp", "yarp_json", "pocolibs", "text", "moos", "hla",
                      "mavlink")
SERVICE_MIDDLEWARES = ("socket", "yarp", "yarp_json", "pocolibs", "ros")

# What of the components in the projects of SyRoTek's users the simulator has of its own.
SYROTEK_COMPONENTS = {"pen": "Pen", "robotproperties": "RobotProperties"}

# By class of MORSE, not of the builder: a user's builder class may name one of MORSE's.
_BY_CLASSPATH = {}
for _entry in COMPONENTS.values():
    _BY_CLASSPATH.setdefault(_entry["classpath"], _entry)


def component_of_type(kind):
    """The entry of a builder's class, or of the nearest one that it derives from; None: none."""
    for known in kind.__mro__:
        if known.__name__ in COMPONENTS and known.__module__.startswith("morse.builder."):
            return COMPONENTS[known.__name__]
    return None


def component_of_class(classpath):
    """The table's entry of a class of MORSE; None where it has none."""
    return _BY_CLASSPATH.get(classpath)


def worlds_folder():
    """Where the worlds are, beside this package in the source tree and where it is installed."""
    return os.path.abspath(os.path.join(_HERE, "..", "..", "..", "worlds"))


def data_folders():
    """Where MORSE's own data may be, in order."""
    roots = [os.environ["MORSE_ROOT"]] if os.environ.get("MORSE_ROOT") else []
    if os.environ.get("CCMORSE_MORSE_DATA") != "off":
        roots += ["/usr", "/usr/local"]
    return [os.path.join(root, "share", "morse", "data") for root in roots]


# Endings of the files of shapes that the simulator reads.
MODEL_ENDINGS = (".blend", ".gltf", ".glb", ".obj", ".stl", ".dae")


def find_asset(category, name):
    """The path of a model file, as MORSE looks for it; None where there is none."""
    named = name.lower().endswith(MODEL_ENDINGS)
    if named and os.path.isfile(name):
        return os.path.abspath(name)
    file = name if named else name + ".blend"
    candidates = [os.path.join(folder, category, file) for folder in data_folders()]
    for folder in filter(None, os.environ.get("MORSE_RESOURCE_PATH", "").split(":")):
        candidates += [os.path.join(folder, name), os.path.join(folder, file),
                       os.path.join(folder, category, file)]
    for candidate in candidates:
        if os.path.isfile(candidate):
            return os.path.abspath(candidate)
    return None


def asset_missing(category, name):
    """The error for a model file that is nowhere."""
    looked = data_folders() + list(filter(None, os.environ.get("MORSE_RESOURCE_PATH",
                                                               "").split(":")))
    return FileNotFoundError(2, "no such %s model; looked in the current folder and in %s" %
                             (category.rstrip("s"), ", ".join(looked)), name)


__all__ = ["COMPONENTS", "ROBOTS", "ENVIRONMENTS", "places"]
