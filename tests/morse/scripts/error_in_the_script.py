from morse.builder import *

robot = ATRV()
pose = Pose()
robot.apend(pose)
env = Environment('empty')
