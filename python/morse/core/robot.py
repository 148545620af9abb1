"""The robot that a component sits on."""

from morse.core.abstractobject import AbstractObject
from morse.core.mathutils import Vector
from morse.helpers.transformation import Transformation3d


class Robot(AbstractObject):
    """What a component knows of its robot, and what it can do to it.

    position_3d       where it is: x, y, z, roll, pitch, yaw, m and rad
    linear_velocity   m/s, in the world
    angular_velocity  rad/s
    facts             what the simulator knows of it: type, size, mass, color, start, ...
    properties        MORSE's, as the builder script has set them
    """

    def __init__(self, obj, parent=None):
        AbstractObject.__init__(self)
        self.bge_object = obj
        self.facts = obj.facts
        self.properties = obj.facts.get("properties", {})
        self.move_status = "Stop"

    def name(self):
        return self.bge_object.name

    @property
    def time(self):
        """Simulated time, s."""
        return self.bge_object.time

    @property
    def position_3d(self):
        pose = self.bge_object.pose
        return Transformation3d.of(pose[0:3], pose[3:6])

    @property
    def linear_velocity(self):
        return Vector(self.bge_object.pose[6:9])

    @property
    def angular_velocity(self):
        return Vector(self.bge_object.pose[9:12])

    def apply_speed(self, kind, linear, angular):
        """Drives: m/s along and rad/s about the robot's own axes, until the next command.

        `kind` is MORSE's "Velocity" or "Position"; here robots go exactly as told by either.
        """
        if kind not in ("Velocity", "Position"):
            raise ValueError("kind must be 'Velocity' or 'Position', not %r" % (kind,))
        self.bge_object.do("speed", linear[0], linear[1], angular[2])

    def force_pose(self, position, orientation=None):
        """Puts it somewhere, standing still: x, y and roll, pitch, yaw or a rotation matrix."""
        yaw = self.position_3d.yaw
        if orientation is not None:
            turned = hasattr(orientation, "to_euler")
            yaw = (orientation.to_euler() if turned else orientation)[2]
        self.bge_object.do("place", position[0], position[1], yaw)
