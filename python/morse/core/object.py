"""What sensors and actuators of one's own derive from."""

import copy

from morse.core import describe
from morse.core.abstractobject import AbstractObject
from morse.core.exceptions import MorseRPCInvokationError
from morse.helpers.transformation import Transformation3d


class Object(AbstractObject):
    """A component on a robot.

    robot_parent  the robot
    local_data    what clients get, or what they have sent
    frequency     Hz
    level         the level of realism, "" where it has but one
    position_3d   where it is in the world: x, y, z, roll, pitch, yaw, m and rad
    canvas        the grid map to draw on (docs/canvas.md)
    """

    def __init__(self, obj, parent=None):
        AbstractObject.__init__(self)
        self.bge_object = obj
        self.robot_parent = parent
        self.frequency = obj.frequency
        self.level = obj.level
        self.canvas = obj.canvas
        self._mount = Transformation3d.of(obj.mount, obj.mount_euler)
        self.local_data = {field[0]: copy.deepcopy(field[1])
                           for field in describe.fields_of(type(self), obj.level)}
        self._set_properties(obj.properties)

    def _set_properties(self, given):
        for python_name, default, name, *_ in describe.properties_of(type(self)):
            value = given.get(name, default)
            if isinstance(default, int) and not isinstance(default, bool) and \
                    isinstance(value, float) and value.is_integer():
                value = int(value)
            setattr(self, python_name, value)

    def name(self):
        """Its full name, "robot.component"."""
        return self.bge_object.name

    @property
    def position_3d(self):
        return self.robot_parent.position_3d.times(self._mount)

    def sensor_to_robot_position_3d(self):
        """Where it is as seen from its robot."""
        return Transformation3d.of(self.bge_object.mount, self.bge_object.mount_euler)

    @property
    def time(self):
        """Simulated time, s."""
        return self.robot_parent.time

    def call(self, component, service, *arguments):
        """Calls a service of another component, or of "simulation", that answers at once.

        Raises MorseRPCInvokationError where it fails. Components of one's own cannot be called.
        """
        answer = self.bge_object.ask([component, service, list(arguments)])
        if "failed" in answer:
            raise MorseRPCInvokationError(answer["failed"])
        return answer.get("result")

    def apply_speed(self, kind, linear, angular):
        """As robot_parent.apply_speed()."""
        self.robot_parent.apply_speed(kind, linear, angular)
