"""Robots, passive objects and zones: what scenes are made of."""

import logging
import math  # noqa: F401  scripts use these without importing them
import os
import sys  # noqa: F401

from morse.builder import bpymorse, data, places
from morse.builder.abstractcomponent import AbstractComponent, Configuration, timer
from morse.builder.blenderobjects import Cube

logger = logging.getLogger("morsebuilder")


class PassiveObject(AbstractComponent):
    """Something from a model file that stands in the scene."""

    def __init__(self, filename="props/objects", prefix=None, keep_pose=False):
        super().__init__(filename=filename, category="")
        self.prefix = prefix
        self.keep_pose = keep_pose
        self.graspable = False
        self.path = data.find_asset("", filename)
        stem = os.path.splitext(os.path.basename(filename))[0]
        if self.path is None and stem.lower() != "canvas":
            if not filename.startswith("props/") or filename.endswith(".blend"):
                raise data.asset_missing("props", filename)
            places.note("the model %s is not installed (Debian's morse-simulator-data has it)" %
                        filename)
        self.set_blender_object(bpymorse.Object(prefix or stem))
        self._bpy_object.game.physics_type = bpymorse.FromModel("NO_COLLISION")
        if stem.lower() == "canvas" and bpymorse.get_material("CanvasMat") is None:
            bpymorse.create_new_material("CanvasMat")
        self.is_canvas = stem.lower() == "canvas"

    def setgraspable(self):
        """Grippers may take it."""
        self.graspable = True
        self.properties(Object=True, Graspable=True)


class Zone(Cube):
    """A box of space with a meaning, for example 'Charging'."""

    def __init__(self, type):  # pylint: disable=redefined-builtin
        super().__init__()
        self.properties(Zone_Tag=True, Type=type)
        self.zone_type = type

    @property
    def size(self):
        """Half extents, m."""
        return self._bpy_object.scale

    @size.setter
    def size(self, value):
        self._bpy_object.scale = value

    def rotate(self, x=0.0, y=0.0, z=0.0):
        logger.warning("zones lie along the axes: rotate() has no effect")


class Component(AbstractComponent):
    """Something with a model of its own."""

    def __init__(self, category="", filename="", make_morseable=True):
        super().__init__(filename=filename, category=category)
        self.model_path = None
        stem = os.path.splitext(os.path.basename(filename))[0]
        self.stem = stem
        if filename:
            self.model_path = data.find_asset(category, filename)
            known = stem in {entry["blend"] for entry in data.ROBOTS.values()}
            if self.model_path is None and not known:
                raise data.asset_missing(category, filename)
        self.set_blender_object(bpymorse.Object(self._object_name()))
        if make_morseable:
            self.morseable()


    def _object_name(self):
        return self.stem or type(self).__name__


class Robot(Component):
    """A robot: a body that components are appended to."""

    skills = ()  # services of its own that the simulator has

    def __init__(self, filename="", name=None):
        super().__init__("robots", filename)
        self.default_interfaces = []
        self.mass = None
        self.friction = None
        self.asked_for_physics = False
        self.external = False
        self.ghost = None
        if name:
            self.name = name
        entry = self.body_entry()
        self.properties(Robot_Tag=True, GroundRobot=False, NoGravity=False)
        if self.property_value("classpath") is None:
            self.properties(classpath="morse.robots.%s.%s" % (type(self).__name__.lower(),
                                                              type(self).__name__))
        self._bpy_object.game.physics_type = bpymorse.FromModel(
            entry["physics"] if entry else "DYNAMIC")
        if entry:
            self._bpy_object.game.mass = entry["mass"]
            self.properties(**entry.get("properties", {}))
            if entry["rest"] is not None:
                self._bpy_object.location = (0.0, 0.0, entry["rest"])

    def _object_name(self):
        return type(self).__name__

    def body_entry(self):
        """What robots.json has of its model; None for a user's own."""
        for entry in data.ROBOTS.values():
            if entry["blend"] == self.stem:
                return entry
        return None

    def set_friction(self, friction=0.0):
        self.friction = friction
        self.asked_for_physics = True

    def set_mass(self, mass):
        """kg."""
        self.mass = mass
        self._bpy_object.game.mass = mass

    def add_default_interface(self, stream):
        """Every component gets this interface that has none of it."""
        self.default_interfaces.append(stream)

    def make_external(self):
        """It is simulated by another node."""
        self.external = True
        self.properties(Robot_Tag=False, External_Robot_Tag=True)
        places.note("%s is a robot of another node, which is not simulated: it stands still" %
                    self.name)

    def make_ghost(self, alpha=0.3):
        """Nothing touches or sees it."""
        self.ghost = alpha
        self.set_no_collision()

    def set_rigid_body(self):
        self.asked_for_physics = True
        self._bpy_object.game.physics_type = "RIGID_BODY"

    def set_dynamic(self):
        self.asked_for_physics = True
        self._bpy_object.game.physics_type = "DYNAMIC"

    def set_no_collision(self):
        self._bpy_object.game.physics_type = "NO_COLLISION"

    def set_collision_bounds(self):
        game = self._bpy_object.game
        game.use_collision_bounds = True
        game.collision_bounds_type = "CONVEX_HULL"
        game.use_collision_compound = True

    def make_grasper(self, obj_name):
        """Gives the part of its model that is so called what grasping needs."""
        places.note("make_grasper() is not simulated")


class GroundRobot(Robot):
    """A robot that stands on the ground."""

    def __init__(self, filename="", name=None):
        super().__init__(filename, name)
        self.properties(GroundRobot=True)


class WheeledRobot(GroundRobot):
    """A robot on wheels that the physics drive."""

    def __init__(self, filename="", name=None):
        super().__init__(filename, name)
        self.wheels_apart = False

    def unparent_wheels(self):
        self.wheels_apart = True

    def after_renaming(self):
        # Blender's model looks along y and is turned by MORSE, with all that is mounted on it; ours
        # looks along x from the start.
        if not self.wheels_apart:
            self.unparent_wheels()


__all__ = ["AbstractComponent", "Component", "Configuration", "GroundRobot", "PassiveObject",
           "Robot", "WheeledRobot", "Zone", "bpymorse", "logging", "logger", "math", "os", "sys",
           "timer"]
