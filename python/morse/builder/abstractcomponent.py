"""What all objects of a scene have in common: MORSE's AbstractComponent."""

import logging
import os
import sys

from morse.builder import bpymorse, data, places

logger = logging.getLogger("morsebuilder")


class timer(float):  # pylint: disable=invalid-name
    """A property that counts the seconds: Blender's type TIMER."""

    is_morse_timer = True


class Configuration:
    """What scripts configure beside the objects themselves."""

    stream_managers = {}  # middleware -> its settings
    simulation_services = ["socket"]  # middlewares that serve `simulation`

    @classmethod
    def reset(cls):
        cls.stream_managers = {}
        cls.simulation_services = ["socket"]


class AbstractComponent:
    """An object of the scene: a place, properties, children, streams, services."""

    components = []  # all there are, in order

    def __init__(self, obj=None, filename="", category=""):
        self.place = places.user_place(self)
        self.basename = None  # the last part of its name, where somebody gave it one
        self.full_name = None  # once it has been renamed
        self.parent = None
        self.children = []
        self.streams = []
        self.services = []
        self.modifiers = []
        self.overlays = []
        self.chosen_level = None
        self.rate = None  # Hz
        self.profiled = False
        self.paint = None  # red, green, blue, 0..1, where it has been painted
        self._exportable = True
        self._category = category
        self._model = filename
        self._bpy_object = None
        AbstractComponent.components.append(self)
        if obj is not None:
            self.set_blender_object(obj)

    def set_blender_object(self, obj):
        self._bpy_object = obj

    # Names

    @property
    def name(self):
        return self._bpy_object.name

    @name.setter
    def name(self, value):
        if "." in value:
            raise SyntaxError("the name %r has a '.', which joins the names of a robot and its "
                              "components; use '_'" % value)
        self.basename = value
        self._bpy_object.name = value

    def __str__(self):
        return self.full_name or self.name

    def append(self, obj, child=None, level=1):
        """Makes `obj` a part of this one, or of the child of this model that is so called.

        It gets the name of the variable that it is in where append() was called, `level` calls up,
        unless it has one: the last of the variables there, then of the attributes of `self`.
        """
        if not isinstance(obj, AbstractComponent):
            raise TypeError("append() takes a component, not %r" % (obj,))
        frame = sys._getframe(level)
        if obj.basename is None:
            name = _name_in(frame.f_locals, obj)
            if name is not None:
                obj.basename = name
        if obj.parent is not None and obj in obj.parent.children:
            obj.parent.children.remove(obj)
        obj.parent = self
        self.children.append(obj)
        holder = self._bpy_object
        if child is not None:
            holder = self.get_child(child)
            if holder is None:
                logger.error("%s has no child called %s; %s is appended to itself", self.name,
                             child, obj.name)
                holder = self._bpy_object
        if obj._bpy_object is not None and holder is not None:
            obj._bpy_object.parent = holder

    @staticmethod
    def close_context(level=1):
        """Gives robots and other objects without parent the names of their variables, now."""
        AbstractComponent.name_by_variables(sys._getframe(level).f_locals)

    @staticmethod
    def name_by_variables(variables):
        for name, value in list(variables.items()):
            if (isinstance(value, AbstractComponent) and value.parent is None and
                    value.basename is None and value._bpy_object is not None and
                    not getattr(value, "is_environment", False)):
                value.basename = name
                value._bpy_object.name = name

    def after_renaming(self):
        """Called once all names are known."""

    # Places

    @property
    def location(self):
        return self._bpy_object.location

    @location.setter
    def location(self, xyz):
        self._bpy_object.location = xyz

    @property
    def rotation_euler(self):
        return self._bpy_object.rotation_euler

    @rotation_euler.setter
    def rotation_euler(self, xyz):
        self._bpy_object.rotation_euler = xyz

    @property
    def scale(self):
        return self._bpy_object.scale

    @scale.setter
    def scale(self, xyz):
        self._bpy_object.scale = xyz

    def translate(self, x=0.0, y=0.0, z=0.0):
        """Moves it by so many metres."""
        self._bpy_object.location = self._bpy_object.location + (x, y, z)

    def rotate(self, x=0.0, y=0.0, z=0.0):
        """Adds to its Euler angles XYZ, rad."""
        self._bpy_object.rotation_euler = self._bpy_object.rotation_euler + (x, y, z)

    # Properties

    def properties(self, **kwargs):
        bpymorse.properties(self._bpy_object, **kwargs)

    def property_value(self, name):
        """The value of a property; None where it has none of that name."""
        known = self._bpy_object.game.properties.get(name)
        return None if known is None else known.value

    def frequency(self, frequency=None):
        """Sets how often it acts, Hz."""
        if frequency is None:
            return
        if not frequency > 0:
            raise ValueError("a frequency of %r Hz; must be more than 0" % frequency)
        self.rate = float(frequency)

    def level(self, level):
        """Chooses one of its levels of realism."""
        self.chosen_level = level
        self.properties(abstraction_level=level)

    def profile(self):
        """Has MORSE show how much time it takes."""
        self.profiled = True
        places.note("profile() has no effect", matters=False)

    def select(self):
        bpymorse.select_only(self._bpy_object)

    def get_child(self, name, objects=None, recursive=True):
        """The object of the model that is called `name`; None where there is none."""
        for item in objects if objects is not None else self._bpy_object.children:
            if item.name == name or item.name.rsplit(".", 1)[0] == name:
                return item
            found = self.get_child(name, item.children) if recursive and item.children else None
            if found is not None:
                return found
        return None

    # Streams and services

    def table_entry(self):
        """Its entry in the table of components; None where it has none."""
        classpath = self.property_value("classpath")
        return data.component_of_class(classpath) if classpath else None

    def _direction(self):
        return None

    def add_stream(self, datastream, method=None, path=None, classpath=None, direction=None,
                   **kwargs):
        """Shares its data over a middleware. Several calls add several streams."""
        self._must_be_exportable()
        if classpath is None:
            classpath = self.property_value("classpath")
        entry = data.component_of_class(classpath) if classpath else None
        if direction is None:
            direction = self._direction() or {"sensor": "OUT", "actuator": "IN"}.get(
                entry["kind"] if entry else None)
        level = self._stream_level(entry)
        if method is None:
            if direction is None:
                logger.error("%s is neither a sensor nor an actuator and has no stream of %s; give "
                             "it a direction", self.name, datastream)
                return
            if datastream not in data.STREAM_MIDDLEWARES:
                logger.error("no middleware is called %s; there are %s", datastream,
                             ", ".join(data.STREAM_MIDDLEWARES))
                return
            if entry is None or not entry["streams"]:
                logger.warning("%s gets a generic stream of %s: its class %s has no form of its "
                               "own", self.name, datastream, classpath)
            elif level not in entry["streams"]:
                logger.error("%s has no stream of level %s", self.name, level)
                return
            elif datastream not in entry["streams"][level]:
                logger.error("%s has no stream of %s at level %s; there are %s", self.name,
                             datastream, level, ", ".join(entry["streams"][level]))
                return
        if datastream != "socket":
            places.note("streams of %s are not simulated, 'socket' is" % datastream)
        self.streams.append({"middleware": datastream, "method": method, "path": path,
                             "direction": direction, "level": level, "settings": kwargs})

    def _stream_level(self, entry):
        if entry is None:
            return self.chosen_level or "default"
        if self.chosen_level is None and len(entry["levels"]) > 1:
            self.level(entry["default_level"])
        return self.chosen_level or entry["default_level"]

    def add_service(self, interface, component=None, config=None):
        """Answers requests that come over a middleware."""
        if interface not in data.SERVICE_MIDDLEWARES:
            raise KeyError(interface)
        if interface != "socket":
            places.note("services over %s are not simulated, 'socket' is" % interface)
        if interface not in self.services:
            self.services.append(interface)

    def add_interface(self, interface, **kwargs):
        """Services and a stream."""
        self._must_be_exportable()
        if interface in data.SERVICE_MIDDLEWARES:
            self.add_service(interface)
        self.add_stream(interface, **kwargs)

    def alter(self, modifier_name=None, classpath=None, direction=None, **kwargs):
        """Has its data changed on their way in or out."""
        if classpath is None:
            entry = self.table_entry()
            classpath = entry["modifiers"][modifier_name] if entry else None
            if classpath is None:
                raise KeyError(modifier_name)
        self.modifiers.append({"name": modifier_name, "classpath": classpath,
                               "direction": direction or self._direction(), "settings": kwargs,
                               "place": places.user_place()})

    def add_overlay(self, datastream, overlay, config=None, **kwargs):
        """Offers its services in another form, by a class "package.module.Class" of the user's."""
        if datastream != "socket":
            places.note("overlays of %s are not simulated, those of 'socket' are" % datastream)
        self.overlays.append({"middleware": datastream, "classpath": overlay, "settings": kwargs,
                              "place": places.user_place()})

    def mark_unexportable(self):
        self._exportable = False

    def is_exportable(self):
        return self._exportable

    def _must_be_exportable(self):
        if not self._exportable:
            place = places.user_place()
            sys.stderr.write("[ERROR][MORSE] %s:%d: a %s has no data to share: remove its stream\n"
                             % (place[0], place[1], type(self).__name__))
            sys.stderr.flush()
            sys.exit(1)

    # Models

    def is_morseable(self):
        """Has it what makes an object a component?"""
        return "classpath" in self._bpy_object.game.properties

    def morseable(self, calling_module=None):
        """Makes an object that came with a model a component."""
        self.properties(Component_Tag=True)

    def append_meshes(self, objects=None, component=None, prefix=None):
        """Names of the objects of a model file that it brings into the scene."""
        return self._load_model(component or self._model, prefix)

    def append_scenes(self, component=None):
        """All objects of a model file."""
        return self._load_model(component or self._model, None)

    def append_collada(self, component=None):
        """All objects of a Collada file."""
        return self._load_model(component or self._model, None, ".dae")

    def _load_model(self, name, prefix, ending=".blend"):
        file = name if name.endswith(ending) else name + ending
        path = data.find_asset(self._category, name if ending == ".blend" else file)
        if path is None:
            raise data.asset_missing(self._category, file)
        stem = prefix or os.path.splitext(os.path.basename(path))[0]
        return [bpymorse.Object(stem)]

    def set_color(self, r, g, b):
        """Paints it: red, green, blue from 0 to 1."""
        self.paint = (r, g, b)

    def hide_mesh(self, hide=True):
        self._bpy_object.hide_render = hide


def _name_in(variables, obj):
    name = None
    for candidate, value in variables.items():
        if value is obj:
            name = candidate
    if "self" in variables:
        for candidate, value in getattr(variables["self"], "__dict__", {}).items():
            # What every component keeps of others is no variable of the user's.
            if value is obj and candidate != "parent":
                name = candidate
    return name
