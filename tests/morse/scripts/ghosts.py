from morse.builder import *

robot = ATRV()
sick = Sick()
sick.translate(z=0.3)
sick.properties(laser_range=20.0)
robot.append(sick)
motion = MotionVW()
robot.append(motion)
pose = Pose()
robot.append(pose)
robot.add_default_interface('socket')

ghost = ATRV()
ghost.translate(x=3.0, y=0.4)  # its right half lies in the way
ghost.make_ghost()

wall = B21()
wall.translate(x=8.0)

env = Environment('empty', fastmode=True)
