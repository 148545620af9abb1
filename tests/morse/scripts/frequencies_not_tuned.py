from morse.builder import *

robot = ATRV()
pose = Pose()
pose.frequency(120)
robot.append(pose)
env = Environment('empty', fastmode=True, auto_tune_time=False)
