"""The actuator Pen for builder scripts."""

from morse.builder.creator import ActuatorCreator


class Pen(ActuatorCreator):
    """Draws on the canvas."""

    _classpath = "drawing.actuators.pen.Pen"

    def __init__(self, name=None):
        ActuatorCreator.__init__(self, name)
