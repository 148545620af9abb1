from morse.builder import *

robot = ATRV()

odometry = Odometry()
robot.append(odometry)
odometry.add_stream('socket')

raw = Odometry()
raw.level('raw')
robot.append(raw)
raw.add_stream('socket')

gps = GPS()
gps.level('extended')
robot.append(gps)
gps.add_stream('socket')

env = Environment('empty', fastmode=True)
env.properties(longitude=43.6, latitude=1.4333, altitude=135.0)
