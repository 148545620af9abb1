"""MORSE's own: a SmallTable, 1.1 m wide, in the room of the boxes."""
from morse.builder import *

robot = ATRV()
robot.translate(x=0.0, y=-8.0, z=0.1)
laser = Sick()
laser.translate(z=0.62)
robot.append(laser)
pose = Pose()
robot.append(pose)
robot.add_default_interface('socket')

table = PassiveObject('props/objects', 'SmallTable')
table.translate(x=4.0, y=-8.0)
table.properties(Object=True)

env = Environment('indoors-1/boxes')
