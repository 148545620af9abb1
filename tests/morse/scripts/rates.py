from morse.builder import *

robot = ATRV()
motion = MotionVW()
robot.append(motion)
every = Pose()
robot.append(every)
third = Pose()
third.frequency(20)
robot.append(third)
uneven = Pose()
uneven.frequency(25)
robot.append(uneven)
slow = Pose()
slow.frequency(frequency=4)
robot.append(slow)
robot.add_default_interface('socket')

env = Environment('empty', fastmode=True)
