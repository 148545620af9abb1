from morse.builder import *

for_all = 'socket'

r1 = ATRV()
r1.translate(x=-3)
pose = Pose()
r1.append(pose)
pose.add_interface(for_all)

r2 = B21()
r2.translate(x=3)
pose = Pose()
r2.append(pose)
pose.add_interface(for_all)

env = Environment('empty', fastmode = True)
