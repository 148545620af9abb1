from morse.builder import *
from morse.builder.blenderobjects import Cube

robot = ATRV()
sick = Sick()
sick.translate(z=0.3)
robot.append(sick)
motion = MotionVW()
robot.append(motion)
pose = Pose()
robot.append(pose)
robot.add_default_interface('socket')

cube = Cube()
cube.translate(x=2.0)
cube.color(1.0, 0.0, 0.0)

env = Environment('empty', fastmode=True)
