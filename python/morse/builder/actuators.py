"""MORSE's actuators, made of the table components.json."""

import logging  # noqa: F401  scripts use these without importing them
import math  # noqa: F401

from morse.builder import bpymorse, data  # noqa: F401
from morse.builder.creator import ActuatorCreator, make_class


class Joystick(ActuatorCreator):
    """A game controller, the index-th."""

    _classpath = data.COMPONENTS["Joystick"]["classpath"]

    def __init__(self, name=None, index=0):
        super().__init__(name)
        self.apply_entry(data.COMPONENTS["Joystick"])
        self.properties(Index=index)


class Sound(ActuatorCreator):
    """Plays a file."""

    _classpath = data.COMPONENTS["Sound"]["classpath"]

    def __init__(self, name=None):
        super().__init__(name)
        self.apply_entry(data.COMPONENTS["Sound"])

    def open(self, filepath):
        """Which one."""
        self.properties(filepath=filepath)


class Armature(ActuatorCreator):
    """Joints of a model."""

    _classpath = data.COMPONENTS["Armature"]["classpath"]

    def __init__(self, name=None, armature_name=None, model_name=None):
        super().__init__(name or armature_name)
        self.apply_entry(data.COMPONENTS["Armature"])
        self.model_name = model_name
        self.ik_targets = []

    def create_ik_targets(self, bones):
        """Things that these bones reach for."""
        for bone in bones:
            target = bpymorse.Object("ik_target.%s.%s" % (self.name, bone), "EMPTY")
            self.ik_targets.append(target)
        return self.ik_targets


class KukaLWR(Armature):
    """An arm of seven joints."""

    _classpath = data.COMPONENTS["KukaLWR"]["classpath"]

    def __init__(self, name=None):
        super().__init__(name, model_name="kuka_lwr")
        self.create_ik_targets(["kuka_7"])


class Waypoint(ActuatorCreator):
    """Drives to a point."""

    _classpath = data.COMPONENTS["Waypoint"]["classpath"]

    def __init__(self, name=None):
        super().__init__(name)
        self.apply_entry(data.COMPONENTS["Waypoint"])
        self.add_lr_radars()

    def add_lr_radars(self):
        """What it would see obstacles with."""
        self.add_radar("Radar.L", "CollisionL", +1)
        self.add_radar("Radar.R", "CollisionR", -1)

    def add_radar(self, name, collision, fact):
        radar = bpymorse.Object(name, "EMPTY")
        radar.location = (0.7, 0.4 * fact, 0.8)
        radar.parent = self._bpy_object

    def radar_set_collision(self, obj, sensor, controller_type, collision, value):
        """Wires of Blender's that nothing here has."""


for _entry in data.COMPONENTS.values():
    if _entry["kind"] == "actuator" and _entry["name"] not in globals():
        globals()[_entry["name"]] = make_class(_entry["name"])

__all__ = ["ActuatorCreator", "bpymorse", "logging", "math"] + [
    _entry["name"] for _entry in data.COMPONENTS.values() if _entry["kind"] == "actuator"]
