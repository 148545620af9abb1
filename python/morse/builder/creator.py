"""What one's own sensors and actuators derive from: MORSE's creators."""

from morse.builder import bpymorse, data
from morse.builder.abstractcomponent import AbstractComponent


class ComponentCreator(AbstractComponent):
    """A component without a body of its own."""

    APPEND_EMPTY = 0
    USE_BLEND = 1
    APPEND_COLLADA = 2

    _classpath = None
    _blendname = None
    _kind = None

    def __init__(self, name=None, category="", action=APPEND_EMPTY, blendfile="", blendobject=None,
                 make_morseable=True):
        super().__init__(filename=blendfile, category=category)
        self.set_blender_object(bpymorse.Object(name or type(self).__name__, "EMPTY"))
        if name:
            self.name = name
        self.properties(Component_Tag=True)
        if isinstance(action, str):  # MORSE before 1.3: the class in the second place
            self._classpath = action
        if self._classpath:
            self.properties(classpath=self._classpath)
        self.frequency(60)

    def _direction(self):
        return {"sensor": "OUT", "actuator": "IN"}.get(self._kind)

    def apply_entry(self, entry):
        """Takes rate and presets of the table."""
        self.properties(classpath=entry["classpath"])
        self.frequency(entry["frequency"])
        self.properties(**entry["presets"])
        if not entry["exportable"]:
            self.mark_unexportable()


class SensorCreator(ComponentCreator):
    """A sensor."""

    _kind = "sensor"

    def __init__(self, name=None, action=ComponentCreator.APPEND_EMPTY, make_morseable=True,
                 **_more):
        super().__init__(name, "sensors", action, self._blendname or "", None, make_morseable)


class ActuatorCreator(ComponentCreator):
    """An actuator."""

    _kind = "actuator"

    def __init__(self, name=None, action=ComponentCreator.APPEND_EMPTY, make_morseable=True,
                 **_more):
        super().__init__(name, "actuators", action, self._blendname or "", None, make_morseable)


def make_class(name, bases=None, namespace=None):
    """The builder's class of a table's entry."""
    entry = data.COMPONENTS[name]

    def __init__(self, name=None):  # pylint: disable=invalid-name
        creator = SensorCreator if entry["kind"] == "sensor" else ActuatorCreator
        creator.__init__(self, name)
        self.apply_entry(entry)

    members = {"_classpath": entry["classpath"], "__init__": __init__,
               "__doc__": "MORSE's %s (docs/morse.md)." % entry["classpath"]}
    members.update(namespace or {})
    if bases is None:
        bases = (SensorCreator if entry["kind"] == "sensor" else ActuatorCreator,)
    made = type(name, bases, members)
    made.__module__ = "morse.builder.%ss" % entry["kind"]
    return made
