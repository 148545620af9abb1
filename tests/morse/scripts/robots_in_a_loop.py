from morse.builder import *

for i in range(4):
    robot = ATRV('patrol%d' % i)
    robot.translate(x=3.0 * i, y=-2.0)
    motion = Waypoint()
    robot.append(motion)
    pose = Pose()
    robot.append(pose)
    robot.add_default_interface('socket')

env = Environment('empty', fastmode=True)
