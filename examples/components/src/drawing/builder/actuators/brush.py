"""The actuator Brush, a plug-in in C++, for builder scripts."""

import os

from morse.builder.creator import ActuatorCreator


class Brush(ActuatorCreator):
    """Draws a trace of its robot on the canvas."""

    _plugin = os.path.join(os.path.dirname(os.path.abspath(__file__)),
                           "..", "..", "plugins", "brush.so")

    def __init__(self, name=None):
        ActuatorCreator.__init__(self, name)
