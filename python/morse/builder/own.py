"""The code of components of one's own (docs/components.md)."""

import importlib.util
import os

from morse.builder import data, places
from morse.core import describe
from morse.core.actuator import Actuator
from morse.core.overlay import MorseOverlay
from morse.core.sensor import Sensor


def _exists(classpath):
    """Is there a module of that name? Its packages are imported for it."""
    try:
        return importlib.util.find_spec(classpath.rpartition(".")[0]) is not None
    except (ImportError, ValueError):
        return False


def code_of(component, full):
    """What a scenario says of the component's code; None where it is the simulator's own.

    Raises what the import of the user's module raises.
    """
    plugin = getattr(type(component), "_plugin", None)
    if plugin is not None:
        file = os.path.abspath(plugin)
        if not os.path.isfile(file):
            raise FileNotFoundError(2, "the plug-in of %s has not been built; run make in its folder" %
                                    full, file)
        return {"language": "c++", "kind": component._kind, "code": file}
    classpath = component.property_value("classpath") or ""
    if not classpath or classpath.startswith("morse.") or not _exists(classpath):
        return None
    native = classpath.rsplit(".", 1)[-1].lower() in data.SYROTEK_COMPONENTS
    try:
        cls, code = describe.describe(classpath, component.chosen_level or "")
    except ImportError as error:
        if not native:
            raise
        places.note("%s: the simulator's own %s stands in for %s, which needs what is not there: %s" %
                    (full, data.SYROTEK_COMPONENTS[classpath.rsplit(".", 1)[-1].lower()], classpath,
                     error), component.place, matters=False)
        return None
    kind = "actuator" if issubclass(cls, Actuator) else "sensor"
    if not issubclass(cls, (Actuator, Sensor)):
        raise TypeError("%s must derive from morse.core.sensor.Sensor or "
                        "morse.core.actuator.Actuator" % classpath)
    folders = [describe.source_folder(cls)]
    outer = describe.source_folder(describe.load(classpath))
    code.update(kind=kind, path=folders + [outer] * (outer not in folders))
    return code


def overlays_of(component, full):
    """What a scenario says of the component's overlays; raises what imports of their modules do."""
    found = []
    for overlay in component.overlays:
        if overlay["middleware"] != "socket":
            continue  # the script has been told
        classpath = overlay["classpath"]
        if not _exists(classpath):
            places.note("%s: there is no module of the overlay %s" % (full, classpath),
                        overlay["place"])
            continue
        cls, entry = describe.describe_overlay(classpath, overlay["settings"])
        if not issubclass(cls, MorseOverlay):
            raise TypeError("%s must derive from morse.core.overlay.MorseOverlay" % classpath)
        found.append(dict(entry, path=[describe.source_folder(cls)]))
    return found
