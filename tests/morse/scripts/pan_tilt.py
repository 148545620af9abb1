from morse.builder import *

robot = ATRV()

ptu = PTU()
ptu.translate(x=0.2, z=0.9)
ptu.properties(Speed=2.0)
robot.append(ptu)

posture = PTUPosture()
ptu.append(posture)
gyroscope = Gyroscope()
ptu.append(gyroscope)
eye = Pose()
eye.translate(x=0.1)
ptu.append(eye)
sick = Sick()
sick.translate(z=0.1)
ptu.append(sick)
robot.add_default_interface('socket')

mouse = ATRV()
mouse.translate(x=4.0, y=3.0)

env = Environment('empty', fastmode=True)
