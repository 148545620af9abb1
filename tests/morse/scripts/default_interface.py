from morse.builder import *

robot = ATRV()
robot.add_default_interface('socket')
pose = Pose()
robot.append(pose)
gps = GPS()
robot.append(gps)
gps.add_stream('socket')  # one is enough
keyboard = Keyboard()  # has no data to share
robot.append(keyboard)
silent = Odometry()
silent.mark_unexportable()
robot.append(silent)

other = ATRV()
other.translate(x=5.0)
quiet = Pose()
other.append(quiet)
served = Pose()
other.append(served)
served.add_service('socket')

env = Environment('empty', fastmode=True)
