from morse.builder import *

seer = ATRV()
seen = ATRV()
seen.translate(x=6.0)
hidden = ATRV()
hidden.translate(x=12.0)
aside = ATRV()
aside.translate(y=8.0)
pose = Pose()
seer.append(pose)
pose.add_interface('socket')

env = Environment('empty', fastmode=True)
