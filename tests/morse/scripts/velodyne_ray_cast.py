from morse.builder import *

robot = ATRV()
velodyne = VelodyneRayCast()
velodyne.translate(z=1.9)
robot.append(velodyne)
velodyne.add_service('socket')

env = Environment('empty', fastmode=True)
