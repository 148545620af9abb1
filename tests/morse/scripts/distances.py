from morse.builder import *

seer = Pioneer3DX()
seen = Pioneer3DX()
seen.translate(x=6.0)
hidden = Pioneer3DX()
hidden.translate(x=12.0)
aside = Pioneer3DX()
aside.translate(y=8.0)
pose = Pose()
seer.append(pose)
pose.add_interface('socket')

env = Environment('empty', fastmode=True)
