from morse.builder import *
from morse.builder.creator import SensorCreator, ActuatorCreator

class Radiation(SensorCreator):
    _classpath = "my_project.sensors.radiation.Radiation"

    def __init__(self, name=None):
        SensorCreator.__init__(self, name)
        self.frequency(10)

class Pen(ActuatorCreator):
    _classpath = "my_project.actuators.pen.Pen"

    def __init__(self, name=None):
        ActuatorCreator.__init__(self, name)

robot = ATRV()
radiation = Radiation()
robot.append(radiation)
pen = Pen()
robot.append(pen)
robot.add_default_interface('socket')
env = Environment('empty')
