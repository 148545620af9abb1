"""The thesis's RobotProperties (L. Bertl, 2017, section 3.2): tells programs what robot it is on."""

import morse.core.sensor
from morse.core.exceptions import MorseRPCInvokationError
from morse.core.services import service
from morse.helpers.components import add_data, add_property


class RobotProperties(morse.core.sensor.Sensor):
    """What programs have to know of a robot and nobody measures: its type, size and settings.

    It is sent as a whole in each line, and a part of it is what get_property answers.
    """
    _name = "RobotProperties"
    _short_desc = "Tells programs what robot it is on."

    add_data('properties', {}, 'dict', 'name -> value; lengths in metres, masses in kilogrammes')

    # A setting of Player's, for the programs that ask for it.
    add_property('_proxy_index', 0, 'ProxyIndex', 'int', 'index of the robot among the proxies')

    def __init__(self, obj, parent=None):
        morse.core.sensor.Sensor.__init__(self, obj, parent)
        self._collect()

    def _collect(self):
        facts = self.robot_parent.facts
        known = {'name': self.robot_parent.name(), 'proxy_index': self._proxy_index}
        for name in ('type', 'size', 'mass', 'max_speed', 'max_turn_rate', 'color', 'start'):
            known[name] = facts[name]
        # And what the builder script has said of it: robot.properties(Owner='nobody').
        known.update(self.robot_parent.properties)
        self.local_data['properties'] = known

    @service
    def get_property(self, name):
        """The value of one of them."""
        known = self.local_data['properties']
        if name not in known:
            raise MorseRPCInvokationError("The robot has no property %s; it has %s" %
                                          (name, ', '.join(sorted(known))))
        return known[name]

    def default_action(self):
        self._collect()
