from morse.builder import *

robot = ATRV()
pose = Pose()
pose.alter('Noise', pos_std=0.1, rot_std=0.02)
robot.append(pose)
pose.add_stream('socket')
ned = Pose()
ned.alter('NED')
robot.append(ned)
env = Environment('empty', fastmode=True)
