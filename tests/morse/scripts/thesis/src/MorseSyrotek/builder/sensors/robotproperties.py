from morse.builder.creator import SensorCreator

class RobotProperties(SensorCreator):
    _classpath = "MorseSyrotek.sensors.RobotProperties.RobotProperties"

    def __init__(self, name = None):
        SensorCreator.__init__(self, name)
        self.frequency(1)
