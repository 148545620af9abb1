from morse.builder import *

robot = ATRV()
camera = SemanticCamera()
camera.translate(x=0.7, z=0.5)
robot.append(camera)
relative = SemanticCamera()
relative.translate(x=0.7, z=0.5)
relative.properties(relative=True, noocclusion=True)
robot.append(relative)
teleport = Teleport()
robot.append(teleport)
robot.add_default_interface('socket')

mouse = ATRV()
mouse.translate(x=6.0)
mouse.properties(Object=True, Label="MOUSE", Type="Animal", Description="grey")

behind_it = ATRV()
behind_it.translate(x=12.0)
behind_it.properties(Object=True)

env = Environment('empty', fastmode=True)
