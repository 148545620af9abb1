from morse.builder import *

robot = ATRV()
robot.translate(x=1.0, y=2.0)
marker = Arucomarker()
marker.properties(xoffset=0.5, zoffset=1.0)
robot.append(marker)
marker.add_interface('socket')

env = Environment('empty', fastmode=True)
