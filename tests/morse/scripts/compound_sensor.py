from morse.builder import *

robot = ATRV()
pose = Pose()
robot.append(pose)
gyroscope = Gyroscope()
robot.append(gyroscope)
everything = CompoundSensor([pose, gyroscope])
robot.append(everything)
everything.add_interface('socket')

env = Environment('empty', fastmode=True)
