from morse.builder import *

robot = ATRV()

ptu = PTU()
ptu.translate(x=0.2, z=0.9)
ptu.rotate(z=math.pi / 2)
robot.append(ptu)

pose = Pose()
pose.translate(x=0.5, z=0.1)
ptu.append(pose)
pose.add_interface('socket')

robot.add_default_interface('socket')
env = Environment('empty', fastmode=True)
