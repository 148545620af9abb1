from morse.builder import *

robot = ATRV()
pose = Pose()
pose.frequency(120)
robot.append(pose)
slow = Odometry()
slow.frequency(frequency=1)
robot.append(slow)
env = Environment('empty', fastmode=True)
