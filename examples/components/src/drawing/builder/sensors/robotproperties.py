"""The sensor RobotProperties for builder scripts."""

from morse.builder.creator import SensorCreator


class RobotProperties(SensorCreator):
    """Tells programs what robot it is on."""

    _classpath = "drawing.sensors.robotproperties.RobotProperties"

    def __init__(self, name=None):
        SensorCreator.__init__(self, name)
