"""MORSE's sensors, made of the table components.json."""

import logging  # noqa: F401  scripts use these without importing them
import math  # noqa: F401

from morse.builder import bpymorse, data  # noqa: F401
from morse.builder.creator import SensorCreator, make_class


class LaserSensorWithArc(SensorCreator):
    """What all scanners are."""

    _classpath = data.COMPONENTS["LaserSensorWithArc"]["classpath"]

    def __init__(self, name=None):
        super().__init__(name)
        self.apply_entry(data.component_of_type(type(self)))
        self.arc = None  # the settings that it was made with

    def get_ray_material(self):
        """The material of the drawn arc."""
        return (bpymorse.get_material("RayMat") or
                bpymorse.create_new_material("RayMat"))

    def settings(self):
        """Name -> value of what makes up its fan, presets and all."""
        values = dict(data.COMPONENTS["LaserSensorWithArc"]["properties"])
        for name in values:
            value = self.property_value(name)
            if value is not None:
                values[name] = value
        return values

    def create_laser_arc(self):
        """Fixes the fan: what is set later counts only if this is called again."""
        self.arc = self.settings()

    def after_renaming(self):
        if self.arc is None:
            self.create_laser_arc()


class VideoCamera(SensorCreator):
    """A camera, which looks along its robot's x."""

    _classpath = data.COMPONENTS["VideoCamera"]["classpath"]

    def __init__(self, name=None):
        super().__init__(name)
        self.apply_entry(data.component_of_type(type(self)))

    def rotate(self, x=0, y=0, z=0):
        """By Euler angles of the robot's axes, rad."""
        super().rotate(x, y, z)


class CompoundSensor(SensorCreator):
    """The data of several sensors as one."""

    _classpath = data.COMPONENTS["CompoundSensor"]["classpath"]

    def __init__(self, sensors, name=None):
        super().__init__(name)
        self.apply_entry(data.component_of_type(type(self)))
        self.sensors = sensors

    def after_renaming(self):
        self.properties(sensors=",".join(str(sensor) for sensor in self.sensors))


class Kinect(CompoundSensor):
    """A colour and a depth camera side by side."""

    def __init__(self, name="Kinect"):
        self.video_camera = None
        super().__init__([], name)
        self.video_camera = VideoCamera("rgb")
        self.depth_camera = globals()["DepthVideoCamera"]("depth")
        for camera, y in ((self.video_camera, 0.08), (self.depth_camera, -0.08)):
            camera.properties(cam_width=128, cam_height=128)
            camera.translate(0.06, y, 0.04)
            camera.frequency(20)
            self.append(camera)
        self.sensors = [self.video_camera, self.depth_camera]

    def add_stream(self, *args, **kwargs):
        self.video_camera.add_stream(*args, **kwargs)
        self.depth_camera.add_stream(*args, **kwargs)

    def profile(self):
        self.video_camera.profile()
        self.depth_camera.profile()

    def frequency(self, frequency=None):
        super().frequency(frequency)
        if self.video_camera is not None:
            self.video_camera.frequency(frequency)
            self.depth_camera.frequency(frequency)


_SPECIAL = {"LaserSensorWithArc": {}, "VideoCamera": {}, "CompoundSensor": {}, "Kinect": {}}

for _entry in data.COMPONENTS.values():
    _name = _entry["name"]
    if _entry["kind"] != "sensor" or _name in _SPECIAL:
        continue
    _base = globals().get(_entry.get("base", ""))
    if _base is None:
        globals()[_name] = make_class(_name)
    else:  # its constructor takes what the table has for the class's own name
        globals()[_name] = type(_name, (_base,), {
            "_classpath": _entry["classpath"], "__module__": __name__,
            "__doc__": "MORSE's %s (docs/morse.md)." % _entry["classpath"]})

__all__ = ["SensorCreator", "bpymorse", "logging", "math"] + [
    _entry["name"] for _entry in data.COMPONENTS.values() if _entry["kind"] == "sensor"]
