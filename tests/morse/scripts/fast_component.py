from morse.builder import *

robot = ATRV()
pose = Pose()
pose.frequency(120)
robot.append(pose)
pose.add_stream('socket')

env = Environment('empty', fastmode=True)
